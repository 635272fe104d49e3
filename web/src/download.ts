// Files that the core writes, by the words of the command line.
import { core } from './core.js';
import { save, tell } from './dom.js';

const TYPES: Record<string, string> = { svg: 'image/svg+xml', dxf: 'image/vnd.dxf', pdf: 'application/pdf', csv: 'text/csv', json: 'application/json', html: 'text/html' };

/** Calls the core and gives its file, or its answer, to the reader. */
export async function download(line: string[], file: string, name: string, isAnswer = false): Promise<void> {
  const input = line[1] ?? 'gearbox.yaml';
  const words = isAnswer ? line : [...line, '--output', name];
  tell(`${name} is being made …`);
  let called;
  try {
    called = await core.call(words, { [input]: file });
  } catch (error) {
    tell(error instanceof Error ? error.message : String(error));
    return;
  }
  const content = isAnswer ? called.answer : called.files[name];
  if (called.code !== 0 || content === undefined) {
    tell(called.messages || `No ${name}.`);
    return;
  }
  save(name, content as BlobPart, TYPES[name.split('.').pop() ?? ''] ?? 'application/octet-stream');
  tell(`${name} is saved.`);
}
