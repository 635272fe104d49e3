// The core, off the main thread, and the whole program, which is loaded when it is first called.
import beginCalls, * as calls from './generated/calls.js';
import beginCore, * as core from './generated/core.js';

const beginnings: Partial<Record<'core' | 'calls', Promise<unknown>>> = {};

/** The module with a method, loaded once. */
function ready(method: string): Promise<unknown> {
  const name = method === 'call' ? 'calls' : 'core';
  const begin = { core: beginCore, calls: beginCalls }[name];
  return (beginnings[name] ??= begin({ module_or_path: new URL(`${name}.wasm`, self.location.href) }));
}

/** The call that runs now, for its progress. */
let running: number | null = null;
let last = 0;
Object.assign(self, {
  epicyclicProgress: (line: string, share: number) => {
    // Some searches tell thousands of times a second.
    if (performance.now() - last < 50) return;
    last = performance.now();
    self.postMessage({ id: running, progress: [share, line] });
  },
});

/** A command line, as plain data. */
function call(line: string[], files: Record<string, string>): unknown {
  const called = calls.call(line, Object.keys(files), Object.values(files));
  const written = called.written.map((name, place) => [name, called.file(place)!] as const);
  const { code, answer, messages } = called;
  called.free();
  return { code, answer, messages, files: Object.fromEntries(written) };
}

self.onmessage = async ({ data: { id, method, args } }) => {
  try {
    await ready(method);
    running = id;
    const methods = { ...core, call } as unknown as Record<string, (...args: unknown[]) => unknown>;
    const reply = methods[method]!(...args);
    self.postMessage({ id, reply });
  } catch (error) {
    self.postMessage({ id, error: String(error) });
  }
};
