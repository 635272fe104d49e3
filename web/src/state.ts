// What the page shows, kept in the address, so that a link shows it to others.

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

export interface State {
  page: 'gearbox' | 'choose' | 'motor';
  gearbox: GearboxState;
  choose: Record<string, string>;
  motor: string;
}

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

/** The state of an address; nothing where it has none that can be read. */
export async function unpacked(text: string): Promise<Partial<State> | null> {
  try {
    const bytes = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
    const state: unknown = JSON.parse(new TextDecoder().decode(await through(bytes, new DecompressionStream('deflate-raw'))));
    return typeof state === 'object' && state !== null ? (state as Partial<State>) : null;
  } catch {
    return null;
  }
}
