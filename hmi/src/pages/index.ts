// The pages, in the order of the navigation. Each is a folder of its own, loaded when it is first shown, with a
// catalogue of its own in `src/locales/LANGUAGE/ID.json`, whose key `title` names it.
import type { Component } from 'svelte';
import type { IconName } from '$lib/parts/icons';

export type Page = { id: string; icon: IconName; load: () => Promise<{ default: Component }> };

export const pages: Page[] = [
  { id: 'position', icon: 'position', load: () => import('./position/Position.svelte') },
  { id: 'program', icon: 'program', load: () => import('./program/Program.svelte') },
  { id: 'offsets', icon: 'system', load: () => import('./offsets/Offsets.svelte') },
  { id: 'settings', icon: 'settings', load: () => import('./settings/Settings.svelte') },
  { id: 'graphics', icon: 'graphics', load: () => import('./graphics/Graphics.svelte') },
  { id: 'cycles', icon: 'cycles', load: () => import('./cycles/Cycles.svelte') },
  { id: 'diagnosis', icon: 'diagnosis', load: () => import('./diagnosis/Diagnosis.svelte') },
  { id: 'plc', icon: 'plc', load: () => import('./plc/Plc.svelte') },
  { id: 'alarms', icon: 'alarms', load: () => import('./alarms/Alarms.svelte') },
  { id: 'help', icon: 'help', load: () => import('./help/Help.svelte') },
];
