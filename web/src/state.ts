// What the page shows: as a link shows it to others, and as each entry of the tab's history keeps it.

export interface GearboxState {
  /** The text of the file. */
  file: string;
  /** The name it was opened by, of an example or a file. */
  name: string;
  transmission: string | null;
  gear: string | null;
  speed: string;
  torque: string;
  efficiency: string;
  power: boolean;
}

export const PAGES = ['gearbox', 'choose', 'motor'] as const;

export interface State {
  page: (typeof PAGES)[number];
  gearbox: GearboxState;
  choose: Record<string, string>;
  motor: string;
}

/** What an entry of the history keeps beside its address. */
export interface Entry {
  state: State;
  /** Texts that were changed and not saved since. */
  edited: { gearbox: boolean; motor: boolean };
  /** The text that `epicyclic serve` gave, where the page began with it. */
  served: string | null;
}

/** A link that cannot be read, with the reason. */
export class Damaged extends Error {}

async function through(bytes: Uint8Array, stream: CompressionStream | DecompressionStream): Promise<Uint8Array> {
  const blob = new Blob([bytes as BlobPart]);
  return new Uint8Array(await new Response(blob.stream().pipeThrough(stream)).arrayBuffer());
}

/** A state as part of an address. */
export async function packed(state: State): Promise<string> {
  const bytes = await through(new TextEncoder().encode(JSON.stringify(state)), new CompressionStream('deflate-raw'));
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** The state of an address; what it does not say is as in `first`. */
export async function unpacked(text: string, first: State): Promise<State> {
  let state: unknown;
  try {
    const bytes = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
    state = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(await through(bytes, new DecompressionStream('deflate-raw'))));
  } catch {
    throw new Damaged('it is cut off or changed');
  }
  return checked(state, first);
}

type Parts = Record<string, unknown>;
const isParts = (value: unknown): value is Parts => typeof value === 'object' && value !== null && !Array.isArray(value);
const isText = (value: unknown) => typeof value === 'string';
const isTextOrNone = (value: unknown) => value === null || typeof value === 'string';
const isPage = (value: unknown) => PAGES.some((page) => page === value);
const areTexts = (value: unknown) => isParts(value) && Object.values(value).every(isText);

const GEARBOX: Record<keyof GearboxState, (value: unknown) => boolean> = {
  file: isText,
  name: isText,
  transmission: isTextOrNone,
  gear: isTextOrNone,
  speed: isText,
  torque: isText,
  efficiency: isText,
  power: (value) => typeof value === 'boolean',
};
const STATE: Record<keyof State, (value: unknown) => boolean> = { page: isPage, gearbox: isParts, choose: areTexts, motor: isText };

/** The known parts of a value, each of its kind; parts of other versions of the app are left out. */
function known<T extends object>(value: Parts, kinds: Record<keyof T, (value: unknown) => boolean>, at: string): Partial<T> {
  const found: Parts = {};
  for (const [key, is] of Object.entries<(value: unknown) => boolean>(kinds)) {
    if (!(key in value)) continue;
    if (!is(value[key])) throw new Damaged(`the value of ${at}${key} cannot be ${JSON.stringify(value[key])}`);
    found[key] = value[key];
  }
  return found as Partial<T>;
}

function checked(value: unknown, first: State): State {
  if (!isParts(value)) throw new Damaged('it holds no state of the app');
  const state = known<State>(value, STATE, '');
  const gearbox = known<GearboxState>((state.gearbox ?? {}) as Parts, GEARBOX, 'gearbox.');
  return { ...first, ...state, gearbox: { ...first.gearbox, ...gearbox } };
}

const KEY = 'epicyclic-entry-';
const SHOWN = 'epicyclic-shown';
const idOf = (state: unknown) => (isParts(state) && typeof state['id'] === 'string' ? state['id'] : null);

/** The entry that was shown before the page was loaded again. Chromium forgets the state of one whose address changes meanwhile. */
function shownBefore(): string | null {
  const [loaded] = performance.getEntriesByType('navigation') as PerformanceNavigationTiming[];
  if (loaded?.type !== 'reload') return null;
  try {
    return sessionStorage.getItem(SHOWN);
  } catch {
    return null;
  }
}

/** The entries of this tab's history. What each shows outlives a reload, and is there when one goes back. */
export class Entries {
  /** The entry that is shown. */
  private id: string | null = null;

  /** Whether the browser has gone to an entry other than the one that is shown. */
  get hasMoved(): boolean {
    return idOf(history.state) !== this.id;
  }

  /** Takes the entry that the browser is at; gives what it keeps, nothing for one that is new. */
  enter(first: State): Entry | null {
    const isLoaded = this.id === null;
    this.id = idOf(history.state);
    if (this.id === null) {
      const again = isLoaded ? shownBefore() : null;
      this.id = this.named(location.href, 'replaceState', again);
      if (again === null) return null;
    }
    try {
      const kept: unknown = JSON.parse(sessionStorage.getItem(KEY + this.id) ?? 'null');
      if (!isParts(kept)) return null;
      const { gearbox, motor } = kept['edited'] as Entry['edited'];
      const served = typeof kept['served'] === 'string' ? kept['served'] : null;
      return { state: checked(kept['state'], first), edited: { gearbox, motor }, served };
    } catch {
      // Another version of the app has kept it otherwise: the address has it, too.
      return null;
    }
  }

  /** A new entry behind the one that is shown. */
  add(): void {
    this.id = this.named(location.href, 'pushState');
  }

  /** Keeps what the entry shows. */
  keep(entry: Entry): void {
    const write = () => {
      sessionStorage.setItem(KEY + this.id, JSON.stringify(entry));
      sessionStorage.setItem(SHOWN, this.id ?? '');
    };
    const others = () => Object.keys(sessionStorage).filter((key) => key.startsWith(KEY));
    try {
      try {
        write();
      } catch {
        // There is no more room: the addresses of the other entries hold them as well.
        for (const key of others()) sessionStorage.removeItem(key);
        write();
      }
    } catch {
      // Where the browser gives no room at all, the address alone keeps it.
    }
  }

  /** Another address for the entry that is shown. */
  address(address: string): void {
    history.replaceState({ id: this.id }, '', address);
  }

  private named(address: string, how: 'pushState' | 'replaceState', known: string | null = null): string {
    const id = known ?? `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;
    history[how]({ id }, '', address);
    return id;
  }
}
