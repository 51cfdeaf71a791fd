//! Where results go: never over what the command reads.

use crate::cli::Common;
use crate::job::Failure;
use std::fs;
use std::path::Path;

/// Refuses an output that is one of the files that are read, by whatever name.
pub fn check(output: &Path, inputs: impl IntoIterator<Item = impl AsRef<Path>>) -> Result<(), Failure> {
    if output == Path::new("-") {
        return Ok(());
    }
    // What is not there yet is none of them.
    let Ok(place) = fs::canonicalize(output) else { return Ok(()) };
    let is_read = |input: &Path| fs::canonicalize(input).is_ok_and(|input| input == place);
    match inputs.into_iter().any(|input| is_read(input.as_ref())) {
        true => Err(Failure::output_is_input(&output.to_string_lossy())),
        false => Ok(()),
    }
}

/// The same where the files are a program, or a drawing, and those that the command names beside it.
pub fn check_beside(output: &Path, program: &Path, common: &Common) -> Result<(), Failure> {
    check(output, common.files().chain([program]))
}
