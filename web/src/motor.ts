// The page of a hydromotor: its numbers, its figures, its chambers as they fill.
import { core, Failure, Overtaken } from './core.js';
import { at, h, s, save, tell, type Host } from './dom.js';
import { download } from './download.js';
import { tabled } from './gearbox.js';
import { examples } from './generated/examples.js';
import type { Motor, MotorMoving } from './generated/answers.js';

const FIELDS: [key: string, label: string, hint: string, kind: 'count' | 'text'][] = [
  ['stator', 'Lobes of the stator N', '', 'count'],
  ['rotor', 'Lobes of the rotor n', '', 'count'],
  ['z3', 'Teeth of the stator Z₃', '', 'count'],
  ['zs', 'Teeth of a satellite Z_s', '', 'count'],
  ['module', 'Module', '2 mm', 'text'],
  ['part', 'Part of the family, 0 to 1', '0.5', 'text'],
  ['width', 'Width', '40 mm', 'text'],
  ['pressure', 'Pressure drop', '20 MPa', 'text'],
  ['speed', 'Speed of the rotor', '100 rpm', 'text'],
];
const FRAMES = 90;
const degrees = (radians: number) => (radians * 180) / Math.PI;

/** The page. */
export class MotorPage {
  readonly element: HTMLElement;
  private picture = h('div', { id: 'chambers' });
  private tables = h('div', { class: 'tables' });
  private key = h('dl', { class: 'key' });
  private play: HTMLButtonElement;
  private angle: HTMLInputElement;
  private speed: HTMLInputElement;
  private caption = h('p', { class: 'note' });
  private moving: MotorMoving | null = null;
  private show: ((lobe: number, frame: number) => void) | null = null;
  private turned = 0;
  private last: number | null = null;
  private isPlaying = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  private isOpen = false;

  constructor(
    public file: string,
    private host: Host,
  ) {
    this.play = h('button', { type: 'button', onclick: () => this.toggle() }, this.isPlaying ? 'Pause' : 'Play');
    this.speed = h('input', { type: 'range', min: '1', max: '60', step: '1', value: '8', 'aria-label': 'Degrees of the rotor in a second' });
    this.angle = h('input', { type: 'range', min: '0', max: '360', step: '1', value: '0', 'aria-label': 'Angle of the rotor in degrees', oninput: () => this.stand() });
    this.element = h('div', { class: 'page', id: 'motor' }, this.side(), this.results());
    const step = (now: number) => {
      if (this.isPlaying && this.isOpen && this.last !== null) {
        this.turned += ((now - this.last) / 1000) * Number(this.speed.value);
        this.place();
      }
      this.last = now;
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
    this.fill();
  }

  /** Whether the page is on the screen. */
  set open(is: boolean) {
    if (is && !this.isOpen && !this.moving) void this.update();
    this.isOpen = is;
  }

  /** Another motor, as its file. */
  load(file: string): void {
    this.file = file;
    this.host.changed();
    this.fill();
    this.moving = null;
    if (this.isOpen) void this.update();
  }

  private side(): HTMLElement {
    const motors = examples.filter(({ kind }) => kind === 'motor');
    const pick = h(
      'select',
      { id: 'motor-pick', onchange: () => this.pick(pick.value) },
      h('option', { value: '' }, '– own numbers –'),
      ...motors.map(({ file, text }) => h('option', { value: file }, /^title: *(.+)$/m.exec(text)?.[1] ?? file)),
    );
    const field = ([key, label, hint, kind]: (typeof FIELDS)[number]) =>
      h(
        'label',
        { class: 'field' },
        h('span', {}, label),
        h('input', { id: `motor-${key}`, type: 'text', inputmode: kind === 'count' ? 'numeric' : null, placeholder: hint, autocomplete: 'off', oninput: (event) => this.set(key, (event.target as HTMLInputElement).value.trim()) }),
      );
    const text = h('textarea', { id: 'motor-text', spellcheck: 'false', oninput: () => this.write(text.value) });
    return h(
      'div',
      { class: 'side' },
      h('section', { class: 'card', 'aria-label': 'Which motor' }, h('label', { class: 'field' }, h('span', {}, 'Hydromotor'), pick), h('div', { class: 'fields' }, ...FIELDS.map(field)), h('div', { class: 'refused', id: 'motor-refused', role: 'alert' })),
      h('details', { class: 'card' }, h('summary', {}, 'File (YAML)'), h('label', {}, h('span', { class: 'note' }, 'With oil, gaps, friction, ports and more keys than the fields above.'), text)),
    );
  }

  private results(): HTMLElement {
    const view = (name: string, label: string) => h('button', { type: 'button', onclick: () => void this.download(name, label) }, label);
    return h(
      'div',
      {},
      h(
        'section',
        { class: 'card', 'aria-label': 'Chambers' },
        h('div', { class: 'head' }, h('h2', { id: 'motor-title' }, 'Chambers as the rotor turns'), h('div', { class: 'tools' }, this.play, h('label', {}, 'speed ', this.speed), h('label', {}, 'angle ', this.angle))),
        h('div', { class: 'motor' }, this.picture, h('div', {}, this.key, h('ul', { class: 'legend' }, ...[['filling', 'filling, high pressure'], ['emptying', 'emptying, low pressure'], ['changing_over', 'changing over']].map(([state, words]) => h('li', {}, h('i', { class: `swatch c-${state}` }), words!))), this.caption)),
      ),
      h(
        'section',
        { class: 'card', 'aria-label': 'Drawings', style: 'margin-top:1rem' },
        h('div', { class: 'head' }, h('h2', {}, 'Drawings'), h('div', { class: 'tools' }, view('dimensions.pdf', 'Dimensions PDF'), view('teeth.dxf', 'Teeth DXF'), view('teeth.svg', 'Teeth SVG'), view('chambers.svg', 'Chambers SVG'))),
        h('p', { class: 'note' }, 'Drawings for an office and for CAD, in millimetres.'),
      ),
      h('section', { class: 'card', 'aria-label': 'Figures', style: 'margin-top:1rem' }, h('h2', {}, 'Figures'), this.tables),
    );
  }

  /** One key of the file, written or left out. */
  private set(key: string, value: string): void {
    const line = new RegExp(`^${key}:.*\\n?`, 'm');
    let file = this.file.replace(line, '');
    // The three ways to choose one motor of a family exclude each other.
    if (key === 'part') file = file.replace(/^(l|a):.*\n?/gm, '');
    if (value) file = `${file.replace(/\n*$/, '\n')}${key}: ${value}\n`;
    at<HTMLTextAreaElement>('motor-text').value = file;
    this.edit(file);
  }

  /** The text as it was written. */
  private write(file: string): void {
    this.edit(file);
    this.fields();
  }

  private edit(file: string): void {
    this.file = file;
    this.host.changed(true);
    at<HTMLSelectElement>('motor-pick').value = '';
    void this.update();
  }

  private pick(value: string): void {
    const example = examples.find(({ file }) => file === value);
    if (example && this.host.leave()) this.load(example.text);
    else this.fill();
  }

  private fill(): void {
    this.element.querySelector<HTMLTextAreaElement>('#motor-text')!.value = this.file;
    this.element.querySelector<HTMLSelectElement>('#motor-pick')!.value = examples.find(({ text }) => text === this.file)?.file ?? '';
    this.fields();
  }

  private fields(): void {
    for (const [key] of FIELDS) {
      const found = new RegExp(`^${key}: *([^#\\n]*)`, 'm').exec(this.file)?.[1]?.trim() ?? '';
      this.element.querySelector<HTMLInputElement>(`#motor-${key}`)!.value = found;
    }
  }

  /** Calculates anew. */
  async update(): Promise<void> {
    try {
      const { motor, key, tables } = await core.motor(this.file);
      at('motor-refused').textContent = '';
      tabled(this.tables, tables);
      this.figures(motor, key);
      this.moving = await core.moving(this.file, FRAMES);
      this.draw(this.moving);
    } catch (error) {
      if (error instanceof Overtaken) return;
      const place = error instanceof Failure ? error.refused.place : null;
      at('motor-refused').textContent = (place ? `Line ${place.line}${place.path ? `, ${place.path}` : ''}: ` : '') + (error instanceof Error ? error.message : String(error));
    }
  }

  private figures({ numbers }: Motor, key: [string, string][]): void {
    at('motor-title').textContent = `Motor ${numbers.stator_lobes}×${numbers.rotor_lobes}: chambers as the rotor turns`;
    const shown = (name: string) => name.charAt(0).toUpperCase() + name.slice(1);
    this.key.replaceChildren(...key.map(([name, value]) => h('div', {}, h('dt', {}, shown(name)), h('dd', {}, value))));
  }

  private draw(moving: MotorMoving): void {
    const mm = (points: number[][]) => `M${points.map(([x, y]) => `${(x! * 1000).toFixed(3)} ${(y! * 1000).toFixed(3)}`).join('L')}Z`;
    const reach = 1000 * Math.max(...moving.stator_m.map(([x, y]) => Math.hypot(x!, y!)));
    const wall = reach * 1.09;
    const outside = 0.99 * wall;
    const ring = `M${outside} 0A${outside} ${outside} 0 1 0 ${-outside} 0A${outside} ${outside} 0 1 0 ${outside} 0Z`;
    const rotor = s('g', {}, s('path', { class: 'c-steel g-edge', d: mm(moving.rotor_m) }), s('circle', { class: 'g-mark', cx: 0.72 * 1000 * Math.min(...moving.rotor_m.map(([x, y]) => Math.hypot(x!, y!))), cy: 0, r: 0.018 * reach }), s('circle', { class: 'g-hole g-edge', r: 0.16 * reach }));
    const first = moving.frames[0]!;
    const satellites = first.satellites.map(() => s('g', {}, s('path', { class: 'c-steel g-edge', d: mm(moving.satellite_m) }), s('circle', { class: 'g-mark', cx: 0.6 * 1000 * Math.max(...moving.satellite_m.map(([x, y]) => Math.hypot(x!, y!))), cy: 0, r: 0.012 * reach })));
    const chambers = first.chambers.map(() => s('path', {}));
    const outlines = moving.frames.map((frame) => frame.chambers.map((chamber) => mm(chamber.outline_m)));
    const svg = s(
      'svg',
      { viewBox: `${-wall} ${-wall} ${2 * wall} ${2 * wall}`, role: 'img', 'aria-label': 'The hydromotor with its chambers, coloured by pressure' },
      s('g', { transform: 'scale(1 -1)' }, s('path', { class: 'g-hole', d: mm(moving.stator_m) }), ...chambers, s('path', { class: 'g-ring g-edge', 'fill-rule': 'evenodd', d: `${mm(moving.stator_m)}${ring}` }), rotor, ...satellites),
    );
    const count = moving.frames.length;
    const lobes = Math.round((2 * Math.PI) / (moving.step_rad * count));
    this.show = (lobe, index) => {
      const frame = moving.frames[index]!;
      const lobeTurn = (lobe * 2 * Math.PI) / lobes;
      rotor.setAttribute('transform', `rotate(${degrees(frame.rotor_rad + lobeTurn).toFixed(3)})`);
      satellites.forEach((satellite, place) => {
        // A lobe on, each satellite stands where the next one stood.
        const now = frame.satellites[(place + lobe) % satellites.length]!;
        const turn = now.turn_rad + Math.floor((place + lobe) / satellites.length) * moving.round_turn_rad;
        const [x, y] = now.centre_m as [number, number];
        satellite.setAttribute('transform', `translate(${(x * 1000).toFixed(3)} ${(y * 1000).toFixed(3)}) rotate(${degrees(turn).toFixed(3)})`);
      });
      frame.chambers.forEach(({ state }, place) => {
        chambers[place]!.setAttribute('d', outlines[index]![place]!);
        chambers[place]!.setAttribute('class', `c-${state} g-edge`);
      });
      const counts = { filling: 0, emptying: 0, changing_over: 0 };
      for (const { state } of frame.chambers) counts[state]++;
      this.caption.textContent = `${counts.filling} chambers fill, ${counts.emptying} empty${counts.changing_over ? `, ${counts.changing_over} change over` : ''}. The dots turn with rotor and satellites.${moving.has_teeth ? '' : ' Pitch curves: this motor has no teeth of the form given.'}`;
    };
    this.picture.replaceChildren(svg);
    this.place();
  }

  private place(): void {
    if (!this.moving || !this.show) return;
    const step = degrees(this.moving.step_rad);
    const index = Math.floor(this.turned / step);
    const count = this.moving.frames.length;
    this.show(Math.floor(index / count), ((index % count) + count) % count);
    if (this.isPlaying) this.angle.value = String(Math.round(this.turned) % 360);
  }

  private toggle(): void {
    this.isPlaying = !this.isPlaying;
    this.play.textContent = this.isPlaying ? 'Pause' : 'Play';
  }

  private stand(): void {
    if (this.isPlaying) this.toggle();
    this.turned = Number(this.angle.value);
    this.place();
  }

  private async download(name: string, label: string): Promise<void> {
    tell(`${label} …`);
    await download(['draw', 'motor.yaml', '--view', name.split('.')[0]!], this.file, `motor-${name}`);
  }

  /** Saves the file. */
  save(): void {
    save('motor.yaml', this.file, 'application/yaml');
    this.host.saved();
    tell('The hydromotor is saved as a file.');
  }
}

