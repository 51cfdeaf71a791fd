//! Connections: how many at once, and how long each may take.

use super::patient::Patient;
use axum::Router;
use axum::body::Body;
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use std::convert::Infallible;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;
use tokio::io::{AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{Semaphore, watch};
use tokio::time::timeout;
use tokio_rustls::TlsAcceptor;
use tower::ServiceExt;

/// Connections at once.
pub(super) const MOST_CONNECTIONS: usize = 256;

/// Connections that are told at once that there is no room; others are closed without a word.
const MOST_TOLD: usize = 32;

/// How long the head of a request may take, and an idle connection may stay.
const HEAD: Duration = Duration::from_secs(10);

/// How long who finds no room may take to hear so.
const TOLD: Duration = Duration::from_secs(1);

/// Bytes of a request that are held before it is understood: bounds its head.
const HEAD_BYTES: usize = 64 << 10;

/// What who finds no room is told.
const NO_ROOM: &[u8] = b"HTTP/1.1 503 Service Unavailable\r\nretry-after: 10\r\nconnection: close\r\n\
    content-type: application/json\r\ncontent-length: 32\r\n\r\n{\"error\":\"too_many_connections\"}";

/// Who sent a request.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Peer(pub SocketAddr);

/// Takes connections until it is told to stop, then lets those end that are under way.
pub(super) async fn serve(
    listener: TcpListener,
    acceptor: Option<TlsAcceptor>,
    router: Router,
    mut stops: watch::Receiver<bool>,
) {
    let room = Arc::new(Semaphore::new(MOST_CONNECTIONS));
    let told = Arc::new(Semaphore::new(MOST_TOLD));
    loop {
        let accepted = tokio::select! {
            accepted = listener.accept() => accepted,
            _ = stops.changed() => break,
        };
        let Ok((stream, peer)) = accepted else {
            // Out of descriptors: others will be given back.
            tokio::time::sleep(Duration::from_millis(50)).await;
            continue;
        };
        match room.clone().try_acquire_owned() {
            Ok(place) => {
                let (acceptor, router, stops) = (acceptor.clone(), router.clone(), stops.clone());
                tokio::spawn(async move {
                    let _ = stream.set_nodelay(true);
                    let stream = Patient::new(stream);
                    match acceptor {
                        None => connection(stream, peer, router, stops).await,
                        Some(acceptor) => {
                            if let Ok(Ok(stream)) = timeout(HEAD, acceptor.accept(stream)).await {
                                connection(stream, peer, router, stops).await;
                            }
                        }
                    }
                    drop(place);
                });
            }
            // Over an encrypted connection nobody could be told in time.
            Err(_) if acceptor.is_some() => drop(stream),
            Err(_) => {
                if let Ok(place) = told.clone().try_acquire_owned() {
                    tokio::spawn(async move {
                        let _ = timeout(TOLD, send_away(stream)).await;
                        drop(place);
                    });
                }
            }
        }
    }
    drop(listener);
    // Each gives its place back as it ends.
    let all = room.acquire_many(u32::try_from(MOST_CONNECTIONS).unwrap_or(u32::MAX));
    let _ = timeout(super::FAREWELL, all).await;
}

/// Says that there is no room, and reads what was asked, so that the answer is not lost with the connection.
async fn send_away(mut stream: TcpStream) {
    if stream.write_all(NO_ROOM).await.is_ok() && stream.shutdown().await.is_ok() {
        let mut rest = [0; 1024];
        while stream.read(&mut rest).await.is_ok_and(|count| count > 0) {}
    }
}

async fn connection(
    stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static,
    peer: SocketAddr,
    router: Router,
    mut stops: watch::Receiver<bool>,
) {
    let service = service_fn(move |request: hyper::Request<Incoming>| {
        let mut request = request.map(Body::new);
        request.extensions_mut().insert(Peer(peer));
        let router = router.clone();
        async move {
            let Ok(response) = router.oneshot(request).await;
            Ok::<_, Infallible>(response)
        }
    });
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(HEAD)
        .max_buf_size(HEAD_BYTES)
        .serve_connection(TokioIo::new(stream), service)
        .with_upgrades();
    tokio::pin!(connection);
    tokio::select! {
        // What a client did wrong is its own affair.
        _ = connection.as_mut() => {}
        _ = stops.changed() => {
            connection.as_mut().graceful_shutdown();
            let _ = connection.await;
        }
    }
}
