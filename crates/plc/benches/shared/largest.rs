//! The largest ladder of the GSK990MC, to measure scans with.

use ferrocut_plc::{Address, Limits, Pace, Plc, Program};
use std::fmt::Write;

/// Steps of it.
pub const STEPS: u32 = 4_700;

/// Networks of one to eight contacts in series and parallel, over a spread of signals; each eighth network has
/// a function where `functions` says so.
fn ladder(functions: bool) -> String {
    let mut text = String::from("RD X8.4\nAND.NOT G8.4\nWRT R0.0\nEND1\n");
    let mut n: u32 = 0;
    let mut left = STEPS - 5;
    // A sequence without a pattern that a processor could learn.
    let mut seed: u32 = 1;
    let mut random = |most: u32| {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 16) % most
    };
    while left > 12 {
        n += 1;
        let contacts = 1 + random(7);
        let not = |is: u32| if is == 0 { ".NOT" } else { "" };
        let signal = |r: u32| match r % 4 {
            0 => format!("X{}.{}", r / 32 % 64, r / 4 % 8),
            1 => format!("F{}.{}", r / 32 % 64, r / 4 % 8),
            2 => format!("K{}.{}", r / 32 % 20, r / 4 % 8),
            _ => format!("R{}.{}", r / 32 % 100, r / 4 % 8),
        };
        writeln!(text, "RD{} {}", not(random(3)), signal(random(4096))).unwrap();
        for _ in 1..contacts {
            let (what, not, signal) = (random(3), not(random(3)), signal(random(4096)));
            writeln!(text, "{}{not} {signal}", ["AND", "OR", "AND"][what as usize]).unwrap();
        }
        left -= contacts + 1;
        if functions && n.is_multiple_of(8) {
            let d = n % 500;
            let (line, steps) = match n / 8 % 6 {
                0 if n / 8 / 6 < 200 => (format!("TMRB {} 500", n / 48 + 1), 3),
                1 => (format!("COMPB 1002 D{d} D1000"), 4),
                2 => (format!("DIFU {}", n / 8), 2),
                3 => (format!("MOVE 1111 0000 R{} R{}", d % 100, 2000 + d), 5),
                4 => (format!("ADDB 2 D{d} 1 D{}", 2000 + d), 5),
                _ => (format!("DECB 1 R{} 1 R{}", d % 100, 3000 + d), 5),
            };
            left -= steps;
            let has_w1 = line.starts_with("TMRB") || line.starts_with("DIFU");
            // What takes RST and ACT gets both.
            if line.starts_with("ADDB") {
                text.push_str("RD.STK R9091.1\n");
                left -= 1;
            }
            writeln!(text, "{line}").unwrap();
            if !has_w1 {
                left += 1;
                continue;
            }
        }
        writeln!(text, "WRT R{}.{}", 1000 + n / 8, n % 8).unwrap();
    }
    for k in 0..left / 2 {
        write!(text, "RD X0.0\nWRT R{}.0\n", 3900 + k).unwrap();
    }
    text + "END2\n"
}

/// A control with it that has scanned once.
pub fn plc(functions: bool) -> Plc {
    let program = Program::from_text(ladder(functions).as_bytes(), &Limits::default()).unwrap();
    assert!((STEPS - 2..=STEPS).contains(&program.steps()), "{}", program.steps());
    let mut plc = Plc::new(program, Pace::default());
    for byte in 0..64 {
        let x = Address::parse(&format!("X{byte}")).unwrap();
        plc.memory_mut().set_byte(x, (byte as u8).wrapping_mul(37));
    }
    assert!(plc.scan().is_round);
    plc
}
