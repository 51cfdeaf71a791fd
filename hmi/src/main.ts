import './app.css';
import { mount } from 'svelte';
import App from './App.svelte';
import { load } from '$lib/i18n/index.svelte';
import { keepPrefs, prefs } from '$lib/state/prefs.svelte';
import { machine } from '$lib/state/machine.svelte';

keepPrefs();
await load(prefs.language);
machine.start();
const target = document.getElementById('app');
if (target) mount(App, { target });
