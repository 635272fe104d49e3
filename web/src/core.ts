// The core in workers: the one file through which the app asks anything of it.
import type { AdjustableNumber } from './generated/adjust.js';
import type { Adjust, Analyze, AnalyzeGear, AnalyzeInputs, Front, Motor, MotorMoving, Refused, Transmissions } from './generated/answers.js';

/** What is asked of a gearbox's file. */
export interface Question {
  transmission: string | null;
  gear: string | null;
  speed: string | null;
  torque: string | null;
  efficiency: string | null;
  pictures?: PictureName[];
  tables?: boolean;
  gear_tables?: boolean;
  list?: boolean;
}

export type PictureName = 'scheme' | 'power' | 'speeds' | 'levers' | 'ladder';

/** A picture, or in words why there is none. */
export type Picture = { svg: string; message?: undefined } | { message: string; svg?: undefined };

/** A gearbox looked at. */
export interface Look {
  transmissions?: Transmissions;
  analyze?: Analyze;
  adjust?: Adjust;
  tables?: string;
  gear?: AnalyzeGear;
  inputs?: AnalyzeInputs;
  gear_tables?: string;
  pictures?: Partial<Record<PictureName, Picture>>;
}

/** The text of a file with other numbers, and the gearbox looked at. */
export interface Adjusted {
  file: string;
  look: Look | Refused;
}

/** A hydromotor looked at. */
export interface LookedMotor {
  motor: Motor;
  /** What it is chosen by: names, and figures with their units. */
  key: [string, string][];
  tables: string;
}

/** What a call of the command line leaves behind. */
export interface Called {
  code: number;
  answer: string;
  messages: string;
  files: Record<string, Uint8Array>;
}

/** A refusal of the core, with its place in the file where it has one. */
export class Failure extends Error {
  constructor(readonly refused: Refused) {
    super(refused.message);
  }
}

/** Somebody has asked the same again before this was answered. */
export class Overtaken extends Error {}

/** Takes the share of a search that is done, below 0 where it is not known, and a line that says so. */
type Progress = (share: number, line: string) => void;

interface Waiting {
  resolve: (reply: unknown) => void;
  reject: (error: Error) => void;
  progress?: Progress | undefined;
}

/** A worker with the core. */
class Worked {
  private worker: Worker;
  private waiting = new Map<number, Waiting>();
  private next = 0;

  constructor() {
    this.worker = this.start();
  }

  private start(): Worker {
    const worker = new Worker(new URL('worker.js', document.baseURI), { type: 'module' });
    worker.onmessage = ({ data }) => {
      const waiting = this.waiting.get(data.id);
      if (!waiting) return;
      if (data.progress) {
        waiting.progress?.(data.progress[0], data.progress[1]);
        return;
      }
      this.waiting.delete(data.id);
      if (data.error !== undefined) waiting.reject(new Error(data.error));
      else waiting.resolve(data.reply);
    };
    worker.onerror = () => this.fail(new Error('The calculation cannot be loaded. Load the page again.'));
    return worker;
  }

  private fail(error: Error): void {
    for (const { reject } of this.waiting.values()) reject(error);
    this.waiting.clear();
  }

  ask<T>(method: string, args: unknown[], progress?: Waiting['progress']): Promise<T> {
    const id = this.next++;
    return new Promise<T>((resolve, reject) => {
      this.waiting.set(id, { resolve: resolve as (reply: unknown) => void, reject, progress });
      this.worker.postMessage({ id, method, args });
    });
  }

  /** Ends what runs, whatever it is. */
  cancel(): void {
    this.worker.terminate();
    this.fail(new Overtaken());
    this.worker = this.start();
  }
}

/** Of questions of one kind only the newest is answered: while one runs, one more waits. */
class Newest {
  private running = false;
  private held: (() => void) | null = null;
  private drop: (() => void) | null = null;

  run<T>(ask: () => Promise<T>): Promise<T> {
    return new Promise<T>((resolve, reject) => {
      const begin = () => {
        this.running = true;
        this.held = this.drop = null;
        ask()
          .then(resolve, reject)
          .finally(() => {
            this.running = false;
            this.held?.();
          });
      };
      if (!this.running) return begin();
      this.drop?.();
      this.held = begin;
      this.drop = () => reject(new Overtaken());
    });
  }
}

/** Text of a reply as data; a refusal is thrown. */
function read<T>(reply: string): T {
  return taken(JSON.parse(reply) as T | Refused);
}

/** A reply, or its refusal thrown. */
export function taken<T>(data: T | Refused): T {
  if (typeof data === 'object' && data !== null && 'answer' in data && data.answer === 'error') throw new Failure(data as Refused);
  return data as T;
}

const live = new Worked();
let slow: Worked | null = null;
let searching: Worked | null = null;
/** For outlines, tables and motions, which take longer than a change: none waits for them. */
const beside = () => (slow ??= new Worked());
const kinds = new Map<string, Newest>();

function newest<T>(kind: string, ask: () => Promise<T>): Promise<T> {
  let of = kinds.get(kind);
  if (!of) kinds.set(kind, (of = new Newest()));
  return of.run(ask);
}

export const core = {
  look: (file: string, question: Question) => newest('look', () => live.ask<string>('look', [file, JSON.stringify(question)])).then(read<Look>),
  tables: (file: string, question: Question) =>
    newest('tables', () => beside().ask<string>('look', [file, JSON.stringify(question)])).then(read<Look>),
  front: (file: string, question: Question) =>
    newest('front', () => beside().ask<string>('front', [file, JSON.stringify(question)])).then(read<Front>),
  /** `look` at the file with other numbers at places that it has named. What is refused is refused of the file then. */
  adjusted: (file: string, question: Question, changes: { number: AdjustableNumber; to: string }[]) =>
    newest('look', () => live.ask<string>('adjusted', [file, JSON.stringify(question), JSON.stringify(changes)])).then(read<Adjusted>),
  scheme: (name: string, k1: number, k2: number) =>
    live.ask<string>('scheme', [name, k1, k2]).then(read<{ file: string }>),
  motor: (file: string) => newest('motor', () => live.ask<string>('motor', [file])).then(read<LookedMotor>),
  moving: (file: string, frames: number) =>
    newest('moving', () => beside().ask<string>('moving', [file, frames])).then(read<MotorMoving>),
  /** A command line, in a worker of its own that `cancel` ends. */
  call: (line: string[], files: Record<string, string>, progress?: Progress) =>
    (searching ??= new Worked()).ask<Called>('call', [line, files], progress),
  cancel: () => searching?.cancel(),
};
