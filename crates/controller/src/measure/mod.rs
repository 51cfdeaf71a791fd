//! Measuring a work zero and a tool (GSK990MC part 2, 3.4.3): centre of a hole or boss, of a slot or web, along
//! angles, of an edge; length and diameter of a tool.
//!
//! Pure: [`shape`] makes centre and size of points, [`work`] and [`tool`] say which places the probe is sent to and
//! what its touches come to. Who moves the axes is [`Cnc::touch`](crate::Cnc::touch).
//!
//! A probe is led by three kinds of moves. A *guarded* one goes to a place through room that should be free; a touch on
//! it is an alarm. A *search* goes at its speed until it touches; the probe backs off a little and touches once more,
//! slowly: that touch counts. Then it returns to where the search began.

pub mod shape;
pub mod tool;
pub mod work;

use ferrocut_geometry::Position;
use ferrocut_machine::Fault;
use ferrocut_toolpath::SpindleState;

/// A touch, and the way to it. Machine positions, mm.
#[derive(Clone, PartialEq, Debug)]
pub struct Touch {
    /// Places to which guarded moves lead, one after the other. The search begins at the last of them.
    pub via: Vec<Position>,
    /// Where the search ends without a touch.
    pub limit: Position,
}

/// Speeds and distances of touches.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pace {
    /// Speed of guarded moves, mm/min.
    pub way: f64,
    /// Speed of the search, mm/min.
    pub search: f64,
    /// Speed of the touch that counts, mm/min.
    pub fine: f64,
    /// How far the probe backs off between the two, mm.
    pub back_off: f64,
}

impl Default for Pace {
    fn default() -> Pace {
        Pace { way: 1500.0, search: 300.0, fine: 60.0, back_off: 1.0 }
    }
}

/// Touches one after the other.
#[derive(Clone, PartialEq, Debug)]
pub struct Touching {
    /// The touches in their order.
    pub touches: Vec<Touch>,
    /// Places to which guarded moves lead behind the last.
    pub end: Vec<Position>,
    /// How fast.
    pub pace: Pace,
    /// What the spindle does meanwhile; it stands where there is nothing.
    pub spindle: Option<SpindleState>,
    /// What a search that meets nothing is.
    pub missed: Fault,
}

/// A size that cannot be measured with: its name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Unusable(pub &'static str);

/// A size above zero.
fn size(value: Option<f64>, name: &'static str) -> Result<f64, Unusable> {
    value.filter(|value| value.is_finite() && *value > 0.0).ok_or(Unusable(name))
}
