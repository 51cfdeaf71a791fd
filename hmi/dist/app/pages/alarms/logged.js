// src/pages/alarms/logged.ts
var WHO = [
	[/^panel from (?<address>.+)$/, "log.panel"],
	[/^connection (?<number>\d+) from (?<address>.+)$/, "log.connection_from"],
	[/^connection (?<number>\d+)$/, "log.connection"],
	[/^control$/, "log.control"],
	[/^ferrocut memory \((?<user>.+)\)$/, "log.maintenance_of"],
	[/^ferrocut memory$/, "log.maintenance"]
];
/** Names of what was changed, by item. */
var NAMES = {
	rights: [
		[/^log in (?<level>\d)$/, "log.log_in"],
		[/^password (?<level>\d)$/, "log.password"],
		[/^command$/, "log.command"],
		[/^log out$/, "log.log_out"]
	],
	memory: [
		[/^restored$/, "log.restored"],
		[/^uploaded$/, "log.uploaded"],
		[/^recovered$/, "log.recovered"]
	],
	ladder: [[/^exchanged$/, "log.exchanged"]],
	position: [[/^machine zero (?<axis>[A-Z])$/, "log.machine_zero"]],
	alarms: [[/^all$/, "log.all"]],
	log: [[/^all$/, "log.all"]],
	counters: [
		"parts",
		"all-parts",
		"run-time",
		"cutting-time",
		"all-cutting-time",
		"power-on-time",
		"starts"
	].map((name) => [new RegExp(`^${name}$`), `log.${name}`]),
	offsets: [
		"length",
		"length_wear",
		"radius",
		"radius_wear",
		"cutting_length",
		"entry_angle",
		"tip_radius"
	].map((name) => [new RegExp(`^(?<number>\\d+) ${name}$`), `log.offset_${name}`])
};
/** What it was and became, by item. */
var VALUES = {
	rights: [
		[/^machine$/, "log.machine"],
		[/^network$/, "log.network"],
		[/^right$/, "log.right"],
		[/^wrong$/, "log.wrong"],
		[/^set$/, "log.set"],
		[/^taken$/, "log.taken"],
		[/^left$/, "log.left"],
		[/^asked for$/, "log.asked"],
		[/^asked for no longer$/, "log.withdrawn"],
		[/^handed over to connection (?<number>\d+)$/, "log.handed_over"],
		[/^declined to connection (?<number>\d+)$/, "log.declined"]
	],
	programs: [[/^locked (?<level>\d)$/, "log.locked"], [/^(?<size>\d+)$/, "log.bytes"]],
	plc: [[/^released$/, "log.released"], [/^forced (?<value>[01])$/, "log.forced"]],
	memory: [
		[/^memory\.db: missing$/, "log.finding_missing"],
		[/^memory\.db: schema$/, "log.finding_schema"],
		[/^memory\.db: (?<table>\w+): row_sum$/, "log.finding_row"],
		[/^memory\.db: (?<table>\w+): total$/, "log.finding_total"],
		[/^memory\.db-wal: commits (?<found>\d+) < (?<reported>\d+)$/, "log.finding_commits"],
		[/^mark: missing$/, "log.finding_mark"],
		[/^memory\.db: (?<said>.+)$/, "log.finding_structure"]
	]
};
function said(words, rules = [], { t }) {
	for (const [form, key] of rules) {
		const found = form.exec(words);
		if (found) return t(key, found.groups);
	}
	return words;
}
/** An entry, as it is shown. */
function logged(entry, texts) {
	const { t, has } = texts;
	const item = (name) => has(`item.${name}`) ? t(`item.${name}`) : name;
	const value = (words) => {
		const names = entry.item === "memory" ? words.split(" ") : [];
		return names.length && names.every((name) => has(`item.${name}`)) ? names.map(item).join(", ") : said(words, VALUES[entry.item], texts);
	};
	return {
		who: said(entry.who, WHO, texts),
		item: item(entry.item),
		name: said(entry.name, NAMES[entry.item], texts),
		from: value(entry.from),
		to: value(entry.to)
	};
}
export { logged };
