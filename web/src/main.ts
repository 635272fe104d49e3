// The app: pages, address, files.
import { ChoosePage } from './choose.js';
import { at, tell } from './dom.js';
import { GearboxPage } from './gearbox.js';
import { examples } from './generated/examples.js';
import { MotorPage } from './motor.js';
import { packed, unpacked, type State } from './state.js';

const example = (file: string) => examples.find((one) => one.file === file)?.text ?? '';
const first: State = {
  page: 'gearbox',
  gearbox: { file: example('real-transmissions.yaml'), name: 'real-transmissions.yaml', transmission: 'ZF 8HP45 / 8HP30-I (2010)', gear: '3', speed: '', torque: '', efficiency: '', power: true },
  choose: { speeds: '0.8 m/s, 3.15 m/s' },
  motor: example('motor-5x3.yaml'),
};

const shared = location.hash.startsWith('#s=') ? await unpacked(location.hash.slice(3)) : null;
if (location.hash.startsWith('#s=') && !shared) tell('The link is damaged; this is the first example.');
const state: State = { ...first, ...shared, gearbox: { ...first.gearbox, ...shared?.gearbox } };

const isMotor = (text: string) => /^(stator|rotor):/m.test(text);

/** The file that `epicyclic serve` was given. */
async function served(): Promise<void> {
  const reply = await fetch('opened');
  if (!reply.ok) return tell('There is no file to open here; this is the first example.');
  const file = await reply.text();
  if (isMotor(file)) {
    state.page = 'motor';
    state.motor = file;
  } else state.gearbox = { ...first.gearbox, file, name: '', transmission: null, gear: null };
}
if (location.hash === '#open') await served();

let timer: ReturnType<typeof setTimeout> | undefined;
function changed(): void {
  state.gearbox = gearbox.state;
  state.choose = choose.values;
  state.motor = motor.file;
  clearTimeout(timer);
  timer = setTimeout(() => void packed(state).then((text) => history.replaceState(null, '', `#s=${text}`)), 400);
}

const gearbox = new GearboxPage(state.gearbox, changed);
const choose = new ChoosePage(state.choose, changed, (file, name) => {
  show('gearbox');
  void gearbox.open(file, name);
});
const motor = new MotorPage(state.motor, changed);
at('main').append(gearbox.element, choose.element, motor.element);

function show(page: State['page']): void {
  state.page = page;
  for (const [name, { element }] of Object.entries({ gearbox, choose, motor })) element.hidden = name !== page;
  for (const link of document.querySelectorAll<HTMLElement>('nav a')) {
    if (link.dataset['page'] === page) link.setAttribute('aria-current', 'page');
    else link.removeAttribute('aria-current');
  }
  motor.open = page === 'motor';
}

for (const link of document.querySelectorAll<HTMLElement>('nav a')) {
  link.addEventListener('click', (event) => {
    event.preventDefault();
    show(link.dataset['page'] as State['page']);
    changed();
  });
}
at('open').addEventListener('click', () => at<HTMLInputElement>('file').click());
at<HTMLInputElement>('file').addEventListener('change', async (event) => {
  const input = event.target as HTMLInputElement;
  const file = input.files?.[0];
  if (!file) return;
  const text = await file.text();
  input.value = '';
  show(isMotor(text) ? 'motor' : 'gearbox');
  if (isMotor(text)) motor.load(text);
  else await gearbox.open(text, '');
  tell(`${file.name} is open.`);
});
at('save').addEventListener('click', () => (state.page === 'motor' ? motor.save() : gearbox.save()));
at('share').addEventListener('click', async () => {
  const link = `${location.origin}${location.pathname}#s=${await packed(state)}`;
  history.replaceState(null, '', link);
  try {
    await navigator.clipboard.writeText(link);
    tell('The link is copied: it holds the gearbox and all that is shown.');
  } catch {
    tell('The link is in the address bar.');
  }
});

show(state.page);
await gearbox.update(true);
performance.mark('ready');
document.body.dataset['ready'] = performance.now().toFixed(0);
if ('serviceWorker' in navigator && location.protocol.startsWith('http')) void navigator.serviceWorker.register('sw.js');
