// The app as the program gives it out: `epicyclic serve`.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, unlinkSync, writeFileSync } from 'node:fs';
import http from 'node:http';
import { networkInterfaces, tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { browser, open, until } from './serve.mjs';

const program = process.env.EPICYCLIC ?? '../target/debug/epicyclic';
const app = process.env.WEB ?? '../target/app';
let chromium;

before(async () => {
  chromium = await browser();
});
after(() => chromium?.close());

/** The program serving, and its address; it ends after what is done with it. */
async function served(words, done, input = null) {
  const running = spawn(program, ['serve', '--port', '0', '--no-browser', ...words], { stdio: [input === null ? 'ignore' : 'pipe', 'pipe', 'inherit'] });
  try {
    if (input !== null) running.stdin.end(input);
    const address = await new Promise((resolve, reject) => {
      running.stdout.on('data', (line) => resolve(String(line).trim()));
      running.on('exit', (code) => reject(new Error(`ended with ${code}`)));
    });
    await done(address, () => running.kill());
  } finally {
    running.kill();
  }
}

const asked = (address, path, options = {}) =>
  new Promise((resolve, reject) => {
    const { hostname, port } = new URL(address);
    http.request({ hostname, port, path, ...options }, (reply) => {
      const parts = [];
      reply.on('data', (part) => parts.push(part)).on('end', () => resolve({ code: reply.statusCode, headers: reply.headers, body: Buffer.concat(parts) }));
    }).on('error', reject).end();
  });

test('the program holds the app as it was built', () =>
  served([], async (address) => {
    for (const file of readdirSync(app)) {
      const { code, body } = await asked(address, `/${file}`);
      assert.equal(code, 200, file);
      assert.ok(body.equals(readFileSync(join(app, file))), file);
    }
    assert.equal((await asked(address, '/../Cargo.toml')).code, 404);
    assert.equal((await asked(address, '/opened')).code, 404);
    assert.equal((await asked(address, '/', { method: 'POST' })).code, 405);
    assert.equal((await asked(address, '/', { method: 'HEAD' })).body.length, 0);
  }));

test('it answers this machine alone, under its own name', () =>
  served([], async (address) => {
    const { port } = new URL(address);
    assert.equal((await asked(address, '/', { headers: { host: `elsewhere.example:${port}` } })).code, 403);
    assert.equal((await asked(address, '/', { headers: { host: `localhost:${port}` } })).code, 200);
    const others = Object.values(networkInterfaces()).flat().filter(({ internal, family }) => !internal && family === 'IPv4');
    for (const { address: other } of others) {
      await assert.rejects(asked(`http://${other}:${port}/`, '/'), /ECONNREFUSED/);
    }
  }));

/** What the page shows of a file; of what is missing the browser itself complains where `missing` allows it. */
async function shown(words, done, input, missing = /^$/) {
  await served(words, async (address, end) => {
    const context = await chromium.newContext({ reducedMotion: 'reduce' });
    const { page, faults } = await open(context, new URL('/', address).href, new URL(address).hash);
    await done(page, address, end);
    assert.deepEqual(faults.filter((fault) => !missing.test(fault)), []);
    await context.close();
  }, input);
}

test('the page opens with the file that is named, and reads it anew', async () => {
  const file = join(mkdtempSync(join(tmpdir(), 'epicyclic-')), 'box.yaml');
  writeFileSync(file, readFileSync('../examples/scheme-ii-3.yaml'));
  const name = readFileSync(file, 'utf8').match(/^gearbox: *(.*)$/m)[1].replaceAll(/['"]/g, '');
  await shown([file], async (page, address) => {
    assert.ok((await page.textContent('#title')).includes(name));
    writeFileSync(file, readFileSync(file, 'utf8').replace(/^gearbox:.*$/m, 'gearbox: quite another'));
    await page.goto('about:blank');
    await page.goto(address);
    await until(page, () => document.querySelector('#title')?.textContent.includes('quite another'));
  });
});

test('a file that changes, or goes, while its page is open is never shown as it was', async () => {
  const file = join(mkdtempSync(join(tmpdir(), 'epicyclic-')), 'box.yaml');
  const box = readFileSync('../examples/scheme-ii-3.yaml', 'utf8');
  const write = (name) => writeFileSync(file, box.replace(/^gearbox:.*$/m, `gearbox: ${name}`));
  write('the first');
  await shown([file], async (page, address, end) => {
    const isTitle = (title) => until(page, (title) => document.querySelector('#title')?.textContent === title && document.body.dataset.ready, title);
    const notice = async () => {
      await page.waitForSelector('#notice:not([hidden])');
      return page.locator('#notice p').textContent();
    };
    const anew = async () => {
      await page.goto('about:blank');
      await page.goto(address);
      await page.waitForSelector('body[data-ready]');
    };
    await isTitle('the first');
    write('the second');
    await page.reload();
    await isTitle('the second');
    // What was changed in the page stays until the person wants the file.
    const own = box.replace(/^gearbox:.*$/m, 'gearbox: my own');
    await page.fill('#text', own);
    await isTitle('my own');
    write('the third');
    await page.reload();
    assert.match(await notice(), /has changed since it was opened/);
    assert.equal(await page.inputValue('#text'), own);
    await page.getByRole('button', { name: 'Read the file again' }).click();
    await isTitle('the third');
    await page.goBack();
    await isTitle('my own');
    // A file that cannot be read, and a program that has ended.
    writeFileSync(file, Buffer.from([0x67, 0xff, 0x0a]));
    await anew();
    assert.match(await notice(), /box\.yaml: cannot be read: /);
    assert.match(await page.textContent('#title'), /8HP45/);
    unlinkSync(file);
    await anew();
    assert.match(await notice(), /box\.yaml: cannot be read: /);
    write('the fourth');
    await anew();
    await isTitle('the fourth');
    await until(page, () => navigator.serviceWorker.controller);
    end();
    await anew();
    assert.match(await notice(), /epicyclic serve has ended/);
    assert.match(await page.textContent('#title'), /8HP45/);
  }, null, /Failed to load resource/);
});

test('a motor opens on its page, from standard input, too', async () => {
  const isMotor = (page) => page.getAttribute('#to-motor', 'aria-current').then((is) => assert.equal(is, 'page'));
  await shown(['../examples/motor-5x3.yaml'], isMotor);
  await shown(['-'], isMotor, readFileSync('../examples/motor-5x3.yaml'));
});

test('what cannot be served is told', () => {
  const refused = (words) => {
    const { status, stderr } = spawnSync(program, ['serve', '--no-browser', ...words], { encoding: 'utf8', timeout: 20_000 });
    return [status, stderr];
  };
  const [missing, why] = refused(['not-there.yaml']);
  assert.equal(missing, 3);
  assert.match(why, /not-there\.yaml: cannot be read/);
  return served([], async (address) => {
    const [taken, told] = refused(['--port', new URL(address).port]);
    assert.equal(taken, 2);
    assert.match(told, /--port: \d+ on 127\.0\.0\.1: .*give another one, or 0/);
  });
});
