// Small helpers for the page.

type Child = Node | string | null | undefined | false;
type Props = Record<string, string | number | boolean | null | undefined | ((event: Event) => void)>;

/** An element with attributes, listeners (`onclick`) and children. */
export function h<K extends keyof HTMLElementTagNameMap>(tag: K, props: Props = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  fill(element, props);
  element.append(...children.filter((child): child is Node | string => child !== null && child !== undefined && child !== false));
  return element;
}

/** An element of SVG. */
export function s<K extends keyof SVGElementTagNameMap>(tag: K, props: Props = {}, ...children: Node[]): SVGElementTagNameMap[K] {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  fill(element, props);
  element.append(...children);
  return element;
}

function fill(element: Element, props: Props): void {
  for (const [name, value] of Object.entries(props)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === 'function') element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? '' : String(value));
  }
}

/** The element with this id. */
export function at<T extends Element = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found as unknown as T;
}

/** A number as people read it: four decimals, as the program's tables have them, or so many digits. */
export function shown(value: number | null | undefined, digits?: number): string {
  if (value === null || value === undefined) return '–';
  const text = Number(digits === undefined ? value.toFixed(4) : value.toPrecision(digits)).toString();
  return text.replace('-', '−').replace(/^−0$/, '0');
}

/** What a page of the app tells of itself. */
export interface Host {
  /** Something else is shown; with `isEdit` the text is another one. */
  changed: (isEdit?: boolean) => void;
  /** Whether the text may be replaced: where it was changed and not saved, the person is asked. */
  leave: () => boolean;
  /** The text is saved as a file. */
  saved: () => void;
}

/** Gives a file to the reader. */
export function save(name: string, content: BlobPart, type: string): void {
  const link = h('a', { href: URL.createObjectURL(new Blob([content], { type })), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Tells screen readers, and people at the foot of the page. */
export function tell(message: string): void {
  const status = at('status');
  status.textContent = message;
  status.classList.add('fresh');
  clearTimeout(timer);
  timer = setTimeout(() => status.classList.remove('fresh'), 4000);
}
let timer: ReturnType<typeof setTimeout> | undefined;
