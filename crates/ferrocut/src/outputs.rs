//! Where results go: never over what the command reads.

use crate::job::Failure;
use std::fs;
use std::path::Path;

/// Refuses an output that is one of the files that are read, by whatever name.
pub fn check<'a>(output: &Path, inputs: impl IntoIterator<Item = &'a Path>) -> Result<(), Failure> {
    // Standard output, and what is not there yet, are none of them.
    let Ok(place) = fs::canonicalize(output) else { return Ok(()) };
    let is_read = |input: &Path| fs::canonicalize(input).is_ok_and(|input| input == place);
    match output != Path::new("-") && inputs.into_iter().any(is_read) {
        true => Err(Failure::output_is_input(&output.to_string_lossy())),
        false => Ok(()),
    }
}
