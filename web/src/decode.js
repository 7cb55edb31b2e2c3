// The data as the program packs them: numbers of 16 bits between two bounds, in base64; tables as CSV.
const NOT_A_NUMBER = 65535;

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// {min, max, data} -> Float32Array; 65534 stands for max.
export function unpack(packed) {
  const levels = new Uint16Array(bytesOf(packed.data).buffer);
  const step = (packed.max - packed.min) / 65534;
  return Float32Array.from(levels, level => (level === NOT_A_NUMBER ? NaN : packed.min + step * level));
}

export function unpackIndices(base64) {
  return new Int32Array(bytesOf(base64).buffer);
}

function cell(text) {
  if (text === '' || text === 'nan') return null;
  const value = Number(text);
  return Number.isNaN(value) ? text : value;
}

// One line of CSV, with quoted cells.
function cells(line) {
  const found = [];
  for (const match of line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g))
    found.push(match[1] === undefined ? cell(match[2]) : match[1].replaceAll('""', '"'));
  return found;
}

// {names, column: {name: [values]}, rows: [{name: value}], length}; empty cells and nan are null.
export function table(csv) {
  const lines = csv.split(/\r?\n/).filter(line => line !== '');
  const names = lines.length ? lines[0].split(',') : [];
  const rows = lines.slice(1).map(cells);
  const records = rows.map(row => Object.fromEntries(names.map((name, k) => [name, row[k] ?? null])));
  const column = Object.fromEntries(names.map((name, k) => [name, rows.map(row => row[k] ?? null)]));
  return {names, column, rows: records, length: rows.length};
}
