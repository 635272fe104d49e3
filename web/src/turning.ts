// The sets from the front, turning at the speeds of the gear. Outlines and speeds come from the core; here groups are turned.
import { core, Overtaken, type Question } from './core.js';
import { h, s, shown } from './dom.js';
import type { Front } from './generated/answers.js';

type FrontGear = Front['sets'][number]['gears'][number];

/** A group, and how it stands after an angle of the input. */
interface Part {
  group: SVGGElement;
  at: (input: number) => string;
}

const degrees = (radians: number) => (radians * 180) / Math.PI;

/** The card of the turning gears. */
export class Turning {
  readonly element: HTMLElement;
  private isOnScreen = false;
  private frame: number | null = null;
  private sets = h('div', { class: 'turning' });
  private note = h('p', { class: 'note' });
  private play: HTMLButtonElement;
  private speed: HTMLInputElement;
  private angle: HTMLInputElement;
  private parts: Part[] = [];
  private input = 0;
  private last: number | null = null;
  private isPlaying = !matchMedia('(prefers-reduced-motion: reduce)').matches;

  constructor() {
    this.play = h('button', { type: 'button', onclick: () => this.toggle() }, this.isPlaying ? 'Pause' : 'Play');
    this.speed = h('input', { type: 'range', min: '0.005', max: '0.5', step: '0.005', value: '0.06', 'aria-label': 'Turns of the input in a second' });
    this.angle = h('input', { type: 'range', min: '0', max: '360', step: '1', value: '0', 'aria-label': 'Angle of the input in degrees', oninput: () => this.stand() });
    this.element = h(
      'section',
      { class: 'card', 'data-view': 'turning', 'aria-label': 'Gears from the front' },
      h('div', { class: 'head' }, h('h2', {}, 'Gears from the front'), h('div', { class: 'tools' }, this.play, h('label', {}, 'speed ', this.speed), h('label', {}, 'angle ', this.angle))),
      this.sets,
      this.note,
    );
  }

  /** Whether it is on the screen. */
  set isSeen(isSeen: boolean) {
    this.isOnScreen = isSeen;
    this.turn();
  }

  /** Frames are asked for only while something turns in sight. */
  private turn(): void {
    if (this.frame !== null || !this.isPlaying || !this.isOnScreen) return;
    const step = (now: number) => {
      this.frame = null;
      if (this.last !== null) {
        this.input += ((now - this.last) / 1000) * Number(this.speed.value) * 2 * Math.PI;
        this.place();
      }
      this.last = now;
      this.turn();
      if (this.frame === null) this.last = null;
    };
    this.frame = requestAnimationFrame(step);
  }

  private toggle(): void {
    this.isPlaying = !this.isPlaying;
    this.play.textContent = this.isPlaying ? 'Pause' : 'Play';
    this.turn();
  }

  private stand(): void {
    if (this.isPlaying) this.toggle();
    this.input = (Number(this.angle.value) * Math.PI) / 180;
    this.place();
  }

  private place(): void {
    for (const { group, at } of this.parts) group.setAttribute('transform', at(this.input));
    if (this.isPlaying) this.angle.value = String(Math.round(degrees(this.input)) % 360);
  }

  /** The gears of a file in a gear, where they are on the screen or wanted anyway. */
  async show(file: string, question: Question, isWanted = this.isOnScreen): Promise<void> {
    if (!isWanted) return;
    try {
      const { transmission, gear, efficiency } = question;
      const front = await core.front(file, { transmission, gear, efficiency, speed: null, torque: null });
      this.draw(front);
    } catch (error) {
      if (error instanceof Overtaken) return;
      this.element.classList.remove('waiting');
      this.parts = [];
      this.sets.replaceChildren();
      this.note.textContent = error instanceof Error ? error.message : String(error);
    }
  }

  private draw(front: Front): void {
    this.element.classList.remove('waiting');
    this.parts = [];
    this.sets.replaceChildren(...front.sets.map((set) => this.set(set)));
    const words = [];
    if (front.gear === null || front.gear === undefined) words.push('Choose a gear to see it turn.');
    else words.push('Speeds are multiples of the input’s; counter-clockwise is positive.');
    if (front.sets.some((set) => !set.has_teeth)) words.push('Circles are pitch circles, where the file has k and no teeth.');
    if (front.sets.some((set) => !set.planets_are_given)) words.push('Where the file does not say how many planets there are, three are shown.');
    if (front.left_out.length) words.push(`Not shown, since they have bevel gears or do not say their teeth: ${front.left_out.join(', ')}.`);
    for (const { set, why } of front.uncut) words.push(`The teeth of ${set} are not shown: ${why}.`);
    this.note.textContent = words.join(' ');
    this.place();
  }

  private set(set: Front['sets'][number]): HTMLElement {
    const rim = set.reach * 1.02;
    const dot = 0.02 * rim;
    const carrier = set.carrier_of_input ?? 0;
    const path = ({ outline }: FrontGear) => `M${outline.map(([x, y]) => `${x!.toFixed(3)} ${y!.toFixed(3)}`).join('L')}Z`;
    const around = (r: number) => `M${r} 0A${r} ${r} 0 1 0 ${-r} 0A${r} ${r} 0 1 0 ${r} 0Z`;
    const body = (gear: FrontGear) => (gear.outline.length ? path(gear) : around(gear.pitch_radius));
    const mark = (at: number) => s('circle', { class: 'g-mark', cx: at, cy: 0, r: dot });
    const bore = (radius: number) => s('circle', { class: 'g-hole g-edge', r: radius });
    // Large gears lie behind small ones.
    const sorted = (part: FrontGear['part']) => set.gears.filter((gear) => gear.part === part).sort((one, other) => other.rim_radius - one.rim_radius);
    const turning = (group: SVGGElement, speed: number | null | undefined, turn: number, [x, y]: number[] = [0, 0]) => {
      const place = x || y ? `translate(${x} ${y}) ` : '';
      this.parts.push({ group, at: (input) => `${place}rotate(${degrees((speed ?? 0) * input + turn)})` });
      return group;
    };
    const rings = sorted('ring').map((ring) =>
      turning(s('g', {}, s('path', { class: 'g-ring g-edge', 'fill-rule': 'evenodd', d: around(ring.rim_radius) + body(ring) }), mark(0.97 * ring.rim_radius - dot)), ring.speed_of_input, ring.turn_rad, ring.centre),
    );
    const suns = sorted('sun').map((sun, place, all) => {
      // The gears of a pair lie side by side, other suns one over the other.
      const isInFront = place === all.length - 1 || !set.planets.length;
      const teeth = s('path', { class: `g-sun g-edge${isInFront ? '' : ' g-behind'}`, d: body(sun) });
      return turning(s('g', {}, teeth, mark(0.7 * sun.pitch_radius), ...(isInFront ? [bore(0.25 * sun.pitch_radius)] : [])), sun.speed_of_input, sun.turn_rad, sun.centre);
    });
    const standing = set.planets.flatMap((at) => at.gears.map((own) => ({ at, own, gear: set.gears[own.gear]! })));
    standing.sort((one, other) => other.gear.rim_radius - one.gear.rim_radius);
    const planets = standing.map(({ at, own, gear }) => {
      const group = s('g', {}, s('path', { class: 'g-planet g-edge', d: body(gear) }), mark(0.6 * gear.pitch_radius), bore(0.14 * gear.pitch_radius));
      const speed = gear.speed_of_input ?? 0;
      this.parts.push({
        group,
        at: (input) => {
          const angle = at.angle_rad + carrier * input;
          const [x, y] = [at.centre_distance * Math.cos(angle), at.centre_distance * Math.sin(angle)];
          return `translate(${x.toFixed(4)} ${y.toFixed(4)}) rotate(${degrees(speed * input + own.turn_rad).toFixed(3)})`;
        },
      });
      return group;
    });
    const arms = set.planets.map(({ angle_rad, centre_distance }) => s('line', { x2: centre_distance * Math.cos(angle_rad), y2: centre_distance * Math.sin(angle_rad), 'stroke-width': 0.05 * rim }));
    const carrierGroup = turning(s('g', { class: 'g-carrier' }, ...arms), carrier, 0);
    const centrals = set.gears.filter(({ part }) => part !== 'planet');
    const speeds = [
      ...centrals.map(({ name, speed_of_input }) => `${name} ${shown(speed_of_input)}`),
      ...(set.planets.length ? [`carrier ${shown(set.carrier_of_input)}`] : []),
      ...set.gears.filter(({ part }) => part === 'planet').map(({ name, speed_of_input }) => `${name} ${shown(speed_of_input)}`),
    ];
    const words = speeds.join(', ');
    const picture = s('svg', { viewBox: `${-rim} ${-rim} ${2 * rim} ${2 * rim}`, role: 'img', 'aria-label': `Set ${set.set} from the front. Speeds: ${words}` }, s('g', { transform: 'scale(1 -1)' }, ...rings, ...planets, carrierGroup, ...suns));
    const teeth = set.has_teeth ? ` ${set.gears.map(({ teeth }) => teeth).join('/')}` : '';
    return h('figure', {}, picture, h('figcaption', {}, h('b', {}, `${set.set}${teeth}`), h('br'), words));
  }
}
