//! What a reset keeps and clears (GSK990MC 4.1 note 7, bits 34, 35, 36, 52).
#![allow(missing_docs, clippy::unwrap_used)]

use ferrocut_geometry::Position;
use ferrocut_interpreter::{Interpreter, Options, dialects};
use ferrocut_machine::{Memory, Setup};
use ferrocut_program::{ProgramMemory, Text};

/// The codes in force after the program was reset at X7, and the interpreter.
fn reset(program: &str, setup: &str) -> (Vec<u16>, Interpreter) {
    let dialect = dialects::by_name("gsk990mc").unwrap();
    let text = Text::from_bytes(program.as_bytes().to_vec()).unwrap();
    let programs = ProgramMemory::new("reset.nc", text, dialect.syntax);
    let mut memory = Memory::new("gsk990mc");
    Setup::from_toml(setup).unwrap().apply(&mut memory).unwrap();
    let mut interpreter = Interpreter::new(dialect, programs, memory, Options::default());
    for step in &mut interpreter {
        step.unwrap();
    }
    interpreter.reset(Position::xyz(7.0, 0.0, 0.0));
    (interpreter.codes_in_force().collect(), interpreter)
}

const PROGRAM: &str = "#1=5\n#150=6\n#500=8\nG1 G18 G91 G20 G55 G61 G43 H1 X1 F10\nM30\n";

#[test]
fn the_standard_setting_clears_only_compensation() {
    let (codes, _) = reset(PROGRAM, "[tools.1]\nlength = 3");
    // 35#7 and 36#0 are set: groups 7 and 8.
    for kept in [10, 180, 910, 200, 550, 610, 400, 490] {
        assert!(codes.contains(&kept), "{kept} in {codes:?}");
    }
    assert!(!codes.contains(&430));
}

#[test]
fn each_bit_clears_its_group() {
    for (bit, before, after) in [
        ("NO35.1", 10, 0),
        ("NO35.2", 180, 170),
        ("NO35.3", 910, 900),
        ("NO35.5", 550, 540),
        ("NO36.6", 610, 640),
    ] {
        let (kept, _) = reset(PROGRAM, "");
        assert!(kept.contains(&before) && !kept.contains(&after), "{bit}");
        let (cleared, _) = reset(PROGRAM, &format!("[parameters]\n\"{bit}\" = 1"));
        assert!(cleared.contains(&after) && !cleared.contains(&before), "{bit}");
    }
}

#[test]
fn variables_are_kept_or_cleared_by_their_bits() {
    let variables = |setup: &str| {
        let (_, interpreter) = reset(PROGRAM, setup);
        [1, 150, 500].map(|n| interpreter.memory().variables.get(n))
    };
    let cleared = "[parameters]\n\"NO52.7\" = 1\n\"NO52.6\" = 1";
    assert_eq!(variables("[parameters]\n\"NO52.7\" = 0\n\"NO52.6\" = 0"), [Some(5.0), Some(6.0), Some(8.0)]);
    assert_eq!(variables(cleared), [None, None, Some(8.0)]);
}

#[test]
fn the_program_starts_again_from_where_the_axes_stand() {
    let (_, mut interpreter) = reset("G91 G0 X1\nM30\n", "");
    let first = interpreter.next().unwrap().unwrap();
    assert_eq!(first.op.target().unwrap().0[0], 8.0);
}
