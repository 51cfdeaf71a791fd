//! The files of the panel: built into the program, or read from `hmi/dist` in a debug build.

use axum::body::{Body, Bytes};
use axum::http::header::{
    ACCEPT_ENCODING, CACHE_CONTROL, CONTENT_ENCODING, CONTENT_SECURITY_POLICY, CONTENT_TYPE, ETAG,
    IF_NONE_MATCH, VARY,
};
use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, Uri};
use axum::response::{IntoResponse, Response};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use rust_embed::RustEmbed;
use sha2::{Digest, Sha256};
use std::collections::HashMap;
use std::io::Write;
use std::sync::{LazyLock, Mutex, PoisonError};

/// What `npm run build` in `hmi` writes.
#[derive(RustEmbed)]
#[folder = "../../hmi/dist"]
struct Dist;

/// The page that a browser is given first.
const INDEX: &str = "index.html";

/// Files below this length gain nothing by compression, bytes.
const SHORT: usize = 512;

/// What the panel may do where no page says otherwise. Styles may stand in the page: the editor writes its own.
const POLICY: &str = "default-src 'none'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; \
    font-src 'self'; connect-src 'self'; worker-src 'self' blob:; manifest-src 'self'; base-uri 'none'; \
    form-action 'none'; frame-ancestors 'none'";

/// A file that is ready to be sent.
#[derive(Clone)]
struct Ready {
    hash: [u8; 32],
    etag: HeaderValue,
    plain: Bytes,
    /// The same compressed, where that is shorter.
    packed: Option<Bytes>,
    kind: HeaderValue,
    policy: HeaderValue,
}

/// Files that were asked for. There are as many as the panel has.
static READY: LazyLock<Mutex<HashMap<String, Ready>>> = LazyLock::new(Mutex::default);

/// Whether there is a panel.
pub(super) fn is_built() -> bool {
    Dist::get(INDEX).is_some()
}

/// Answers a request for a file.
pub(super) async fn serve(method: Method, uri: Uri, headers: HeaderMap) -> Response {
    if method != Method::GET && method != Method::HEAD {
        return StatusCode::METHOD_NOT_ALLOWED.into_response();
    }
    let path = match uri.path().trim_start_matches('/') {
        "" => INDEX,
        path => path,
    };
    let ready = if is_plain(path) { ready(path) } else { None };
    match ready {
        Some(ready) => answer(&ready, &headers),
        None => StatusCode::NOT_FOUND.into_response(),
    }
}

/// Whether a path can be one of the panel's files: names with letters, digits and `-_.@+`, none hidden.
fn is_plain(path: &str) -> bool {
    let is_name = |name: &str| {
        !name.is_empty()
            && !name.starts_with('.')
            && name.bytes().all(|b| b.is_ascii_alphanumeric() || b"-_.@+".contains(&b))
    };
    path.len() <= 256 && path.split('/').all(is_name)
}

fn ready(path: &str) -> Option<Ready> {
    let file = Dist::get(path)?;
    let hash = file.metadata.sha256_hash();
    let mut all = READY.lock().unwrap_or_else(PoisonError::into_inner);
    // In a debug build files may change under it.
    if let Some(ready) = all.get(path).filter(|ready| ready.hash == hash) {
        return Some(ready.clone());
    }
    let plain = Bytes::from(file.data.into_owned());
    let etag = format!("\"{}\"", BASE64_STANDARD.encode(hash.get(..18).unwrap_or(&[])));
    let policy = match path.ends_with(".html") {
        true => format!("{POLICY}; script-src 'self'{}", import_maps(&plain)),
        false => format!("{POLICY}; script-src 'self'"),
    };
    let ready = Ready {
        hash,
        etag: HeaderValue::from_str(&etag).ok()?,
        packed: packed(path, &plain),
        plain,
        kind: HeaderValue::from_static(kind(path)),
        policy: HeaderValue::from_str(&policy).ok()?,
    };
    all.insert(path.to_owned(), ready.clone());
    Some(ready)
}

/// Its kind for the browser. A script of the wrong kind is not run.
fn kind(path: &str) -> &'static str {
    match path.rsplit_once('.').map_or("", |(_, extension)| extension) {
        "html" => "text/html; charset=utf-8",
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "json" | "map" => "application/json",
        "webmanifest" => "application/manifest+json",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "ico" => "image/x-icon",
        "woff2" => "font/woff2",
        "wasm" => "application/wasm",
        "txt" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

fn packed(path: &str, plain: &Bytes) -> Option<Bytes> {
    let is_packed_already = [".png", ".woff2", ".ico"].iter().any(|end| path.ends_with(end));
    if is_packed_already || plain.len() < SHORT {
        return None;
    }
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(plain).ok()?;
    encoder.finish().ok().filter(|packed| packed.len() < plain.len()).map(Bytes::from)
}

/// The import map of a page as a source that its policy allows: no other script may stand in a page.
fn import_maps(page: &[u8]) -> String {
    let page = String::from_utf8_lossy(page);
    let mut sources = String::new();
    let mut rest = &*page;
    while let Some((_, from)) = rest.split_once("<script") {
        let Some((attributes, from)) = from.split_once('>') else { break };
        let Some((text, from)) = from.split_once("</script>") else { break };
        if attributes.contains("importmap") && !attributes.contains("src=") {
            sources += &format!(" 'sha256-{}'", BASE64_STANDARD.encode(Sha256::digest(text.as_bytes())));
        }
        rest = from;
    }
    sources
}

/// Whether a client takes gzip.
fn takes_gzip(headers: &HeaderMap) -> bool {
    let accepted = headers.get(ACCEPT_ENCODING).and_then(|value| value.to_str().ok()).unwrap_or("");
    accepted.split(',').any(|part| {
        let (name, quality) = part.split_once(';').unwrap_or((part, ""));
        matches!(name.trim(), "gzip" | "*")
            && !matches!(quality.trim(), "q=0" | "q=0.0" | "q=0.00" | "q=0.000")
    })
}

fn answer(ready: &Ready, headers: &HeaderMap) -> Response {
    let knows = |value: &HeaderValue| {
        value.to_str().is_ok_and(|tags| {
            tags.split(',').any(|tag| tag.trim().trim_start_matches("W/").as_bytes() == ready.etag.as_bytes())
        })
    };
    let mut response = if headers.get_all(IF_NONE_MATCH).iter().any(knows) {
        StatusCode::NOT_MODIFIED.into_response()
    } else {
        match ready.packed.as_ref().filter(|_| takes_gzip(headers)) {
            Some(packed) => {
                let mut response = Response::new(Body::from(packed.clone()));
                response.headers_mut().insert(CONTENT_ENCODING, HeaderValue::from_static("gzip"));
                response
            }
            None => Response::new(Body::from(ready.plain.clone())),
        }
    };
    let head = response.headers_mut();
    head.insert(CONTENT_TYPE, ready.kind.clone());
    head.insert(ETAG, ready.etag.clone());
    // Names have no hashes: a browser asks each time whether it has the newest.
    head.insert(CACHE_CONTROL, HeaderValue::from_static("no-cache"));
    head.insert(VARY, HeaderValue::from_static("accept-encoding"));
    head.insert(CONTENT_SECURITY_POLICY, ready.policy.clone());
    response
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_path_leads_out_of_the_panel() {
        for path in
            ["../Cargo.toml", "a/../b", "/etc/passwd", "a//b", ".git", "a/.b", "a\\b", "%2e%2e/x", "a\0", ""]
        {
            assert!(!is_plain(path), "{path}");
        }
        for path in ["index.html", "vendor/three.module.js", "lib/api-1/@x+y_z.js"] {
            assert!(is_plain(path), "{path}");
        }
    }

    #[test]
    fn an_import_map_is_allowed_by_its_hash_and_no_other_script() {
        let map = r#"{"imports":{"a":"/a.js"}}"#;
        let page = format!(
            "<script type=\"importmap\">{map}</script><script>alert(1)</script><script src=\"a.js\"></script>"
        );
        let hash = BASE64_STANDARD.encode(Sha256::digest(map.as_bytes()));
        assert_eq!(import_maps(page.as_bytes()), format!(" 'sha256-{hash}'"));
    }

    #[test]
    fn gzip_goes_to_those_who_take_it() {
        let takes = |value: &'static str| {
            takes_gzip(&HeaderMap::from_iter([(ACCEPT_ENCODING, HeaderValue::from_static(value))]))
        };
        assert!(takes("gzip, br") && takes("br;q=1.0, *;q=0.5"));
        assert!(!takes("br") && !takes("gzip;q=0") && !takes(""));
    }
}
