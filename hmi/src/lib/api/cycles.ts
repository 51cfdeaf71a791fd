// What the cycle editor asks and is answered (docs/cycles.md).
// Written from crates/editor by `FERROCUT_WRITE=1 cargo test -p ferrocut-server types`.

/**
 * A value of a field.
 */
export type Value = number | string;

/**
 * A value that a fresh form holds.
 */
export type Fresh = number | string;

/**
 * A choice of a field.
 */
export type Choice = {
/**
 * The word in a block.
 */
value: string,
/**
 * What it is called.
 */
title: string, };

/**
 * A field of a form.
 */
export type FormField = {
/**
 * Key of its value: the parameter's name, behind its stage and a point where that is not the cycle itself
 * (`ZS`, `rough.F`).
 */
name: string,
/**
 * The stage: `cycle`, `drill`, `rough`, `semi` or `finish`.
 */
stage: string,
/**
 * The manual's symbol, `Fz`; empty for choices.
 */
symbol: string,
/**
 * What it means.
 */
meaning: string,
/**
 * What it stands with: `place`, `shape`, `planes`, `cutting` or `tool`.
 */
group: string,
/**
 * What it measures: `length`, `angle`, `feed`, `speed`, `time`, `count`, `factor`, `tool`, `number`,
 * `choice`, `name`.
 */
kind: string,
/**
 * Sign of its unit.
 */
unit: string,
/**
 * Least value; none for words.
 */
minimum: number | null,
/**
 * Greatest value.
 */
maximum: number | null,
/**
 * What a fresh form holds; none where it is empty.
 */
standard: Fresh | null,
/**
 * The words of a choice.
 */
choices: Array<Choice>, };

/**
 * A figure of positions.
 */
export type FigureForm = {
/**
 * `LINE`, `ARC`, `RECT`, `GRID` or `POINTS`.
 */
kind: string,
/**
 * What it is called.
 */
title: string,
/**
 * Its fields; none where it is a list of points.
 */
parameters: Array<FormField>,
/**
 * Points that it may list at most; 0 where it has none.
 */
points: number, };

/**
 * What a cycle needs of a profile.
 */
export type ProfileUse = "none" | "points" | "path" | "contours" | "depths";

/**
 * A cycle as a form.
 */
export type Form = {
/**
 * `G281` to `G299`, `P2D`, `P3D`.
 */
id: string,
/**
 * Key of its group: `axis`, `pockets`, `bosses`, `milling` or `profiles`.
 */
group: string,
/**
 * What the group is called.
 */
group_title: string,
/**
 * What it is called.
 */
title: string,
/**
 * Its stages in order.
 */
stages: Array<Choice>,
/**
 * Its fields.
 */
parameters: Array<FormField>,
/**
 * Figures that it may be repeated on.
 */
positions: Array<FigureForm>,
/**
 * What it needs of a profile.
 */
profile: ProfileUse, };

/**
 * What is made of a corner.
 */
export type CornerKind = "round" | "chamfer";

/**
 * A corner that is not sharp.
 */
export type Corner = {
/**
 * What is made of it.
 */
kind: CornerKind,
/**
 * Radius, or length along each side, mm.
 */
size: number, };

/**
 * An element of a contour.
 */
export type Element = { "kind": "line",
/**
 * End point, mm.
 */
to: [number, number],
/**
 * What is made of the corner at its end.
 */
corner?: Corner | null, } | { "kind": "arc",
/**
 * End point, mm.
 */
to: [number, number],
/**
 * Centre, mm.
 */
center: [number, number],
/**
 * The way round.
 */
clockwise: boolean,
/**
 * What is made of the corner at its end.
 */
corner?: Corner | null, };

/**
 * A contour.
 */
export type Contour = {
/**
 * Where it begins, mm.
 */
start: [number, number],
/**
 * Its elements, each from where the one before ends.
 */
elements: Array<Element>,
/**
 * Radius of a tangential way in, mm; 0 for none (4.21).
 */
entry?: number,
/**
 * The same of the way out.
 */
exit?: number, };

/**
 * The plane of a profile of depth.
 */
export type DepthPlane = "XZ" | "YZ";

/**
 * A profile of depth: its abscissa, and the tool axis.
 */
export type Depth = {
/**
 * `XZ` or `YZ`.
 */
plane: DepthPlane,
/**
 * What it looks like.
 */
contour: Contour, };

/**
 * A profile in the plane.
 */
export type Profile = {
/**
 * The outer contour, then islands.
 */
contours: Array<Contour>, };

/**
 * A figure of positions.
 */
export type Positions = {
/**
 * `LINE`, `ARC`, `RECT`, `GRID` or `POINTS`.
 */
kind: string,
/**
 * Values by name.
 */
values: { [key in string]: Value },
/**
 * The points behind the first, mm; of `POINTS` alone.
 */
points: Array<[number, number]>, };

/**
 * What is known of a tool; what is missing is as the machine's table has it.
 */
export type ToolData = {
/**
 * Its number.
 */
number: number,
/**
 * Its diameter, mm.
 */
diameter?: number | null,
/**
 * Length of its cutting edge, mm; 0 where not known.
 */
cutting_length?: number | null,
/**
 * Steepest angle at which it may enter the material, degrees; 0 where not known.
 */
entry_angle?: number | null,
/**
 * Radius of its rounded tip, mm.
 */
tip_radius?: number | null, };

/**
 * A cycle as a form was filled in.
 */
export type Request = {
/**
 * The cycle, `G287`.
 */
cycle: string,
/**
 * Values by the name of their field. What is left out is what the control takes for it.
 */
values: { [key in string]: Value },
/**
 * The figure that it is repeated on: none or one.
 */
positions: Array<Positions>,
/**
 * The profile, where the cycle follows or clears one.
 */
profile?: Profile | null,
/**
 * Profiles of depth, of the outer contour and of islands (4.16).
 */
depths: Array<Depth>,
/**
 * What is to be taken for tools instead of the machine's table.
 */
tools: Array<ToolData>, };

/**
 * A finding as a form shows it.
 */
export type Finding = {
/**
 * The field: the name of a value, `positions.N`, `profile`; empty where it is of the cycle as a whole.
 */
parameter: string,
/**
 * The alarm, `FC-0302`.
 */
id: string,
/**
 * `error` or `warning`.
 */
severity: 'error' | 'warning',
/**
 * What is wrong.
 */
text: string,
/**
 * What to do; empty where nothing is known.
 */
help: string, };

export type Written = { text: string, expanded: boolean, findings: Array<Finding>, };

export type Drawn = { closed: boolean,
/**
 * Where it begins, mm.
 */
start: [number, number],
/**
 * Its elements, each from where the one before ends.
 */
elements: Array<Element>,
/**
 * Radius of a tangential way in, mm; 0 for none (4.21).
 */
entry?: number,
/**
 * The same of the way out.
 */
exit?: number, };

export type Drawing = { contours: Array<Drawn>, findings: Array<Finding>, };
