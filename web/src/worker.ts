// The core, off the main thread.
import init, * as core from './generated/core.js';

const ready = init({ module_or_path: new URL('core.wasm', self.location.href) });

self.onmessage = async ({ data: { id, method, args } }) => {
  try {
    await ready;
    const reply = (core as unknown as Record<string, (...args: unknown[]) => unknown>)[method]!(...args);
    self.postMessage({ id, reply });
  } catch (error) {
    self.postMessage({ id, error: String(error) });
  }
};
