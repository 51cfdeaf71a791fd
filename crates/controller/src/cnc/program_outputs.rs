//! Outputs that programs set themselves, and those of them that change in step with motion (LinuxCNC M codes: M62, M63,
//! M67).
//!
//! Such an output changes as the next move begins, and where none follows it never does. So a change is kept beside the
//! queue of motion, with the mark of the move that it waits for, and is made in the servo period in which the setpoints pass into that
//! move: where it is joined to the one before, in the middle of the joint. Motion knows nothing of it, and the path is the
//! same as without it. Setpoints are those of the interpolator: what the axes are behind them, by acceleration after
//! interpolation or by their following error, an output is before them.
//!
//! What was given up, by reset, alarm or the end of the program, changes no more. On the way back along the path, and
//! forward again to where it was held, outputs stay as they are, as LinuxCNC's do.

use super::Cnc;
use ferrocut_toolpath::{Op, Port, Step};
use std::collections::VecDeque;

/// Outputs of each kind (LinuxCNC, motmod: num_dio and num_aio are 64 at most). Others change nothing.
const PORTS: usize = 64;

/// One output, or the word of all that have variables.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Place {
    Digital(usize),
    Analog(usize),
    /// Digital outputs 0 to 15 at once.
    Word,
}

impl Place {
    /// Where an output stands; none for one that the machine does not have. #1100 to #1115 are the digital outputs from 0
    /// on, and #1132 is all of these (GSK990MC 4.9.2); other names are numbers (Weihong 4.4: M901).
    fn of(port: &Port) -> Option<Place> {
        let number = |number: i64| usize::try_from(number).ok().filter(|number| *number < PORTS);
        match port {
            Port::Digital(digital) => number(*digital).map(Place::Digital),
            Port::Analog(analog) => number(*analog).map(Place::Analog),
            Port::Named(name) => match name.strip_prefix('#').map(str::parse) {
                Some(Ok(variable @ 1100..=1115)) => Some(Place::Digital(variable - 1100)),
                Some(Ok(1132)) => Some(Place::Word),
                Some(_) => None,
                None => port.number().and_then(|port| number(port.into())).map(Place::Digital),
            },
        }
    }
}

/// A change that waits for a move.
#[derive(Clone, Copy, Debug)]
struct Change {
    /// The mark of the move.
    tag: u64,
    place: Place,
    value: f64,
}

/// The outputs. A reset leaves them as they are.
#[derive(Debug)]
pub(super) struct ProgramOutputs {
    digital: u64,
    analog: [f64; PORTS],
    /// Changes whose move has not begun, in the order of the moves.
    waiting: VecDeque<Change>,
}

impl ProgramOutputs {
    /// `moves`: how many are kept for motion.
    pub fn new(moves: usize) -> ProgramOutputs {
        // More than there are places, so that some wait for a move that was given where it is full.
        let room = moves + 2 * PORTS + 2;
        ProgramOutputs { digital: 0, analog: [0.0; PORTS], waiting: VecDeque::with_capacity(room) }
    }

    /// Digital outputs 0 to 15 from bit 0 on.
    pub fn word(&self) -> u16 {
        self.digital as u16
    }

    /// Sets an output now.
    pub fn set(&mut self, port: &Port, value: f64) {
        if let Some(place) = Place::of(port) {
            self.put(place, value);
        }
    }

    fn put(&mut self, place: Place, value: f64) {
        match place {
            Place::Digital(number) if value == 0.0 => self.digital &= !(1 << number),
            Place::Digital(number) => self.digital |= 1 << number,
            Place::Analog(number) => {
                if let Some(analog) = self.analog.get_mut(number) {
                    *analog = value;
                }
            }
            Place::Word => {
                let word = value.clamp(0.0, f64::from(u16::MAX)) as u16;
                self.digital = self.digital & !u64::from(u16::MAX) | u64::from(word);
            }
        }
    }

    /// Sets an output when the move with this mark begins, which none given before has. Of several changes of an output
    /// before one move the last counts.
    pub fn wait_for(&mut self, tag: u64, port: &Port, value: f64) {
        let Some(place) = Place::of(port) else { return };
        let mut of_move = self.waiting.iter().rev().take_while(|change| change.tag == tag);
        if let Some(behind) = of_move.position(|change| change.place == place) {
            self.waiting.remove(self.waiting.len() - 1 - behind);
        }
        self.waiting.push_back(Change { tag, place, value });
    }

    /// The move with this mark, given last, is none that outputs wait for: they wait for the one behind it.
    pub fn pass_over(&mut self, tag: u64) {
        self.waiting
            .iter_mut()
            .rev()
            .take_while(|change| change.tag == tag)
            .for_each(|change| change.tag += 1);
    }

    /// Whether no more steps are to be taken before moves have begun: then motion looks ahead less far.
    pub fn is_full(&self) -> bool {
        self.waiting.len() == self.waiting.capacity()
    }

    /// What waits will not change.
    pub fn forget_waiting(&mut self) {
        self.waiting.clear();
    }
}

impl Cnc {
    /// Whether a digital output of programs is on, counted from 0.
    pub fn digital_output(&self, number: usize) -> bool {
        number < PORTS && self.program_outputs.digital >> number & 1 == 1
    }

    /// Value of an analog output of programs, counted from 0.
    pub fn analog_output(&self, number: usize) -> f64 {
        self.program_outputs.analog.get(number).copied().unwrap_or(0.0)
    }

    /// Keeps an output that changes with the next move, where the path runs on into that; whether it does. Where no move is
    /// under way, and at the end of a block behind which the program stops, it is a step like others, and kept as it is done:
    /// so its block is one that is come to.
    pub(super) fn keeps_output_for_next_move(&mut self, step: &Step) -> bool {
        let Op::Output { port, value, with_next_move: true } = &step.op else { return false };
        if self.given.is_empty() || self.blocks.stops_behind_taken() {
            return false;
        }
        self.program_outputs.wait_for(self.next_tag, port, *value);
        true
    }

    /// The move with this mark is being run: outputs that waited for it, or for one before it, change.
    pub(super) fn change_outputs(&mut self, running: u64) {
        let is_kept_back = self.is_auxiliary_locked();
        while let Some(change) = self.program_outputs.waiting.front().copied().filter(|c| c.tag <= running) {
            self.program_outputs.waiting.pop_front();
            if !is_kept_back {
                self.program_outputs.put(change.place, change.value);
            }
        }
    }
}
