//! A quantity over time in columns of lowest and highest value, whatever the length of the run.
//!
//! How long a run takes is not known before. A column begins as one period; when all columns are full, two
//! become one and every further one takes twice the periods. So nothing between two points is lost, and the
//! memory stays the same.

/// Columns at most; after two became one, half of them.
pub const COLUMNS: usize = 1200;

/// The quantity. Periods in which it has no value leave gaps.
pub struct Series {
    columns: Vec<[f64; 2]>,
    /// Periods of a column.
    per: u64,
    /// Periods in the last column.
    filled: u64,
}

/// A column without a value.
const GAP: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

fn joined(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

impl Series {
    /// A series without values.
    pub fn new() -> Series {
        Series { columns: Vec::with_capacity(COLUMNS), per: 1, filled: 0 }
    }

    /// Takes the value of the next period; one that is not finite is none.
    pub fn push(&mut self, value: f64) {
        let value = if value.is_finite() { [value; 2] } else { GAP };
        if self.filled > 0 && self.filled < self.per {
            if let Some(last) = self.columns.last_mut() {
                *last = joined(*last, value);
            }
            self.filled += 1;
            return;
        }
        if self.columns.len() >= COLUMNS {
            self.halve();
        }
        self.columns.push(value);
        self.filled = 1;
    }

    /// Makes one column of two.
    fn halve(&mut self) {
        let mut kept = 0;
        for from in (0..self.columns.len()).step_by(2) {
            let pair = self.columns.get(from..).unwrap_or_default().iter().take(2);
            let pair = pair.fold(GAP, |a, b| joined(a, *b));
            if let Some(column) = self.columns.get_mut(kept) {
                *column = pair;
            }
            kept += 1;
        }
        self.columns.truncate(kept);
        self.per *= 2;
    }

    /// Lowest and highest value of each column, and the period that it begins with; `None` for a gap.
    pub fn columns(&self) -> impl Iterator<Item = (u64, Option<[f64; 2]>)> + '_ {
        let has_value = |c: &[f64; 2]| c[0] <= c[1];
        let per = self.per;
        self.columns.iter().zip(0..).map(move |(c, at)| (at * per, Some(*c).filter(has_value)))
    }

    /// Lowest and highest value of all.
    pub fn extent(&self) -> Option<[f64; 2]> {
        let all = self.columns.iter().fold(GAP, |a, b| joined(a, *b));
        (all[0] <= all[1]).then_some(all)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(values: impl Iterator<Item = f64>) -> Series {
        let mut series = Series::new();
        values.for_each(|v| series.push(v));
        series
    }

    #[test]
    fn a_short_run_keeps_every_value() {
        let series = of([3.0, f64::NAN, -1.0].into_iter());
        let columns: Vec<_> = series.columns().collect();
        assert_eq!(columns, [(0, Some([3.0, 3.0])), (1, None), (2, Some([-1.0, -1.0]))]);
        assert_eq!(series.extent(), Some([-1.0, 3.0]));
        assert_eq!(of([f64::NAN].into_iter()).extent(), None);
    }

    #[test]
    fn a_column_has_the_lowest_and_the_highest_of_its_periods() {
        // 2401 values fill 1200 columns twice over and begin a column of four: 0…3, 4…7, …, 2400.
        let series = of((0..2401).map(f64::from));
        let columns: Vec<_> = series.columns().collect();
        assert_eq!(columns.len(), 601);
        assert_eq!(columns[0], (0, Some([0.0, 3.0])));
        assert_eq!(columns[599], (2396, Some([2396.0, 2399.0])));
        assert_eq!(columns[600], (2400, Some([2400.0, 2400.0])));
    }

    #[test]
    fn a_peak_of_one_period_stays_in_a_long_run_and_the_memory_as_it_is() {
        let series = of((0..1_000_000).map(|i| if i == 654_321 { 7.0 } else { 0.0 }));
        let (capacity, columns): (_, Vec<_>) = (series.columns.capacity(), series.columns().collect());
        assert_eq!((capacity, series.per), (COLUMNS, 1024));
        let peaks: Vec<_> = columns.iter().filter(|(_, c)| *c == Some([0.0, 7.0])).collect();
        assert_eq!(peaks.len(), 1);
        assert!((peaks[0].0..peaks[0].0 + 1024).contains(&654_321));
    }
}
