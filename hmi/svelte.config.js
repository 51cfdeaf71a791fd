/** @type {import('@sveltejs/vite-plugin-svelte').SvelteConfig} */
export default {
  compilerOptions: {
    runes: true,
    // Of the style alone, so that the build is the same in every folder.
    cssHash: ({ hash, css }) => `s-${hash(css)}`,
  },
};
