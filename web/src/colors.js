// Colour maps that stay legible to colour-blind eyes and in grey; colours of curves; light and dark.
const STOPS = {
  viridis: ['440154', '482475', '414487', '355f8d', '2a788e', '21918c', '22a884', '44bf70', '7ad151', 'bddf26', 'fde725'],
  cividis: ['00224e', '123570', '3b496c', '575d6d', '707173', '8a8678', 'a59c74', 'c3b369', 'e1cc55', 'fee838'],
  // for fields with a sign: purple below zero, orange above
  signed: ['2d004b', '542788', '8073ac', 'b2abd2', 'd8daeb', 'f7f7f7', 'fee0b6', 'fdb863', 'e08214', 'b35806', '7f3b08'],
};
export const MAPS = ['viridis', 'cividis'];
export const PLAIN = [0.62, 0.68, 0.74];

const channel = (hex, k) => parseInt(hex.slice(2 * k, 2 * k + 2), 16) / 255;

// Colour at a fraction 0..1: [r, g, b] in 0..1, sRGB.
export function colorAt(map, fraction) {
  const stops = STOPS[map], place = Math.min(Math.max(fraction, 0), 1) * (stops.length - 1);
  const k = Math.min(Math.floor(place), stops.length - 2), part = place - k;
  return [0, 1, 2].map(c => channel(stops[k], c) * (1 - part) + channel(stops[k + 1], c) * part);
}

export function cssGradient(map, direction = 'to right') {
  return `linear-gradient(${direction}, ${STOPS[map].map(hex => `#${hex}`).join(', ')})`;
}

export function cssColor(map, fraction) {
  return `rgb(${colorAt(map, fraction).map(c => Math.round(255 * c)).join(' ')})`;
}

export const DASHES = [[], [7, 4], [2, 3], [10, 3, 2, 3], [4, 2]];

// Colours of curves (Okabe and Ito) are variables of the style sheet, which differ in light and dark.
const CURVE_COLORS = 5;

export const curveColor = k => `var(--curve-${k % CURVE_COLORS})`;

export function curveColors() {
  return Array.from({length: CURVE_COLORS}, (_, k) => cssVariable(`--curve-${k}`));
}

// ---- light and dark ----

const listeners = [];
const system = matchMedia('(prefers-color-scheme: dark)');

export function isDark() {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === 'dark' : system.matches;
}

export function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  for (const listener of listeners) listener();
}

// Calls `listener` now and whenever light and dark change.
export function onTheme(listener) {
  listeners.push(listener);
  listener();
}

system.addEventListener('change', () => listeners.forEach(listener => listener()));

export function cssVariable(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
