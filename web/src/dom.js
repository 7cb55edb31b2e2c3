// Elements in one line: h('p', {class: 'note'}, 'text', child).  Properties that start with "on" are listeners.
export function h(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false && value != null) element.setAttribute(name, value);
  }
  element.append(...children.flat().filter(child => child != null && child !== false));
  return element;
}

export function choice(label, options, selected, onchange) {
  const select = h('select', {onchange: () => onchange(select.value)},
    options.map(([value, text]) => h('option', {value, selected: value === selected}, text)));
  return h('label', {class: 'choice'}, h('span', {}, label), select);
}

export function toggle(label, checked, onchange) {
  const box = h('input', {type: 'checkbox', checked, onchange: () => onchange(box.checked)});
  return h('label', {class: 'toggle'}, box, label);
}

// Calls `listener` when the element has another size, at the next drawing: never within the observation itself.
export function onResize(element, listener) {
  new ResizeObserver(() => requestAnimationFrame(listener)).observe(element);
}

export function section(title, ...children) {
  return h('section', {}, h('h2', {}, title), ...children);
}
