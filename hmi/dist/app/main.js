import App from "./App.svelte.js";
import { load } from "./lib/i18n/index.svelte.js";
import { keepPrefs, prefs } from "./lib/state/prefs.svelte.js";
import { machine } from "./lib/state/machine.svelte.js";
import { mount } from "svelte";
// src/main.ts
keepPrefs();
await load(prefs.language);
machine.start();
var target = document.getElementById("app");
if (target) mount(App, { target });
