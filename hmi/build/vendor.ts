// What comes from others is bundled once, a file a library, and is reached by an import map: so a change of a page
// changes the file of that page and no other, and two builds of the same source are the same to the byte.

/** Names of modules, as the source imports them, and the file of `dist/vendor` that has them. */
export const vendor: Record<string, string> = {
  svelte: 'svelte',
  'svelte/attachments': 'svelte-attachments',
  'svelte/reactivity': 'svelte-reactivity',
  'svelte/internal/client': 'svelte-internal-client',
  'svelte/internal/disclose-version': 'svelte-internal-disclose-version',
  three: 'three',
  '@codemirror/autocomplete': 'codemirror-autocomplete',
  '@codemirror/commands': 'codemirror-commands',
  '@codemirror/language': 'codemirror-language',
  '@codemirror/lint': 'codemirror-lint',
  '@codemirror/search': 'codemirror-search',
  '@codemirror/state': 'codemirror-state',
  '@codemirror/view': 'codemirror-view',
  uplot: 'uplot',
};

/** The import map of the page. */
export function importMap(): string {
  const imports = Object.fromEntries(Object.entries(vendor).map(([name, file]) => [name, `/vendor/${file}.js`]));
  return JSON.stringify({ imports }, null, 2);
}
