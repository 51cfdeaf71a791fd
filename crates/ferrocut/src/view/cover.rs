//! Leaves out lines that lie under others.
//!
//! A million moves on half a million pixels cover each other many times over. Lines are offered from
//! the nearest to the furthest; one is hidden where every pixel of it has been crossed often enough
//! for nothing to shine through. That keeps large drawings fast and files small.

use super::canvas::{Lines, Point, Rect};

/// Crossings that cover a pixel: lines are about a pixel wide with soft edges.
const OPAQUE: u8 = 3;

/// How often the pixels of a frame were crossed.
pub struct Cover {
    frame: Rect,
    columns: usize,
    crossed: Vec<u8>,
}

impl Cover {
    /// A frame that nothing crosses yet.
    pub fn new(frame: Rect) -> Cover {
        let columns = frame.width.ceil() as usize + 1;
        let rows = frame.height.ceil() as usize + 1;
        Cover { frame, columns, crossed: vec![0; columns * rows] }
    }

    /// The lines that can be seen past what was offered before. All lie within the frame.
    pub fn visible(&mut self, lines: &Lines) -> Lines {
        let mut seen = Lines::default();
        for polyline in lines.iter() {
            if let [point] = polyline {
                seen.polyline([*point]);
            }
            for (a, b) in polyline.iter().zip(polyline.iter().skip(1)) {
                if self.cross(*a, *b) {
                    seen.segment(*a, *b);
                }
            }
        }
        seen
    }

    /// Crosses the pixels from `a` to `b`; whether one of them was still open.
    fn cross(&mut self, a: Point, b: Point) -> bool {
        let d = [b[0] - a[0], b[1] - a[1]];
        let steps = d[0].abs().max(d[1].abs()).ceil().max(1.0);
        let mut open = false;
        let mut i = 0.0;
        while i <= steps {
            let column = (a[0] + d[0] * i / steps - self.frame.x) as usize;
            let row = (a[1] + d[1] * i / steps - self.frame.y) as usize;
            if let Some(crossed) = self.crossed.get_mut(row * self.columns + column.min(self.columns - 1)) {
                open |= *crossed < OPAQUE;
                *crossed = crossed.saturating_add(1);
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
        for _ in 0..OPAQUE {
            assert_eq!(cover.visible(&line).len(), 2);
        }
        assert!(cover.visible(&line).is_empty());
        let longer = Lines::of(&[&[[20.0, 20.0], [90.0, 40.0], [105.0, 40.0]]]);
        assert_eq!(cover.visible(&longer).iter().next(), Some(&[[90.0, 40.0], [105.0, 40.0]][..]));
    }

    #[test]
    fn corners_of_the_frame_are_within() {
        let frame = Rect { x: 0.0, y: 0.0, width: 9.5, height: 9.5 };
        let mut cover = Cover::new(frame);
        let border = Lines::of(&[&frame.corners()]);
        assert_eq!(cover.visible(&border).len(), 4);
    }
}
