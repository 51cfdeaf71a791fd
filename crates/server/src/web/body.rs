//! What a request brings: no more than is taken, in no more time than it needs.

use super::problem::Problem;
use axum::body::{Bytes, to_bytes};
use axum::extract::Request;
use axum::http::header::CONTENT_LENGTH;
use futures_util::StreamExt;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;
use std::time::Duration;
use tokio::sync::{Semaphore, SemaphorePermit};
use tokio::time::timeout;

/// Time that any body has to come.
const PATIENCE: Duration = Duration::from_secs(10);

/// Bytes a second that a long one comes with at least.
const SLOWEST: u64 = 1 << 20;

/// Above this a body is long, bytes.
const LONG: usize = 64 << 10;

/// Bytes of a disk that files leave to the memory of the control.
const KEPT_FREE: u64 = 64 << 20;

/// Long bodies that are held at once.
static ROOM: Semaphore = Semaphore::const_new(8);

/// A body that comes: how many bytes were told, how long it may take, and its place among the long ones.
fn expected(request: &Request, most: usize) -> Result<(Duration, Option<SemaphorePermit<'static>>), Problem> {
    let told = request.headers().get(CONTENT_LENGTH);
    let told: Option<u64> = told.and_then(|value| value.to_str().ok()?.parse().ok());
    if told.is_some_and(|told| told > most as u64) {
        return Err(Problem::TooLarge);
    }
    let length = told.unwrap_or(most as u64);
    let place = match length > LONG as u64 {
        true => Some(ROOM.try_acquire().map_err(|_| Problem::Busy)?),
        false => None,
    };
    Ok((PATIENCE + Duration::from_secs(length / SLOWEST), place))
}

/// The body of a request, of at most so many bytes.
pub(super) async fn read(request: Request, most: usize) -> Result<Bytes, Problem> {
    let (patience, _place) = expected(&request, most)?;
    match timeout(patience, to_bytes(request.into_body(), most)).await {
        Ok(Ok(bytes)) => Ok(bytes),
        // More than was told, or a connection that ended: the one is answered, the other hears nothing.
        Ok(Err(_)) => Err(Problem::TooLarge),
        Err(_) => Err(Problem::TooSlow),
    }
}

/// The same of one that is too long to be held: it is laid into a file that is made anew.
pub(super) async fn read_into_file(request: Request, most: usize, path: &Path) -> Result<(), Problem> {
    let (patience, _place) = expected(&request, most)?;
    let mut file = begun(path).map_err(|error| Problem::of_file(&error))?;
    let mut left = most;
    let mut pieces = request.into_body().into_data_stream();
    let all = async {
        while let Some(piece) = pieces.next().await {
            let piece = piece.map_err(|_| Problem::TooLarge)?;
            left = left.checked_sub(piece.len()).ok_or(Problem::TooLarge)?;
            // A disk may let wait.
            let written = tokio::task::block_in_place(|| lay_down(&mut file, &piece));
            written.map_err(|error| Problem::of_file(&error))?;
        }
        Ok(())
    };
    timeout(patience, all).await.map_err(|_| Problem::TooSlow)?
}

/// A new file in the place of what lies there: no link that somebody has put there leads out of the folder.
fn begun(path: &Path) -> io::Result<File> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => File::create_new(path),
    }
}

fn lay_down(file: &mut File, piece: &[u8]) -> io::Result<()> {
    let disk = rustix::fs::fstatvfs(&*file)?;
    let free = disk.f_bavail.saturating_mul(disk.f_frsize);
    if free < KEPT_FREE.saturating_add(piece.len() as u64) {
        return Err(io::ErrorKind::StorageFull.into());
    }
    file.write_all(piece)
}
