//! What a change of mode does to a program that runs, and what the keys do then (GSK990MC part 2, 2.4, 7.3, 8.4).
//!
//! A program belongs to the mode in which it was started: AUTO, MDI or DNC.

use crate::cnc::Interruption;
use crate::signals::Mode;

/// What becomes of a program that runs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Change {
    /// It goes on.
    Nothing,
    /// It runs to the end of its block and stops there.
    FinishBlock,
    /// It decelerates and stops at once, as by feed hold.
    StopAtOnce,
}

/// What a change to `to` does to a running program.
pub fn change(program: Mode, to: Mode) -> Change {
    match to {
        _ if to == program => Change::Nothing,
        // 8.4: to MDI, DNC, AUTO, EDIT the block under way is finished.
        Mode::Auto | Mode::Mdi | Mode::Dnc | Mode::Edit => Change::FinishBlock,
        // 8.4: to STEP, handwheel, JOG, HOME it decelerates and stops.
        Mode::Home | Mode::Jog | Mode::Step | Mode::Handle => Change::StopAtOnce,
    }
}

/// How a program stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Standing {
    /// None is under way.
    None,
    /// It runs.
    Runs,
    /// It runs to the end of its block, because the mode was changed.
    Finishes,
    /// It has stopped and may go on.
    Stopped,
}

/// What cycle start does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Start {
    /// Nothing, without a word.
    Nothing,
    /// Nothing: the mode runs no programs.
    WrongMode,
    /// Nothing: a program of another mode is under way.
    OtherMode,
    /// What the mode runs is started.
    Starts,
    /// The program goes on; one that finishes its block does not stop behind it.
    GoesOn,
}

/// What cycle start does in a mode, with a program of `program`.
pub fn start(program: Mode, standing: Standing, mode: Mode) -> Start {
    match standing {
        Standing::Runs => Start::Nothing,
        // 2.4 note 1: between AUTO, MDI and DNC it has effect until the block is finished; note 2: in EDIT it has not.
        Standing::Finishes if mode.is_automatic() => Start::GoesOn,
        Standing::Finishes => Start::Nothing,
        _ if !mode.is_automatic() => Start::WrongMode,
        Standing::None => Start::Starts,
        Standing::Stopped if mode == program => Start::GoesOn,
        Standing::Stopped => Start::OtherMode,
    }
}

/// Whether feed hold has an effect: not while a change of mode finishes the block (2.4 notes 1, 2, 4), and there is
/// nothing left to hold once the program decelerates (note 3).
pub fn holds(standing: Standing) -> bool {
    standing == Standing::Runs
}

/// What a way by hand is while a program is stopped on its way (8.4); `shifts` is 56#3.
pub fn by_hand(mode: Mode, shifts: bool) -> Interruption {
    match mode {
        Mode::Jog => Interruption::Return,
        // Without the function the way is an intervention too: the axes go back.
        Mode::Step | Mode::Handle if shifts => Interruption::Shift,
        Mode::Step | Mode::Handle => Interruption::Return,
        _ => Interruption::Refused,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Change::{FinishBlock as End, Nothing as On, StopAtOnce as Now};
    use Mode::{Auto, Dnc, Edit, Handle, Home, Jog, Mdi, Step};
    use Start::{GoesOn, Nothing, OtherMode, Starts, WrongMode};

    /// Rows: the mode of the program; columns: the mode that is chosen.
    const TO: [Mode; 8] = [Edit, Auto, Mdi, Dnc, Home, Jog, Step, Handle];
    const CHANGES: [(Mode, [Change; 8]); 3] = [
        (Auto, [End, On, End, End, Now, Now, Now, Now]),
        (Mdi, [End, End, On, End, Now, Now, Now, Now]),
        (Dnc, [End, End, End, On, Now, Now, Now, Now]),
    ];

    #[test]
    fn every_change_of_mode_does_what_the_manual_says() {
        for (program, row) in CHANGES {
            for (to, expected) in TO.into_iter().zip(row) {
                assert_eq!(change(program, to), expected, "{program:?} to {to:?}");
            }
        }
    }

    #[test]
    fn cycle_start_and_feed_hold_have_effect_where_the_manual_says() {
        const WITH_NONE: [Start; 8] =
            [WrongMode, Starts, Starts, Starts, WrongMode, WrongMode, WrongMode, WrongMode];
        const FINISHING: [Start; 8] = [Nothing, GoesOn, GoesOn, GoesOn, Nothing, Nothing, Nothing, Nothing];
        for (program, _) in CHANGES {
            for (at, mode) in TO.into_iter().enumerate() {
                assert_eq!(start(program, Standing::None, mode), WITH_NONE[at], "none in {mode:?}");
                assert_eq!(start(program, Standing::Finishes, mode), FINISHING[at], "{program:?} {mode:?}");
                assert_eq!(start(program, Standing::Runs, mode), Nothing);
                let stopped = match mode {
                    _ if mode == program => GoesOn,
                    Auto | Mdi | Dnc => OtherMode,
                    _ => WrongMode,
                };
                assert_eq!(start(program, Standing::Stopped, mode), stopped, "{program:?} {mode:?}");
            }
        }
        let held = [Standing::None, Standing::Runs, Standing::Finishes, Standing::Stopped].map(holds);
        assert_eq!(held, [false, true, false, false]);
    }

    #[test]
    fn a_way_by_hand_is_an_intervention_or_an_interruption() {
        use Interruption::{Refused, Return, Shift};
        const WAYS: [(bool, [Interruption; 8]); 2] = [
            (false, [Refused, Refused, Refused, Refused, Refused, Return, Return, Return]),
            (true, [Refused, Refused, Refused, Refused, Refused, Return, Shift, Shift]),
        ];
        for (shifts, row) in WAYS {
            for (mode, expected) in TO.into_iter().zip(row) {
                assert_eq!(by_hand(mode, shifts), expected, "{mode:?}");
            }
        }
    }
}
