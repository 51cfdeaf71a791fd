//! Leaves out lines that lie under others.
//!
//! A million moves on half a million pixels cover each other many times over. Lines are offered from
//! the nearest to the furthest; one is hidden where every pixel of it has so much line over it that
//! nothing can shine through. That keeps large drawings fast and files small.

use super::canvas::{Lines, Point, Rect};

/// Parts of a pixel that line over it is counted in.
const PARTS: f64 = 16.0;
/// Line over a pixel that covers it: four pixels' length, for lines are a pixel wide with soft edges.
const OPAQUE: u8 = 64;

/// How much line lies over each pixel of a frame.
pub struct Cover {
    frame: Rect,
    columns: usize,
    over: Vec<u8>,
}

impl Cover {
    /// A frame with nothing in it yet.
    pub fn new(frame: Rect) -> Cover {
        let columns = frame.width.ceil() as usize + 1;
        let rows = frame.height.ceil() as usize + 1;
        Cover { frame, columns, over: vec![0; columns * rows] }
    }

    /// The lines that can be seen past what was offered before. All lie within the frame.
    pub fn visible(&mut self, lines: &Lines) -> Lines {
        let mut seen = Lines::default();
        for polyline in lines.iter() {
            if let [point] = polyline {
                seen.polyline([*point]);
            }
            for (a, b) in polyline.iter().zip(polyline.iter().skip(1)) {
                if self.lay(*a, *b) {
                    seen.segment(*a, *b);
                }
            }
        }
        seen
    }

    /// Lays a line over its pixels; whether one of them was still open.
    fn lay(&mut self, a: Point, b: Point) -> bool {
        let d = [b[0] - a[0], b[1] - a[1]];
        let steps = d[0].abs().max(d[1].abs()).ceil().max(1.0);
        let each = (d[0].hypot(d[1]) / (steps + 1.0) * PARTS).ceil().max(1.0) as u8;
        let mut open = false;
        let mut i = 0.0;
        while i <= steps {
            let column = (a[0] + d[0] * i / steps - self.frame.x) as usize;
            let row = (a[1] + d[1] * i / steps - self.frame.y) as usize;
            if let Some(over) = self.over.get_mut(row * self.columns + column.min(self.columns - 1)) {
                open |= *over < OPAQUE;
                *over = over.saturating_add(each);
            }
            i += 1.0;
        }
        open
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_hidden_once_enough_lie_over_it() {
        let mut cover = Cover::new(Rect { x: 10.0, y: 10.0, width: 100.0, height: 50.0 });
        let line = Lines::of(&[&[[20.0, 20.0], [90.0, 40.0]]]);
        let seen = (0..20).take_while(|_| !cover.visible(&line).is_empty()).count();
        assert!((3..6).contains(&seen), "{seen}");
        let longer = Lines::of(&[&[[20.0, 20.0], [90.0, 40.0], [105.0, 40.0]]]);
        assert_eq!(cover.visible(&longer).iter().next(), Some(&[[90.0, 40.0], [105.0, 40.0]][..]));
    }

    #[test]
    fn a_line_in_many_short_pieces_hides_no_more_than_a_whole_one() {
        let mut cover = Cover::new(Rect { x: 0.0, y: 0.0, width: 20.0, height: 20.0 });
        let mut pieces = Lines::default();
        pieces.polyline((0..=100).map(|i| [f64::from(i) * 0.1, 5.0]));
        cover.visible(&pieces);
        assert_eq!(cover.visible(&Lines::of(&[&[[0.0, 5.0], [10.0, 5.0]]])).len(), 2);
    }

    #[test]
    fn corners_of_the_frame_are_within() {
        let frame = Rect { x: 0.0, y: 0.0, width: 9.5, height: 9.5 };
        let mut cover = Cover::new(frame);
        let border = Lines::of(&[&frame.corners()]);
        assert_eq!(cover.visible(&border).len(), 4);
    }
}
