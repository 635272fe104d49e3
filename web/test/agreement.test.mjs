// The program and the browser answer alike, to the last bit of every number.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { call, initSync as beginCalls } from '../src/generated/calls.js';
import { adjusted, initSync as beginCore, look, motor } from '../src/generated/core.js';

const examples = new URL('../../examples/', import.meta.url);
globalThis.epicyclicProgress = () => {};
for (const [name, begin] of [['core', beginCore], ['calls', beginCalls]]) begin({ module: readFileSync(new URL(`../src/generated/${name}_bg.wasm`, import.meta.url)) });
const files = readdirSync(examples).filter((name) => name.endsWith('.yaml'));
const texts = files.map((name) => readFileSync(new URL(name, examples), 'utf8'));
const text = (name) => texts[files.indexOf(name)];

/** What the program answers to a command line, in the folder of the examples. */
function native(line) {
  const done = spawnSync(process.env.EPICYCLIC, line, { cwd: examples, encoding: 'utf8', maxBuffer: 1 << 28, env: { ...process.env, COLUMNS: '80' } });
  return { code: done.status, answer: done.stdout };
}

/** Where two answers differ first; `null` where they agree. */
function difference(one, other, path = '') {
  if (typeof one !== 'object' || one === null || other === null || typeof other !== 'object') return Object.is(one, other) ? null : `${path}: ${JSON.stringify(one)} and ${JSON.stringify(other)}`;
  const keys = Object.keys(one);
  if (keys.join() !== Object.keys(other).join()) return `${path}: keys ${keys} and ${Object.keys(other)}`;
  for (const key of keys) {
    const found = difference(one[key], other[key], `${path}.${key}`);
    if (found) return found;
  }
  return null;
}

function agree(line) {
  const there = native(line);
  const here = call(line, files, texts);
  assert.equal(here.code, there.code, `${line.join(' ')}: ${here.messages}`);
  if (here.answer !== there.answer) {
    const found = line.includes('json') && there.answer ? difference(JSON.parse(there.answer), JSON.parse(here.answer)) : null;
    assert.equal(found ?? here.answer, found === null ? there.answer : null, line.join(' '));
  }
  here.free();
}

/** The gears of a file, of each of its transmissions. */
function cases() {
  const all = [];
  for (const [place, file] of files.entries()) {
    const has = (key) => new RegExp(`^${key}:`, 'm').test(texts[place]);
    if (has('scenario')) all.push(['simulate', file]);
    else if (has('transmissions')) {
      all.push(['analyze', file]);
      for (const { name } of JSON.parse(native(['analyze', file, '--format', 'json']).answer).transmissions) all.push(['analyze', file, '--transmission', name]);
    } else if (has('gearbox')) all.push(['analyze', file]);
    else if (has('stator')) all.push(['report', file]);
    else if (has('power')) all.push(['drive', file]);
  }
  return all;
}

for (const line of cases()) {
  test(`${line.join(' ')}: the browser answers as the program does`, () => {
    agree([...line, '--format', 'json']);
    if (line[0] !== 'analyze' || (line.length === 2 && line[1] === 'real-transmissions.yaml')) return;
    agree([...line, '--shifts', '--format', 'json']);
    const answer = JSON.parse(native([...line, '--format', 'json']).answer);
    for (const { gear } of answer.gears) {
      const question = [...line, '--gear', gear, '--format', 'json'];
      agree(question);
      // What the page shows is what the program answers.
      const transmission = line[3] ?? null;
      const shown = JSON.parse(look(text(line[1]), JSON.stringify({ transmission, gear, speed: null, torque: null, efficiency: null })));
      assert.equal(difference(answer, shown.analyze), null, line.join(' '));
      assert.equal(difference(JSON.parse(native(question).answer), shown.gear ?? shown.inputs), null, question.join(' '));
    }
  });
}

test('a file with other numbers is looked at as if it were read anew', () => {
  let count = 0;
  for (const [command, file, , transmission = null] of cases()) {
    if (command !== 'analyze') continue;
    const question = JSON.stringify({ transmission, gear: null, speed: null, torque: null, efficiency: null, pictures: ['scheme', 'levers', 'ladder'], list: true });
    const old = text(file);
    const { numbers } = JSON.parse(look(old, question)).adjust ?? { numbers: [] };
    const changes = numbers.flatMap((number) => ['7', '112', '3.25', '2.0', '1e1', 'none', ''].map((to) => [{ number, to }]));
    if (numbers.length > 1) changes.push(numbers.slice(0, 2).map((number) => ({ number, to: number.of === 'k' ? '2.125' : '101' })));
    for (const change of changes) {
      look(old, question);
      const reply = JSON.parse(adjusted(old, question, JSON.stringify(change)));
      // What is no number is refused before it is put into the file.
      if (reply.answer === 'error') {
        assert.ok(['not-a-number', 'empty-text'].includes(reply.name), reply.name);
        assert.ok(change.every(({ to }) => ['none', ''].includes(to)), JSON.stringify(change));
        continue;
      }
      // Another file between, so that nothing is kept of this one.
      look('', question);
      assert.equal(JSON.stringify(reply.look), JSON.stringify(JSON.parse(look(reply.file, question))), `${file}: ${JSON.stringify(change)}`);
      count++;
    }
  }
  assert.ok(count > 300, `${count}`);
});

test('pictures are the same to the letter', () => {
  const of = ['real-transmissions.yaml', '--transmission', '8HP'];
  for (const line of [['draw', ...of], ['draw', ...of, '--gear', '3', '--power'], ['draw', ...of, '--gear', '3', '--view', 'levers'], ['draw', ...of, '--gear', '3', '--view', 'speeds'], ['draw', ...of, '--view', 'ladder'], ['draw', 'motor-5x3.yaml', '--view', 'chambers']]) agree(line);
});

test('searches find the same', () => {
  agree(['select', '--speeds', '0.8 m/s, 3.15 m/s', '--format', 'json']);
  agree(['select', '--ratios', '1.465, 2.56', '--all-structures', '--format', 'json']);
  agree(['teeth', '--ratio', '6', '--limit', '20', '--format', 'json']);
  agree(['schemes', '--format', 'json']);
});

test('a fault has the same words and the same place', () => {
  agree(['select', '--speeds', 'fast', '--format', 'json']);
  agree(['analyze', 'motor-5x3.yaml', '--format', 'json']);
  agree(['analyze', 'wolfrom.yaml', '--gear', 'no such gear', '--format', 'json']);
});

test('the motor on its page is the one of the report', () => {
  const report = JSON.parse(native(['report', 'motor-5x3.yaml', '--format', 'json']).answer);
  const { schema_version, answer, ...shown } = JSON.parse(motor(text('motor-5x3.yaml'))).motor;
  assert.equal(answer, 'motor');
  assert.equal(schema_version, 1);
  assert.equal(difference(report.about.motor.motor, shown), null);
});
