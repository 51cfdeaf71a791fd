import { render } from 'svelte/server';
import { describe, expect, it, vi } from 'vitest';
import { load, t } from '$lib/i18n/index.svelte';
import type { Language } from '$lib/state/prefs.svelte';
import StopButton from './StopButton.svelte';

const machine = vi.hoisted(() => ({ gate: null as boolean | null, status: null }));
const prefs = vi.hoisted(() => ({ language: 'en' as Language }));
vi.mock('$lib/state/machine.svelte', () => ({ machine }));
vi.mock('$lib/state/prefs.svelte', () => ({ prefs }));

/** The key as it is drawn before and behind the gate of a log-in. */
function key(gate: boolean | null): string {
  machine.gate = gate;
  return render(StopButton).body;
}

const languages: Language[] = ['en', 'zh', 'ru', 'es', 'tr'];
describe.each(languages)('the emergency stop in %s', (language) => {
  it('is no key before a log-in that is demanded, and says why', async () => {
    prefs.language = language;
    await load(language);
    const drawn = key(true);
    expect(drawn).toMatch(/<button[^>]* disabled/);
    expect(drawn).toContain(t('rights.gate'));
    expect(drawn).toContain(t('panel.emergency_locked'));
  });
  it.each([false, null])('is a key elsewhere, also while nothing is known of a gate (%s)', (gate) => {
    const drawn = key(gate);
    expect(drawn).not.toMatch(/<button[^>]* disabled/);
    expect(drawn).toContain(t('panel.emergency'));
    expect(drawn).not.toContain(t('panel.emergency_locked'));
  });
});
