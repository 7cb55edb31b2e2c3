// The page of a run.
const picture = () => one('.picture canvas').toDataURL();

function checkNumbers() {
  const shown = all('[data-key]');
  check(shown.length >= 15, `only ${shown.length} figures are shown`);
  for (const cell of shown) {
    const key = cell.dataset.key, value = key.split('.').reduce((object, name) => object?.[name], expected);
    check(value !== undefined, `${key} is not in summary.json`);
    check(cell.title === (value === null ? 'not reached' : String(value)), `${key}: the title is ${cell.title}, not ${value}`);
    if (typeof value === 'number' && key !== 'wall_seconds')
      check(Number(cell.textContent) === Number(value.toPrecision(6)), `${key}: ${cell.textContent} is shown for ${value}`);
  }
  for (const text of expected.skipped)
    check(all('li').some(item => item.textContent === text), `not told that it was skipped: ${text}`);
}

async function checkSlider() {
  const slider = one('#slider');
  await frames(10);
  const last = picture();
  check(one('#time').textContent === `t = ${Number(expected.t.toPrecision(5))}`, `the slider starts at ${one('#time').textContent}`);
  await choose(slider, 0);
  check(one('#time').textContent === 't = 0', `the slider at its left end shows ${one('#time').textContent}`);
  check(picture() !== last, 'the slider does not change the picture');
  await choose(slider, slider.max);
  check(picture() === last, 'the slider moved back does not give the same picture');
}

async function checkPlay() {
  await choose(one('#slider'), 0);
  const states = JSON.parse(one('#data').textContent).surface.frames.map(({t}) => `t = ${Number(t.toPrecision(5))}`);
  const isBetween = () => !states.includes(one('#time').textContent);
  await press(one('.play'));
  const begin = performance.now();
  while (!isBetween() && performance.now() - begin < 5000) await frames(1);
  check(isBetween(), 'playing fills in nothing between the states');
  while (Number(one('#slider').value) === 0 && performance.now() - begin < 5000) await frames(1);
  check(Number(one('#slider').value) > 0, 'playing does not move the slider');
  if (one('.play').getAttribute('aria-label') === 'pause') await press(one('.play'));
  check(!isBetween(), `what stands still is no state: ${one('#time').textContent}`);
  await choose(one('#slider'), one('#slider').max);
}

async function checkColours() {
  const [colour, map, range] = all('.tools select'), seen = new Set();
  for (const option of colour.options) {
    await choose(colour, option.value);
    check(!one('.bar').textContent.includes('NaN'), `NaN in the colour bar of ${option.value}`);
    seen.add(picture());
  }
  const isUniform = expected.D12 < 1e-6; // every field of an inflated sphere is one colour: only the plain one differs
  check(seen.size >= (isUniform ? 2 : colour.options.length), `${colour.options.length} colourings give ${seen.size} pictures`);
  await choose(colour, colour.options[0].value);
  const viridis = picture();
  await choose(map, 'cividis');
  check(picture() !== viridis, 'the map does not change the picture');
  await choose(map, 'viridis');
  check(picture() === viridis, 'the map chosen again does not give the same picture');
  await choose(range, 'this');
  check(one('.ticks').textContent.length > 0, 'the colour bar has no numbers');
  await choose(range, 'all');
}

async function checkViews() {
  const before = picture(), buttons = all('.buttons button');
  await press(buttons[1]);
  check(picture() !== before, 'a view does not change the picture');
  await press(buttons[0]);
  for (const box of all('.toggle input')) {
    const picture0 = picture();
    await press(box);
    check(picture() !== picture0, `"${box.parentElement.textContent}" does not change the picture`);
    await press(box);
  }
}

// Somewhere in the right half of the picture lies the deformed capsule.
async function checkHover() {
  const box = one('.picture').getBoundingClientRect();
  one('.picture').dispatchEvent(new PointerEvent('pointermove', {clientX: box.left + 0.75 * box.width, clientY: box.top + 0.5 * box.height}));
  check(/= \S*\d/.test(one('.readout').textContent), `under the pointer: "${one('.readout').textContent}"`);
}

async function checkSorting() {
  const heads = all('.sortable th button'), column = heads.findIndex(head => head.textContent === 't_c');
  if (column < 0) return;
  const values = () => all('.sortable tbody tr').map(row => Number(row.cells[column].textContent));
  await press(heads[column]);
  const rising = values();
  check(rising.length === 2 && rising[0] < rising[1], `sorted by t_c: ${rising}`);
  await press(heads[column]);
  check(values()[0] === rising[1] && values()[1] === rising[0], `sorted the other way: ${values()}`);
}

async function checkCurves() {
  const canvases = all('.uplot canvas');
  check(canvases.length >= 8, `only ${canvases.length} curves`);
  check(canvases.every(isDrawn), 'a curve is empty');
  const over = one('.u-over'), box = over.getBoundingClientRect();
  const at = {clientX: box.left + box.width / 2, clientY: box.top + box.height / 2, bubbles: true};
  over.dispatchEvent(new MouseEvent('mouseenter', at));
  over.dispatchEvent(new MouseEvent('mousemove', at));
  await settle();
  check(/\d/.test(one('.u-legend .u-value').textContent), 'no value is shown under the pointer');
}

async function checkTheme() {
  const background = () => getComputedStyle(document.body).backgroundColor, before = background();
  await press(one('nav button'));
  check(background() !== before, 'light and dark do not change the page');
  check(all('.uplot canvas').every(isDrawn), 'a curve is empty after the change to dark');
}

async function probe() {
  await settle();
  checkNumbers();
  await checkSlider();
  await checkPlay();
  await checkColours();
  await checkViews();
  await checkHover();
  await checkSorting();
  await checkCurves();
  await checkTheme();
  check(one('#scene').textContent.includes('capillary_number') || expected.D12 < 1e-6, 'the scene is not in the page');
}

probe().then(() => conclude(), conclude);
