import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, sep } from 'node:path';
import { defineConfig, type Plugin } from 'vite';
import { vendor } from './build/vendor.ts';

/** Libraries of which only a part is used: the rest is left out. */
const parts: Record<string, string> = { three: 'build/three.ts' };

/** Writes the licences of everything that is bundled beside it. */
function licences(): Plugin {
  const folders = new Set<string>();
  return {
    name: 'licences',
    moduleParsed({ id }) {
      const at = id.lastIndexOf(`${sep}node_modules${sep}`);
      if (at < 0) return;
      const rest = id.slice(at + 14).split(sep);
      const name = rest[0]?.startsWith('@') ? `${rest[0]}/${rest[1]}` : rest[0];
      folders.add(join(id.slice(0, at), 'node_modules', name ?? ''));
    },
    generateBundle() {
      const texts = [...folders].sort().map((folder) => {
        const about = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
        const file = readdirSync(folder).find((name) => /^licen[cs]e/i.test(name));
        const text = file ? readFileSync(join(folder, file), 'utf8').trim() : about.license;
        return `${about.name} ${about.version} (${about.license})\n${'-'.repeat(60)}\n${text}\n`;
      });
      this.emitFile({ type: 'asset', fileName: 'LICENSES', source: texts.join('\n\n') });
    },
  };
}

export default defineConfig({
  plugins: [licences()],
  publicDir: false,
  define: { 'process.env.NODE_ENV': '"production"' },
  build: {
    outDir: 'dist/vendor',
    emptyOutDir: true,
    target: 'es2023',
    minify: false,
    modulePreload: false,
    rollupOptions: {
      input: Object.fromEntries(
        Object.entries(vendor).map(([name, file]) => [
          file,
          parts[name] ? join(dirname(new URL(import.meta.url).pathname), parts[name]) : name,
        ]),
      ),
      preserveEntrySignatures: 'strict',
      output: { entryFileNames: '[name].js', chunkFileNames: 'shared/[name].js', hashCharacters: 'hex' },
    },
  },
});
