// Bundles the app into a folder: one page, its script, its worker, the core, the service worker. No address outside is in any of them.
import { createHash } from 'node:crypto';
import { copyFile, mkdir, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import { build } from 'esbuild';
import { brotliCompressSync, constants } from 'node:zlib';

const out = process.argv[2] ?? '../target/app';
const here = (path) => new URL(path, import.meta.url);

await rm(out, { recursive: true, force: true });
await mkdir(out, { recursive: true });

// The examples of the repository, as they are.
const folder = here('../examples/');
const examples = [];
for (const file of (await readdir(folder)).filter((name) => name.endsWith('.yaml')).sort()) {
  const text = await readFile(new URL(file, folder), 'utf8');
  const has = (key) => new RegExp(`^${key}:`, 'm').test(text);
  const kind = has('scenario') ? null : has('gearbox') || has('transmissions') ? 'gearbox' : has('stator') ? 'motor' : null;
  if (kind) examples.push({ file, kind, text });
}
await writeFile(here('src/generated/examples.ts'),
  `// Made by build.mjs from examples/.\nexport const examples: { file: string; kind: 'gearbox' | 'motor'; text: string }[] = ${JSON.stringify(examples, null, 1)};\n`);

const common = { bundle: true, minify: true, format: 'esm', target: 'es2022', legalComments: 'none', logLevel: 'warning' };
await build({ ...common, entryPoints: { app: here('src/main.ts').pathname, worker: here('src/worker.ts').pathname }, outdir: out });
await build({ ...common, entryPoints: [here('src/style.css').pathname], outfile: `${out}/style.css` });
for (const [from, to] of [['src/index.html', 'index.html'], ['src/icon.svg', 'icon.svg'], ['src/manifest.webmanifest', 'manifest.webmanifest'],
  ['src/generated/core_bg.wasm', 'core.wasm'], ['src/generated/calls_bg.wasm', 'calls.wasm']]) {
  await copyFile(here(from), `${out}/${to}`);
}

// The service worker keeps exactly these files, under a name that changes with any of them.
const files = (await readdir(out)).sort();
const hash = createHash('sha256');
let compressed = 0;
for (const file of files) {
  const bytes = await readFile(`${out}/${file}`);
  hash.update(file).update(bytes);
  const small = brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 9 } }).length;
  // The whole program is loaded when something is searched or saved.
  if (file !== 'calls.wasm') compressed += small;
  console.log(`${file.padEnd(24)} ${String(bytes.length).padStart(9)} bytes, ${String(small).padStart(8)} compressed`);
}
console.log(`first load ${(compressed / 1e6).toFixed(3)} MB compressed`);
await build({ ...common, format: 'iife', entryPoints: [here('src/sw.ts').pathname], outfile: `${out}/sw.js`,
  define: { FILES: JSON.stringify(['./', ...files.map((file) => `./${file}`)]), VERSION: JSON.stringify(hash.digest('hex').slice(0, 16)) } });
await writeFile(`${out}/size.json`, JSON.stringify({ compressed }));
