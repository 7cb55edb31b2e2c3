// A table that sorts by the column whose head is pressed.
import {h} from './dom.js';
import {format} from './format.js';

const collator = new Intl.Collator('en', {numeric: true});

// Empty cells come last, whichever way the column is sorted.
function compare(a, b, direction) {
  const isEmpty = value => value === null || value === undefined || value === '';
  if (isEmpty(a) || isEmpty(b)) return Number(isEmpty(a)) - Number(isEmpty(b));
  const order = typeof a === 'number' && typeof b === 'number' ? a - b : collator.compare(String(a), String(b));
  return direction * order;
}

// columns: [{key, label, title}]; rows: objects.  onselect(row) is called when a row is pressed.
export function sortableTable(columns, rows, onselect) {
  const body = h('tbody'), heads = [];
  let sorted = null, direction = 1;

  const cell = (row, {key}) => {
    const value = row[key], isNumber = typeof value === 'number';
    return h('td', {class: isNumber ? 'number' : null, title: isNumber ? String(value) : null}, isNumber ? format(value, 5) : value ?? '–');
  };
  const fill = () => {
    const shown = sorted ? [...rows].sort((a, b) => compare(a[sorted], b[sorted], direction)) : rows;
    body.replaceChildren(...shown.map(row => h('tr', {class: onselect && 'pressable', onclick: () => onselect?.(row)}, columns.map(column => cell(row, column)))));
    for (const {head, key} of heads) head.setAttribute('aria-sort', key !== sorted ? 'none' : direction > 0 ? 'ascending' : 'descending');
  };
  const sortBy = key => {
    direction = sorted === key ? -direction : 1;
    sorted = key;
    fill();
  };
  for (const {key, label, title} of columns)
    heads.push({key, head: h('th', {scope: 'col', title}, h('button', {onclick: () => sortBy(key)}, label))});
  fill();
  return h('div', {class: 'scroll'}, h('table', {class: 'sortable'}, h('thead', {}, h('tr', {}, heads.map(({head}) => head))), body));
}
