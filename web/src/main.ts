// The app: pages, address, files.
import { ChoosePage } from './choose.js';
import { at, h, tell } from './dom.js';
import { GearboxPage } from './gearbox.js';
import { examples } from './generated/examples.js';
import { MotorPage } from './motor.js';
import { Damaged, Entries, PAGES, packed, unpacked, type Entry, type State } from './state.js';
import { upgrades } from './upgrade.js';

const example = (file: string) => examples.find((one) => one.file === file)?.text ?? '';
const first: State = {
  page: 'gearbox',
  gearbox: { file: example('real-transmissions.yaml'), name: 'real-transmissions.yaml', transmission: 'ZF 8HP45 / 8HP30-I (2010)', gear: '3', speed: '', torque: '', efficiency: '', power: true },
  choose: { speeds: '0.8 m/s, 3.15 m/s' },
  motor: example('motor-5x3.yaml'),
};

const isMotor = (text: string) => /^(stator|rotor):/m.test(text);

/** A message above the page that stays until it is closed; an action closes it, too. */
function notify(message: string, actions: [label: string, act: () => void][] = []): void {
  const notice = at('notice');
  const close = (act?: () => void) => () => {
    notice.hidden = true;
    act?.();
  };
  const buttons = [...actions, ['Close', undefined] as const].map(([label, act]) => h('button', { type: 'button', onclick: close(act) }, label));
  notice.replaceChildren(h('p', {}, message), ...buttons);
  notice.hidden = false;
}

const entries = new Entries();
const begun = (state: State): Entry => ({ state: structuredClone(state), edited: { gearbox: false, motor: false }, served: null });

/** The file that `epicyclic serve` was given; in words why it is not there. */
async function fileOfServe(): Promise<{ file: string } | { why: string }> {
  let reply;
  try {
    reply = await fetch('opened', { cache: 'no-store' });
  } catch {
    return { why: 'epicyclic serve has ended, so the file it was given cannot be read. Start it again and open the address it prints.' };
  }
  const text = await reply.text();
  if (reply.ok) return { file: text };
  return { why: reply.status === 404 ? 'No file was given to epicyclic serve. Start it with one: epicyclic serve gearbox.yaml.' : text };
}

/** A state with another file on its page. */
function withFile(state: State, file: string): State {
  if (isMotor(file)) return { ...state, page: 'motor', motor: file };
  return { ...state, page: 'gearbox', gearbox: { ...state.gearbox, file, name: '', transmission: null, gear: null } };
}

/** What the address shows; of one that shows nothing why, and what stays. */
async function ofAddress(stays: Entry): Promise<Entry> {
  const { hash } = location;
  if (hash.startsWith('#s=')) {
    try {
      return begun(await unpacked(hash.slice(3), first));
    } catch (error) {
      if (!(error instanceof Damaged)) throw error;
      notify(`The link cannot be opened: ${error.message}. Copy the whole link again.`);
      return stays;
    }
  }
  if (hash === '#open') {
    const found = await fileOfServe();
    if ('file' in found) return { ...begun(withFile(first, found.file)), served: found.file };
    notify(found.why);
    return stays;
  }
  const page = PAGES.find((page) => hash === `#${page}`);
  return page ? { ...stays, state: { ...stays.state, page } } : stays;
}

/** An entry that began with the file of `epicyclic serve`, with the file as it is now: what was changed in the page stays. */
async function servedAgain(entry: Entry): Promise<Entry> {
  if (entry.served === null) return entry;
  const found = await fileOfServe();
  if ('why' in found) {
    notify(`${found.why} The page shows the file as it was read last.`);
    return entry;
  }
  if (found.file === entry.served) return entry;
  const again = { ...begun(withFile(entry.state, found.file)), served: found.file };
  const { gearbox, motor } = entry.state;
  const isEdited = isMotor(entry.served) ? entry.edited.motor && motor !== entry.served : entry.edited.gearbox && gearbox.file !== entry.served;
  if (!isEdited) {
    // The gear that was looked at may be there still.
    again.state.gearbox = { ...again.state.gearbox, transmission: gearbox.transmission, gear: gearbox.gear };
    return again;
  }
  notify('The file has changed since it was opened, and so has its text in this page.', [['Read the file again', () => (step(), void go(again))]]);
  return { ...entry, served: found.file };
}

let entry: Entry = begun(first);
let timer: ReturnType<typeof setTimeout> | undefined;
// An address that changes while the page is loaded again makes that a new entry of the history, without what this one keeps.
let isLeft = false;
addEventListener('beforeunload', () => (isLeft = true));
// Whoever goes on has stayed.
for (const kind of ['pointerdown', 'keydown']) addEventListener(kind, () => (isLeft = false), { capture: true });

/** Keeps what is shown, at once; its address follows. */
function changed(): void {
  entries.keep(entry);
  clearTimeout(timer);
  timer = setTimeout(() => void address(), 400);
}

/** The address with all that is shown. */
async function address(): Promise<string> {
  const kept = entry;
  const link = `${location.origin}${location.pathname}#s=${await packed(entry.state)}`;
  // Meanwhile somebody may have gone back.
  if (kept === entry && !isLeft && !entries.hasMoved) {
    try {
      entries.address(link);
    } catch {
      tell('The text is too long for an address; save it as a file.');
    }
  }
  return link;
}

/** Whether the text of a page may be replaced; then it stays one step back in the history. */
function leave(page: 'gearbox' | 'motor'): boolean {
  const question = `The text of the ${page === 'motor' ? 'hydromotor' : 'gearbox'} was changed and is not saved as a file. Replace it?`;
  if (entry.edited[page] && !confirm(question)) return false;
  step();
  entry.edited[page] = false;
  entry.served = null;
  return true;
}

/** A new entry in the history, which begins as the last one. */
function step(): void {
  entries.keep(entry);
  entries.add();
  entry = structuredClone(entry);
  gearbox.state = entry.state.gearbox;
  changed();
}

const of = (page: 'gearbox' | 'motor') => ({
  changed: (isEdit = false) => {
    if (isEdit) entry.edited[page] = true;
    entry.state.motor = motor.file;
    changed();
  },
  leave: () => leave(page),
  saved: () => {
    entry.edited[page] = false;
    changed();
  },
});

const gearbox = new GearboxPage(entry.state.gearbox, of('gearbox'));
const choose = new ChoosePage(
  entry.state.choose,
  (values) => {
    entry.state.choose = values;
    changed();
  },
  (file, name) => {
    if (!leave('gearbox')) return;
    show('gearbox');
    void gearbox.open(file, name);
  },
);
const motor = new MotorPage(entry.state.motor, of('motor'));
at('main').append(gearbox.element, choose.element, motor.element);

function show(page: State['page']): void {
  entry.state.page = page;
  for (const [name, { element }] of Object.entries({ gearbox, choose, motor })) element.hidden = name !== page;
  for (const link of document.querySelectorAll<HTMLElement>('nav a')) {
    if (link.dataset['page'] === page) link.setAttribute('aria-current', 'page');
    else link.removeAttribute('aria-current');
  }
  motor.open = page === 'motor';
  changed();
}

/** Shows an entry in place of the one that is shown. */
async function go(to: Entry): Promise<void> {
  entry = to;
  choose.fill(entry.state.choose);
  motor.load(entry.state.motor);
  show(entry.state.page);
  await gearbox.restore(entry.state.gearbox);
}

/** Follows the browser: back, forward, another link in the same tab. */
async function moved(): Promise<void> {
  if (!entries.hasMoved) return;
  clearTimeout(timer);
  const kept = entries.enter(first);
  at('notice').hidden = true;
  await go(kept ?? (await ofAddress(structuredClone(entry))));
}
addEventListener('popstate', () => void moved());
addEventListener('hashchange', () => void moved());

for (const link of document.querySelectorAll<HTMLElement>('nav a')) {
  link.addEventListener('click', (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    const page = link.dataset['page'] as State['page'];
    if (page === entry.state.page) return;
    step();
    show(page);
  });
}
at('open').addEventListener('click', () => at<HTMLInputElement>('file').click());
at<HTMLInputElement>('file').addEventListener('change', async (event) => {
  const input = event.target as HTMLInputElement;
  const file = input.files?.[0];
  if (!file) return;
  const bytes = await file.arrayBuffer();
  input.value = '';
  let text;
  try {
    text = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return notify(`${file.name} cannot be opened: it is no text in UTF-8.`);
  }
  const page = isMotor(text) ? 'motor' : 'gearbox';
  if (!leave(page)) return;
  if (page === 'motor') motor.load(text);
  show(page);
  if (page === 'gearbox') await gearbox.open(text, '');
  tell(`${file.name} is open.`);
});
at('save').addEventListener('click', () => (entry.state.page === 'motor' ? motor.save() : gearbox.save()));
at('share').addEventListener('click', async () => {
  clearTimeout(timer);
  const link = await address();
  try {
    await navigator.clipboard.writeText(link);
    tell('The link is copied: it holds the gearbox and all that is shown.');
  } catch {
    tell('The link is in the address bar.');
  }
});

const kept = entries.enter(first);
const begin = kept ? await servedAgain(kept) : await ofAddress(entry);
// What is typed before would be replaced.
at('main').inert = false;
await go(begin);
performance.mark('ready');
document.body.dataset['ready'] = performance.now().toFixed(0);
upgrades(notify);
