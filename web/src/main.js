// One page for a run and for a study: the data say which.
import {isDark, setTheme} from './colors.js';
import {h} from './dom.js';
import {runPage} from './run.js';
import {studyPage} from './study.js';

const PAGES = {run: runPage, study: studyPage};

// Wishes in the address: #frame=3&color=T1&view=shear&theme=dark
const start = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
if (start.theme) setTheme(start.theme);

const data = JSON.parse(document.getElementById('data').textContent);
const page = document.getElementById('page');
document.title = `${data.name ?? data.summary.name} – Capsella`;
page.append(
  h('nav', {}, h('span', {class: 'brand'}, 'Capsella'),
    h('button', {'aria-label': 'light or dark', onclick: () => setTheme(isDark() ? 'light' : 'dark')}, '◐')),
  ...PAGES[data.kind](data, start).filter(Boolean),
  h('footer', {}, `Made by Capsella ${data.program}.`));
