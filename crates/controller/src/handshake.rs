//! How a code (M, S, T, B) is handed to the ladder.
//!
//! The number is shown first; its strobe follows after a delay (Fanuc 3010). The ladder does what the code means
//! and turns FIN on; when FIN was on for its width (GSK990MC P202) the strobe turns off, and the code is done when
//! FIN is off again. Codes of one block that are handed over together share one FIN.
//!
//! The high-speed form (Fanuc 3001#7) has no way back: each change of a strobe is a code, and its own finish
//! signal is brought to the state of the strobe.

use crate::signals::{Code, Inputs, Outputs};
use ferrocut_machine::HandshakeConfig;

/// Codes that are handed over together.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Codes {
    /// M code.
    pub m: Option<u32>,
    /// S code.
    pub s: Option<u32>,
    /// T code.
    pub t: Option<u32>,
    /// B code, the second auxiliary function.
    pub b: Option<u32>,
}

impl Codes {
    /// An M code.
    pub fn m(code: u32) -> Codes {
        Codes { m: Some(code), ..Codes::default() }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        *self == Codes::default()
    }

    /// The first one as its word: `M8`.
    pub fn word(&self) -> String {
        let named = [('M', self.m), ('S', self.s), ('T', self.t), ('B', self.b)];
        let first = named.into_iter().find_map(|(letter, code)| code.map(|code| format!("{letter}{code}")));
        first.unwrap_or_default()
    }
}

/// Where a handshake stands after a period.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Progress {
    /// Nothing is handed over.
    Idle,
    /// The ladder has not finished.
    Waits,
    /// It has, in this period.
    Done,
    /// It takes too long.
    Late,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Phase {
    Idle,
    /// The number is shown, the strobe not yet.
    Shown,
    /// The strobe is on.
    Asked,
    /// FIN came, and is to turn off.
    Finished,
}

/// The handshake of M, S, T and B codes.
#[derive(Clone, Debug)]
pub struct Handshake {
    /// Periods from a code to its strobe.
    delay: u64,
    /// Periods that FIN must be on.
    width: u64,
    /// Periods that a code may take.
    patience: Option<u64>,
    is_high_speed: bool,
    phase: Phase,
    codes: Codes,
    /// M, S, T, B as they are shown.
    shown: [Code; 4],
    /// Periods in this phase; while FIN is waited for, those that it was on.
    count: u64,
    /// Periods since the code was handed over.
    waited: u64,
}

impl Handshake {
    /// A handshake at a period of `period` s.
    pub fn new(config: &HandshakeConfig, period: f64) -> Handshake {
        // What a quotient of decimals is above a whole number is no further period.
        let periods = |seconds: f64| (seconds / period - 1e-9).ceil().max(0.0) as u64;
        Handshake {
            delay: periods(config.strobe_delay_ms / 1000.0),
            width: periods(config.finish_width_ms / 1000.0),
            patience: (config.time_out_s > 0.0).then(|| periods(config.time_out_s)),
            is_high_speed: config.high_speed,
            phase: Phase::Idle,
            codes: Codes::default(),
            shown: [Code::default(); 4],
            count: 0,
            waited: 0,
        }
    }

    /// Hands codes over. Nothing may be under way.
    pub fn begin(&mut self, codes: Codes) {
        if codes.is_empty() {
            return;
        }
        for (shown, code) in self.shown.iter_mut().zip([codes.m, codes.s, codes.t, codes.b]) {
            if let Some(code) = code {
                shown.code = code;
            }
        }
        (self.codes, self.phase, self.count, self.waited) = (codes, Phase::Shown, 0, 0);
    }

    /// Whether codes are under way.
    pub fn is_busy(&self) -> bool {
        self.phase != Phase::Idle
    }

    /// The codes under way.
    pub fn codes(&self) -> Codes {
        self.codes
    }

    /// Takes the codes back: reset.
    pub fn cancel(&mut self) {
        if !self.is_high_speed {
            self.shown.iter_mut().for_each(|code| code.strobe = false);
        }
        (self.codes, self.phase) = (Codes::default(), Phase::Idle);
    }

    /// Goes on by one period.
    pub fn tick(&mut self, inputs: &Inputs) -> Progress {
        if self.phase == Phase::Idle {
            return Progress::Idle;
        }
        match self.phase {
            Phase::Shown if self.count >= self.delay => self.strobe(),
            Phase::Shown => self.count += 1,
            Phase::Asked if self.is_high_speed => {
                if self.all_follow(inputs) {
                    return self.done();
                }
            }
            Phase::Asked if !inputs.finished => self.count = 0,
            Phase::Asked => {
                self.count += 1;
                if self.count >= self.width {
                    self.shown.iter_mut().for_each(|code| code.strobe = false);
                    self.phase = Phase::Finished;
                }
            }
            Phase::Finished if !inputs.finished => return self.done(),
            Phase::Finished | Phase::Idle => {}
        }
        self.waited += 1;
        match self.patience {
            Some(patience) if self.waited >= patience => Progress::Late,
            _ => Progress::Waits,
        }
    }

    /// The ladder is asked.
    fn strobe(&mut self) {
        let asked = self.asked();
        for (shown, _) in self.shown.iter_mut().zip(asked).filter(|(_, asked)| *asked) {
            shown.strobe = !(self.is_high_speed && shown.strobe);
        }
        (self.phase, self.count) = (Phase::Asked, 0);
    }

    fn asked(&self) -> [bool; 4] {
        let Codes { m, s, t, b } = self.codes;
        [m.is_some(), s.is_some(), t.is_some(), b.is_some()]
    }

    fn all_follow(&self, inputs: &Inputs) -> bool {
        let Inputs { m_finished, s_finished, t_finished, b_finished, .. } = *inputs;
        let finished = [m_finished, s_finished, t_finished, b_finished];
        let mut signals = self.shown.iter().zip(finished).zip(self.asked());
        signals.all(|((shown, finished), asked)| !asked || shown.strobe == finished)
    }

    fn done(&mut self) -> Progress {
        (self.codes, self.phase) = (Codes::default(), Phase::Idle);
        Progress::Done
    }

    /// Tells the ladder. Stops and ends of programs are told by signals of their own, too.
    pub fn tell(&self, outputs: &mut Outputs) {
        [outputs.m, outputs.s, outputs.t, outputs.b] = self.shown;
        let m = self.codes.m;
        (outputs.m00, outputs.m01) = (m == Some(0), m == Some(1));
        (outputs.m02, outputs.m30) = (m == Some(2), m == Some(30));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn handshake(set: impl Fn(&mut HandshakeConfig)) -> Handshake {
        let mut config = HandshakeConfig { strobe_delay_ms: 3.0, finish_width_ms: 2.0, ..Default::default() };
        set(&mut config);
        Handshake::new(&config, 0.001)
    }

    fn told(handshake: &Handshake) -> Outputs {
        let mut outputs = Outputs::default();
        handshake.tell(&mut outputs);
        outputs
    }

    fn with_fin(finished: bool) -> Inputs {
        Inputs { finished, ..Inputs::default() }
    }

    #[test]
    fn a_strobe_follows_its_code_and_ends_with_fin() {
        let mut h = handshake(|_| {});
        assert_eq!(h.tick(&with_fin(true)), Progress::Idle);
        h.begin(Codes { m: Some(3), s: Some(1200), ..Codes::default() });
        assert!(h.is_busy());
        // Shown at once, the strobes 3 ms later.
        for _ in 0..3 {
            assert_eq!(h.tick(&with_fin(false)), Progress::Waits);
            let o = told(&h);
            assert_eq!((o.m, o.s.strobe), (Code { strobe: false, code: 3 }, false));
        }
        h.tick(&with_fin(false));
        let o = told(&h);
        let on = |code| Code { strobe: true, code };
        assert_eq!((o.m, o.s, o.t.strobe, o.b.strobe), (on(3), on(1200), false, false));
        // FIN for one period is no FIN; for two it is.
        h.tick(&with_fin(true));
        h.tick(&with_fin(false));
        h.tick(&with_fin(true));
        assert!(told(&h).m.strobe);
        assert_eq!(h.tick(&with_fin(true)), Progress::Waits);
        assert!(!told(&h).m.strobe && !told(&h).s.strobe);
        // Done when FIN is off again; the numbers stay.
        assert_eq!(h.tick(&with_fin(true)), Progress::Waits);
        assert_eq!(h.tick(&with_fin(false)), Progress::Done);
        assert_eq!((h.tick(&with_fin(false)), told(&h).m.code), (Progress::Idle, 3));
    }

    #[test]
    fn stops_and_ends_have_signals_of_their_own() {
        for (code, wanted) in [(0, 0b0001), (1, 0b0010), (2, 0b0100), (30, 0b1000), (3, 0)] {
            let mut h = handshake(|_| {});
            h.begin(Codes::m(code));
            let o = told(&h);
            let bits = [o.m00, o.m01, o.m02, o.m30].iter().rev().fold(0, |bits, on| bits * 2 + u8::from(*on));
            assert_eq!(bits, wanted, "M{code}");
            h.cancel();
            assert!(!h.is_busy() && !told(&h).m30);
        }
    }

    #[test]
    fn a_code_that_takes_too_long_is_told() {
        let mut h = handshake(|config| config.time_out_s = 0.05);
        h.begin(Codes::m(10));
        let late = (1..).find(|_| h.tick(&with_fin(false)) == Progress::Late);
        assert_eq!((late, h.codes().word()), (Some(50), "M10".to_owned()));
        // FIN that never turns off is late, too.
        let mut h = handshake(|config| config.time_out_s = 0.05);
        h.begin(Codes { t: Some(4), ..Codes::default() });
        assert_eq!((1..).find(|_| h.tick(&with_fin(true)) == Progress::Late), Some(50));
        // 0 waits for ever.
        let mut h = handshake(|config| config.time_out_s = 0.0);
        h.begin(Codes::m(10));
        assert!((0..200_000).all(|_| h.tick(&with_fin(false)) == Progress::Waits));
    }

    #[test]
    fn the_high_speed_form_goes_by_changes() {
        let mut h = handshake(|config| config.high_speed = true);
        let both = Codes { m: Some(8), t: Some(2), ..Codes::default() };
        for on in [true, false, true] {
            h.begin(both);
            let mut inputs = Inputs { m_finished: !on, t_finished: !on, ..Inputs::default() };
            for _ in 0..5 {
                assert_eq!(h.tick(&inputs), Progress::Waits);
            }
            let o = told(&h);
            assert_eq!((o.m.strobe, o.t.strobe, o.s.strobe), (on, on, false));
            // Each by its own signal, FIN does not count.
            inputs.m_finished = on;
            inputs.finished = true;
            assert_eq!(h.tick(&inputs), Progress::Waits);
            inputs.t_finished = on;
            assert_eq!(h.tick(&inputs), Progress::Done);
        }
    }
}
