// Bundles src/ into one page without its data: report_page.html, which the program embeds and fills in.
//   npm ci && npm run build
// The result is checked in, so that building Capsella needs no node; the test `page.bundle` rebuilds and compares.
import {build} from 'esbuild';
import {readFileSync, writeFileSync} from 'node:fs';

const MARK = '@CAPSELLA_DATA@'; // where the program puts the data: once in the page
const here = name => new URL(name, import.meta.url).pathname;

async function bundle(entry) {
  const result = await build({
    entryPoints: [here(entry)],
    bundle: true,
    minify: true,
    format: 'iife',
    target: 'es2020',
    legalComments: 'none',
    charset: 'utf8',
    write: false,
  });
  return result.outputFiles[0].text.replaceAll('</script', '<\\/script').trimEnd();
}

// The licences ask to be in every copy, so they are in every page.
const licence = name => `${name}\n\n${readFileSync(here(`node_modules/${name}/LICENSE`), 'utf8').trim()}\n`;

const [script, style] = [await bundle('src/main.js'), await bundle('src/page.css')];
const page = readFileSync(here('src/page.html'), 'utf8')
  .replace('LICENCES', () => ['three', 'uplot'].map(licence).join('\n'))
  .replace('/*STYLE*/', () => style)
  .replace('/*SCRIPT*/', () => script);
if (page.split(MARK).length !== 2) throw new Error(`expected ${MARK} once in the page`);
writeFileSync(process.argv[2] ?? here('report_page.html'), page);
