// Which page is shown: the part of the address behind `#`, such as `#/program/edit/O0001`.

function parse(hash: string): string[] {
  const parts = hash.replace(/^#\/?/, '').split('/').filter(Boolean);
  return parts.map((part) => {
    try {
      return decodeURIComponent(part);
    } catch {
      return part;
    }
  });
}

let parts = $state.raw<string[]>(parse(location.hash));

addEventListener('hashchange', () => {
  parts = parse(location.hash);
});

export const route = {
  /** The page. */
  get page(): string {
    return parts[0] ?? 'position';
  },
  /** Its part, such as a tab. */
  get tab(): string {
    return parts[1] ?? '';
  },
  /** What it is about, such as a program. */
  get item(): string {
    return parts[2] ?? '';
  },
};

/** The address of a page, for links. */
export function href(...to: string[]): string {
  return `#/${to.map(encodeURIComponent).join('/')}`;
}

/** Goes to a page. */
export function go(...to: string[]): void {
  location.hash = href(...to);
}
