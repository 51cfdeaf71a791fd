//! Machine zero return: how axes find their reference points (GSK990MC part 2, chapter 9).
//!
//! An axis runs through legs, each in one direction at one speed until its switch or its encoder says so:
//!
//! ```text
//! marker, behind the switch    ──fast──▶▓▓slow▓▓──search──▶ marker
//! marker, before the switch    ──fast──▶▓▓   marker ◀──search── ◀slow▓▓
//! edge A, behind               ──fast──▶▓▓slow▓▓▶ edge
//! edge A, before               ──fast──▶▓▓   edge ◀slow▓▓
//! edge B                       as A, then back onto the edge from the other side, at the speed of search
//! ```
//!
//! What was met there (plus the shift) is the reference point. The axis runs onto it exactly, and once all stand, their
//! places are called what the reference points are called. The manual prints the names of the modes before and
//! behind, with and without marker, A and B; what they do is that of the trade. An axis that begins on its switch
//! leaves it at once. One whose point is known and that stands behind its switch is positioned on the point.
//!
//! Places come from where drives kept them, so that neither the servo period nor the lag of the axis is in them.

use crate::drives::{Drives, Switches};
use crate::manual::Manual;
use ferrocut_geometry::{AXES, Axis, AxisSet, Position};
use ferrocut_machine::{Fault, HomingConfig, Machine};

/// What ends a leg.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Until {
    /// The switch is reached.
    On,
    /// It is left.
    Off,
    /// The encoder passes its marker.
    Marker,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Speed {
    Fast,
    Slow,
    Search,
}

/// A leg, onwards in the direction of homing or back.
#[derive(Clone, Copy, Debug)]
struct Leg {
    onwards: bool,
    speed: Speed,
    until: Until,
}

const fn leg(onwards: bool, speed: Speed, until: Until) -> Leg {
    Leg { onwards, speed, until }
}

/// The legs by what is searched: 6#6 ZPLS, 6#1 ZMOD, 6#7 MAOB.
fn legs(config: &HomingConfig) -> &'static [Leg] {
    const TO: Leg = leg(true, Speed::Fast, Until::On);
    const OFF: Leg = leg(true, Speed::Slow, Until::Off);
    const BACK: Leg = leg(false, Speed::Slow, Until::Off);
    const MARKER: Leg = leg(true, Speed::Search, Until::Marker);
    const MARKER_BACK: Leg = leg(false, Speed::Search, Until::Marker);
    const ONTO: Leg = leg(true, Speed::Search, Until::On);
    const BACK_ONTO: Leg = leg(false, Speed::Search, Until::On);
    match (config.marker, config.before, config.twice) {
        (true, false, _) => &[TO, OFF, MARKER],
        (true, true, _) => &[TO, BACK, MARKER_BACK],
        (false, false, false) => &[TO, OFF],
        (false, true, false) => &[TO, BACK],
        (false, false, true) => &[TO, OFF, BACK_ONTO],
        (false, true, true) => &[TO, BACK, ONTO],
    }
}

/// What an axis needs to know to find its reference point. Speeds are mm/s.
#[derive(Clone, Copy, Debug, Default)]
struct Settings {
    fast: f64,
    slow: f64,
    search: f64,
    /// Speed to a reference point that is known.
    known: f64,
    /// 1 upwards, -1 downwards.
    sign: f64,
    closes: bool,
    shift: f64,
    /// Farthest way of a leg.
    most: f64,
    /// Axes wait for those of lower rank.
    rank: Option<usize>,
}

/// How far an axis has come.
#[derive(Clone, Copy, Debug)]
enum Stage {
    /// Others come first.
    Waits,
    Runs(Running),
    /// To the place that was found.
    Onto(f64),
    /// To a reference point that was known.
    Known(f64),
    /// Stands on its reference point: where that is by its name so far.
    Arrived(f64),
}

/// A leg being run.
#[derive(Clone, Copy, Debug)]
struct Running {
    leg: usize,
    /// Where it began.
    from: f64,
    /// The axis moves in its direction.
    turned: bool,
    /// What ends it was otherwise meanwhile.
    was_other: bool,
    armed: bool,
    /// Where the switch was left.
    left: Option<f64>,
}

/// Distance from a place within which an axis is there: what counting in units leaves, mm.
const THERE: f64 = 1e-6;

/// How far an axis must be beyond the near end of its switch, which is off, to be behind it: more than a switch plays, mm.
const NEAR_END: f64 = 0.5;

/// Machine zero return of all axes.
#[derive(Clone, Debug)]
pub(crate) struct Homing {
    config: HomingConfig,
    legs: &'static [Leg],
    settings: [Settings; AXES],
    stages: [Option<Stage>; AXES],
    /// Where the axes were a period ago.
    before: Position,
    /// Axes whose reference point is known.
    referenced: AxisSet,
    /// Those that stand on it since.
    arrived: AxisSet,
    /// Where the switch was left when the reference point was found, from there.
    end: [Option<f64>; AXES],
}

impl Homing {
    /// The axes of a machine, all with a known reference point.
    pub fn new(machine: &Machine) -> Homing {
        let mut settings = [Settings::default(); AXES];
        for axis in &machine.axes {
            let homing = &axis.homing;
            let rapid = match machine.homing.at_manual_rapid {
                true => axis.manual_rapid.unwrap_or(axis.rapid),
                false => axis.rapid,
            };
            if let Some(place) = settings.get_mut(axis.name.index()) {
                *place = Settings {
                    fast: homing.fast.min(axis.rapid) / 60.0,
                    slow: homing.slow.min(axis.rapid) / 60.0,
                    search: homing.search.min(axis.rapid) / 60.0,
                    known: rapid.min(axis.rapid) / 60.0,
                    sign: if homing.negative { -1.0 } else { 1.0 },
                    closes: homing.closes,
                    shift: homing.shift,
                    // Wherever the axis stands, its switch is no farther away.
                    most: 1.5 * (axis.max - axis.min),
                    rank: machine
                        .homing
                        .order
                        .bytes()
                        .position(|letter| Axis::from_letter(letter) == Some(axis.name)),
                };
            }
        }
        Homing {
            config: machine.homing.clone(),
            legs: legs(&machine.homing),
            settings,
            stages: [None; AXES],
            before: Position::ZERO,
            referenced: machine.axis_set(),
            arrived: AxisSet::EMPTY,
            end: [None; AXES],
        }
    }

    pub fn config(&self) -> &HomingConfig {
        &self.config
    }

    /// Axes whose reference point is known.
    pub fn referenced(&self) -> AxisSet {
        self.referenced
    }

    pub fn set_referenced(&mut self, axes: AxisSet) {
        self.referenced = axes;
    }

    /// Where an axis stands, `place` by its name so far, is its reference point from now on.
    pub fn found_at(&mut self, axis: Axis, place: f64) {
        if let Some(stage) = self.stages.get_mut(axis.index()) {
            *stage = Some(Stage::Arrived(place));
        }
    }

    /// Axes that stand on their reference points.
    pub fn arrived(&self) -> AxisSet {
        self.arrived
    }

    /// Notes where the axes are commanded to be: the lamps of those that left their reference points go out.
    pub fn note(&mut self, at: &Position, reference: &Position) {
        if !self.arrived.is_empty() && !self.is_active() {
            self.arrived =
                self.arrived.iter().filter(|axis| (at[*axis] - reference[*axis]).abs() <= THERE).collect();
        }
    }

    /// Axes that went to their reference points in another way, and stand on them.
    pub fn stand(&mut self, axes: AxisSet) {
        self.arrived = self.arrived.iter().chain(axes.and(self.referenced).iter()).collect();
    }

    /// Whether an axis is on its way.
    pub fn is_active(&self) -> bool {
        self.stages.iter().flatten().any(|stage| !matches!(stage, Stage::Arrived(_)))
    }

    /// Whether an axis is on its way.
    pub fn moves(&self, axis: Axis) -> bool {
        matches!(self.stages.get(axis.index()), Some(Some(stage)) if !matches!(stage, Stage::Arrived(_)))
    }

    /// Whether an axis searches, so that its software limits do not hold.
    pub fn searches(&self, axis: Axis) -> bool {
        matches!(self.stages.get(axis.index()), Some(Some(Stage::Waits | Stage::Runs(_) | Stage::Onto(_))))
    }

    /// Whether an axis at a place that is sent to its reference point by hand is positioned on it, since it is known: as
    /// parameters have it, or since it stands behind its switch, where it would meet nothing but the travel switch.
    pub fn goes_straight(&self, axis: Axis, at: f64, reference: f64, switches: &Switches) -> bool {
        let settings = self.of(axis);
        let is_on = switches.home.contains(axis) != settings.closes;
        let end = self.end.get(axis.index()).copied().flatten();
        let beyond = |end: f64| (at - reference - end) * settings.sign;
        let is_behind = !is_on
            && match self.config.before {
                // What was left is its near end.
                true => end.is_some_and(|end| beyond(end) > NEAR_END),
                // One that was never searched is before its point.
                false => beyond(end.unwrap_or_default()) >= -THERE,
            };
        self.referenced.contains(axis) && (self.config.known_at_rapid || is_behind)
    }

    /// Sends an axis that is at `at` to its reference point, at `reference` where it is known. By hand, one at a time
    /// where that is set; whether it goes.
    pub fn begin(&mut self, axis: Axis, by_hand: bool, at: f64, reference: f64, switches: &Switches) -> bool {
        let one_at_a_time = by_hand && self.config.one_at_a_time && self.is_active();
        let known = by_hand && self.goes_straight(axis, at, reference, switches);
        match self.stages.get_mut(axis.index()) {
            Some(stage) if !one_at_a_time && stage.is_none() => {
                *stage = Some(if known { Stage::Known(reference) } else { Stage::Waits });
            }
            _ => return false,
        }
        self.arrived = self.arrived.iter().filter(|other| *other != axis).collect();
        true
    }

    /// The key of an axis was let go: where it is to be held, the axis comes to rest and its search is given up.
    pub fn let_go(&mut self, axis: Axis, manual: &mut Manual) {
        let Some(stage) = self.stages.get_mut(axis.index()) else { return };
        if self.config.key_held && stage.is_some_and(|stage| !matches!(stage, Stage::Arrived(_))) {
            *stage = None;
            manual.drive(axis, 0.0);
        }
    }

    /// Gives up what is not done; the first axis that was on its way.
    pub fn abort(&mut self) -> Option<Axis> {
        let is_under_way =
            |stage: &Option<Stage>| stage.is_some_and(|stage| !matches!(stage, Stage::Arrived(_)));
        let axis = Axis::ALL.into_iter().find(|axis| self.stages.get(axis.index()).is_some_and(is_under_way));
        for stage in self.stages.iter_mut().filter(|stage| is_under_way(stage)) {
            *stage = None;
        }
        axis
    }

    /// The axes that have arrived, all standing: where their reference points are by their names so far.
    pub fn take_arrived(&mut self) -> [Option<f64>; AXES] {
        let found = self.stages.map(|stage| match stage {
            Some(Stage::Arrived(place)) => Some(place),
            _ => None,
        });
        for ((stage, found), axis) in self.stages.iter_mut().zip(&found).zip(Axis::ALL) {
            if found.is_some() {
                *stage = None;
                self.referenced = self.referenced.with(axis);
                self.arrived = self.arrived.with(axis);
            }
        }
        found
    }

    /// Goes on by a period: tells the axes where to move. `actual` is where they are and `added` what compensation
    /// adds to their commands; while `held` they stand. What is wrong, and with which axis.
    pub fn tick(
        &mut self,
        manual: &mut Manual,
        drives: &mut dyn Drives,
        switches: &Switches,
        actual: &Position,
        added: &Position,
        held: bool,
    ) -> Option<(Axis, Fault)> {
        let mut wrong = None;
        for axis in Axis::ALL {
            let Some(Some(stage)) = self.stages.get(axis.index()).copied() else { continue };
            let sense = Sense {
                is_on: switches.home.contains(axis) != self.of(axis).closes,
                moved: actual[axis] - self.before[axis],
                actual: actual[axis],
                added: added[axis],
            };
            match self.step(axis, stage, manual, drives, &sense, held) {
                Ok(stage) => {
                    if let Some(place) = self.stages.get_mut(axis.index()) {
                        *place = Some(stage);
                    }
                }
                Err(fault) => wrong = wrong.or(Some((axis, fault))),
            }
        }
        self.before = *actual;
        wrong
    }

    fn of(&self, axis: Axis) -> Settings {
        self.settings.get(axis.index()).copied().unwrap_or_default()
    }

    /// Whether an axis is before this one in the order and not there yet.
    fn must_wait(&self, axis: Axis) -> bool {
        let Some(rank) = self.of(axis).rank else { return false };
        let before = |other: &Axis| self.of(*other).rank.is_some_and(|other| other < rank);
        let on_way = |other: &Axis| {
            self.stages.get(other.index()).is_some_and(|s| s.is_some_and(|s| !matches!(s, Stage::Arrived(_))))
        };
        Axis::ALL.iter().any(|other| before(other) && on_way(other))
    }

    fn step(
        &mut self,
        axis: Axis,
        stage: Stage,
        manual: &mut Manual,
        drives: &mut dyn Drives,
        sense: &Sense,
        held: bool,
    ) -> Result<Stage, Fault> {
        let settings = self.of(axis);
        let at = manual.at(axis);
        match stage {
            Stage::Waits if self.must_wait(axis) => Ok(stage),
            Stage::Waits => {
                self.referenced = self.referenced.iter().filter(|other| *other != axis).collect();
                // On the switch already, the axis leaves it.
                let leg = usize::from(sense.is_on);
                let running =
                    Running { leg, from: at, turned: false, was_other: true, armed: false, left: None };
                Ok(Stage::Runs(running))
            }
            Stage::Runs(running) => self.run(axis, running, manual, drives, sense, held),
            Stage::Onto(place) | Stage::Known(place) => {
                if (at - place).abs() <= THERE && manual.stands(axis) {
                    return Ok(Stage::Arrived(place));
                }
                let speed = match stage {
                    Stage::Known(_) => manual.under_rapid_override(settings.known),
                    _ => settings.search,
                };
                manual.go(axis, place, if held { 0.0 } else { speed });
                Ok(stage)
            }
            Stage::Arrived(_) => Ok(stage),
        }
    }

    fn run(
        &mut self,
        axis: Axis,
        mut running: Running,
        manual: &mut Manual,
        drives: &mut dyn Drives,
        sense: &Sense,
        held: bool,
    ) -> Result<Stage, Fault> {
        let settings = self.of(axis);
        let Some(leg) = self.legs.get(running.leg).copied() else { return Err(Fault::HomeSwitch) };
        let sign = if leg.onwards { settings.sign } else { -settings.sign };
        let speed = match leg.speed {
            Speed::Fast => manual.under_rapid_override(settings.fast),
            Speed::Slow => settings.slow,
            Speed::Search => settings.search,
        };
        manual.drive(axis, if held { 0.0 } else { sign * speed });
        running.turned |= sense.moved * sign > 0.0;
        let met = match leg.until {
            Until::Marker if running.turned && !running.armed => {
                drives.arm_marker(axis);
                running.armed = true;
                None
            }
            Until::Marker => drives.marker(axis).filter(|_| running.armed),
            until => {
                let is = (until == Until::On) == sense.is_on;
                running.was_other |= running.turned && !is;
                (is && running.was_other && (running.turned || running.leg == 0)).then(|| {
                    // A ladder may make the signal of something else than the switch whose edge drives keep (6#5).
                    let own = drives.switches().home.contains(axis) != settings.closes;
                    let edge = drives.home_edge(axis).filter(|_| own == sense.is_on);
                    edge.unwrap_or(sense.actual + sense.added)
                })
            }
        };
        let Some(met) = met else {
            let most = if leg.until == Until::Marker { self.config.marker_way } else { settings.most };
            return match (manual.at(axis) - running.from).abs() > most {
                true if leg.until == Until::Marker => Err(Fault::HomeMarker),
                true => Err(Fault::HomeSwitch),
                false => Ok(Stage::Runs(running)),
            };
        };
        // Encoders count what the drives are told, compensation and all.
        let met = met - sense.added;
        if leg.until == Until::Off {
            running.left = Some(met);
        }
        let Some(next) = self.legs.get(running.leg + 1) else {
            let place = met + settings.shift;
            if let Some(end) = self.end.get_mut(axis.index()) {
                *end = running.left.map(|left| left - place);
            }
            return Ok(Stage::Onto(place));
        };
        let goes_on = next.onwards == leg.onwards;
        running = Running {
            leg: running.leg + 1,
            from: manual.at(axis),
            turned: goes_on,
            // Coming onto the switch and going on, the axis was on it.
            was_other: goes_on && next.until != Until::Marker,
            armed: false,
            ..running
        };
        Ok(Stage::Runs(running))
    }
}

/// What is known of an axis in a period.
struct Sense {
    is_on: bool,
    /// How far it moved.
    moved: f64,
    actual: f64,
    added: f64,
}
