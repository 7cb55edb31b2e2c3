// What the probes share: findings are written into the page, where the test reads them.
const findings = [];
const check = (isTrue, what) => isTrue || findings.push(what);
const one = selector => document.querySelector(selector);
const all = selector => [...document.querySelectorAll(selector)];
const expected = JSON.parse(one('#expected').textContent);
// A frame whose document stays open keeps the page loading, and the browser hands the page out when it is loaded.
const hold = document.body.appendChild(document.createElement('iframe'));
hold.hidden = true;
hold.contentDocument.open();

const frames = count => new Promise(resolve => requestAnimationFrame(() => resolve(count > 1 ? frames(count - 1) : null)));
const settle = () => frames(6); // what a change sets off is drawn within a few

async function choose(element, value) {
  element.value = value;
  element.dispatchEvent(new Event(element.tagName === 'INPUT' ? 'input' : 'change'));
  await settle();
}

async function press(element) {
  element.click();
  await settle();
}

function conclude(error) {
  if (error) findings.push(`${error.stack}`);
  findings.push(...messages);
  const pre = document.createElement('pre');
  pre.id = 'findings';
  pre.textContent = `\n${findings.length ? findings.join('\n') : 'passed'}\n`;
  document.body.append(pre);
  hold.contentDocument.close();
}

// Whether a canvas shows more than one colour.
function isDrawn(canvas) {
  const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  return data.some((value, k) => value !== data[k % 4]);
}
