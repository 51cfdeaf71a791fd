//! Which requests are looked at at all.
//!
//! A page of somebody else, open in the operator's browser, can send requests here as if it were he. So a request must
//! name this computer as its host (a page whose name was made to lead here does not), must come from a page of this
//! server where a browser says which page it comes from, and must carry the cookie of a session where a log-in is
//! needed. What the browser may do with answers is said in their heads.

use super::Shared;
use super::problem::Problem;
use super::session::{Entry, token_of};
use axum::extract::{Request, State};
use axum::http::header::{
    ALLOW, CACHE_CONTROL, CONTENT_SECURITY_POLICY, HOST, ORIGIN, REFERRER_POLICY, X_CONTENT_TYPE_OPTIONS,
};
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use std::net::IpAddr;
use std::sync::Arc;

/// What answers may do in a browser that say nothing else: nothing.
const POLICY: &str = "default-src 'none'; frame-ancestors 'none'";

const FETCH_SITE: HeaderName = HeaderName::from_static("sec-fetch-site");
const OPENER: HeaderName = HeaderName::from_static("cross-origin-opener-policy");
const RESOURCE: HeaderName = HeaderName::from_static("cross-origin-resource-policy");

/// What this server is called and how it is reached.
#[derive(Clone, Debug)]
pub(super) struct Doors {
    /// Only this computer can connect.
    pub is_local: bool,
    /// Connections are encrypted.
    pub is_encrypted: bool,
    /// Names that it may be called by, in small letters, beside addresses.
    pub names: Vec<String>,
}

impl Doors {
    /// Whether a request may call this server so: `localhost:8080`, `192.168.1.7`, `[::1]:8080`.
    fn knows(&self, host: &str) -> bool {
        let host = host.to_ascii_lowercase();
        let is_port = |text: &str| text.len() <= 5 && text.bytes().all(|b| b.is_ascii_digit());
        let name = match host.rsplit_once(':') {
            Some((name, port)) if is_port(port) => name,
            _ => host.as_str(),
        };
        let bare = name.strip_prefix('[').and_then(|name| name.strip_suffix(']')).unwrap_or(name);
        match bare.parse::<IpAddr>() {
            // A name that leads here cannot look like an address.
            Ok(address) => !self.is_local || address.is_loopback(),
            Err(_) => name == "localhost" || self.names.iter().any(|own| own == name),
        }
    }

    fn scheme(&self) -> &'static str {
        if self.is_encrypted { "https" } else { "http" }
    }

    /// Why a request is not looked at.
    fn refuses(&self, headers: &HeaderMap, path: &str) -> Option<Problem> {
        let mut hosts = headers.get_all(HOST).iter();
        let host = hosts.next().and_then(|host| host.to_str().ok()).filter(|host| self.knows(host));
        let Some(host) = host.filter(|_| hosts.next().is_none()) else { return Some(Problem::Host) };
        let mut origins = headers.get_all(ORIGIN).iter();
        if let Some(origin) = origins.next() {
            let own = format!("{}://{}", self.scheme(), host);
            if origins.next().is_some() || !origin.as_bytes().eq_ignore_ascii_case(own.as_bytes()) {
                return Some(Problem::Origin);
            }
        }
        let site = headers.get(FETCH_SITE).map(HeaderValue::as_bytes);
        let is_foreign = matches!(site, Some(b"cross-site" | b"same-site"));
        (is_foreign && path.starts_with("/api/")).then_some(Problem::Origin)
    }
}

/// Lets a request through, or says why not.
pub(super) async fn watch(State(shared): State<Arc<Shared>>, mut request: Request, next: Next) -> Response {
    let path = request.uri().path();
    let is_api = path.starts_with("/api/");
    let response = match shared.doors.refuses(request.headers(), path) {
        Some(problem) => problem.into_response(),
        None => {
            let entry = token_of(request.headers()).and_then(|token| shared.sessions.find(&token));
            let is_open = !is_api || path == "/api/session";
            if !is_open
                && entry.as_deref().and_then(Entry::rights).is_none()
                && shared.sessions.needs_log_in()
            {
                Problem::LogIn.into_response()
            } else {
                let is_page = matches!(path, "/" | "/index.html") && *request.method() == Method::GET;
                // A page is given a session, so that its socket and its requests are known to be one's.
                let fresh = (entry.is_none() && is_page && !shared.sessions.needs_log_in())
                    .then(|| shared.sessions.begin());
                if let Some(entry) = entry {
                    request.extensions_mut().insert(entry);
                }
                let mut response = next.run(request).await;
                if let Some((_, cookie)) = fresh.flatten() {
                    response.headers_mut().append(axum::http::header::SET_COOKIE, cookie);
                }
                response
            }
        }
    };
    with_head(response, is_api)
}

/// The heads that every answer has.
fn with_head(mut response: Response, is_api: bool) -> Response {
    let head = response.headers_mut();
    let fixed = HeaderValue::from_static;
    head.insert(X_CONTENT_TYPE_OPTIONS, fixed("nosniff"));
    head.insert(REFERRER_POLICY, fixed("no-referrer"));
    head.insert(OPENER, fixed("same-origin"));
    head.insert(RESOURCE, fixed("same-origin"));
    head.entry(CONTENT_SECURITY_POLICY).or_insert(fixed(POLICY));
    if is_api {
        head.insert(CACHE_CONTROL, fixed("no-store"));
    }
    head.remove(ALLOW);
    response
}

#[cfg(test)]
mod tests {
    use super::*;

    fn doors(is_local: bool) -> Doors {
        Doors { is_local, is_encrypted: !is_local, names: vec!["mill".to_owned()] }
    }

    fn refused(doors: &Doors, heads: &[(HeaderName, &'static str)], path: &str) -> Option<Problem> {
        let heads = heads.iter().map(|(name, value)| (name.clone(), HeaderValue::from_static(value)));
        let mut map = HeaderMap::new();
        for (name, value) in heads {
            map.append(name, value);
        }
        doors.refuses(&map, path)
    }

    #[test]
    fn names_that_were_made_to_lead_here_are_not_known() {
        let local = doors(true);
        for host in ["localhost:8080", "LOCALHOST", "127.0.0.1:8080", "[::1]:8080", "127.0.0.1", "mill:80"] {
            assert!(local.knows(host), "{host}");
        }
        for host in [
            "evil.example",
            "evil.example:8080",
            "localhost.evil.example",
            "192.168.1.7",
            "",
            "127.0.0.1.evil",
        ] {
            assert!(!local.knows(host), "{host}");
        }
        assert!(doors(false).knows("192.168.1.7:8443") && !doors(false).knows("evil.example:8443"));
    }

    #[test]
    fn a_page_of_somebody_else_is_refused() {
        let local = doors(true);
        let host = (HOST, "localhost:8080");
        let check = |more: &[(HeaderName, &'static str)]| {
            refused(&local, &[std::slice::from_ref(&host), more].concat(), "/api/socket")
        };
        assert_eq!(check(&[]), None);
        assert_eq!(check(&[(ORIGIN, "http://localhost:8080")]), None);
        for origin in [
            "http://evil.example",
            "null",
            "https://localhost:8080",
            "http://localhost:8081",
            "http://127.0.0.1:8080",
        ] {
            assert_eq!(check(&[(ORIGIN, origin)]), Some(Problem::Origin), "{origin}");
        }
        assert_eq!(check(&[(FETCH_SITE, "cross-site")]), Some(Problem::Origin));
        assert_eq!(check(&[(FETCH_SITE, "same-origin")]), None);
        assert_eq!(check(&[(HOST, "evil.example")]), Some(Problem::Host));
        assert_eq!(refused(&local, &[], "/"), Some(Problem::Host));
    }
}
