import { __vitePreload } from "../_virtual/_vite/preload-helper.js";
// src/pages/index.ts
var pages = [
	{
		id: "position",
		icon: "position",
		load: () => __vitePreload(() => import("./position/Position.svelte.js"), [])
	},
	{
		id: "program",
		icon: "program",
		load: () => __vitePreload(() => import("./program/Program.svelte.js"), [])
	},
	{
		id: "offsets",
		icon: "system",
		load: () => __vitePreload(() => import("./offsets/Offsets.svelte.js"), [])
	},
	{
		id: "settings",
		icon: "settings",
		load: () => __vitePreload(() => import("./settings/Settings.svelte.js"), [])
	},
	{
		id: "graphics",
		icon: "graphics",
		load: () => __vitePreload(() => import("./graphics/Graphics.svelte.js"), [])
	},
	{
		id: "cycles",
		icon: "cycles",
		load: () => __vitePreload(() => import("./cycles/Cycles.svelte.js"), [])
	},
	{
		id: "diagnosis",
		icon: "diagnosis",
		load: () => __vitePreload(() => import("./diagnosis/Diagnosis.svelte.js"), [])
	},
	{
		id: "plc",
		icon: "plc",
		load: () => __vitePreload(() => import("./plc/Plc.svelte.js"), [])
	},
	{
		id: "alarms",
		icon: "alarms",
		load: () => __vitePreload(() => import("./alarms/Alarms.svelte.js"), [])
	},
	{
		id: "help",
		icon: "help",
		load: () => __vitePreload(() => import("./help/Help.svelte.js"), [])
	}
];
export { pages };
