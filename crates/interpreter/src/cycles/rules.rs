//! What controls do differently in their canned cycles.

use ferrocut_geometry::Axis;

/// What the word that counts holes means.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Repeat {
    /// The block is carried out so many times; with G91 each hole lies one step further (Fanuc's K).
    Block,
    /// So many holes at equal distances on the line from the present place, which is not drilled, to the
    /// programmed one (Kaitong's L). Without a programmed place all are at the present one.
    Line,
}

/// What a peck cycle does that was given no depth of cut.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum NoDepth {
    /// An alarm.
    Alarm,
    /// It positions and cuts nothing.
    Position,
    /// It takes this one, mm.
    Depth(f64),
}

/// What the spindle does after a cycle that stopped it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Restart {
    /// What it did before.
    AsBefore,
    /// It turns clockwise.
    Clockwise,
}

/// How fast the spindle may turn in rigid tapping, r/min.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RigidSpeeds {
    /// In any gear.
    pub highest: f64,
    /// In each gear.
    pub in_gear: [f64; 4],
    /// Up to which speed the spindle turns in the first and in the second gear; none where the ladder chooses it,
    /// and the machine judges the speed in the gear that is engaged.
    pub gear_up_to: Option<[f64; 2]>,
}

impl RigidSpeeds {
    /// The highest speed in the gear that `rpm` needs.
    pub fn limit(&self, rpm: f64) -> f64 {
        let [first, second, third, fourth] = self.in_gear;
        let in_gear = match self.gear_up_to {
            None => first.max(second).max(third).max(fourth),
            Some([up_to, _]) if rpm <= up_to => first,
            Some([_, up_to]) if rpm <= up_to => second,
            Some(_) => third,
        };
        in_gear.min(self.highest)
    }
}

/// How the feed of a tapping cycle comes about.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Tapping {
    /// F is the feed of G94 or G95. Rigid after a code of its own (M29), else with a floating holder;
    /// with Q in steps.
    Feed {
        /// Rigid tapping is fitted.
        rigid: bool,
        /// Highest spindle speeds of it.
        rigid_speeds: RigidSpeeds,
        /// Speed of the spindle on the way out of a rigidly tapped thread, over that on the way in.
        rigid_retract: f64,
        /// It begins with an oriented spindle stop.
        rigid_orients: bool,
        /// Steps draw back only a little (else to the R level).
        steps_are_fast: bool,
        /// How far, where V does not say, mm.
        retract: f64,
    },
    /// With a floating holder in one stroke, whatever the spindle's speed. F is the feed.
    Floating,
    /// Always rigid. F is the pitch in mm, I the threads per inch, in force until the next one, also when
    /// the cycle ends.
    Pitch {
        /// Smallest and largest F, mm.
        pitch: (f64, f64),
        /// Smallest and largest I, threads per inch.
        threads: (f64, f64),
    },
}

/// Numbers and choices of the canned cycles, in millimetres and seconds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rules {
    /// The address that counts holes.
    pub repeat_letter: u8,
    /// The address that counts them where that one is missing.
    pub other_repeat_letter: Option<u8>,
    /// What it means.
    pub repeat: Repeat,
    /// A negative count is as good as its amount; else it is an alarm.
    pub repeats_lose_sign: bool,
    /// Cycles work in X, Y and along Z whatever the plane; else G18 and G19 are alarms.
    pub in_any_plane: bool,
    /// Retract of chip breaking (G73).
    pub chip_break_retract: f64,
    /// Gap at which rapid ends above the last depth (G83).
    pub peck_clearance: f64,
    /// Peck cycles without depth of cut.
    pub no_depth: NoDepth,
    /// Distance that the tool is moved aside by the sign of its shift in boring (G76, G87): axis and
    /// direction.
    pub shift: (Axis, f64),
    /// How far, where Q does not say.
    pub default_shift: f64,
    /// The spindle after G76, G86, G87 and G88.
    pub restart: Restart,
    /// Whether it is started again behind G87 before the tool is moved back, not behind that.
    pub restart_aside: bool,
    /// Tapping.
    pub tapping: Tapping,
    /// Highest spindle speed of tapping that is not rigid by such a code, r/min.
    pub max_tapping_rpm: f64,
    /// Shortest and longest dwell.
    pub dwell: (f64, f64),
    /// Seconds that P1 stands for.
    pub dwell_p_unit_s: f64,
    /// A cycle needs a spindle speed that was once given.
    pub needs_speed: bool,
    /// Codes of tool length are without effect but in the block that starts the cycle mode; and what that
    /// block takes up does not change the machine height of the initial level.
    pub length_at_start_only: bool,
    /// A cycle stays in force beside motion codes; else they end it.
    pub stand_beside_motion: bool,
    /// Boring is done only in a block with an axis; else R alone is enough, as it is for drilling.
    pub boring_needs_axis: bool,
    /// Radius of the helix by which a pocket is entered, over the tool radius.
    pub pocket_helix_factor: f64,
}

/// Those of a control whose cycles read none of it.
impl Default for Rules {
    fn default() -> Rules {
        Rules {
            repeat_letter: b'K',
            other_repeat_letter: None,
            repeat: Repeat::Block,
            repeats_lose_sign: false,
            in_any_plane: true,
            chip_break_retract: 0.0,
            peck_clearance: 0.0,
            no_depth: NoDepth::Alarm,
            shift: (Axis::X, 1.0),
            default_shift: 0.0,
            restart: Restart::AsBefore,
            restart_aside: false,
            tapping: Tapping::Floating,
            max_tapping_rpm: f64::INFINITY,
            dwell: (0.0, f64::INFINITY),
            dwell_p_unit_s: 1.0,
            needs_speed: false,
            length_at_start_only: false,
            stand_beside_motion: false,
            boring_needs_axis: false,
            pocket_helix_factor: 0.0,
        }
    }
}
