// The page of a gearbox: pick or edit one, and see all of it change at once.
import { core, taken, Failure, Overtaken, type Look, type Picture, type PictureName, type Question } from './core.js';
import { at, h, save, shown, tell, type Host } from './dom.js';
import { examples } from './generated/examples.js';
import type { AdjustableNumber } from './generated/adjust.js';
import { download } from './download.js';
import { Turning } from './turning.js';
import type { GearboxState } from './state.js';

const SCHEMES = ['I', 'II', 'III', 'I-1', 'I-2', 'I-3', 'I-4', 'II-1', 'II-2', 'II-3', 'II-4', 'III-1', 'III-2', 'III-3'];
const KINDS: Record<AdjustableNumber['of'], string> = { k: 'k', sun_teeth: 'teeth of the sun', ring_teeth: 'teeth of the ring' };
/** What was chosen of another file, by the names of the refusals of a file that has no such. */
const CHOSEN: Record<string, 'gear' | 'transmission'> = { 'no-gear': 'gear', 'no-transmission': 'transmission', 'one-gearbox': 'transmission' };

interface View {
  name: PictureName;
  title: string;
  card: HTMLElement;
  picture: HTMLElement;
  isSeen: boolean;
}

/** The page, and what it shows. */
export class GearboxPage {
  readonly element: HTMLElement;
  private views: View[] = [];
  private tables!: HTMLElement;
  private gearTables!: HTMLElement;
  private turning: Turning;
  private look: Look | null = null;
  private tablesSeen = { all: false, gear: false };
  private tableTimer: ReturnType<typeof setTimeout> | undefined;
  private restTimer: ReturnType<typeof setTimeout> | undefined;
  /** What pictures and tables were asked of last. */
  private drawnOf = '';
  /** Milliseconds from the last change to the pictures on the page. */
  lastChange = 0;
  /** How many gearboxes were opened, and how many changes asked for: what comes late of another gearbox is dropped. */
  private opened = 0;
  private asked = 0;
  private updated: Promise<void> = Promise.resolve();
  /** Whether the gearbox is another than the one whose gears and numbers can be chosen. */
  private isAnother = true;
  /** The file that was answered last with its numbers, and which of them were changed since: what is half typed may be no gearbox. */
  private answered: { file: string; numbers: AdjustableNumber[] } = { file: '', numbers: [] };
  private changes = new Map<number, string>();

  constructor(
    public state: GearboxState,
    private host: Host,
  ) {
    this.turning = new Turning();
    this.element = h('div', { class: 'page', id: 'gearbox' }, this.side(), this.results());
    const seen = new IntersectionObserver((entries) => this.seen(entries), { rootMargin: '20px' });
    for (const card of this.element.querySelectorAll('[data-view]')) seen.observe(card);
    this.fill();
  }

  /** Another gearbox, as its file. */
  async open(file: string, name: string): Promise<void> {
    await this.restore(Object.assign(this.state, { file, name, transmission: null, gear: null }));
  }

  /** All that the page shows, as it was. */
  async restore(state: GearboxState): Promise<void> {
    this.state = state;
    this.another();
    this.fill();
    this.host.changed();
    let updated;
    void this.update();
    // One that is overtaken has shown nothing.
    do await (updated = this.updated);
    while (updated !== this.updated);
  }

  private another(): void {
    this.opened++;
    this.isAnother = true;
    this.answered = { file: this.state.file, numbers: [] };
    this.changes.clear();
  }

  // --- what can be chosen ---

  private side(): HTMLElement {
    const option = (value: string, text: string) => h('option', { value }, text);
    const gearboxes = examples.filter((example) => example.kind === 'gearbox');
    const pick = h(
      'select',
      { id: 'pick', onchange: () => void this.pick(pick.value) },
      option('', '– own file –'),
      h('optgroup', { label: 'Examples' }, ...gearboxes.map(({ file, text }) => option(file, titled(file, text)))),
      h('optgroup', { label: 'Catalogue of two and three speeds' }, ...SCHEMES.map((name) => option(`scheme ${name}`, `Scheme ${name}`))),
    );
    const set = (key: 'speed' | 'torque' | 'efficiency') => (event: Event) => {
      this.state[key] = (event.target as HTMLInputElement).value.trim();
      this.host.changed();
      void this.update();
    };
    const field = (key: 'speed' | 'torque' | 'efficiency', label: string, hint: string) =>
      h('label', { class: 'field' }, h('span', {}, label), h('input', { id: key, placeholder: hint, autocomplete: 'off', oninput: set(key) }));
    const file = h('textarea', {
      id: 'text',
      spellcheck: 'false',
      autocomplete: 'off',
      'aria-describedby': 'refused',
      onfocus: () => this.write(),
      oninput: () => {
        Object.assign(this.state, { file: file.value, name: '' });
        this.host.changed(true);
        this.another();
        at<HTMLSelectElement>('pick').value = '';
        void this.update();
      },
    });
    return h(
      'div',
      { class: 'side' },
      h(
        'section',
        { class: 'card', 'aria-label': 'Which gearbox' },
        h('label', { class: 'field' }, h('span', {}, 'Gearbox'), pick),
        h('label', { class: 'field', id: 'transmission-field', hidden: true }, h('span', {}, 'Transmission of the list'), h('select', { id: 'transmission', onchange: (event) => this.choose((event.target as HTMLSelectElement).value) })),
        h('p', { class: 'note', id: 'about' }),
        h('div', { class: 'refused', id: 'refused', role: 'alert' }),
      ),
      h('section', { class: 'card', 'aria-label': 'Sets' }, h('h2', {}, 'Sets'), h('div', { id: 'numbers' })),
      h(
        'section',
        { class: 'card', 'aria-label': 'Input' },
        h('h2', {}, 'Input'),
        h('div', { class: 'fields' }, field('speed', 'Speed', '1500 rpm'), field('torque', 'Torque', '400 N·m')),
        field('efficiency', 'Efficiency of each set, carrier fixed', '0.98'),
      ),
      h('details', { class: 'card', open: innerWidth > 900 }, h('summary', {}, 'File (YAML)'), h('label', {}, h('span', { class: 'note' }, 'Sets, brakes, clutches and gears; every change is calculated at once.'), file)),
    );
  }

  private async pick(value: string): Promise<void> {
    if (!value || !this.host.leave()) return this.fill();
    if (value.startsWith('scheme ')) {
      delete document.body.dataset['change'];
      const name = value.slice(7);
      await this.open((await core.scheme(name, 2.5, 2.5)).file, value);
    } else {
      const example = examples.find(({ file }) => file === value);
      if (example) await this.open(example.text, value);
    }
  }

  private choose(transmission: string): void {
    Object.assign(this.state, { transmission: transmission || null, gear: null });
    this.host.changed();
    this.another();
    void this.update();
  }

  /** The fields as the state has them. */
  private fill(): void {
    const find = <T extends HTMLElement>(id: string) => this.element.querySelector<T>(`#${id}`)!;
    const { file, name } = this.state;
    find<HTMLTextAreaElement>('text').value = file;
    find<HTMLSelectElement>('pick').value = name;
    if (find<HTMLSelectElement>('pick').selectedIndex < 0) find<HTMLSelectElement>('pick').value = '';
    for (const key of ['speed', 'torque', 'efficiency'] as const) find<HTMLInputElement>(key).value = this.state[key];
    find('about').textContent = comment(file);
    find<HTMLInputElement>('power').checked = this.state.power;
  }

  // --- what is shown ---

  private results(): HTMLElement {
    const view = (name: PictureName, title: string, extra: Node[] = []) => {
      const picture = h('div', { class: 'picture', tabindex: '0', role: 'group', 'aria-label': title });
      const save = (kind: 'svg' | 'dxf' | 'pdf') => h('button', { type: 'button', 'aria-label': `${title} as ${kind.toUpperCase()}`, onclick: () => void this.download(name, kind) }, kind.toUpperCase());
      const enlarge = h('button', { type: 'button', class: 'enlarge', 'aria-pressed': 'false', 'aria-label': `Enlarge ${title.toLowerCase()}`, onclick: () => enlarge.setAttribute('aria-pressed', String(picture.classList.toggle('large'))) }, 'Enlarge');
      const tools = h('div', { class: 'tools' }, ...extra, enlarge, save('svg'), save('dxf'), save('pdf'));
      const card = h('section', { class: 'card', 'data-view': name, 'aria-label': title }, h('div', { class: 'head' }, h('h2', {}, title), tools), picture);
      this.views.push({ name, title, card, picture, isSeen: false });
      return card;
    };
    const power = h('label', {}, h('input', { type: 'checkbox', id: 'power', onchange: (event) => this.show((event.target as HTMLInputElement).checked) }), ' power flow');
    this.tables = h('div', { class: 'tables' });
    this.gearTables = h('div', { class: 'tables' });
    const csv = h('button', { type: 'button', onclick: () => void this.saveTable('csv') }, 'CSV');
    const json = h('button', { type: 'button', onclick: () => void this.saveTable('json') }, 'JSON');
    const report = h('button', { type: 'button', onclick: () => void this.saveReport() }, 'Report (HTML)');
    return h(
      'div',
      {},
      h('section', { class: 'card', 'aria-label': 'Gears' }, h('h2', { id: 'title' }, ' '), h('fieldset', { class: 'gears', id: 'gears', 'aria-label': 'Gear' })),
      h(
        'div',
        { class: 'views' },
        view('scheme', 'Scheme', [power]),
        this.turning.element,
        view('speeds', 'Speed diagram'),
        view('levers', 'Lever diagram'),
        view('ladder', 'Ratios'),
        h('section', { class: 'card whole', 'data-view': 'gear_tables', id: 'gear-card', 'aria-label': 'The gear in full' }, h('h2', {}, 'The gear in full'), this.gearTables),
        h('section', { class: 'card whole', 'data-view': 'tables', 'aria-label': 'All gears' }, h('div', { class: 'head' }, h('h2', {}, 'All gears'), h('div', { class: 'tools' }, csv, json, report)), this.tables),
      ),
    );
  }

  private seen(entries: IntersectionObserverEntry[]): void {
    let isNew = false;
    for (const { target, isIntersecting } of entries) {
      const name = (target as HTMLElement).dataset['view'];
      if (name === 'tables') this.tablesSeen.all = isIntersecting;
      else if (name === 'gear_tables') this.tablesSeen.gear = isIntersecting;
      else if (name === 'turning') this.turning.isSeen = isIntersecting;
      else for (const view of this.views) if (view.name === name) view.isSeen = isIntersecting;
      isNew ||= isIntersecting;
    }
    if (isNew) void this.update();
  }

  private show(power: boolean): void {
    this.state.power = power;
    this.host.changed();
    void this.update();
  }

  private question(): Question {
    const { transmission, gear, speed, torque, efficiency } = this.state;
    return { transmission, gear, speed: speed || null, torque: torque || null, efficiency: efficiency || null };
  }

  /** Views that the gear has a picture for. */
  private drawable(): View[] {
    return this.views.filter(({ name }) => name !== 'speeds' || this.state.gear !== null);
  }

  /** All that pictures and tables are of. */
  private shows(): string {
    return JSON.stringify([this.state.file, this.question(), this.state.power]);
  }

  private named(view: View): PictureName {
    return view.name === 'scheme' && this.state.power && this.state.gear !== null ? 'power' : view.name;
  }

  /** Calculates and draws anew what is seen. */
  private update(): Promise<void> {
    return (this.updated = this.calculated());
  }

  private async calculated(): Promise<void> {
    const began = performance.now();
    delete document.body.dataset['change'];
    const [opened, asked, { file }] = [this.opened, ++this.asked, this.state];
    const wanted = this.drawable().filter(({ isSeen }) => isSeen);
    const question = this.question();
    try {
      const look = await this.looked({ ...question, pictures: wanted.map((view) => this.named(view)), list: this.isAnother });
      if (opened !== this.opened) return;
      if (look.transmissions && !look.analyze) {
        this.state.transmission = look.transmissions.transmissions[0]?.name ?? null;
        return this.update();
      }
      // Of several that were asked meanwhile the first one makes the fields: somebody may be typing into them when the others come.
      const { isAnother } = this;
      this.isAnother = false;
      if (isAnother) this.transmissions((look.transmissions?.transmissions ?? []).map(({ name }) => name));
      this.look = look;
      at('refused').textContent = '';
      this.facts(look, isAnother);
      const of = this.shows();
      if (of !== this.drawnOf) this.markOld();
      this.drawnOf = of;
      for (const view of wanted) drawn(view.picture, look.pictures?.[this.named(view)]);
      this.lastChange = performance.now() - began;
      if (asked === this.asked) document.body.dataset['change'] = this.lastChange.toFixed(2);
      this.host.changed(this.state.file !== file);
      if (isAnother && this.state.gear === null) {
        const first = look.analyze?.gears.find((gear) => gear.state === 'driven');
        if (first) return this.gear(first.gear);
      }
      // The text, outlines of gears and long tables follow when the numbers stand still.
      clearTimeout(this.tableTimer);
      this.tableTimer = setTimeout(() => {
        this.write();
        void this.turning.show(this.state.file, question);
        if (this.tablesSeen.all || this.tablesSeen.gear) void this.tabulate(this.tablesSeen, []);
      }, 80);
      // What is out of sight may be printed.
      clearTimeout(this.restTimer);
      this.restTimer = setTimeout(() => {
        void this.turning.show(this.state.file, question, true);
        void this.tabulate({ all: true, gear: true }, this.drawable().filter(({ picture }) => picture.classList.contains('waiting')));
      }, 1000);
    } catch (error) {
      if (opened !== this.opened) return;
      const chosen = error instanceof Failure ? CHOSEN[error.refused.name] : undefined;
      if (this.isAnother && chosen && this.state[chosen] !== null) {
        tell(`There is no ${chosen} ${this.state[chosen]} in this file.`);
        this.state[chosen] = null;
        return this.update();
      }
      this.host.changed(this.state.file !== file);
      this.refuse(error);
    }
  }

  /** What the core says of the file, with the numbers that were changed written into it. */
  private async looked(question: Question): Promise<Look> {
    const changes = [...this.changes];
    const opened = this.opened;
    let { file } = this.state;
    let look: Look;
    if (!changes.length) {
      look = await core.look(file, question);
    } else {
      const { numbers } = this.answered;
      const adjusted = await core.adjusted(this.answered.file, question, changes.map(([place, to]) => ({ number: numbers[place]!, to })));
      if (opened !== this.opened) throw new Overtaken();
      this.state.file = file = adjusted.file;
      look = taken(adjusted.look);
    }
    if (opened === this.opened) {
      this.state.file = file;
      this.answered = { file, numbers: look.adjust?.numbers ?? [] };
      for (const [place, to] of changes) if (this.changes.get(place) === to) this.changes.delete(place);
    }
    return look;
  }

  /** The text with the numbers that were changed. */
  private write(): void {
    const text = at<HTMLTextAreaElement>('text');
    if (text.value !== this.state.file) text.value = this.state.file;
  }

  /** Marks all pictures and tables: they are not as the numbers are now. */
  private markOld(): void {
    this.drawnOf = '';
    for (const place of [...this.drawable().map(({ picture }) => picture), this.tables, this.gearTables, this.turning.element]) place.classList.add('waiting');
  }

  /** Tables, and pictures that nobody sees yet. */
  private async tabulate({ all, gear }: { all: boolean; gear: boolean }, unseen: View[]): Promise<void> {
    const [opened, of] = [this.opened, this.shows()];
    const views = unseen.map((view) => ({ view, name: this.named(view) }));
    try {
      const look = await core.tables(this.state.file, { ...this.question(), pictures: views.map(({ name }) => name), tables: all, gear_tables: gear });
      // What comes late of other numbers is followed by what is asked of these.
      if (opened !== this.opened || of !== this.shows()) return;
      for (const { view, name } of views) drawn(view.picture, look.pictures?.[name]);
      if (look.tables !== undefined) tabled(this.tables, look.tables);
      if (gear) tabled(this.gearTables, look.gear_tables ?? '<p class="note">Choose a gear.</p>');
      document.body.dataset['tables'] = String(Date.now());
    } catch (error) {
      if (opened === this.opened) this.refuse(error);
    }
  }

  private refuse(error: unknown): void {
    if (error instanceof Overtaken) return;
    this.write();
    const place = error instanceof Failure ? error.refused.place : null;
    at('refused').textContent = (place ? `Line ${place.line}, column ${place.column}${place.path ? `, ${place.path}` : ''}: ` : '') + (error instanceof Error ? error.message : String(error));
    this.markOld();
  }

  private transmissions(names: string[]): void {
    at('transmission-field').hidden = names.length === 0;
    at('transmission').replaceChildren(...names.map((name) => h('option', { value: name, selected: name === this.state.transmission }, name)));
  }

  private facts(look: Look, isAnother: boolean): void {
    const { analyze, adjust } = look;
    if (!analyze || !adjust) return;
    at('title').textContent = analyze.gearbox;
    document.title = `${analyze.gearbox} – epicyclic`;
    const names = ['', ...analyze.gears.map(({ gear }) => gear)];
    const fieldset = at('gears');
    const old = [...fieldset.querySelectorAll('input')].map(({ value }) => value);
    if (isAnother || old.join('\n') !== names.join('\n')) {
      const one = (value: string) => h('label', {}, h('input', { type: 'radio', name: 'gear', value, onchange: () => void this.gear(value || null) }), h('b', {}, value || 'All'), h('small', {}));
      fieldset.replaceChildren(...names.map(one));
    }
    for (const input of fieldset.querySelectorAll('input')) {
      input.checked = input.value === (this.state.gear ?? '');
      const gear = analyze.gears.find(({ gear }) => gear === input.value);
      const words = gear ? (gear.ratio === null || gear.ratio === undefined ? '–' : shown(gear.ratio)) : `${analyze.gears.length} gears`;
      input.parentElement!.querySelector('small')!.textContent = words;
      input.setAttribute('aria-label', gear ? `Gear ${gear.gear}, ratio ${words}` : 'All gears');
    }
    this.sliders(adjust.numbers, isAnother);
  }

  private sliders(numbers: AdjustableNumber[], isAnother: boolean): void {
    const box = at('numbers');
    const key = numbers.map(({ set, of }) => `${set} ${of}`).join('\n');
    if (isAnother || box.dataset['key'] !== key) {
      box.dataset['key'] = key;
      const row = (number: AdjustableNumber, place: number) => {
        const isK = number.of === 'k';
        // Twice and half of what it was: the ends of the slider, not limits of what may be typed.
        const ends = isK ? { min: Math.max(1.05, number.value / 2).toFixed(3), max: (number.value * 2).toFixed(3), step: '0.001' } : { min: String(Math.max(6, Math.round(number.value / 2))), max: String(Math.round(number.value * 1.6)), step: '1' };
        const name = `${number.set}: ${KINDS[number.of]}`;
        const change = (value: string) => this.adjust(place, value);
        const slider = h('input', { type: 'range', ...ends, value: number.value, 'aria-label': `${name}, slider`, oninput: () => change(slider.value) });
        // A field for numbers would leave a comma out, and with it make 2.154 of 2,154 a thousand times as much.
        const field = h('input', { type: 'text', inputmode: isK ? 'decimal' : 'numeric', autocomplete: 'off', value: number.value, 'aria-label': name, oninput: () => change(field.value), onchange: () => this.leftEmpty(field, place) });
        return h('div', { class: 'number', 'data-place': place }, h('span', { class: 'name' }, name), slider, field);
      };
      const none = h('p', { class: 'note' }, 'Its sets have no k or teeth of their own in the file; edit the file.');
      box.replaceChildren(...(numbers.length ? numbers.map(row) : [none]));
      return;
    }
    numbers.forEach((number, place) => {
      for (const input of box.querySelectorAll<HTMLInputElement>(`[data-place="${place}"] input`)) {
        if (input !== document.activeElement) input.value = String(number.value);
      }
    });
  }

  /** A field that is left without a number shows that of the file again. */
  private leftEmpty(field: HTMLInputElement, place: number): void {
    const number = this.answered.numbers[place];
    if (!field.value.trim() && number) field.value = String(number.value);
  }

  private adjust(place: number, to: string): void {
    // Of a text that is no gearbox no number has a known place.
    if (this.answered.numbers[place]) {
      if (to.trim()) this.changes.set(place, to);
      else this.changes.delete(place);
      // A field that is empty for now changes nothing.
      if (!this.changes.size) this.state.file = this.answered.file;
    }
    void this.update();
  }

  private async gear(name: string | null): Promise<void> {
    this.state.gear = name;
    this.host.changed();
    const speeds = this.views.find((view) => view.name === 'speeds')!;
    if (name === null) drawn(speeds.picture, { message: 'A speed diagram shows one gear: choose one.' });
    await this.update();
  }

  // --- files ---

  private stem(): string {
    const { analyze } = this.look ?? {};
    const words = `${analyze?.gearbox ?? 'gearbox'}${this.state.gear ? `-${this.state.gear}` : ''}`;
    return words.toLowerCase().replaceAll(/[^a-z0-9]+/g, '-').replaceAll(/^-|-$/g, '');
  }

  private async download(view: PictureName, kind: 'svg' | 'dxf' | 'pdf'): Promise<void> {
    const { transmission, gear, power, efficiency } = this.state;
    const line = ['draw', 'gearbox.yaml', '--view', view];
    if (transmission) line.push('--transmission', transmission);
    if (gear && view !== 'ladder') line.push('--gear', gear);
    if (view === 'scheme' && gear && power) {
      line.push('--power');
      if (efficiency) line.push('--efficiency', efficiency);
    }
    await download(line, this.state.file, `${this.stem()}-${view}.${kind}`);
  }

  private line(command: string): string[] {
    const { transmission, gear, speed, torque, efficiency } = this.state;
    const line = [command, 'gearbox.yaml'];
    const add = (option: string, value: string | null) => value && line.push(option, value);
    add('--transmission', transmission);
    if (command === 'analyze') add('--gear', gear);
    add('--speed', speed);
    add('--torque', torque);
    add('--efficiency', efficiency);
    return line;
  }

  private async saveTable(kind: 'csv' | 'json'): Promise<void> {
    await download([...this.line('analyze'), '--format', kind], this.state.file, `${this.stem()}.${kind}`, true);
  }

  private async saveReport(): Promise<void> {
    await download(this.line('report'), this.state.file, `${this.stem()}.html`);
  }

  /** Saves the file. */
  save(): void {
    save(`${this.stem()}.yaml`, this.state.file, 'application/yaml');
    this.host.saved();
    tell('The gearbox is saved as a file.');
  }
}

/** A picture in its place, or the words that stand for it. */
export function drawn(place: HTMLElement, picture: Picture | undefined): void {
  place.classList.remove('waiting');
  if (picture?.svg !== undefined) {
    place.innerHTML = picture.svg.replaceAll(/ id="layer-[^"]*"/g, '');
    // Letters of 2.5 mm are then a little larger than those of the page.
    const svg = place.querySelector('svg')!;
    svg.style.setProperty('--natural', `${5 * parseFloat(svg.getAttribute('width')!)}px`);
  } else place.replaceChildren(h('p', { class: 'note' }, picture?.message ?? ''));
}

/** Tables in their place; those that can be scrolled can be reached by the keyboard. */
export function tabled(place: HTMLElement, html: string): void {
  place.classList.remove('waiting');
  place.innerHTML = html;
  for (const table of place.querySelectorAll('.table')) {
    // A column whose cells say by themselves what they are has no heading.
    for (const empty of table.querySelectorAll('th')) if (!empty.textContent?.trim()) empty.replaceWith(h('td'));
    table.setAttribute('tabindex', '0');
    table.setAttribute('role', 'group');
    table.setAttribute('aria-label', table.previousElementSibling?.textContent ?? 'Table');
  }
}

function titled(file: string, text: string): string {
  const name = /^gearbox: *(.+)$/m.exec(text)?.[1]?.replaceAll(/^["']|["']$/g, '');
  const stem = file.replace(/\.yaml$/, '').replaceAll('-', ' ');
  const list = [...text.matchAll(/^- name: *(.+)$/gm)].map(([, name]) => name!.replace(/ \(.*| gen .*/, ''));
  return list.length ? list.join(', ') : name ? `${name} (${stem})` : stem;
}

/** The comment at the head of a file. */
function comment(text: string): string {
  const lines = [];
  for (const line of text.split('\n')) {
    if (!/^# ?\S/.test(line)) break;
    lines.push(line.replace(/^# ?/, ''));
  }
  const words = lines.join(' ');
  return words.length > 300 ? `${words.slice(0, 297)}…` : words;
}
