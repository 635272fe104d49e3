// TypeScript types of the answers, made from the JSON Schemas that the core itself prints.
import { readFile, writeFile } from 'node:fs/promises';
import { compile } from 'json-schema-to-typescript';
import { initSync, schemas } from './src/generated/core.js';

initSync({ module: await readFile(new URL('./src/generated/core_bg.wasm', import.meta.url)) });
const all = JSON.parse(schemas());
const options = {
  bannerComment: '',
  additionalProperties: false,
  declareExternallyReferenced: true,
  style: { singleQuote: true },
};
const names = { analyze: 'Analyze', 'analyze-gear': 'AnalyzeGear', 'analyze-inputs': 'AnalyzeInputs', transmissions: 'Transmissions',
  adjust: 'Adjust', front: 'Front', motor: 'Motor', 'motor-moving': 'MotorMoving', select: 'Select', schemes: 'Schemes', error: 'Refused' };
let index = '// Made by types.mjs from the JSON Schemas of the answers.\n';
for (const [name, schema] of Object.entries(all)) {
  const type = names[name];
  if (!type) throw new Error(`no type is named for the answer ${name}`);
  const text = await compile({ ...schema, title: type }, type, options);
  await writeFile(new URL(`./src/generated/${name}.ts`, import.meta.url), `// Made by types.mjs.\n${text}`);
  index += `export type { ${type} } from './${name}.js';\n`;
}
await writeFile(new URL('./src/generated/answers.ts', import.meta.url), index);
