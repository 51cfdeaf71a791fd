// Draws digits in a thread of its own: a number that changes 50 times a second costs the page no style, layout or paint.
import type { Place, Shown, Told } from './protocol';

type Sheet = { context: OffscreenCanvasRenderingContext2D; places: Place[]; shown: Shown[] };

const sheets = new Map<number, Sheet>();
/** Widths of characters, by font. */
const widths = new Map<string, Map<string, number>>();

/** px. All digits are as wide as the widest, so that they stand still while they change. */
function widthOf(context: OffscreenCanvasRenderingContext2D, character: string): number {
  let known = widths.get(context.font);
  if (!known) {
    const wide = Math.max(...[...'0123456789'].map((digit) => context.measureText(digit).width));
    known = new Map([...'0123456789'].map((digit) => [digit, wide]));
    widths.set(context.font, known);
  }
  let width = known.get(character);
  if (width === undefined) known.set(character, (width = context.measureText(character).width));
  return width;
}

function draw({ context, places, shown }: Sheet): void {
  context.clearRect(0, 0, context.canvas.width, context.canvas.height);
  context.textAlign = 'center';
  shown.forEach(({ text, tone }, index) => {
    const place = places[index];
    if (!place) return;
    context.font = place.font;
    context.fillStyle = place.colours[tone] ?? place.colours[0] ?? '';
    const base = place.middle + context.measureText('0').actualBoundingBoxAscent / 2;
    const steps = [...text].map((character) => widthOf(context, character) + place.spacing);
    let at = place.edge;
    if (place.align === 'right') at -= steps.reduce((sum, step) => sum + step, -place.spacing);
    [...text].forEach((character, turn) => {
      const step = steps[turn]!;
      context.fillText(character, at + (step - place.spacing) / 2, base);
      at += step;
    });
  });
}

addEventListener('message', ({ data }: MessageEvent<Told>) => {
  switch (data.do) {
    case 'new': {
      const context = data.canvas.getContext('2d');
      // The page hears of it, and writes the numbers itself.
      if (!context) throw new Error();
      sheets.set(data.sheet, { context, places: [], shown: [] });
      return;
    }
    case 'look': {
      const sheet = sheets.get(data.sheet);
      if (!sheet) return;
      [sheet.context.canvas.width, sheet.context.canvas.height] = [data.width, data.height];
      sheet.places = data.places;
      draw(sheet);
      return;
    }
    case 'show':
      for (const [number, shown] of data.numbers) {
        const sheet = sheets.get(number);
        if (!sheet) continue;
        sheet.shown = shown;
        draw(sheet);
      }
      return;
    case 'drop':
      sheets.delete(data.sheet);
  }
});
