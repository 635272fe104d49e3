// The page that chooses a gearbox for given speeds: candidates with what speaks against each, in a worker that can be ended.
import { core, Overtaken } from './core.js';
import { h, shown } from './dom.js';
import type { Select } from './generated/answers.js';
import { drawn } from './gearbox.js';

const CRITERIA: Record<string, string> = {
  ratio_error: 'ratio', ring_to_sun_ratio: 'k', efficiency: 'efficiency', link_speed: 'speed of a link', planet_speed: 'speed of a planet',
  clutch_slip: 'slip of the clutch', circulation: 'circulating power', same_direction: 'the output reverses', drawable: 'lines would cross', planet_gap: 'room for planets',
};

type Candidate = Select['candidates'][number];

/** The page. */
export class ChoosePage {
  readonly element: HTMLElement;
  private form: HTMLFormElement;
  private found = h('div', { class: 'candidates', id: 'candidates' });
  private words = h('p', { class: 'note', id: 'found', role: 'status' });
  private refused = h('div', { class: 'refused', role: 'alert', id: 'choose-refused' });
  private progress = h('progress', { hidden: true, 'aria-label': 'Progress of the search', max: '1' });
  private cancel: HTMLButtonElement;
  private go: HTMLButtonElement;

  constructor(
    private values: Record<string, string>,
    private changed: (values: Record<string, string>) => void,
    private open: (file: string, name: string) => void,
  ) {
    const field = (name: string, label: string, hint: string) => h('label', { class: 'field' }, h('span', {}, label), h('input', { name, placeholder: hint, autocomplete: 'off' }));
    const choice = (name: string, label: string, options: [string, string][]) =>
      h('label', { class: 'field' }, h('span', {}, label), h('select', { name }, ...options.map(([value, text]) => h('option', { value }, text))));
    this.go = h('button', { type: 'submit', class: 'main' }, 'Find gearboxes');
    this.cancel = h('button', { type: 'button', disabled: true, onclick: () => core.cancel() }, 'Cancel');
    this.form = h(
      'form',
      {
        class: 'card',
        'aria-label': 'Speeds wanted',
        oninput: () => this.read(),
        onsubmit: (event) => {
          event.preventDefault();
          void this.search();
        },
      },
      h('h2', {}, 'Speeds wanted'),
      field('speeds', 'Speeds of the machine, the slowest first', '0.8 m/s, 3.15 m/s'),
      h('p', { class: 'note' }, 'Two or three speeds; the fastest is direct drive. Or give the ratios:'),
      field('ratios', 'Ratios of the braked gears', '1.465, 2.56'),
      h('div', { class: 'fields' }, field('tolerance', 'A ratio may be off by', '10%'), choice('signs', 'Signs of the ratios', [['', 'alike'], ['any', 'any'], ['as-given', 'as given']])),
      h('div', { class: 'fields' }, field('input', 'Speed of the input', '1475 rpm'), field('power', 'Power', '75 kW')),
      choice('structures', 'Gearboxes', [['', 'the catalogue'], ['all', 'all 111 structures of two sets']]),
      choice('teeth', 'Tooth numbers', [['', 'ratios k'], ['teeth', 'all tooth numbers (takes longer)']]),
      h('div', { class: 'row' }, this.go, this.cancel),
      h('div', { class: 'row' }, this.progress),
      this.refused,
    );
    this.element = h('div', { class: 'page', id: 'choose' }, h('div', { class: 'side' }, this.form), h('div', {}, h('section', { class: 'card', 'aria-label': 'Candidates' }, h('h2', {}, 'Candidates'), this.words, this.found)));
    this.words.textContent = 'Give speeds or ratios; every scheme is calculated and judged by each criterion.';
  }

  private read(): void {
    this.values = Object.fromEntries([...new FormData(this.form)].map(([name, value]) => [name, String(value).trim()]));
    this.changed(this.values);
  }

  /** The fields with these values. */
  fill(values: Record<string, string>): void {
    this.values = values;
    for (const field of this.form.querySelectorAll<HTMLInputElement | HTMLSelectElement>('[name]')) field.value = values[field.name] ?? '';
  }

  private line(): string[] {
    const value = (name: string) => this.values[name] ?? '';
    const line = ['select'];
    const add = (option: string, name: string) => value(name) && line.push(option, value(name));
    if (value('ratios')) add('--ratios', 'ratios');
    else add('--speeds', 'speeds');
    add('--tolerance', 'tolerance');
    add('--signs', 'signs');
    add('--input', 'input');
    if (value('input')) add('--power', 'power');
    if (value('structures')) line.push('--all-structures');
    if (value('teeth')) line.push('--teeth', '--limit', '12');
    return line;
  }

  /** Searches, and shows what is found. */
  async search(): Promise<void> {
    this.read();
    this.refused.textContent = '';
    this.go.disabled = true;
    this.cancel.disabled = false;
    this.progress.hidden = false;
    this.progress.removeAttribute('value');
    const line = this.line();
    try {
      const called = await core.call([...line, '--format', 'json'], {}, (share, told) => {
        if (share >= 0) this.progress.value = share;
        this.words.textContent = told;
      });
      const answer = JSON.parse(called.answer || '{}');
      if (called.code !== 0 || answer.answer === 'error') {
        this.refused.textContent = answer.message ?? called.messages;
        this.found.replaceChildren();
        this.words.textContent = 'No gearbox.';
        return;
      }
      await this.show(answer as Select, line);
    } catch (error) {
      this.refused.textContent = error instanceof Overtaken ? 'The search was ended.' : String(error);
    } finally {
      this.go.disabled = false;
      this.cancel.disabled = true;
      this.progress.hidden = true;
    }
  }

  private async show(answer: Select, line: string[]): Promise<void> {
    const shownHere = (answer.candidates ?? []).slice(0, 12);
    this.words.textContent = `${answer.accepted} meet all criteria, ${answer.rejected} do not. The best are first.`;
    this.found.replaceChildren(...shownHere.map((candidate) => this.candidate(candidate, line)));
    for (const [place, candidate] of shownHere.entries()) {
      const [k1, k2] = candidate.sets.map(({ k }) => String(k));
      const sizes = ['--k1', k1!, ...(k2 ? ['--k2', k2] : [])];
      const called = await core.call(['draw', candidate.scheme ?? candidate.structure, ...sizes], {});
      const picture = this.found.children[place]?.querySelector<HTMLElement>('.picture');
      if (picture) drawn(picture, called.code === 0 ? { svg: called.answer } : { message: called.messages });
    }
  }

  private candidate(candidate: Candidate, line: string[]): HTMLElement {
    const name = candidate.scheme ?? candidate.structure;
    const against = candidate.criteria.filter(({ met }) => !met);
    const fact = (name: string, value: string) => h('div', {}, h('dt', {}, name), h('dd', {}, value));
    const { objectives } = candidate;
    const save = async () => {
      const called = await core.call([...line, '--save', 'box.yaml', '--nth', String(candidate.no), '--format', 'json'], {});
      const file = called.files['box.yaml'];
      if (file) this.open(new TextDecoder().decode(file), '');
    };
    return h(
      'article',
      { class: 'card candidate' },
      h('div', { class: 'picture' }),
      h(
        'div',
        {},
        h('h3', {}, `${candidate.no}. ${candidate.scheme ? `Scheme ${name}` : name} `, h('span', { class: candidate.accepted ? 'badge' : 'badge no' }, candidate.accepted ? 'meets all criteria' : 'does not meet all')),
        h(
          'dl',
          {},
          ...candidate.sets.map(({ k }, place) => fact(`k of set ${place + 1}`, shown(k))),
          ...candidate.gears.map(({ gear, ratio }) => fact(`Ratio of gear ${gear}`, shown(ratio))),
          fact('Least efficiency', shown(objectives.efficiency)),
          fact('Greatest speed', `${shown(objectives.speed_of_input, 3)} of the input’s`),
        ),
        h('p', { class: 'note' }, against.length ? `Against it: ${against.map(({ criterion, value }) => `${CRITERIA[criterion] ?? criterion.replaceAll('_', ' ')}${['same_direction', 'drawable'].includes(criterion) ? '' : ` (${shown(value ?? null, 3)})`}`).join(', ')}.` : 'Nothing speaks against it.'),
        h('button', { type: 'button', onclick: () => void save(), 'aria-label': `Open candidate ${candidate.no}` }, 'Open as gearbox'),
      ),
    );
  }
}
