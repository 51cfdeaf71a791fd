import { svelte } from '@sveltejs/vite-plugin-svelte';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';
import type { Plugin } from 'vite';
import { importMap, vendor } from './build/vendor.ts';

const at = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** Puts the import map into the page, and of the scripts only the first: it names the others. */
function mapped(): Plugin {
  return {
    name: 'import-map',
    apply: 'build',
    enforce: 'post',
    // A remark whose length is that of the folder's name: the build is to be the same in every folder.
    generateBundle(_, bundle) {
      for (const file of Object.values(bundle)) {
        if (file.type === 'chunk') file.code = file.code.replace(/\/\* empty css\s*\*\/\n?/g, '');
      }
    },
    transformIndexHtml: {
      order: 'post',
      handler: (html) =>
        html
          .replace(/\s*<script type="module"[^>]*><\/script>/g, '')
          .replace(
            '</head>',
            `<script type="importmap">${importMap()}</script>\n` +
              '<script type="module" src="/app/main.js"></script>\n</head>',
          ),
    },
  };
}

/** The file of a module: that of a component and that of its style are told apart. */
function named(chunk: { facadeModuleId?: string | null }): string {
  const id = chunk.facadeModuleId ?? '';
  if (id.includes('type=style')) return 'app/[name].style.js';
  return id.endsWith('.svelte') ? 'app/[name].svelte.js' : 'app/[name].js';
}

// One file of `dist` a file of the source, not minified and without hashes in names, so that changes of different
// files merge in `dist` as they do in `src`. `vite.vendor.config.ts` bundles what comes from others.
export default defineConfig({
  plugins: [svelte(), mapped()],
  resolve: { alias: { $lib: at('./src/lib'), $pages: at('./src/pages') } },
  json: { namedExports: false },
  server: { proxy: { '/api': { target: 'http://127.0.0.1:8080', ws: true } } },
  build: {
    outDir: 'dist',
    emptyOutDir: false,
    target: 'es2023',
    minify: false,
    cssMinify: false,
    cssCodeSplit: false,
    modulePreload: false,
    assetsInlineLimit: 0,
    reportCompressedSize: false,
    rollupOptions: {
      external: Object.keys(vendor),
      output: {
        preserveModules: true,
        preserveModulesRoot: at('./src'),
        entryFileNames: named,
        chunkFileNames: named,
        assetFileNames: 'app/[name][extname]',
      },
    },
  },
  worker: { rollupOptions: { output: { entryFileNames: 'app/lib/digits/[name].js' } } },
  test: { include: ['src/**/*.test.ts'], environment: 'node' },
});
