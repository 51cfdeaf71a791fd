// Draws digits in a thread of its own: a number that changes 50 times a second costs the page no style, layout or paint.
import { shareOf, smaller } from './fit';
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
    context.fillStyle = place.colours[tone] ?? place.colours[0] ?? '';
    const characters = [...text];
    const widthAt = (share: number) => {
      context.font = share === 1 ? place.font : smaller(place.font, share);
      return characters.reduce((sum, character) => sum + widthOf(context, character), (characters.length - 1) * place.spacing * share);
    };
    let width = widthAt(1);
    const share = shareOf(width, place);
    if (share < 1) width = widthAt(share);
    const spacing = place.spacing * share;
    const base = place.middle + context.measureText('0').actualBoundingBoxAscent / 2;
    let at = place.align === 'right' ? place.edge - width : place.edge;
    for (const character of characters) {
      const own = widthOf(context, character);
      context.fillText(character, at + own / 2, base);
      at += own + spacing;
    }
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
