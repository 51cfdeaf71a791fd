// What the drawing of a form shows: the shape to scale from above and in section, and a mark for each parameter.
import { distance } from './geometry';
import { subject, toward, type Item } from './items';
import { plan } from './plan';
import { section } from './section';
import type { Form, Request } from '$lib/api/cycles';
import type { Point } from './geometry';

export type Scene = { plan: Item[]; section: Item[] };

/** What a form looks like. */
export function scene(form: Form, request: Request): Scene {
  const of = subject(form, request);
  return { plan: plan(of), section: section(of) };
}

/** Every point of the items, for their box. */
export function places(items: Item[]): Point[] {
  return items.flatMap((item) => {
    switch (item.kind) {
      case 'line':
      case 'area':
        return item.points;
      case 'measure': {
        const long = distance(item.from, item.to) || 1;
        const [nx, ny] = [-(item.to[1] - item.from[1]) / long, (item.to[0] - item.from[0]) / long];
        return [item.from, item.to].flatMap((p): Point[] => [p, [p[0] + nx * item.aside, p[1] + ny * item.aside]]);
      }
      case 'angle':
        return [item.at, toward(item.at, item.from, item.radius), toward(item.at, item.to, item.radius)];
      default:
        return [item.at];
    }
  });
}
