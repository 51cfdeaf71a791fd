//! What a request brings: no more than is taken, in no more time than it needs.

use super::problem::Problem;
use axum::body::{Bytes, to_bytes};
use axum::extract::Request;
use axum::http::header::CONTENT_LENGTH;
use futures_util::StreamExt;
use std::time::Duration;
use tokio::sync::{Semaphore, SemaphorePermit};
use tokio::time::timeout;

/// Time that any body has to come.
const PATIENCE: Duration = Duration::from_secs(10);

/// Bytes a second that a long one comes with at least.
const SLOWEST: u64 = 1 << 20;

/// Above this a body is long, bytes.
const LONG: usize = 64 << 10;

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

/// The same of one that is too long to be held: each piece is given away as it comes.
pub(super) async fn read_in_pieces(
    request: Request,
    most: usize,
    mut each: impl FnMut(&[u8]) -> Result<(), Problem>,
) -> Result<(), Problem> {
    let (patience, _place) = expected(&request, most)?;
    let mut left = most;
    let mut pieces = request.into_body().into_data_stream();
    let all = async {
        while let Some(piece) = pieces.next().await {
            let piece = piece.map_err(|_| Problem::TooLarge)?;
            left = left.checked_sub(piece.len()).ok_or(Problem::TooLarge)?;
            each(&piece)?;
        }
        Ok(())
    };
    timeout(patience, all).await.map_err(|_| Problem::TooSlow)?
}
