//! In which direction an axis moves, as backlash and pitch errors see it.
//!
//! GSK990MC P189: an axis has turned back once it moves back by more than α in one servo period. A large α
//! spreads the place of compensation over a width, so that the rows of a surface leave no ridge; a small one puts
//! it where a circle crosses its axis. At creeping speed no period reaches α, so a way altogether counts too
//! (P188, which the manual has for Z).

/// The direction of one axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Direction {
    /// 1 or −1.
    side: f64,
    /// The farthest place on this side since it was turned to.
    farthest: f64,
    step: f64,
    way: f64,
}

impl Direction {
    /// An axis at `at` that moved last in the positive direction, or not.
    pub fn new(at: f64, is_positive: bool, step: f64, way: f64) -> Direction {
        Direction { side: if is_positive { 1.0 } else { -1.0 }, farthest: at, step, way }
    }

    /// The axis moved by `d` to `at`; 1 or −1.
    #[inline]
    pub fn follow(&mut self, d: f64, at: f64) -> f64 {
        let back = -d * self.side;
        if back > 0.0 {
            if back > self.step || (self.farthest - at) * self.side > self.way {
                self.side = -self.side;
                self.farthest = at;
            }
        } else if (at - self.farthest) * self.side > 0.0 {
            self.farthest = at;
        }
        self.side
    }

    /// The place where the axis stands is called `at`.
    pub fn rename(&mut self, at: f64) {
        self.farthest = at;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_has_turned_back_by_step_or_by_way() {
        let mut direction = Direction::new(0.0, true, 0.01, 0.05);
        let mut at = 0.0;
        let mut go = |d: f64| {
            at += d;
            direction.follow(d, at)
        };
        assert_eq!([go(1.0), go(-0.01), go(-0.011)], [1.0, 1.0, -1.0]);
        // Creeping back: 0.05 and a bit from the farthest place.
        assert_eq!(go(-0.5), -1.0);
        for k in 1..=6 {
            assert_eq!(go(0.009), if k < 6 { -1.0 } else { 1.0 }, "after {k} periods");
        }
        // To and fro within the way is no reversal, however often.
        for _ in 0..50 {
            assert_eq!([go(-0.009), go(0.009)], [1.0, 1.0]);
        }
    }
}
