// The page of a study.
async function checkCurves() {
  const [figure] = all('.tools select');
  check(all('.uplot canvas').length === 1 && isDrawn(one('.uplot canvas')), 'the curve is missing or empty');
  const before = one('.uplot canvas').toDataURL();
  await choose(figure, 'D12');
  check(one('figcaption').textContent.includes('D'), `the curve of D12 is called ${one('figcaption').textContent}`);
  check(one('.uplot canvas').toDataURL() !== before, 'another figure does not change the curve');
}

function checkPhases() {
  const symbols = all('.diagram > circle, .diagram > path');
  check(symbols.length === expected.cases, `${symbols.length} symbols for ${expected.cases} cases in the phase diagram`);
  check(all('.diagram > path').length === all('.sortable tbody tr').filter(row => row.textContent.includes('ruptured')).length,
    'as many crosses as ruptured cases');
}

async function checkTable() {
  const rows = () => all('.sortable tbody tr'), heads = all('.sortable th button');
  check(rows().length === expected.cases, `${rows().length} rows for ${expected.cases} cases`);
  const column = heads.findIndex(head => head.textContent === 'd_max'), values = () => rows().map(row => Number(row.cells[column].textContent));
  await press(heads[column]);
  check(values().every((value, k, list) => k === 0 || list[k - 1] <= value), `sorted by d_max: ${values()}`);
  await press(rows().at(-1));
  check(all('.site.chosen').length === 2, `${all('.site.chosen').length} sites are marked for the row of a ruptured case`);
  const name = rows().at(-1).cells[heads.findIndex(head => head.textContent === 'case')].textContent;
  check(one('#time').textContent === name, `the row of ${name} shows ${one('#time').textContent}`);
}

async function checkCapsule() {
  const picture = () => one('.picture canvas').toDataURL();
  check(Number(one('#slider').max) === expected.cases - 1, `${one('#slider').max} is the last of ${expected.cases} cases`);
  await choose(one('#slider'), 0);
  const first = picture();
  await choose(one('#slider'), one('#slider').max);
  check(picture() !== first, 'the slider does not change the picture');
}

async function probe() {
  await settle();
  await checkCurves();
  checkPhases();
  await checkTable();
  await checkCapsule();
  check(document.title.startsWith(expected.name), `the title is ${document.title}`);
}

probe().then(() => conclude(), conclude);
