//! Setpoints as CSV: `t,x,y,…`, a row each servo period.
//!
//! Times in s, machine coordinates in mm and degrees, written with as many digits as bring the value
//! back exactly. The first row is the position at rest when motion first begins.

use crate::job::Failure;
use crate::stdout;
use ferrocut_controller::Tick;
use ferrocut_geometry::{Axis, Position};
use ferrocut_machine::Machine;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Writes setpoints.
pub struct Samples {
    out: BufWriter<Box<dyn Write>>,
    axes: Vec<Axis>,
    period_ms: f64,
    rows: u64,
    /// Where the axes stand before motion begins.
    before: Position,
}

impl Samples {
    /// Creates the file and writes its header; the axes stand at `start`.
    pub fn create(path: &Path, machine: &Machine, start: Position) -> Result<Samples, Failure> {
        let out: Box<dyn Write> = match path == Path::new("-") {
            true => Box::new(stdout::lock()),
            false => match File::create(path) {
                Ok(file) => Box::new(file),
                Err(error) => return Err(Failure::cannot_write(&path.to_string_lossy(), &error)),
            },
        };
        let axes: Vec<Axis> = machine.axis_set().iter().collect();
        let mut samples = Samples {
            out: BufWriter::with_capacity(1 << 16, out),
            axes,
            period_ms: machine.servo_period_ms,
            rows: 0,
            before: start,
        };
        let header: Vec<&str> = samples.axes.iter().map(|a| a.name()).collect();
        match writeln!(samples.out, "t,{}", header.join(",")) {
            Ok(()) => Ok(samples),
            Err(error) => Err(Failure::cannot_write(&path.to_string_lossy(), &error)),
        }
    }

    /// Takes the setpoint of a period.
    pub fn take(&mut self, tick: &Tick) -> io::Result<()> {
        if self.rows == 0 {
            if !tick.moving {
                return Ok(());
            }
            self.row(self.before)?;
        }
        self.row(tick.position)
    }

    fn row(&mut self, position: Position) -> io::Result<()> {
        let ms = self.rows as f64 * self.period_ms;
        write!(self.out, "{}", ms / 1000.0)?;
        for axis in &self.axes {
            write!(self.out, ",{}", position[*axis])?;
        }
        self.rows += 1;
        self.out.write_all(b"\n")
    }

    /// Writes what is left.
    pub fn finish(mut self) -> io::Result<()> {
        self.out.flush()
    }
}
