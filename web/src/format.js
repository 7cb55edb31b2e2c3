// Numbers as text: six significant digits, no trailing zeros, e-notation where it is shorter to read.
export function format(value, digits = 6) {
  if (value == null || Number.isNaN(value)) return '–';
  if (Number.isInteger(value) && Math.abs(value) < 1e9) return String(value);
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e6) return String(Number(value.toPrecision(digits)));
  return Number(value.toPrecision(digits)).toExponential().replace('e+', 'e');
}

export function bytes(count) {
  return count < 1e6 ? `${Math.round(count / 1e3)} kB` : `${(count / 1e6).toFixed(1)} MB`;
}

export function duration(seconds) {
  if (seconds < 60) return `${format(seconds, 3)} s`;
  if (seconds < 3600) return `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s`;
  return `${Math.floor(seconds / 3600)} h ${Math.round((seconds % 3600) / 60)} min`;
}

// About `count` round numbers in a range.
export function ticks([low, high], count = 5) {
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough)), ratio = rough / power;
  const step = power * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({length: Math.floor(high / step + 1e-9) - first + 1}, (_, k) => Number(((first + k) * step).toPrecision(12)));
}

// Labels in a row, numbers first to last: 1–8, 10, largest d.
export function listed(labels) {
  const sorted = [...labels].map(String).sort((a, b) => a.localeCompare(b, 'en', {numeric: true})), runs = [];
  for (const label of sorted) {
    const run = runs.at(-1);
    if (run && /^\d+$/.test(label) && Number(run.at(-1)) + 1 === Number(label)) run.push(label);
    else runs.push([label]);
  }
  return runs.map(run => (run.length > 2 ? `${run[0]}–${run.at(-1)}` : run.join(', '))).join(', ');
}
