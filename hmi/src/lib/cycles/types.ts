// What the server says of cycles, and what it is asked (`crates/editor`).

export type Point = [number, number];
export type Value = number | string;
export type Values = Record<string, Value>;

export type Choice = { value: string; title: string };

export type Field = {
  /** Key of its value: `ZS`, `rough.F`. */
  name: string;
  stage: string;
  /** The manual's symbol. */
  symbol: string;
  meaning: string;
  group: 'place' | 'shape' | 'planes' | 'cutting' | 'tool';
  kind: string;
  unit: string;
  minimum: number | null;
  maximum: number | null;
  standard: Value | null;
  choices: Choice[];
};

export type FigureForm = { kind: string; title: string; parameters: Field[]; points: number };

export type Form = {
  id: string;
  group: string;
  group_title: string;
  title: string;
  stages: Choice[];
  parameters: Field[];
  positions: FigureForm[];
  profile: 'none' | 'points' | 'path' | 'contours' | 'depths';
};

export type Corner = { kind: 'round' | 'chamfer'; size: number };

export type Element =
  | { kind: 'line'; to: Point; corner?: Corner | null }
  | { kind: 'arc'; to: Point; center: Point; clockwise: boolean; corner?: Corner | null };

export type Contour = { start: Point; elements: Element[]; entry?: number; exit?: number };
export type Depth = { plane: 'XZ' | 'YZ'; contour: Contour };
export type Positions = { kind: string; values: Values; points: Point[] };
export type Tool = { number: number; diameter: number; cutting_length: number; entry_angle: number };

export type Request = {
  cycle: string;
  values: Values;
  positions: Positions[];
  profile: { contours: Contour[] } | null;
  depths: Depth[];
  tools: Tool[];
};

export type Finding = { parameter: string; id: string; severity: 'error' | 'warning'; text: string; help: string };
export type Written = { text: string; expanded: boolean; findings: Finding[] };
export type FromDrawing = { contours: (Contour & { closed: boolean })[]; findings: Finding[] };
