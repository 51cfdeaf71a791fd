//! A program that asks much of a control in each period.

use std::fmt::Write;

/// Blocks of 0.3 mm and less on a curve, helices, corners, exact stops and positioning, so many times over.
pub fn demanding(rounds: u32) -> String {
    let mut text = "G17 G21 G90 G54\nG64\nS3000 M3\n".to_owned();
    for round in 0..rounds {
        let shift = f64::from(round % 12) * 2.0 - 12.0;
        let _ = writeln!(text, "G0 X{:.3} Y0 Z5\nG1 Z-1 F2000\nF6000", 40.0 + shift);
        for k in 0..4000 {
            let t = f64::from(k) * 0.0016;
            let (x, y) = ((40.0 + shift) * t.cos() + 4.0 * (9.0 * t).sin(), 40.0 * t.sin());
            let _ = writeln!(text, "X{x:.3} Y{y:.3} Z{:.3}", -1.0 - 0.3 * (5.0 * t).sin());
        }
        for k in 0..40 {
            let (x, y) = ((k * 37 % 61) - 30, (k * 53 % 47) - 23);
            let exact = if k % 5 == 0 { "G61" } else { "G64" };
            let _ = writeln!(text, "{exact} G1 X{x} Y{y}");
        }
        let _ = writeln!(
            text,
            "G64 G0 X30 Y0\nG2 X30 Y0 Z-3 I-15 J0 F3000\nG0 Z20 \nA{}\nM8\nG4 X0.05\nM9",
            round % 12 * 30
        );
    }
    text + "M30\n"
}
