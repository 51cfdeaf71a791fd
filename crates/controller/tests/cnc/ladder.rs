//! NC, standard ladder and machine together, through the keys of the panel only.

use crate::common::mill::Mill;
use ferrocut_controller::signals::Mode;
use ferrocut_controller::{Event, State};
use ferrocut_geometry::Axis;
use ferrocut_machine::{AlarmId, Fault};
use ferrocut_toolpath::{Speed, SpindleState};

/// The speed of the spindle, r/min, to the nearest; clockwise positive.
fn rpm(mill: &Mill) -> i32 {
    mill.cnc.spindle().actual_rpm().round() as i32
}

#[test]
fn the_spindle_turns_by_way_of_the_ladder() {
    let mut m = Mill::new("M03 S1200\nG04 X0.5\nM04 S600\nG04 X0.5\nM05\nG04 X0.5\nM30");
    let outputs = ["SPINDLE_CW", "SPINDLE_CCW", "LAMP_SP_CW", "LAMP_SP_CCW", "LAMP_SP_STOP", "SSTA", "SARA"];
    m.start();
    assert!(m.is("LAMP_START") && m.is("TOWER_GREEN") && m.is("DOOR_LOCK"));
    // 1200 r/min at 4000 a second: the code is done after 0.3 s.
    let took = m.until(|m| rpm(m) == 1200);
    assert!((200..320).contains(&took), "{took}");
    m.run(20);
    assert_eq!(m.on(&outputs), ["SPINDLE_CW", "LAMP_SP_CW", "SARA"]);
    m.until(|m| rpm(m) == -600);
    m.run(20);
    assert_eq!(m.on(&outputs), ["SPINDLE_CCW", "LAMP_SP_CCW", "SARA"]);
    m.until(|m| m.is("SSTA"));
    m.run(20);
    assert_eq!((m.on(&outputs), rpm(&m)), (vec!["LAMP_SP_STOP", "SSTA"], 0));
    m.until(|m| *m.cnc.state() == State::Ended);
    m.run(20);
    assert_eq!(m.on(&["LAMP_START", "TOWER_GREEN", "DOOR_LOCK", "TOWER_YELLOW"]), ["TOWER_YELLOW"]);
}

#[test]
fn the_other_way_is_waited_for_from_the_first_scan_on() {
    let mut m = Mill::new("M03 S2000\nM04\nG01 X10 F1000\nM30");
    m.start();
    m.until(|m| m.at[Axis::X] > 0.0);
    assert!(rpm(&m) <= -1960, "{}", rpm(&m));
}

#[test]
fn a_speed_with_another_sense_is_not_run_up_to_in_the_old_one() {
    let mut m = Mill::new("M03 S500\nS3000 M05\nM03 S500\nS3000 M04\nM30");
    m.start();
    let fastest = std::cell::Cell::new(0);
    m.until(|m| {
        fastest.set(fastest.get().max(rpm(m)));
        rpm(m) < -2900
    });
    // Until the ladder has heard of it some scans later.
    assert!((500..=520).contains(&fastest.get()), "{fastest:?}");
}

#[test]
fn codes_of_the_machine_reach_its_valves() {
    let codes = [
        ("M08", "COOLANT", true),
        ("M09", "COOLANT", false),
        ("M26", "FLUSH", true),
        ("M27", "FLUSH", false),
        ("M35", "CONVEYOR", true),
        ("M36", "CONVEYOR", false),
        ("M44", "BLOW", true),
        ("M45", "BLOW", false),
        ("M10", "A_RELEASE", true),
        ("M11", "A_CLAMP", true),
        ("M19", "ORARA", true),
        ("M18", "ORARA", false),
        ("M29", "RTAP", true),
        ("M28", "RTAP", false),
    ];
    let program: String = codes.iter().map(|(code, ..)| format!("{code}\nM00\n")).collect();
    let mut m = Mill::new(&format!("{program}M30"));
    m.start();
    for (code, output, on) in codes {
        m.until(|m| *m.cnc.state() == State::Stopped(0));
        assert_eq!(m.is(output), on, "{code}");
        // M10 and M11 wait for the clamp.
        assert!(code != "M10" || m.is("A_LOOSE"));
        assert!(code != "M11" || m.is("A_CLAMPED"));
        assert!(m.is("OP") && !m.is("STL") && !m.is("MF") && !m.is("FIN"));
        m.press("KEY_START");
    }
    m.until(|m| *m.cnc.state() == State::Ended);
}

#[test]
fn the_end_of_a_program_ends_what_its_codes_began() {
    let mut m = Mill::new("M03 S500\nM08\nM26\nM35\nM44\nM30");
    m.run_program();
    m.run(300);
    assert_eq!(m.on(&["SPINDLE_CW", "COOLANT", "FLUSH", "CONVEYOR", "BLOW"]), ["CONVEYOR"]);
    assert_eq!((rpm(&m), m.cnc.report().parts), (0, 1));
}

#[test]
fn a_move_of_the_block_runs_beside_its_code_and_the_next_block_waits() {
    // Releasing A takes 0.12 s, the move 0.6 s and more: both at once.
    let mut m = Mill::new("G01 X10 F1000 M10\nG01 Y10\nM11\nM30");
    m.start();
    m.until(|m| m.at[Axis::X] > 1.0);
    assert!(m.is("A_RELEASE"));
    m.until(|m| m.is("A_LOOSE"));
    assert!(m.at[Axis::X] < 8.0);
    // A code that takes long: the axes come to rest on the end of the block, and DEN says so.
    let mut m = Mill::new("G00 X1 M03 S4000\nG01 Y10 F1000\nM30");
    m.start();
    m.until(|m| m.at[Axis::X] == 1.0);
    assert!(m.outputs.m.strobe && m.cnc.waits_for_ladder());
    m.run(300);
    assert!(m.is("DEN") && m.at[Axis::Y] == 0.0 && m.cnc.waits_for_ladder());
    m.until(|m| m.at[Axis::Y] > 0.0);
    // The speed is there to 2 %.
    assert!(!m.is("DEN") && rpm(&m) >= 3920);
}

#[test]
fn codes_of_a_block_follow_each_other_and_wait_for_their_turn() {
    let mut m = Mill::new("M08 M26 M44\nM00\nM30");
    m.start();
    m.until(|m| *m.cnc.state() == State::Stopped(0));
    assert_eq!(m.codes, [8, 26, 44, 0]);
    assert_eq!(m.on(&["COOLANT", "FLUSH", "BLOW"]), ["COOLANT", "FLUSH", "BLOW"]);
}

#[test]
fn a_tool_is_changed_by_its_program() {
    // The second reference point, where Z meets the magazine, is at -100.
    let setup = "[parameters]\nP52 = -100.0\n";
    let mut m = Mill::with("T3 M06\nM03 S800\nT14\nG01 X5 F1000\nM06\nM30", setup, |_| {});
    m.start();
    m.until(|m| m.events.contains(&Event::ToolChange(3)));
    assert_eq!((m.pocket, m.byte("POCKET"), m.at[Axis::Z]), (3, 3, -100.0));
    m.until(|m| m.events.contains(&Event::ToolChange(14)));
    assert_eq!((m.pocket, m.byte("POCKET")), (14, 14));
    m.until(|m| *m.cnc.state() == State::Ended);
    let states =
        ["TOOL_CLAMPED", "TOOL_LOOSE", "MAG_AT_SPINDLE", "MAG_AWAY", "MAG_CW", "MAG_CCW", "MSG_TOOL"];
    assert_eq!(m.on(&states), ["TOOL_CLAMPED", "MAG_AWAY"]);
    assert_eq!(m.cnc.report().tool(), 14);
}

#[test]
fn a_pocket_that_there_is_not_is_told_and_reset_ends_the_wait() {
    let mut m = Mill::new("T17\nM30");
    m.start();
    m.run(2_000);
    assert_eq!(m.on(&["MSG_POCKET", "TF", "FIN", "MAG_CW", "MAG_CCW"]), ["MSG_POCKET", "TF"]);
    m.reset();
    assert_eq!(m.on(&["MSG_POCKET", "TF", "STL", "OP"]), Vec::<&str>::new());
    assert_eq!(m.cnc.state(), &State::Reset);
}

#[test]
fn a_code_that_is_never_done_is_an_alarm() {
    let mut m = Mill::with("G01 X5 F1000\nM10\nM30", "", |machine| machine.handshake.time_out_s = 2.0);
    m.start();
    m.until(|m| m.is("A_RELEASE"));
    // The clamp hangs.
    let hangs = m.address("A_LOOSE");
    m.plc.force(&ferrocut_plc::Maintenance::granted(), hangs, false);
    let took = m.until(|m| matches!(m.cnc.state(), State::Alarmed(_)));
    let State::Alarmed(alarm) = m.cnc.state().clone() else { panic!() };
    assert_eq!((alarm.fault, alarm.span.line), (Fault::CodeNotFinished, 2));
    assert!((1_900..2_100).contains(&took), "{took}");
    m.run(20);
    assert!(m.is("TOWER_RED") && !m.is("MF"));
}

/// No M05 and M09 that nobody wrote: DM02 and DM30 end what M codes began, and wait for the spindle.
#[test]
fn the_end_of_a_program_is_one_code_to_the_ladder() {
    for end in [2, 30] {
        let mut m = Mill::new(&format!("M03 S1200\nM08\nG01 X5 F1000\nM{end}"));
        m.run_program();
        assert_eq!((m.codes.clone(), rpm(&m)), (vec![3, 8, end], 0));
        assert_eq!(m.on(&["SFRA", "COOLANT", "SSTA"]), ["SSTA"]);
        let in_force = m.cnc.interpreter().program_state();
        assert_eq!((in_force.spindle, in_force.coolant), (SpindleState::Off, [false; 2]));
    }
    // Held while the ladder has the end: the spindle that stops is not missing.
    let mut m = Mill::with("M03 S1200\nM30", "", |machine| machine.handshake.strobe_delay_ms = 200.0);
    m.start();
    m.until(|m| m.outputs.m30);
    m.press("KEY_HOLD");
    assert_eq!((m.cnc.state(), m.cnc.spindle_due()), (&State::Held, None));
    // One that is not finished is named.
    let mut m = Mill::with("S400\nM30", "", |machine| machine.handshake.time_out_s = 1.0);
    let never = m.address("FIN");
    m.plc.force(&ferrocut_plc::Maintenance::granted(), never, false);
    m.start();
    m.until(|m| matches!(m.cnc.state(), State::Alarmed(_)));
    let State::Alarmed(alarm) = m.cnc.state().clone() else { panic!() };
    assert_eq!((alarm.fault, &alarm.arguments[0]), (Fault::CodeNotFinished, &("word", "M30".into())));
}

#[test]
fn rigid_tapping_wants_its_signal() {
    let tapping = "G00 Z5\nM29 S500\nG84 X0 Y0 Z-5 R2 F500\nG80\nM28\nM30";
    let mut m = Mill::new(&format!("M03 S500\n{tapping}"));
    m.start();
    m.until(|m| m.is("THRD"));
    assert!(m.is("RGTAP") && m.is("TAP") && !m.is("SPINDLE_CW"));
    m.until(|m| *m.cnc.state() == State::Ended);
    assert!(!m.is("RGTAP"));
    // A ladder that turns it off.
    let mut m = Mill::new(tapping);
    let rigid = m.address("RTAP");
    m.plc.force(&ferrocut_plc::Maintenance::granted(), rigid, true);
    let rigid = m.address("RGTAP");
    m.plc.force(&ferrocut_plc::Maintenance::granted(), rigid, false);
    m.start();
    m.until(|m| *m.cnc.state() != State::Running);
    let State::Alarmed(alarm) = m.cnc.state() else { panic!() };
    assert_eq!(alarm.id, AlarmId::Dialect("gsk990mc", 205));
}

/// An M10 x 1.5 hole in a floating holder (no M29), from Z 20 over R 5.
const FLOATING: &str = "M03 S600\nG00 Z20\nG98 G84 X0 Y0 Z-20 R5 P100 F900\nG80\nG04 X2\nM30";

/// GSK990MC 4.4.5: while it taps the spindle turns as at 100 %, from the first turn in the work on.
#[test]
fn a_floating_tap_turns_at_its_speed_from_its_first_turn_on() {
    let mut m = Mill::new(FLOATING);
    m.turn("SWITCH_SPINDLE", 0);
    m.start();
    m.until(|m| m.at[Axis::Z] > 19.0);
    assert_eq!(rpm(&m), 300, "at 50 %");
    m.until(|m| m.at[Axis::Z] < 5.0);
    assert_eq!((rpm(&m), m.is("TAP")), (600, true));
    m.until(|m| m.at[Axis::Z] < -19.9);
    assert_eq!(rpm(&m), 600);
    m.until(|m| m.at[Axis::Z] > 5.0);
    m.run(300);
    assert_eq!((rpm(&m), m.is("TAP")), (300, false), "out of the thread the override counts again");
}

/// A reset acts at once in such a thread, and leaves nothing of it behind.
#[test]
fn a_reset_in_the_thread_of_a_floating_tap_ends_it_and_the_override_counts_again() {
    let mut m = Mill::new(FLOATING);
    m.turn("SWITCH_SPINDLE", 0);
    m.start();
    m.until(|m| m.at[Axis::Z] < -10.0);
    assert_eq!((rpm(&m), m.is("TAP")), (600, true));
    m.reset();
    m.until(|m| *m.cnc.state() == State::Reset);
    m.run(500);
    assert_eq!((rpm(&m), m.is("TAP")), (0, false));
    assert!(m.at[Axis::Z] < -9.0, "it stays where it was stopped");
    // The spindle by its key, at the last speed.
    m.press("KEY_JOG");
    m.press("KEY_SP_CW");
    m.run(400);
    assert_eq!((rpm(&m), m.is("TAP")), (300, false));
    m.turn("SWITCH_SPINDLE", 7);
    m.run(400);
    assert_eq!(rpm(&m), 720);
}

#[test]
fn under_auxiliary_lock_no_code_leaves_the_control() {
    let mut m = Mill::new("M03 S1000\nT5\nM06\nT7 M06\nM08\nG95 G01 X1 F0.5\nM00\nM30");
    m.press("KEY_AUTO");
    m.press("KEY_AUXLOCK");
    assert!(m.is("LAMP_AUXLOCK"));
    m.press("KEY_START");
    while !matches!(m.cnc.state(), State::Stopped(_)) {
        m.tick();
        assert!(!m.is("SF") && !m.is("TF") && (!m.is("MF") || m.byte("M_CODE") == 0));
        assert!(m.ms < 20_000);
    }
    assert_eq!((m.cnc.state(), rpm(&m), m.at[Axis::X]), (&State::Stopped(0), 0, 1.0));
    assert_eq!(m.on(&["SPINDLE_CW", "COOLANT"]), Vec::<&str>::new());
    assert_eq!((m.cnc.interpreter().tools(), tool_of_program(&m)), ((0, 0), None));
    m.press("KEY_START");
    m.until(|m| *m.cnc.state() == State::Ended);
    assert_eq!((m.byte("M_CODE"), m.cnc.report().parts), (30, 1));
    assert_eq!((m.cnc.interpreter().tools(), tool_of_program(&m)), ((0, 0), None));
}

/// The tool in the spindle as the program of the tool change keeps it.
fn tool_of_program(mill: &Mill) -> Option<f64> {
    mill.cnc.interpreter().memory().variables.get(500)
}

/// 7.8: M06 is not executed, neither its program nor what it says of the tool.
#[test]
fn a_tool_change_under_auxiliary_lock_never_happened() {
    let mut m = Mill::with(
        "T3 M06\nM00\nT7 M06\nM00\nT7 M06\nM00\nT5 M06\nM30",
        "[parameters]\nP52 = -100.0\n",
        |_| {},
    );
    let stops = |m: &mut Mill| {
        m.until(|m| *m.cnc.state() == State::Running);
        m.until(|m| matches!(m.cnc.state(), State::Stopped(_)));
        (m.cnc.interpreter().tools(), tool_of_program(m), m.pocket)
    };
    m.start();
    assert_eq!(stops(&mut m), ((3, 3), Some(3.0), 3));
    m.press("KEY_AUXLOCK");
    m.machine("KEY_START", true);
    m.run(30);
    m.machine("KEY_START", false);
    assert_eq!(stops(&mut m), ((3, 3), Some(3.0), 3));
    // Without the lock the same blocks change the tool.
    m.press("KEY_AUXLOCK");
    m.machine("KEY_START", true);
    m.run(30);
    m.machine("KEY_START", false);
    assert_eq!(stops(&mut m), ((7, 7), Some(7.0), 7));
    // A lock that comes in the midst of a change waits for its end.
    m.machine("KEY_START", true);
    m.run(30);
    m.machine("KEY_START", false);
    m.until(|m| m.is("TOOL_LOOSE"));
    m.press("KEY_AUXLOCK");
    m.until(|m| *m.cnc.state() == State::Ended);
    assert_eq!((m.cnc.interpreter().tools(), tool_of_program(&m), m.pocket), ((5, 5), Some(5.0), 5));
    assert_eq!(m.on(&["TOOL_CLAMPED", "MAG_AWAY", "TOOL_LOOSE"]), ["TOOL_CLAMPED", "MAG_AWAY"]);
}

#[test]
fn an_open_door_holds_the_program_and_stops_the_spindle() {
    let mut m = Mill::new("M03 S1000\nG01 X50 F1000\nM30");
    m.start();
    m.until(|m| m.at[Axis::X] > 5.0);
    m.machine("DOOR_CLOSED", false);
    m.until(|m| *m.cnc.state() == State::Held);
    m.until(|m| m.is("SSTA"));
    m.run(100);
    let at = m.at;
    assert_eq!(
        m.on(&["MSG_DOOR", "LAMP_HOLD", "LAMP_START", "SPINDLE_CW", "STLK"]),
        ["MSG_DOOR", "LAMP_HOLD", "STLK"]
    );
    // Cycle start is locked while it is open.
    m.press("KEY_START");
    assert_eq!((m.cnc.state(), m.at), (&State::Held, at));
    m.machine("DOOR_CLOSED", true);
    m.run(50);
    assert_eq!((m.cnc.state(), rpm(&m)), (&State::Held, 0), "nothing starts by itself");
    // The spindle is due before the program goes on: the operator turns it on.
    let due = m.cnc.spindle_due();
    assert_eq!(due, Some(SpindleState::Clockwise(Speed::Rpm(1000.0))));
    for key in ["KEY_JOG", "KEY_SP_CW", "KEY_AUTO"] {
        m.press(key);
    }
    m.until(|m| rpm(m) == 1000);
    assert_eq!(m.cnc.spindle_due(), None);
    m.press("KEY_START");
    m.until(|m| m.at[Axis::X] > at[Axis::X] + 1.0);
}

#[test]
fn cutting_waits_for_the_speed_where_the_parameter_says_so() {
    let maintenance = ferrocut_plc::Maintenance::granted();
    for waits in [true, false] {
        let setup = format!("[parameters]\n\"NO38.0\" = {}\n", u8::from(waits));
        let mut m = Mill::with("G00 X5\nM03 S4000\nG00 X10\nG01 X20 F1000\nM30", &setup, |_| {});
        m.start();
        // The spindle has its speed, and loses it before cutting begins: positioning goes on.
        m.until(|m| m.is("SAR"));
        let at_speed = m.address("SARA");
        m.plc.force(&maintenance, at_speed, false);
        m.run(3_000);
        let at = m.at[Axis::X];
        assert!(if waits { at == 10.0 } else { at > 10.0 }, "{at}");
        m.plc.release(&maintenance, at_speed);
        m.until(|m| *m.cnc.state() == State::Ended);
    }
}

#[test]
fn the_spindle_follows_its_override_gears_and_the_limits_of_g96() {
    let spin = |program: &str, setup: &str, position: u8| {
        let mut m = Mill::with(&format!("{program}\nG04 X3\nM30"), setup, |_| {});
        m.turn("SWITCH_SPINDLE", position);
        m.start();
        m.run(2_900);
        (rpm(&m), m.on(&["GR1O", "GR2O", "GR3O", "CSS"]), m)
    };
    // 50 to 120 % in eight steps.
    for (position, wanted) in [(0, 500), (3, 800), (5, 1000), (7, 1200)] {
        assert_eq!(spin("M03 S1000", "", position).0, wanted);
    }
    // P262: not below 80 %.
    assert_eq!(spin("M03 S1000", "[parameters]\nP262 = 0.8\n", 0).0, 800);
    // Gears up to 500, 2000 and 6000: the lowest that has the speed, and no faster than it is.
    let gears = "[parameters]\nP246 = 500\nP247 = 2000\nP248 = 6000\n";
    for (s, wanted, gear) in
        [(400, 400, "GR1O"), (500, 500, "GR1O"), (501, 501, "GR2O"), (3000, 3000, "GR3O")]
    {
        let (rpm, on, _) = spin(&format!("M03 S{s}"), gears, 5);
        assert_eq!((rpm, on), (wanted, vec![gear]), "S{s}");
    }
    assert_eq!(spin("M03 S490", gears, 7).0, 500, "120 % of 490 in gear 1");
    // G96 about X0: 50 m/min at radius 10 are 795.8 r/min; G92 S holds them at 500, before the override or behind.
    let g96 = |clamp: &str| format!("G00 X10\n{clamp}\nG96 P1 S50000\nM03\n");
    let on = "[parameters]\n\"NO61.0\" = 1\n";
    let (found, signals, _) = spin(&g96(""), on, 5);
    assert_eq!((found, signals), (796, vec!["GR1O", "CSS"]));
    assert_eq!(spin(&g96("G92 S500"), on, 5).0, 500);
    assert_eq!(spin(&g96("G92 S500"), on, 7).0, 600);
    let behind = format!("{on}\"NO37.3\" = 1\n");
    assert_eq!(spin(&g96("G92 S500"), &behind, 7).0, 500);
}

#[test]
fn surface_speed_follows_the_axis_while_it_cuts() {
    let setup = "[parameters]\n\"NO61.0\" = 1\n";
    let mut m = Mill::with("G00 X20\nG96 P1 S50000\nM03\nG01 X10 F300\nG04 X1\nM30", setup, |_| {});
    m.start();
    m.until(|m| m.at[Axis::X] == 20.0);
    m.until(|m| m.at[Axis::X] < 15.0);
    // 50 m/min at radius 15 are 530.5 r/min, a little late.
    assert!((520..=531).contains(&rpm(&m)), "{}", rpm(&m));
    m.until(|m| m.at[Axis::X] == 10.0);
    m.run(500);
    assert_eq!(rpm(&m), 796);
}

#[test]
fn short_lines_run_as_one_where_feed_follows_a_surface_speed() {
    let setup = "[parameters]\n\"NO61.0\" = 1\n";
    // More lines of 0.1 mm than motion knows, on a circle about X16.
    let lines: String = (0..=6000)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 250.0)
        .map(|t| format!("X{:.4} Y{:.4}\n", 16.0 + 4.0 * t.cos(), 4.0 * t.sin()))
        .collect();
    let program = format!("G00 X20\nG96 P1 S50000\nM03\nG04 X1\nG95 G01 F6\n{lines}G04 X1\nM30");
    let mut m = Mill::with(&program, setup, |_| {});
    m.start();
    m.until(|m| m.at[Axis::X] == 20.0);
    m.until(|m| m.at[Axis::X] < 12.01);
    let (mut at, mut least, mut speeds) = (m.at, f64::INFINITY, [f64::INFINITY, 0.0_f64]);
    while m.cnc.moves().count() > 200 {
        m.tick();
        let told = m.cnc.spindle().told();
        speeds = [speeds[0].min(told), speeds[1].max(told)];
        // 6 mm a turn, mm/s.
        least = least.min(m.at.distance(at) / 0.001 / (6.0 * told / 60.0));
        at = m.at;
    }
    assert!(speeds[1] > 1.5 * speeds[0], "{speeds:?}");
    assert!(least > 0.8, "{least}");
}

#[test]
fn spindle_keys_turn_it_at_the_last_speed() {
    let mut m = Mill::new("S700\nM30");
    m.run_program();
    assert_eq!(m.outputs.s.code, 700);
    m.press("KEY_JOG");
    assert_eq!(m.mode(), Mode::Jog);
    m.press("KEY_SP_CW");
    m.run(400);
    assert_eq!((rpm(&m), m.is("LAMP_SP_CW")), (700, true));
    m.press("KEY_SP_CCW");
    m.run(600);
    assert_eq!(rpm(&m), -700);
    m.press("KEY_SP_STOP");
    m.run(400);
    assert_eq!((rpm(&m), m.is("LAMP_SP_STOP")), (0, true));
    // Jog turns at P242, 50 r/min, while its key is held.
    m.press("KEY_SP_JOG");
    m.machine("KEY_SP_CW", true);
    m.run(100);
    assert_eq!(rpm(&m), 50);
    m.machine("KEY_SP_CW", false);
    m.run(100);
    assert_eq!(rpm(&m), 0);
    m.press("KEY_SP_JOG");
    m.press("KEY_SP_ORIENT");
    m.run(300);
    assert!(m.is("ORARA") && m.is("LAMP_SP_ORIENT"));
    m.press("KEY_SP_ORIENT");
    assert!(!m.is("ORARA"));
}

/// GSK990MC part 2, 1.2.4: spindle jog is of JOG, STEP and HANDLE.
#[test]
fn spindle_jog_ends_with_the_manual_modes() {
    let mut m = Mill::new("M03 S1000\nG04 X0.5\nM30");
    m.press("KEY_JOG");
    m.press("KEY_SP_JOG");
    for key in ["KEY_STEP", "KEY_MPG"] {
        m.press(key);
        assert_eq!((m.is("LAMP_SP_JOG"), m.inputs.spindle_jog), (true, true), "{key}");
    }
    m.start();
    assert_eq!((m.is("LAMP_SP_JOG"), m.inputs.spindle_jog), (false, false));
    m.until(|m| rpm(m) == 1000);
    m.until(|m| *m.cnc.state() == State::Ended);
    m.run(400);
    m.press("KEY_JOG");
    assert!(!m.is("LAMP_SP_JOG"), "it does not come back by itself");
    // Of another ladder, that keeps the signal, it counts as little.
    let jogs = m.address("SJOG");
    m.plc.force(&ferrocut_plc::Maintenance::granted(), jogs, true);
    m.press("KEY_SP_CW");
    m.machine("KEY_SP_CW", true);
    m.run(300);
    assert_eq!(rpm(&m), 50);
    m.press("KEY_AUTO");
    m.run(400);
    assert_eq!((rpm(&m), m.inputs.spindle_jog), (1000, true));
}

#[test]
fn a_key_of_the_spindle_that_is_held_while_all_is_stopped_turns_it_once_let_go() {
    for (key, speed) in [("KEY_SP_CW", 700), ("KEY_SP_CCW", -700)] {
        for (input, stops) in [("*ESP_BUTTON", false), ("DOOR_CLOSED", false)] {
            let mut m = Mill::new("S700\nM30");
            m.run_program();
            m.press("KEY_JOG");
            m.machine(key, true);
            m.until(|m| rpm(m) == speed);
            m.machine(input, stops);
            m.run(500);
            m.machine(input, !stops);
            m.run(500);
            assert_eq!(rpm(&m), 0, "{input}");
            m.machine(key, false);
            m.run(100);
            assert_eq!(rpm(&m), 0, "{input}");
            m.press(key);
            m.run(500);
            assert_eq!(rpm(&m), speed, "{input}");
        }
    }
}

#[test]
fn an_emergency_stop_ends_all() {
    let mut m = Mill::new("M03 S2000\nM08\nG01 X50 F1000\nM30");
    m.start();
    m.until(|m| m.at[Axis::X] > 5.0);
    m.machine("*ESP_BUTTON", false);
    m.run(1_500);
    assert!(matches!(m.cnc.state(), State::Reset), "{:?}", m.cnc.state());
    let all = ["SPINDLE_CW", "COOLANT", "MF", "LAMP_START", "TOWER_RED", "STL", "SSTA"];
    assert_eq!(m.on(&all), ["TOWER_RED", "SSTA"]);
    let at = m.at;
    m.press("KEY_START");
    m.machine("*ESP_BUTTON", true);
    m.run(500);
    assert_eq!((m.at, rpm(&m)), (at, 0), "nothing starts by itself");
    assert!(!m.is("TOWER_RED"));
}

#[test]
fn a_reset_takes_a_code_back() {
    let mut m = Mill::new("M03 S4000\nG01 X5 F1000\nM30");
    m.start();
    m.until(|m| m.is("MF"));
    m.run(100);
    m.reset();
    assert_eq!((m.cnc.state(), m.on(&["MF", "SF", "SPINDLE_CW", "DM30"])), (&State::Reset, vec![]));
    m.run(1_500);
    assert_eq!((rpm(&m), m.at[Axis::X]), (0, 0.0));
}

#[test]
fn a_hold_lets_a_code_come_to_its_end() {
    let mut m = Mill::new("M10\nG01 X5 F1000\nM30");
    m.start();
    m.until(|m| m.is("MF"));
    m.press("KEY_HOLD");
    m.run(500);
    assert_eq!((m.cnc.state(), m.is("MF"), m.is("A_LOOSE")), (&State::Held, false, true));
    assert_eq!(m.at[Axis::X], 0.0);
    m.press("KEY_START");
    m.until(|m| *m.cnc.state() == State::Ended);
    assert_eq!(m.at[Axis::X], 5.0);
}

#[test]
fn keys_of_modes_choose_the_mode_and_light_its_lamp() {
    let mut m = Mill::new("M30");
    let table = [
        ("AUTO", Mode::Auto),
        ("EDIT", Mode::Edit),
        ("MDI", Mode::Mdi),
        ("DNC", Mode::Dnc),
        ("HOME", Mode::Home),
        ("JOG", Mode::Jog),
        ("STEP", Mode::Step),
        ("MPG", Mode::Handle),
    ];
    let lamps: Vec<String> = table.iter().map(|(name, _)| format!("LAMP_{name}")).collect();
    assert_eq!(m.mode(), Mode::Jog, "after power-on");
    for (name, mode) in table {
        m.press(&format!("KEY_{name}"));
        let lit: Vec<&String> = lamps.iter().filter(|lamp| m.is(lamp)).collect();
        assert_eq!((m.mode(), lit), (mode, vec![&format!("LAMP_{name}")]));
    }
}

#[test]
fn switches_reach_the_nc_and_come_back_as_lamps() {
    type Is = fn(&ferrocut_controller::Inputs) -> bool;
    let table: [(&str, &str, Is); 8] = [
        ("SINGLE", "KEY_AUTO", |i| i.single_block),
        ("SKIP", "KEY_MDI", |i| i.block_skip),
        ("OPTSTOP", "KEY_DNC", |i| i.optional_stop),
        ("DRY", "KEY_AUTO", |i| i.dry_run),
        ("MLOCK", "KEY_JOG", |i| i.machine_lock),
        ("AUXLOCK", "KEY_AUTO", |i| i.auxiliary_lock),
        ("RESTART", "KEY_AUTO", |i| i.restart),
        ("RAPID", "KEY_JOG", |i| i.manual_rapid),
    ];
    let mut m = Mill::new("M30");
    for (name, mode, is_on) in table {
        m.press(mode);
        for wanted in [true, false] {
            m.press(&format!("KEY_{name}"));
            assert_eq!((is_on(&m.inputs), m.is(&format!("LAMP_{name}"))), (wanted, wanted), "{name}");
        }
    }
    for (name, output) in [("LIGHT", "LIGHT"), ("COOLANT", "COOLANT"), ("CHIP", "CONVEYOR")] {
        for wanted in [true, false] {
            m.press(&format!("KEY_{name}"));
            assert_eq!((m.is(output), m.is(&format!("LAMP_{name}"))), (wanted, wanted), "{name}");
        }
    }
    m.machine("KEY_LUBE", true);
    m.run(20);
    assert!(m.is("LUBE") && m.is("LAMP_LUBE"));
    m.machine("KEY_LUBE", false);
    m.run(20);
    assert!(!m.is("LUBE") && !m.is("LAMP_LUBE"));
    assert!(m.is("LAMP_ZERO_Z") && !m.is("LAMP_ZERO_X"));
}

#[test]
fn overrides_and_selections_reach_the_nc() {
    use ferrocut_controller::signals::RapidOverride;
    let mut m = Mill::new("M30");
    for position in 0..=20 {
        m.turn("SWITCH_FEED", position);
        m.run(5);
        let wanted = f64::from(position) / 10.0;
        let found = [m.inputs.feed_override, m.inputs.manual_override];
        assert!(found.iter().all(|f| (f - wanted).abs() < 1e-12), "{position}: {found:?}");
    }
    for (position, wanted) in (0..8).zip([0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2]) {
        m.turn("SWITCH_SPINDLE", position);
        m.run(5);
        assert!((m.inputs.spindle_override - wanted).abs() < 1e-12);
    }
    for (key, wanted) in [
        ("R_F0", RapidOverride::Lowest),
        ("R_25", RapidOverride::Quarter),
        ("R_50", RapidOverride::Half),
        ("R_100", RapidOverride::Full),
    ] {
        m.press(&format!("KEY_{key}"));
        assert_eq!(m.inputs.rapid_override, wanted);
        let lamps = ["LAMP_R_F0", "LAMP_R_25", "LAMP_R_50", "LAMP_R_100"];
        assert_eq!(m.on(&lamps), [format!("LAMP_{key}")]);
    }
    for (n, axis) in ["X", "Y", "Z", "A"].into_iter().enumerate() {
        m.press(&format!("KEY_W{axis}"));
        assert_eq!(m.inputs.handwheel_axis, Some(n));
        m.press(&format!("KEY_S{n}"));
        assert!((m.inputs.increment_of(0.001) - 0.001 * 10f64.powi(n as i32)).abs() < 1e-12);
        for (way, sign) in [("+", 1), ("-", -1)] {
            m.machine(&format!("KEY_{axis}{way}"), true);
            m.run(5);
            let wanted: Vec<i8> = (0..8).map(|k| if k == n { sign } else { 0 }).collect();
            assert_eq!(m.inputs.jog.iter().map(|ways| ways.sign()).collect::<Vec<_>>(), wanted);
            m.machine(&format!("KEY_{axis}{way}"), false);
            m.run(5);
        }
    }
}

#[test]
fn limit_switches_are_told_by_axis_and_way() {
    let mut m = Mill::new("M30");
    m.press("KEY_JOG");
    for bit in 0..8 {
        let (axis, is_plus) = (bit / 2, bit % 2 == 0);
        m.limits = !(1 << bit);
        m.run(5);
        for (n, (at, no)) in m.inputs.at_limit.iter().zip(&m.inputs.no_motion).take(4).enumerate() {
            let wanted = (n == axis && is_plus, n == axis && !is_plus);
            assert_eq!(
                ((at.plus, at.minus), (no.plus, no.minus)),
                (wanted, wanted),
                "switch {bit}, axis {n}"
            );
        }
        assert!(m.is("LAMP_OT"));
        // The key towards it is dead, the one away from it is not.
        let letter = ["X", "Y", "Z", "A"][axis];
        for (way, sign) in [("+", 1), ("-", -1)] {
            m.machine(&format!("KEY_{letter}{way}"), true);
            m.run(5);
            let dead = is_plus == (sign == 1);
            assert_eq!(m.inputs.jog[axis].sign(), if dead { 0 } else { sign });
            m.machine(&format!("KEY_{letter}{way}"), false);
            m.run(5);
        }
        // The release key takes the alarm away, the way on stays shut.
        m.machine("KEY_OT", true);
        m.run(5);
        let ways = m.inputs.at_limit[axis];
        assert!(!ways.plus && !ways.minus && (m.inputs.no_motion[axis].plus == is_plus));
        m.machine("KEY_OT", false);
    }
    m.limits = 0xFF;
    m.run(5);
    assert!(!m.is("LAMP_OT"));
}

#[test]
fn lubrication_and_air_lock_the_start() {
    let mut m = Mill::new("M30");
    m.press("KEY_AUTO");
    for (input, message) in
        [("LUBE_LEVEL", "MSG_LUBE"), ("AIR_PRESSURE", "MSG_AIR"), ("DRIVE_OK", "MSG_DRIVE")]
    {
        m.machine(input, false);
        m.run(20);
        m.press("KEY_START");
        assert_eq!((m.is(message), m.cnc.state()), (true, &State::Ready), "{input}");
        assert_eq!(m.inputs.axes_may_move, input != "AIR_PRESSURE");
        m.machine(input, true);
        m.reset_signal();
        assert!(!m.is(message));
    }
    // Every half hour for 15 s.
    let minutes = m.address("LUBE_MINUTES");
    m.plc.memory_mut().set_byte(minutes, 1);
    m.until(|m| m.is("LUBE"));
    let took = m.until(|m| !m.is("LUBE"));
    assert!((14_900..15_100).contains(&took), "{took}");
    m.press("KEY_START");
    m.until(|m| *m.cnc.state() == State::Ended);
}

#[test]
fn programs_read_and_set_signals() {
    let program =
        "#1102=1\nM00\n#1132=9\nM00\n#1100=0\nIF [#1003 EQ 1] GOTO 5\nG00 X1\nGOTO 6\nN5 G00 X2\nN6 M30";
    for (input, wanted) in [(false, 1.0), (true, 2.0)] {
        let mut m = Mill::new(program);
        let uo = m.address("UO");
        m.start();
        m.until(|m| *m.cnc.state() == State::Stopped(0));
        assert_eq!(m.plc.memory().byte(uo), 0b100);
        m.press("KEY_START");
        m.until(|m| *m.cnc.state() == State::Stopped(0));
        assert_eq!(m.plc.memory().byte(uo), 0b1001);
        // The signal comes while the program waits.
        let ui = m.address("UI");
        m.plc.memory_mut().set_byte(ui, u8::from(input) << 3);
        m.press("KEY_START");
        m.until(|m| *m.cnc.state() == State::Ended);
        assert_eq!((m.at[Axis::X], m.plc.memory().byte(uo)), (wanted, 0b1000));
    }
}
