//! The protocol as senders use it: sessions of UGS, CNCjs and bCNC on the machine itself, and whatever else may come
//! over a connection.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use ferrocut_geometry::{Axis, Position};
use ferrocut_interpreter::Options;
use ferrocut_machine::{Machine as File, Memory};
use ferrocut_server::grbl::{Doing, Grbl, Machine};
use ferrocut_server::mill::Mill;
use proptest::prelude::*;

/// A sender at a machine. Between two periods of the machine, the protocol does what it can.
struct Session {
    grbl: Grbl,
    mill: Mill,
    heard: String,
}

impl Session {
    fn new() -> Session {
        Session::with(Options::default())
    }

    fn with(options: Options) -> Session {
        let mut file = File::demo_mill();
        file.axes.retain(|axis| axis.name.is_linear());
        Session::of(&file, options)
    }

    fn of(file: &File, options: Options) -> Session {
        let mut session = Session {
            grbl: Grbl::new(file),
            mill: Mill::new(file, Memory::new("rs274"), options),
            heard: String::new(),
        };
        session.grbl.connect(&mut session.mill);
        session.wait(5);
        session
    }

    /// One that is unlocked, its greeting heard.
    fn unlocked() -> Session {
        let mut session = Session::new();
        session.say("$X\n");
        session
    }

    fn wait(&mut self, periods: usize) {
        for _ in 0..periods {
            self.mill.tick();
            self.grbl.poll(&mut self.mill);
        }
        self.heard += &self.grbl.take_output();
    }

    fn send(&mut self, bytes: &[u8]) {
        self.grbl.receive(bytes, &mut self.mill);
    }

    /// Sends, waits a little, and returns what was heard since the last time.
    fn say(&mut self, text: &str) -> String {
        self.heard.clear();
        self.send(text.as_bytes());
        self.wait(20);
        std::mem::take(&mut self.heard)
    }

    fn byte(&mut self, byte: u8) -> String {
        self.heard.clear();
        self.send(&[byte]);
        self.wait(20);
        std::mem::take(&mut self.heard)
    }

    /// Waits until the machine is idle; what was heard.
    fn settle(&mut self) -> String {
        for _ in 0..300_000 {
            self.wait(1);
            if self.mill.status().doing == Doing::Idle {
                self.wait(5);
                return std::mem::take(&mut self.heard);
            }
        }
        panic!("never idle: {:?} {}", self.mill.status(), self.heard);
    }

    /// The sender goes away and another comes.
    fn reconnect(&mut self) {
        let Session { grbl, mill, .. } = self;
        grbl.disconnect(mill);
        self.wait(5);
        self.grbl.connect(&mut self.mill);
    }

    fn at(&self) -> Position {
        self.mill.now().position
    }

    fn state(&mut self) -> String {
        let report = self.say("?");
        report.split(['<', '|']).nth(1).unwrap_or("").to_owned()
    }
}

/// Sends a program as most senders do: as many lines as fit 128 bytes, and more when lines are answered.
fn stream(session: &mut Session, program: &str) -> Vec<String> {
    let mut sent: std::collections::VecDeque<usize> = std::collections::VecDeque::new();
    let mut lines = program.lines().peekable();
    let mut answers = Vec::new();
    let mut rest = String::new();
    for _ in 0..2_000_000 {
        while let Some(line) = lines.peek() {
            if sent.iter().sum::<usize>() + line.len() + 1 > 127 {
                break;
            }
            sent.push_back(line.len() + 1);
            session.send(format!("{line}\n").as_bytes());
            lines.next();
        }
        session.wait(1);
        rest += &std::mem::take(&mut session.heard);
        while let Some((line, more)) = rest.split_once("\r\n") {
            if line == "ok" || line.starts_with("error") {
                assert!(sent.pop_front().is_some(), "an answer to nothing");
                answers.push(line.to_owned());
            }
            rest = more.to_owned();
        }
        if sent.is_empty() && lines.peek().is_none() {
            return answers;
        }
    }
    panic!("never answered: {sent:?}, {:?}", session.mill.status());
}

#[test]
fn a_machine_that_was_switched_on_is_locked_until_it_is_homed() {
    let start = Position::xyz(50.0, -20.0, -10.0);
    let mut session = Session::with(Options { start, ..Options::default() });
    assert_eq!(
        std::mem::take(&mut session.heard),
        "\r\nGrbl 1.1h ['$' for help]\r\n[MSG:'$H'|'$X' to unlock]\r\n"
    );
    assert_eq!((session.say("G0X1\n").as_str(), session.state().as_str()), ("error:9\r\n", "Alarm"));
    assert_eq!(session.say("$J=G91X1F100\n"), "error:8\r\n");
    session.send(b"$H\n");
    session.wait(50);
    assert_eq!(session.heard, "", "no answer before the axes are there");
    assert_eq!((session.settle().as_str(), session.state().as_str()), ("ok\r\n", "Idle"));
    assert_eq!(session.at(), Position::ZERO);
    assert_eq!(session.say("G0X1\n"), "ok\r\n");
    assert_eq!(session.say("$X\n"), "ok\r\n");
}

#[test]
fn every_line_has_one_answer_and_blank_ones_too() {
    let mut session = Session::unlocked();
    assert_eq!(session.say("\n\r\n(nothing)\r; nothing\n  \n%\n"), "ok\r\n".repeat(6));
    assert_eq!(session.say("G1X1F10\nG5X1\n\nG1X1X2\nG1\n"), "ok\r\nerror:20\r\nok\r\nerror:25\r\nok\r\n");
    assert_eq!(session.say(&format!("G1{}\n", "X".repeat(2000))), "error:11\r\n");
    assert_eq!(
        session.say("G2X5F100\nG2X5R0.1\nG94F0G1X1\nG10L2P9X1\n"),
        "error:35\r\nerror:34\r\nerror:22\r\nerror:29\r\n"
    );
}

#[test]
fn a_refused_line_does_nothing() {
    let mut session = Session::unlocked();
    let codes = |session: &mut Session| session.say("$G\n").split("\r\n").next().unwrap_or("").to_owned();
    let before = codes(&mut session);
    // No feed, an arc that ends beside its circle, one without centre.
    for (line, error) in [
        ("M3 S100 G1 X1", 22),
        ("T7 M3 S100 G1 X1", 22),
        ("M8 G2 X5 I1 F100", 33),
        ("M7 G2 X5 F100", 35),
        ("G91 G1X1", 22),
        ("G20 G18 G55 G93 G1X1", 22),
        ("G92.1 G1X1", 22),
        ("G28.1 G1X1", 22),
        ("M3 S50 G38.2 Z-1", 22),
    ] {
        assert_eq!(session.say(&format!("{line}\n")), format!("error:{error}\r\n"), "{line}");
        session.settle();
        assert_eq!(codes(&mut session), before, "{line}");
        assert_eq!((session.at(), session.mill.status().rpm), (Position::ZERO, 0.0), "{line}");
    }
    // Offsets too, and nothing waits for the end of a program that did not end.
    session.say("G0X10\nG92X0\nG28.1\nG0X5\n");
    session.settle();
    let offsets = session.say("$#\n");
    assert!(offsets.contains("[G28:10.000,") && offsets.contains("[G92:10.000,"), "{offsets}");
    assert_eq!(session.say("G92.1 G1X1\nG28.1 G1X1\nM2 G1X1\n"), "error:22\r\nerror:22\r\nerror:22\r\n");
    assert_eq!(session.say("$#\n"), offsets);
    session.say("G1X1F600M3S100\n");
    session.settle();
    assert_eq!((session.at()[Axis::X], session.mill.status().rpm), (11.0, 100.0));
    // What is checked alone is checked as it would be run.
    session.say("$C\n");
    assert_eq!(session.say("G91 G2 X5 I1\nX300\n$C\n").matches("ALARM").count(), 0);
}

#[test]
fn ugs_finds_its_controller() {
    // UGS: asks for a status, for the build, the settings and the codes.
    let mut session = Session::unlocked();
    let report = session.say("?");
    assert!(report.starts_with("<Idle|MPos:0.000,0.000,0.000|FS:0,0|WCO:0.000,0.000,0.000>\r\n"), "{report}");
    assert_eq!(session.say("$I\n"), "[VER:1.1h.20190830:]\r\n[OPT:VNM,15,128]\r\nok\r\n");
    let settings = session.say("$$\n");
    for number in [10, 11, 13, 20, 21, 22, 23, 24, 25, 26, 27, 30, 31, 32, 100, 110, 120, 130, 132] {
        assert!(settings.contains(&format!("${number}=")), "{number} {settings}");
    }
    assert_eq!(session.say("$G\n"), "[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]\r\nok\r\n");
    let offsets = session.say("$#\n");
    assert!(
        offsets.starts_with("[G54:0.000,0.000,0.000]\r\n[G55:") && offsets.ends_with(":0]\r\nok\r\n"),
        "{offsets}"
    );
    assert_eq!(session.say("$N\n"), "$N0=\r\n$N1=\r\nok\r\n");
    assert!(session.say("$\n").starts_with("[HLP:"));
    assert_eq!(
        session.say("$Q\n$110=1\n$110=abc\n$10=-1\n"),
        "error:3\r\nerror:17\r\nerror:2\r\nerror:4\r\n"
    );
}

#[test]
fn a_jog_leaves_codes_alone_and_ends_at_its_key() {
    let mut session = Session::unlocked();
    session.say("G91G1F77\n");
    assert_eq!(session.say("$J=G90G21X20Y-5F3000\n"), "ok\r\n");
    assert_eq!(session.state(), "Jog");
    assert_eq!(session.say("G0X1\n"), "error:9\r\n");
    session.settle();
    assert_eq!((session.at()[Axis::X], session.at()[Axis::Y]), (20.0, -5.0));
    assert!(session.say("$G\n").contains("G1 G54 G17 G21 G91 G94 M5 M9 T0 F77 S0"));
    // Held down: one after the other, and none of them counts once the key is released.
    for _ in 0..10 {
        session.say("$J=G91X5F3000\n");
    }
    session.wait(100);
    assert_eq!(session.byte(0x85), "");
    session.settle();
    let at = session.at()[Axis::X];
    assert!((20.5..69.5).contains(&at), "{at}");
    assert_eq!(
        session.say("$J=X9999F100\n$J=X1\n$J=G2X1F1\n$J\n"),
        "error:15\r\nerror:22\r\nerror:16\r\nerror:16\r\n"
    );
    assert_eq!((session.state().as_str(), session.at()[Axis::X]), ("Idle", at));
    // From where the jog ended, incremental as before.
    session.say("X1\n");
    session.settle();
    assert!((session.at()[Axis::X] - at - 1.0).abs() < 1e-9);
}

#[test]
fn a_hold_ends_a_jog() {
    let mut session = Session::unlocked();
    session.say("$J=X100F3000\n");
    session.wait(200);
    session.byte(b'!');
    session.settle();
    assert!(session.at()[Axis::X] < 50.0 && session.state() == "Idle");
}

#[test]
fn a_program_is_held_and_goes_on() {
    let mut session = Session::unlocked();
    assert_eq!(session.say("M3S1000\nG1X50F3000\nX100\n"), "");
    session.wait(1500);
    assert!(session.state() == "Run" && session.at()[Axis::X] > 1.0);
    assert!(session.byte(b'!').is_empty() && session.state().starts_with("Hold"));
    session.wait(500);
    let at = session.at();
    assert_eq!(session.state(), "Hold:0");
    // The spindle stops in a hold, and starts again.
    session.byte(0x9E);
    assert_eq!(session.mill.status().rpm, 0.0);
    session.wait(1000);
    assert_eq!(session.at(), at);
    session.byte(b'~');
    assert!(session.mill.status().rpm > 0.0);
    session.settle();
    assert_eq!(session.at()[Axis::X], 100.0);
}

#[test]
fn a_reset_in_motion_is_an_alarm_and_at_rest_none() {
    let mut session = Session::unlocked();
    session.say("M3S500\nG1X100F3000\nX0\n");
    session.wait(1000);
    let heard = session.byte(0x18);
    assert_eq!(heard, "ALARM:3\r\n\r\nGrbl 1.1h ['$' for help]\r\n[MSG:'$H'|'$X' to unlock]\r\n");
    session.wait(500);
    let at = session.at();
    assert!((1.0..99.0).contains(&at[Axis::X]) && session.mill.status().rpm == 0.0);
    assert_eq!((session.state().as_str(), session.say("G0X0\n").as_str()), ("Alarm", "error:9\r\n"));
    assert_eq!(session.say("$X\n"), "[MSG:Caution: Unlocked]\r\nok\r\n");
    assert_eq!((session.state().as_str(), session.at()), ("Idle", at));
    // As bCNC ends a job: hold, reset.
    session.byte(b'!');
    assert_eq!(session.state(), "Hold:0");
    assert_eq!(session.byte(0x18), "\r\nGrbl 1.1h ['$' for help]\r\n");
    assert_eq!((session.state().as_str(), session.at()), ("Idle", at));
    assert_eq!(session.say("G1X0F1000\n"), "ok\r\n");
    session.settle();
    assert_eq!(session.at()[Axis::X], 0.0);
}

#[test]
fn a_reset_brings_the_codes_of_the_start_back() {
    let mut session = Session::unlocked();
    session.say("G20G91G93G18G55G1F1\nG92X1\nG43.1Z2\nG10L2P1X5\n");
    session.byte(0x18);
    assert!(session.say("$G\n").contains("[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0"));
    let offsets = session.say("$#\n");
    assert!(offsets.contains("[G92:0.000,0.000,0.000]\r\n[TLO:0.000]"), "{offsets}");
    assert!(offsets.contains("[G54:127.000,0.000,0.000]"), "zeros stay: {offsets}");
}

#[test]
fn offsets_shift_what_is_reported() {
    let mut session = Session::unlocked();
    assert_eq!(session.say("G0X10Y5\nG10L20P1X0Y0\nG92Z3\n"), "ok\r\n".repeat(3));
    session.settle();
    let report = session.say("?");
    assert!(report.contains("|WCO:10.000,5.000,-3.000>"), "{report}");
    session.say("$10=0\n");
    assert!(session.say("?").contains("WPos:0.000,0.000,3.000"), "work positions");
    session.say("G0X1\n");
    session.settle();
    assert_eq!(session.at()[Axis::X], 11.0);
    session.say("G28.1\nG0X0\nG28X0\n");
    session.settle();
    assert_eq!(session.at()[Axis::X], 11.0);
}

#[test]
fn each_coolant_goes_on_and_off_alone() {
    let mut session = Session::unlocked();
    let mut codes = |byte: &[u8]| {
        session.send(byte);
        session.settle();
        session.say("$G\n").split(' ').skip_while(|code| *code != "M5").skip(1).collect::<Vec<_>>().join(" ")
    };
    for (byte, on) in
        [(0xA0, "M8"), (0xA1, "M7 M8"), (0xA0, "M7"), (0xA0, "M7 M8"), (0xA1, "M8"), (0xA0, "M9")]
    {
        assert!(codes(&[byte]).starts_with(&format!("{on} T0")), "{on}: {}", codes(b""));
    }
    // Both by lines of their own; of one modal group they have no place in one.
    assert_eq!(session.say("M7\nM8\nM7M8\n"), "ok\r\nok\r\nerror:21\r\n");
}

#[test]
fn rst_clears_what_it_names() {
    let mut session = Session::unlocked();
    session.say("G0X10\nG10L2P1X5Y6\nG10L2P6Z-3\nG28.1\nG30.1\n");
    session.settle();
    session.say("$N0=G55\n$I=mill\n$10=2\n");
    let before = session.say("$#\n");
    assert_eq!(session.say("$RST=$\n"), "[MSG:Restoring defaults]\r\nok\r\n");
    assert_eq!((session.say("$#\n"), session.say("$N\n").as_str()), (before, "$N0=G55\r\n$N1=\r\nok\r\n"));
    assert!(session.say("$$\n").contains("$10=1\r\n"));
    assert_eq!(session.say("$RST=#\n"), "[MSG:Restoring defaults]\r\nok\r\n");
    let offsets = session.say("$#\n");
    for name in ["G54", "G55", "G56", "G57", "G58", "G59", "G28", "G30"] {
        assert!(offsets.contains(&format!("[{name}:0.000,0.000,0.000]")), "{name} {offsets}");
    }
    assert!(session.say("$N\n").contains("G55") && session.at()[Axis::X] == 10.0);
    session.say("G0X1\n");
    session.settle();
    assert_eq!(session.at()[Axis::X], 1.0, "the zero in force is the new one");
    session.say("$RST=*\n");
    assert_eq!(session.say("$N\n"), "$N0=\r\n$N1=\r\nok\r\n");
    assert!(session.say("$I\n").starts_with("[VER:1.1h.20190830:]"));
    session.say("G1X50F1000\n");
    assert_eq!(session.say("$RST=#\n"), "error:8\r\n");
}

#[test]
fn g53_is_for_g0_and_g1() {
    let mut session = Session::unlocked();
    assert_eq!(
        session.say("G53G2X1I1F100\nG53G80\nG80\nG53X1\nG53\n"),
        "error:30\r\nerror:30\r\nok\r\nerror:30\r\nerror:30\r\n"
    );
    assert_eq!(session.say("G2X0Y0I5F100\nG53X1\nX1\n"), "ok\r\nerror:30\r\nerror:35\r\n");
    session.settle();
    assert_eq!(session.say("G0\nG53X1\n"), "ok\r\nok\r\n");
}

#[test]
fn overrides_count_as_grbl_counts_them() {
    let mut session = Session::unlocked();
    // CNCjs sends them as UTF-8.
    for byte in "\u{91}\u{91}\u{94}\u{96}\u{9A}".chars() {
        session.say(&byte.to_string());
    }
    let reports: String = (0..3).map(|_| session.say("?")).collect();
    assert!(reports.contains("|Ov:119,50,110"), "{reports}");
    for _ in 0..30 {
        session.byte(0x92);
    }
    let reports: String = (0..3).map(|_| session.say("?")).collect();
    assert!(reports.contains("|Ov:10,50,110"), "{reports}");
    session.byte(0x90);
    session.byte(0x91);
    session.say("G1X200F3000\n");
    session.wait(1500);
    let feed = session.mill.status().feed;
    assert!((feed - 3300.0).abs() < 1.0, "{feed}");
    session.byte(0x92);
    session.byte(0x92);
    session.wait(500);
    let feed = session.mill.status().feed;
    assert!((feed - 2700.0).abs() < 1.0, "{feed}");
}

#[test]
fn the_spindle_override_acts_at_once() {
    let mut session = Session::unlocked();
    session.say("M3S1000\n");
    session.wait(300);
    let rpm = |session: &mut Session| session.mill.status().rpm;
    assert_eq!(rpm(&mut session), 1000.0);
    session.byte(0x9A);
    assert_eq!(rpm(&mut session), 1100.0);
    assert!(session.say("?").contains("|FS:0,1100"), "what is shown is what it turns at");
    // What comes behind it is overridden too, either way, within what the spindle can do.
    session.say("M4S2000\nG4P1\n");
    session.settle();
    assert_eq!(rpm(&mut session), 2200.0);
    let highest = File::demo_mill().spindle.max_rpm;
    session.say(&format!("M3S{highest}\nG4P3\n"));
    session.settle();
    assert_eq!(rpm(&mut session), highest);
    session.byte(0x9B);
    session.byte(0x9B);
    assert_eq!(rpm(&mut session), highest * 0.9);
    session.byte(0x99);
    assert_eq!(rpm(&mut session), highest);
    // One that stands stays so.
    session.say("M5\n");
    session.settle();
    session.byte(0x9A);
    assert_eq!(rpm(&mut session), 0.0);
    // Stopped in a hold, it comes back with the override that is in force then.
    session.say("S1000M3\nG1X100F1000\n");
    session.wait(1000);
    session.byte(b'!');
    session.wait(300);
    session.byte(0x9E);
    assert_eq!(rpm(&mut session), 0.0);
    session.byte(0x9A);
    assert_eq!(rpm(&mut session), 0.0);
    session.byte(b'~');
    assert_eq!(rpm(&mut session), 1200.0);
    session.settle();
    // A reset sets it back.
    session.byte(0x18);
    session.say("M3S1000\nG4P1\n");
    session.settle();
    assert_eq!(rpm(&mut session), 1000.0);
}

/// Grbl 1.1, status reports: inputs that are on stand in `Pn:`.
#[test]
fn inputs_of_the_simulated_machine_are_shown_and_act() {
    let mut file = File::demo_mill();
    file.axes.retain(|axis| axis.name.is_linear());
    file.plant = Some(ferrocut_machine::PlantConfig::default());
    let mut session = Session::of(&file, Options::default());
    session.say("$X\n");
    let pins = |session: &mut Session| {
        let report = session.say("?");
        let pins = report.split(['|', '>']).find_map(|field| field.strip_prefix("Pn:").map(str::to_owned));
        pins.unwrap_or_default()
    };
    assert_eq!(pins(&mut session), "");
    // The probe goes down onto a block and stays on it.
    let block = ferrocut_controller::drives::Block { min: [-50.0, -50.0, -30.0], max: [50.0, 50.0, -4.0] };
    session.mill.drives().plant().unwrap().place(block);
    let heard = session.say("G38.2Z-20F200\n") + &session.settle();
    let met = heard.split(['[', ':', ',']).nth(4).and_then(|z| z.parse::<f64>().ok());
    assert!(met.is_some_and(|z| (z + 4.0).abs() < 0.01), "{heard}");
    assert_eq!(pins(&mut session), "P");
    // It touches already: what was refused before is answered as such, and before the alarm.
    let mut heard = session.say("G1X1F0\nG38.2Z-20F200\nG0X5\n");
    session.wait(300);
    heard += &std::mem::take(&mut session.heard);
    let answers: Vec<&str> = heard.lines().filter(|line| !line.starts_with("[PRB")).collect();
    assert_eq!(answers, ["error:22", "ALARM:4", "ok", "error:9"], "{heard}");
    session.say("$X\n");
    session.say("G0Z0\n");
    session.settle();
    assert_eq!(pins(&mut session), "");
    session.mill.drives().plant().unwrap().clear();
    // The door holds all until it is closed, and `~` was given then.
    session.say("M3S1000\nG1X200F3000\n");
    session.wait(1500);
    session.mill.drives().plant().unwrap().move_door(true);
    session.wait(1000);
    assert_eq!((session.state().as_str(), session.mill.status().rpm), ("Door:1", 0.0));
    assert_eq!(pins(&mut session), "D");
    session.byte(b'~');
    assert_eq!(session.state(), "Door:1");
    session.mill.drives().plant().unwrap().move_door(false);
    session.wait(5);
    assert_eq!((session.state().as_str(), pins(&mut session).as_str()), ("Door:0", ""));
    session.byte(b'~');
    session.settle();
    assert_eq!(session.at()[Axis::X], 200.0);
    // One that stands open behind a reset holds too.
    session.mill.drives().plant().unwrap().move_door(true);
    session.wait(20);
    session.byte(0x18);
    session.wait(20);
    assert_eq!(session.state(), "Door:1");
    session.mill.drives().plant().unwrap().move_door(false);
    session.wait(20);
    session.byte(b'~');
    session.wait(20);
    assert_eq!(session.state(), "Idle");
    // The emergency stop is a reset.
    session.say("G1X0F3000\n");
    session.wait(500);
    session.mill.drives().plant().unwrap().press_emergency_stop(true);
    session.wait(600);
    let heard = std::mem::take(&mut session.heard);
    assert!(heard.contains("ALARM:3"), "{heard}");
    assert_eq!((session.state().as_str(), pins(&mut session).as_str()), ("Alarm", "R"));
    session.mill.drives().plant().unwrap().press_emergency_stop(false);
    assert_eq!(pins(&mut session), "");
}

#[test]
fn a_travel_switch_is_an_alarm_and_lets_its_axis_go_back() {
    let mut file = File::demo_mill();
    file.axes.retain(|axis| axis.name.is_linear());
    let mut x = ferrocut_machine::PlantAxis::new(Axis::X);
    x.limits = Some([-1000.0, 20.0]);
    file.plant = Some(ferrocut_machine::PlantConfig { axes: vec![x], ..Default::default() });
    let mut session = Session::of(&file, Options::default());
    session.say("$X\nG1X50F1000\n");
    session.wait(4000);
    let heard = std::mem::take(&mut session.heard);
    assert!(heard.contains("ALARM:1\r\n[MSG:Reset to continue]"), "{heard}");
    let report = session.say("?");
    assert!(report.starts_with("<Alarm|") && report.contains("|Pn:X|"), "{report}");
    session.byte(0x18);
    assert_eq!(session.say("$X\n"), "[MSG:Caution: Unlocked]\r\nok\r\n");
    assert_eq!(session.say("$J=G90X0F1000\n"), "ok\r\n");
    session.settle();
    assert_eq!((session.at()[Axis::X], session.say("?").contains("Pn:")), (0.0, false));
    // Unlocked on its switch it goes no further onto it, nor does another axis onto its own.
    session.say("G1X50F1000\n");
    session.wait(4000);
    session.byte(0x18);
    session.say("$X\n");
    let before = session.at()[Axis::X];
    assert_eq!(session.say("$J=G91X5F1000\n"), "ok\r\n");
    session.wait(2000);
    let heard = std::mem::take(&mut session.heard);
    assert!(heard.contains("ALARM:1"), "{heard}");
    assert!((session.at()[Axis::X] - before).abs() < 0.2, "{before} {:?}", session.at());
    session.byte(0x18);
    session.say("$X\n");
    assert_eq!(session.say("$J=G91Y8F1000\n"), "ok\r\n");
    session.settle();
    assert_eq!(session.say("$J=G90X0F1000\n"), "ok\r\n");
    session.settle();
    assert_eq!((session.at()[Axis::X], session.say("?").contains("Pn:")), (0.0, false));
    // It acts again.
    session.say("G1X50F1000\n");
    session.wait(4000);
    let heard = std::mem::take(&mut session.heard);
    assert!(heard.contains("ALARM:1"), "{heard}");
}

/// Grbl 1.1: alarm 7, error 13; a hold is nothing to homing.
#[test]
fn an_open_door_ends_homing_and_keeps_the_machine_locked() {
    let mut file = File::demo_mill();
    file.axes.retain(|axis| axis.name.is_linear());
    file.plant = Some(ferrocut_machine::PlantConfig::default());
    let mut session = Session::of(&file, Options::default());
    session.mill.drives().plant().unwrap().move_door(true);
    session.wait(5);
    assert_eq!(
        (session.say("$X\n").as_str(), session.say("$H\n").as_str()),
        ("error:13\r\n", "error:13\r\n")
    );
    assert_eq!(session.state(), "Alarm");
    session.mill.drives().plant().unwrap().move_door(false);
    session.wait(5);
    session.say("$X\nG0X200\n");
    session.settle();
    session.say("$H\n");
    session.wait(200);
    assert_eq!(session.state(), "Home");
    session.mill.drives().plant().unwrap().move_door(true);
    session.wait(50);
    let heard = std::mem::take(&mut session.heard);
    assert!(heard.contains("ALARM:7"), "{heard}");
    session.wait(2000);
    let at = session.at();
    session.wait(500);
    assert_eq!((session.state().as_str(), session.at()), ("Alarm", at));
    session.mill.drives().plant().unwrap().move_door(false);
    session.wait(5);
    session.say("$H\n");
    session.settle();
    assert_eq!(session.state(), "Idle");
    // Homed already: a hold does not break the second time off.
    session.say("G0X200\n");
    session.settle();
    session.say("$H\n");
    session.wait(200);
    assert_eq!(session.state(), "Home");
    session.byte(b'!');
    session.settle();
    assert_eq!(session.state(), "Idle");
}

#[test]
fn the_door_stops_all_and_goes_on() {
    let mut session = Session::unlocked();
    session.say("M3S1000\nG1X200F3000\n");
    session.wait(1500);
    assert!(session.byte(0x84).contains("[MSG:Check Door]"));
    assert_eq!(session.state(), "Door:2");
    session.wait(600);
    assert_eq!((session.state().as_str(), session.mill.status().rpm), ("Door:0", 0.0));
    session.byte(b'~');
    assert_eq!(session.mill.status().rpm, 1000.0);
    session.settle();
    assert_eq!(session.at()[Axis::X], 200.0);
}

#[test]
fn check_mode_tells_what_is_wrong_and_moves_nothing() {
    let mut session = Session::unlocked();
    assert_eq!(session.say("$C\n"), "[MSG:Enabled]\r\nok\r\n");
    assert_eq!(session.state(), "Check");
    assert_eq!(
        session.say("G1X10\nG1X10F100\nG2X5R1\nG0Y3\nM30\nG0Y1\n"),
        "error:22\r\nok\r\nerror:34\r\nok\r\nok\r\nok\r\n"
    );
    assert_eq!(session.at(), Position::ZERO);
    assert_eq!(session.say("$C\n"), "[MSG:Disabled]\r\nok\r\n\r\nGrbl 1.1h ['$' for help]\r\n");
    assert_eq!((session.state().as_str(), session.say("G0X1\n").as_str()), ("Idle", "ok\r\n"));
}

#[test]
fn beyond_the_limits_is_an_alarm_that_wants_a_reset() {
    let mut session = Session::unlocked();
    session.say("G1X10F1000\nX99999\nX5\n");
    session.wait(3000);
    let heard = std::mem::take(&mut session.heard);
    assert!(heard.ends_with("ALARM:2\r\n[MSG:Reset to continue]\r\n"), "{heard}");
    assert_eq!((session.state().as_str(), session.say("$X\n").as_str()), ("Alarm", "error:9\r\n"));
    session.byte(0x18);
    assert_eq!(session.say("$X\n"), "[MSG:Caution: Unlocked]\r\nok\r\n");
    assert_eq!(session.at()[Axis::X], 10.0);
    session.say("G0X0\n");
    session.settle();
    assert_eq!(session.at()[Axis::X], 0.0);
}

#[test]
fn a_probe_tells_where_it_met_the_work() {
    let mut session = Session::with(Options { skip: Some((Axis::Z, -3.5)), ..Options::default() });
    session.say("$X\n");
    let heard = session.say("G10L2P1Z-1\nG38.2Z-20F1000\nG4P0.1\n") + &session.settle();
    assert!(heard.contains("[PRB:0.000,0.000,-3.500:1]\r\nok\r\n"), "{heard}");
    // It is a place of the machine, whatever program zero and units become.
    for line in ["$#", "G10L20P1Z0", "G20", "G92X5", "G43.1Z2"] {
        session.say(&format!("{line}\n"));
        let heard = session.say("$#\n");
        assert!(heard.contains("[PRB:0.000,0.000,-3.500:1]"), "{line} {heard}");
    }
    session.say("G21\nG92.1\nG49\n");
    // Away from it nothing is met. Each line is answered, those behind it by the lock.
    let heard = session.say("G0Z5\nG38.2Z20F1000\nG0X50\nG4P0\n\n$G\n") + &session.settle();
    let answers: Vec<&str> =
        heard.lines().filter(|line| !line.starts_with("[PRB") && !line.starts_with("[GC")).collect();
    assert_eq!(answers, ["ok", "ALARM:5", "ok", "error:9", "error:9", "ok", "ok"], "{heard}");
    session.wait(500);
    assert_eq!(session.at()[Axis::X], 0.0, "what stands behind it is not run");
}

#[test]
fn a_dwell_is_answered_when_the_motion_before_it_has_ended() {
    // CNCjs ends a job so.
    let mut session = Session::unlocked();
    let (mut periods, mut heard) = (20, session.say("G1X10F600\nG4P0\n"));
    while heard.matches("ok").count() < 2 {
        session.wait(1);
        periods += 1;
        heard += &std::mem::take(&mut session.heard);
    }
    assert!(periods > 1000 && session.at()[Axis::X] == 10.0, "{periods}");
}

#[test]
fn a_program_ends_and_another_follows() {
    let mut session = Session::unlocked();
    let program = "G20G91G1X1F10M3S100\nM8\nM30\nG0X1\n";
    session.send(program.as_bytes());
    let heard = session.settle();
    let heard = heard + &session.settle();
    assert_eq!(heard.matches("ok\r\n").count(), 4, "{heard}");
    assert!(heard.contains("[MSG:Pgm End]"), "{heard}");
    // G20 stays, all else is as at the start (Grbl 1.1, M30).
    assert!(session.say("$G\n").contains("[GC:G0 G54 G17 G20 G90 G94 M5 M9"), "codes");
    assert!((session.at()[Axis::X] - 25.4).abs() < 1e-9);
    session.say("M30\n");
    assert!(session.say("$G\n").contains("[GC:G1 G54 G17 G20 G90 G94 M5 M9"), "codes");
    assert_eq!(session.say("X2\n"), "error:22\r\n");
}

/// Jobs that are sent one behind the other may end with nothing between.
#[test]
fn every_end_of_a_program_is_answered() {
    for (program, ends) in [("M30\nM30\nG0X1\n", 2), ("M2\n\nM2\nM2\nG0X1\n", 3), ("M30\n%\nM30\nG0X1\n", 2)]
    {
        let mut session = Session::unlocked();
        session.send(program.as_bytes());
        let heard = session.settle() + &session.settle();
        assert_eq!(heard.matches("ok\r\n").count(), program.lines().count(), "{program} {heard}");
        assert_eq!(heard.matches("[MSG:Pgm End]").count(), ends, "{program} {heard}");
        assert_eq!(session.at()[Axis::X], 1.0, "{program}");
    }
}

#[test]
fn line_numbers_come_back() {
    let mut session = Session::unlocked();
    session.say("N100G1X10F600\nN200X20\n");
    session.wait(500);
    assert!(session.say("?").contains("|Ln:100|"));
    session.wait(1000);
    assert!(session.say("?").contains("|Ln:200|"));
}

#[test]
fn start_lines_run_behind_a_reset() {
    let mut session = Session::unlocked();
    assert_eq!(session.say("$N0=G55 (the second)\n$N1=G5\n"), "ok\r\nerror:20\r\n");
    assert!(session.byte(0x18).ends_with(">G55:ok\r\n"));
    assert!(session.say("$G\n").contains("G55"));
}

#[test]
fn asleep_nothing_but_a_reset_is_taken() {
    let mut session = Session::unlocked();
    assert_eq!(session.say("$SLP\n"), "[MSG:Sleeping]\r\nok\r\n");
    assert_eq!((session.state().as_str(), session.say("G0X1\n").as_str()), ("Sleep", "error:9\r\n"));
    session.byte(0x18);
    assert_eq!(session.state(), "Alarm");
}

#[test]
fn a_sender_that_goes_away_leaves_nothing_running() {
    let mut session = Session::unlocked();
    session.say("$J=X300F1000\n");
    session.wait(200);
    let Session { grbl, mill, .. } = &mut session;
    grbl.disconnect(mill);
    session.settle();
    assert!(session.at()[Axis::X] < 20.0);
    session.say("G1X200F1000\n");
    session.wait(300);
    let Session { grbl, mill, .. } = &mut session;
    grbl.disconnect(mill);
    session.wait(500);
    assert_eq!(session.mill.status().doing, Doing::Held);
    session.grbl.connect(&mut session.mill);
    assert_eq!(session.state(), "Hold:0");
}

/// The end of a program that is refused ends nothing, whoever is there to hear of it.
#[test]
fn the_next_sender_is_answered_though_the_last_ones_end_of_program_was_refused() {
    let mut session = Session::unlocked();
    session.say("G4P0.5\nG1X10M30\n");
    session.reconnect();
    session.byte(b'~');
    session.settle();
    assert_eq!(session.say("G0X1\n"), "ok\r\n");
    assert!(session.say("$G\n").ends_with("ok\r\n"));
}

#[test]
fn five_thousand_lines_stream_through_128_bytes() {
    let mut session = Session::unlocked();
    let mut program = "G21G90G1F6000\n".to_owned();
    for k in 0..4997 {
        let angle = f64::from(k) * 0.02;
        let radius = 2.0 + f64::from(k) * 0.01;
        program += &format!("X{:.3}Y{:.3}\n", radius * angle.cos(), radius * angle.sin());
    }
    program += "G4P0.1\nM2\n";
    let answers = stream(&mut session, &program);
    assert!(answers.len() == 5000 && answers.iter().all(|answer| answer == "ok"));
    session.settle();
    assert_eq!(session.mill.cnc().report().moves, 4997);
    assert_eq!(session.mill.cnc().report().parts, 1);
}

#[test]
fn a_flood_of_resets_is_answered_within_bounds() {
    let mut session = Session::unlocked();
    session.send(&[0x18; 5000]);
    assert!(session.grbl.kept() < 1 << 17, "{}", session.grbl.kept());
    session.wait(20);
    assert!(session.byte(0x18).contains("Grbl 1.1h"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn whatever_comes_is_answered_within_bounds(
        parts in prop::collection::vec(part(), 1..60),
        pause in 0usize..4,
    ) {
        let mut session = Session::unlocked();
        for part in parts {
            match part {
                Some(bytes) => session.send(&bytes),
                None => session.reconnect(),
            }
            prop_assert!(session.grbl.kept() < 1 << 17);
            session.wait(pause * pause * 10);
            session.heard.clear();
        }
        // One that has nothing left to do answers.
        session.byte(b'~');
        session.wait(200);
        if session.mill.status().doing == Doing::Idle {
            prop_assert_ne!(session.say("\n"), "");
        }
        // Whatever state it is in, a reset and unlocking make it one that works.
        session.wait(50);
        session.byte(0x18);
        for _ in 0..20_000 {
            session.wait(1);
            if session.mill.status().doing == Doing::Idle {
                break;
            }
        }
        session.say("$X\n");
        session.heard.clear();
        prop_assert!(session.say("G4P0\n").ends_with("ok\r\n"));
    }
}

/// What a sender, or anyone else, may send; nothing where he goes away and another comes.
fn part() -> impl Strategy<Value = Option<Vec<u8>>> {
    let line = prop::sample::select(vec![
        "G0X10\n",
        "G1Y5F500\n",
        "G2X5Y5R9\n",
        "G91\n",
        "G90\n",
        "G20\n",
        "M3S500\n",
        "M5\n",
        "M0\n",
        "M2\n",
        "M30\n",
        "G4P0.01\n",
        "G4P0.1\nG2X5Y5R1M30\n",
        "G92X1\n",
        "G10L2P1X1\n",
        "G38.2Z-1F100\n",
        "G28\n",
        "$H\n",
        "$X\n",
        "$C\n",
        "$J=G91X1F900\n",
        "$J=X5F2000\n",
        "$SLP\n",
        "$$\n",
        "$G\n",
        "$#\n",
        "$N0=G54\n",
        "G53G0X-5\n",
        "X99999\n",
        "T3M6\n",
        "\n",
        "\r\n",
        "O100 sub\n",
        "#1=5\n",
        "N5G1X1F1e9\n",
        "M7M8\n",
        "M9\n",
        "G93G1X1F60\n",
        "(open\n",
        ";x\n",
        "%\n",
    ]);
    let realtime = prop::sample::select(vec![
        0x18u8, b'?', b'!', b'~', 0x84, 0x85, 0x90, 0x91, 0x92, 0x95, 0x96, 0x97, 0x99, 0x9A, 0x9D, 0x9E,
        0xA0, 0xA1, 0xC2, 0xFF,
    ]);
    prop_oneof![
        6 => line.prop_map(|line| Some(line.as_bytes().to_vec())),
        3 => realtime.prop_map(|byte| Some(vec![byte])),
        1 => prop::collection::vec(any::<u8>(), 0..40).prop_map(Some),
        1 => (any::<u8>(), 0usize..40_000).prop_map(|(byte, count)| Some(vec![byte; count])),
        1 => Just(None),
    ]
}
