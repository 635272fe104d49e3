// What a person expects of any page: links, back, reload, print, a newer version. Nothing that was typed is lost or changed unasked.
import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { app, change, open, pages, PHONE, serve, until } from './serve.mjs';

const { on, url, chromium } = pages();

const example = (name) => readFileSync(`../examples/${name}`, 'utf8');
const value = (page, id) => page.inputValue(`#${id}`);
const pick = (page, name) => change(page, () => page.selectOption('#pick', name));
/** The hash of a link with this state. */
const link = (state) => `#s=${deflateRawSync(JSON.stringify(state)).toString('base64url')}`;
const isTitle = (page, title) => until(page, (title) => document.querySelector('#title').textContent.includes(title), title);
const isRefused = (page, id, words) => until(page, ([id, words]) => document.getElementById(id).textContent.includes(words), [id, words]);
const notice = async (page) => ((await page.isVisible('#notice')) ? page.locator('#notice p').textContent() : '');

/** Answers the next question of the page, and gives its words. */
function answered(page, yes) {
  return new Promise((done) => page.once('dialog', async (dialog) => {
    const words = dialog.message();
    await (yes ? dialog.accept() : dialog.dismiss());
    done(words);
  }));
}

// --- links and the way back ---

on('a link that is pasted into an open tab is opened, and back returns to what was there', async (page) => {
  const before = await page.textContent('#title');
  await page.goto(url() + link({ page: 'gearbox', gearbox: { file: example('simpson.yaml'), transmission: null, gear: null } }));
  await isTitle(page, 'Simpson');
  await page.goto(url() + link({ page: 'motor', motor: example('motor-5x3.yaml').replace(/^width:.*$/m, 'width: 77 mm') }));
  await until(page, () => document.querySelector('#motor-width').value === '77 mm');
  assert.equal(await page.isVisible('#motor'), true);
  await page.goBack();
  await isTitle(page, 'Simpson');
  assert.equal(await page.isVisible('#gearbox'), true);
  await page.goBack();
  await isTitle(page, before);
  await page.goForward();
  await isTitle(page, 'Simpson');
});

on('back returns to the page and the example before', async (page) => {
  await pick(page, 'wolfrom.yaml');
  await page.click('#to-choose');
  assert.equal(await page.isVisible('#choose'), true);
  await page.goBack();
  assert.equal(await page.isVisible('#choose'), false);
  await isTitle(page, 'Wolfrom');
  await page.goBack();
  await isTitle(page, '8HP45');
  assert.equal(await value(page, 'pick'), 'real-transmissions.yaml');
});

on('an address names a page', async (page, context) => {
  for (const name of ['gearbox', 'choose', 'motor']) {
    assert.equal(await page.getAttribute(`#to-${name}`, 'href'), `#${name}`);
    const other = await open(context, url(), `#${name}`);
    assert.equal(await other.page.isVisible(`#${name}`), true, name);
    assert.deepEqual(other.faults, []);
  }
});

const BROKEN = [
  [link({ page: 'foo' }), 'page cannot be "foo"'],
  [link({ gearbox: { file: 5 } }), 'gearbox.file cannot be 5'],
  [link({ gearbox: { gear: 3 } }), 'gearbox.gear cannot be 3'],
  [link({ gearbox: { power: 'yes' } }), 'gearbox.power cannot be "yes"'],
  [link({ gearbox: [] }), 'gearbox cannot be []'],
  [link({ motor: null }), 'motor cannot be null'],
  [link({ choose: { speeds: 3 } }), 'choose cannot be {"speeds":3}'],
  [link('state'), 'holds no state'],
  [link(null), 'holds no state'],
  [link({ motor: example('motor-5x3.yaml') }).slice(0, -20), 'cut off'],
  ['#s=', 'cut off'],
  ['#s=%%%', 'cut off'],
];
on('a broken link is refused in words, in a new tab and in an open one', async (page, context) => {
  await pick(page, 'simpson.yaml');
  for (const [hash, words] of BROKEN) {
    const other = await open(context, url(), hash);
    assert.ok((await notice(other.page)).includes(words), `${words}: ${await notice(other.page)}`);
    await isTitle(other.page, '8HP45');
    assert.deepEqual(other.faults, []);
    await other.page.close();
    await page.goto(url() + hash);
    await page.waitForSelector('#notice:not([hidden])');
    assert.ok((await notice(page)).includes(words), words);
    await isTitle(page, 'Simpson');
    await page.getByRole('button', { name: 'Close' }).click();
    assert.equal(await page.isVisible('#notice'), false);
  }
});

on('a link to parts that this version does not know opens with those it knows', async (page) => {
  await page.goto(url() + link({ page: 'gearbox', colour: 'red', gearbox: { file: example('simpson.yaml'), transmission: null, gear: '9', zoom: 3 } }));
  await isTitle(page, 'Simpson');
  // A gear that is not there gives way to one that is.
  await page.waitForSelector('#gears input:checked');
  assert.equal(await page.textContent('#refused'), '');
  assert.equal(await notice(page), '');
});

on('without a program that serves, its address says so', async (page, context) => {
  const other = await context.newPage();
  await other.goto(`${url()}#open`);
  await other.waitForSelector('body[data-ready]');
  assert.match(await notice(other), /No file was given to epicyclic serve/);
  await page.evaluate(() => navigator.serviceWorker.ready);
  await context.setOffline(true);
  // The worker, which fetches for the page, may be told a moment later.
  let told = '';
  for (let tries = 0; tries < 10 && !/epicyclic serve has ended/.test(told); tries++) {
    await other.goto('about:blank');
    await other.goto(`${url()}#open`);
    await other.waitForSelector('body[data-ready]');
    told = await notice(other);
  }
  assert.match(told, /epicyclic serve has ended/);
  await isTitle(other, '8HP45');
});

// --- nothing that was typed is lost ---

on('what was typed a moment ago is there after a reload, right or wrong', async (page) => {
  const again = async () => {
    await page.reload();
    await page.waitForSelector('body[data-ready]');
  };
  const broken = 'gearbox: half typed\nsets: [\n';
  await page.fill('#text', broken);
  await again();
  assert.equal(await value(page, 'text'), broken);
  await page.fill('#text', example('simpson.yaml'));
  await page.fill('#speed', 'fast');
  await again();
  assert.equal(await value(page, 'text'), example('simpson.yaml'));
  assert.equal(await value(page, 'speed'), 'fast');
  await page.click('#to-choose');
  await page.getByLabel('Ratios of the braked gears').fill('1.465, 2.5');
  await page.getByLabel('Gearboxes').selectOption('all');
  await again();
  assert.equal(await page.isVisible('#choose'), true);
  assert.equal(await page.getByLabel('Ratios of the braked gears').inputValue(), '1.465, 2.5');
  assert.equal(await page.getByLabel('Gearboxes').inputValue(), 'all');
  await page.click('#to-motor');
  await page.locator('#motor details summary').click();
  await page.fill('#motor-text', 'stator: 5\nrotor: three\n');
  await again();
  assert.equal(await value(page, 'motor-text'), 'stator: 5\nrotor: three\n');
  assert.equal(await page.isVisible('#motor'), true);
});

on('what is typed is there after a reload that takes longer than its address', async (page) => {
  await page.route(url(), async (route) => {
    await new Promise((done) => setTimeout(done, 1500));
    await route.continue();
  });
  await page.fill('#text', 'gearbox: half typed\n');
  const entries = await page.evaluate(() => history.length);
  await page.reload();
  await page.waitForSelector('body[data-ready]');
  assert.equal(await value(page, 'text'), 'gearbox: half typed\n');
  assert.equal(await page.evaluate(() => history.length), entries);
}, { serviceWorkers: 'block' });

on('what is typed is there after a reload while its address changes', async (page) => {
  await page.fill('#text', 'gearbox: half typed\n');
  // Chromium forgets what the history keeps of an entry whose address changes just then.
  await page.evaluate(() => {
    let left = 200;
    const change = () => {
      history.replaceState(history.state, '', `#s=${left}`);
      if (--left) setTimeout(change);
    };
    change();
  });
  await page.reload();
  await page.waitForSelector('body[data-ready]');
  assert.equal(await value(page, 'text'), 'gearbox: half typed\n');
});

on('a changed text is replaced only after a question, and is one step back', async (page) => {
  const own = example('simpson.yaml').replace(/^gearbox:.*$/m, 'gearbox: my own');
  await change(page, () => page.fill('#text', own));
  const file = { name: 'wolfrom.yaml', mimeType: 'application/yaml', buffer: Buffer.from(example('wolfrom.yaml')) };
  const ways = [() => page.selectOption('#pick', 'wolfrom.yaml'), () => page.selectOption('#pick', 'scheme II-3'), () => page.setInputFiles('#file', file)];
  for (const way of ways) {
    const asked = answered(page, false);
    await way();
    assert.match(await asked, /gearbox was changed and is not saved/);
    assert.equal(await value(page, 'text'), own);
    assert.equal(await value(page, 'pick'), '');
  }
  const asked = answered(page, true);
  await pick(page, 'wolfrom.yaml');
  await asked;
  await isTitle(page, 'Wolfrom');
  await page.goBack();
  await isTitle(page, 'my own');
  assert.equal(await value(page, 'text'), own);
  // What is saved may go.
  await Promise.all([page.waitForEvent('download'), page.click('#save')]);
  await pick(page, 'wolfrom.yaml');
  await isTitle(page, 'Wolfrom');
  // A number that was changed is a change, too; a candidate of a search asks as well.
  await pick(page, 'scheme II-3');
  await change(page, () => page.locator('#numbers input[type=text]').first().fill('2.7'));
  await page.click('#to-choose');
  await page.getByRole('button', { name: 'Find gearboxes' }).click();
  const again = answered(page, false);
  await page.getByRole('button', { name: 'Open candidate 1' }).click();
  assert.match(await again, /not saved/);
  assert.equal(await page.isVisible('#choose'), true);
});

on('a changed motor is replaced only after a question', async (page) => {
  await page.click('#to-motor');
  await page.getByLabel('Width').fill('80 mm');
  const text = await value(page, 'motor-text');
  const last = (await page.locator('#motor-pick option').evaluateAll((all) => all.map((one) => one.value))).at(-1);
  const asked = answered(page, false);
  await page.selectOption('#motor-pick', last);
  assert.match(await asked, /hydromotor was changed/);
  assert.equal(await value(page, 'motor-text'), text);
  assert.equal(await value(page, 'motor-pick'), '');
});

on('a file that is no text is refused', async (page) => {
  const text = await value(page, 'text');
  await page.setInputFiles('#file', { name: 'box.yaml', mimeType: 'application/yaml', buffer: Buffer.from([0x67, 0xff, 0xfe, 0x0a]) });
  await page.waitForSelector('#notice:not([hidden])');
  assert.match(await notice(page), /box\.yaml cannot be opened: it is no text in UTF-8/);
  assert.equal(await value(page, 'text'), text);
});

// --- numbers are what was typed ---

on('another gearbox has its lists and fields, made once, whatever else is asked meanwhile', async (page) => {
  await pick(page, 'scheme II-3');
  assert.equal(await page.isVisible('#transmission-field'), false);
  const made = await page.evaluate(async (list) => {
    const asked = (id, kind) => document.getElementById(id).dispatchEvent(new Event(kind));
    let made = 0;
    new MutationObserver(() => made++).observe(document.getElementById('numbers'), { childList: true });
    asked('power', 'change');
    document.getElementById('text').value = list;
    asked('text', 'input');
    for (let again = 0; again < 3; again++) {
      asked('power', 'change');
      await new Promise((done) => setTimeout(done, 5));
    }
    while (!document.body.dataset.change) await new Promise((done) => setTimeout(done, 20));
    return made;
  }, example('real-transmissions.yaml'));
  assert.equal(made, 1);
  assert.equal(await page.isVisible('#transmission-field'), true);
});

on('a decimal comma is refused with the number as it is written, and no field leaves it out', async (page) => {
  await pick(page, 'scheme II-3');
  const text = await value(page, 'text');
  const k = page.locator('#numbers input[type=text]').first();
  const name = await k.getAttribute('aria-label');
  assert.match(name, /: k$/);
  await k.fill('');
  await k.pressSequentially('2,154');
  assert.equal(await k.inputValue(), '2,154');
  await isRefused(page, 'refused', '2,154: decimal comma; write 2.154, or 2154 if the comma parts thousands');
  assert.match(await page.textContent('#refused'), new RegExp(`^set ${name.replace(':', ',')}: `));
  assert.equal(await value(page, 'text'), text.replace('k: 2.5', 'k: 2'), 'as far as it was a number');
  await change(page, () => k.fill('2.154'));
  assert.equal(await page.textContent('#refused'), '');
  await until(page, () => /k: 2\.154\b/.test(document.querySelector('#text').value));
  // A field that is left empty shows what the file has.
  await k.fill('');
  await k.blur();
  assert.equal(await k.inputValue(), '2.154');
  assert.match(await value(page, 'text'), /k: 2\.154\b/);
  for (const [id, typed, words] of [['efficiency', '0,97', '0.97'], ['speed', '1500,5 rpm', '1500.5 rpm'], ['torque', '400,5 N·m', '400.5 N·m']]) {
    await page.fill(`#${id}`, typed);
    await isRefused(page, 'refused', `${id}: ${typed}: decimal comma; write ${words}`);
    await change(page, () => page.fill(`#${id}`, ''));
  }
  await page.click('#to-motor');
  const stator = page.getByLabel('Lobes of the stator');
  await stator.fill('');
  await stator.pressSequentially('5,5');
  assert.equal(await stator.inputValue(), '5,5');
  await isRefused(page, 'motor-refused', '5,5: decimal comma; write 5.5');
  await page.getByLabel('Width').fill('40,5 mm');
  await page.getByLabel('Lobes of the stator').fill('5');
  await isRefused(page, 'motor-refused', '40,5 mm: decimal comma; write 40.5 mm');
  await page.click('#to-choose');
  await page.getByLabel('A ratio may be off by').fill('2,5%');
  await page.getByRole('button', { name: 'Find gearboxes' }).click();
  await isRefused(page, 'choose-refused', 'decimal comma');
  assert.equal(await page.locator('input[type=number]').count(), 0);
});

// --- what is hidden, and what is printed ---

on('what is hidden is not shown', async (page) => {
  assert.equal(await page.isVisible('#transmission-field'), true);
  await pick(page, 'simpson.yaml');
  await isTitle(page, 'Simpson');
  assert.equal(await page.isVisible('#transmission-field'), false);
  for (const name of ['gearbox', 'choose', 'motor']) {
    await page.click(`#to-${name}`);
    const shown = await page.locator('[hidden]').evaluateAll((all) => all.filter((one) => getComputedStyle(one).display !== 'none').map((one) => one.outerHTML.slice(0, 80)));
    assert.deepEqual(shown, [], name);
  }
});

on('all of a gearbox is printed, dark on white, with what is out of sight', async (page) => {
  await until(page, () => document.querySelectorAll('[data-view] .picture svg').length === 4 && !document.querySelector('.waiting'));
  assert.ok((await page.locator('.turning svg').count()) > 3);
  await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  for (const part of ['header', '.side', '.tools', '#choose', '#motor']) assert.equal(await page.locator(part).first().isVisible(), false, part);
  for (const part of ['#title', '#gears', '[data-view=ladder] svg', '.turning svg', '#gear-card table', '[data-view=tables] table']) assert.equal(await page.locator(part).first().isVisible(), true, part);
  const colours = await page.evaluate(() => ['#title', 'td', '#gears label:has(:checked) b'].map((part) => getComputedStyle(document.querySelector(part)).color));
  for (const colour of colours) assert.ok(Math.max(...colour.match(/\d+/g).slice(0, 3).map(Number)) < 100, colour);
  assert.equal(await page.evaluate(() => getComputedStyle(document.querySelector('.picture svg')).filter), 'none');
  // What is not as the numbers are now is not printed beside what is.
  const meanwhile = await page.evaluate(() => new Promise((done) => {
    const seen = () => document.body.dataset.change && done(getComputedStyle(document.querySelector('[data-view=tables] .tables')).display);
    new MutationObserver(seen).observe(document.body, { attributes: true, attributeFilter: ['data-change'] });
    document.querySelector('#gears input[value="5"]').click();
  }));
  assert.equal(meanwhile, 'none');
  await until(page, () => !document.querySelector('.waiting'));
  assert.equal(await page.locator('[data-view=tables] .tables').isVisible(), true);
}, { colorScheme: 'dark', viewport: PHONE });

// --- a newer version ---

test('a newer version is taken: at once by a page in which nothing was done, else when the person wants it', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'epicyclic-app-'));
  cpSync(app, folder, { recursive: true });
  const server = await serve(folder);
  const context = await chromium().newContext({ reducedMotion: 'reduce' });
  let version = 0;
  const newer = () => {
    const name = `newer ${++version}`;
    writeFileSync(join(folder, 'index.html'), readFileSync(join(app, 'index.html'), 'utf8').replace('<h1>epicyclic</h1>', `<h1>${name}</h1>`));
    writeFileSync(join(folder, 'sw.js'), readFileSync(join(app, 'sw.js'), 'utf8').replaceAll(/epicyclic-(?=[0-9a-f$])/g, `epicyclic-${version}-`));
    return name;
  };
  try {
    const { page, faults } = await open(context, server.url);
    await until(page, () => navigator.serviceWorker.controller);
    const isNow = (name) => until(page, (name) => document.querySelector('h1')?.textContent === name && document.body.dataset.ready, name);
    const first = newer();
    await page.reload();
    await isNow(first);
    // With something typed the person is asked, and finds it afterwards.
    await page.fill('#text', 'gearbox: half typed\n');
    const second = newer();
    await page.evaluate(() => navigator.serviceWorker.getRegistration().then((one) => one.update()));
    await page.waitForSelector('#notice:not([hidden])');
    assert.equal(await page.textContent('h1'), first);
    assert.match(await notice(page), /newer version/);
    await page.getByRole('button', { name: 'Load it' }).click();
    await isNow(second);
    assert.equal(await value(page, 'text'), 'gearbox: half typed\n');
    // No file of an older one is kept.
    assert.equal((await page.evaluate(() => caches.keys())).length, 1);
    assert.deepEqual(faults, []);
  } finally {
    await context.close();
    server.end();
  }
});
