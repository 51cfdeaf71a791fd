//! What the panel's server refuses, and that it and the machine go on meanwhile.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

mod common;

use common::{Answer, Place, Socket, answer, ask, control};
use ferrocut_memory::{Author, Level, LogEntry, Seat, Store};
use ferrocut_server::hub::MOST_CONNECTIONS;
use ferrocut_server::panel::Panel;
use ferrocut_server::web::{Certificate, Settings, StartError, Web};
use serde_json::json;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use tempfile::TempDir;
use tokio_rustls::rustls::crypto::ring::default_provider;
use tokio_rustls::rustls::pki_types::pem::PemObject;
use tokio_rustls::rustls::pki_types::{CertificateDer, ServerName};
use tokio_rustls::rustls::{ClientConfig, ClientConnection, RootCertStore, StreamOwned};

/// Tests that open many connections come one after the other: a process may have 1,024 files open.
static MANY: Mutex<()> = Mutex::new(());

const PASSWORD: &str = "open sesame 4";

#[test]
fn no_path_leads_out_of_the_panel_or_the_memory() {
    let place = Place::local();
    let own = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml")).unwrap();
    let first = own.lines().find(|line| line.starts_with("name")).unwrap();
    for path in [
        "/../../crates/server/Cargo.toml",
        "/../Cargo.toml",
        "/..%2f..%2fcrates/server/Cargo.toml",
        "/%2e%2e/%2e%2e/crates/server/Cargo.toml",
        "/..\\..\\crates\\server\\Cargo.toml",
        "//etc/passwd",
        "/etc/passwd",
        "/.git/config",
        "/api/programs/..%2f..%2fetc%2fpasswd",
        "/api/programs/%2fetc%2fpasswd",
        "/api/programs/..",
        "/api/programs/O1%00.nc",
        "/api/path?program=..%2f..%2fetc%2fpasswd",
        "/api/path?program=%2fetc%2fpasswd",
        "/api/explain?word=%2fetc%2fpasswd%3a1",
    ] {
        let answer = place.get(path);
        let text = answer.text();
        assert!(!text.contains("root:") && !text.contains(first), "{path}: {text}");
        assert!(answer.status != 200 || text.contains("\"found\":false"), "{path}: {} {text}", answer.status);
    }
    let cookie = place.get("/").cookie();
    let mut socket = Socket::new(place.address(), &[("cookie", &cookie)]).unwrap();
    socket.take_command();
    for name in ["..%2fO1", "%2ftmp%2fO1", "O1%0d%0ax", ".."] {
        let answer = place.http("PUT", &format!("/api/programs/{name}"), &[("cookie", &cookie)], b"M30\n");
        assert!(matches!(answer.status, 400 | 404), "{name}: {}", answer.status);
    }
    // Programs that are checked call those of the control alone.
    let text = b"M98 P1\nM30\n";
    assert!(place.http("POST", "/api/check", &[], text).text().contains("findings"));
}

#[test]
fn pages_of_others_are_refused() {
    let place = Place::local();
    let evil = ("origin", "http://evil.example");
    for (method, path, body) in [
        ("POST", "/api/session", &br#"{"level":1,"password":"12345678"}"#[..]),
        ("POST", "/api/check", b"G0"),
        ("PUT", "/api/programs/O1", b"M30"),
        ("DELETE", "/api/session", b""),
        ("GET", "/api/parameters", b""),
    ] {
        let refused = place.http(method, path, &[evil], body);
        assert_eq!((refused.status, &refused.json()["error"]), (403, &json!("other_origin")), "{path}");
        let site = place.http(method, path, &[("sec-fetch-site", "cross-site")], body);
        assert_eq!(site.status, 403, "{path}");
        let rebound = place.http(method, path, &[("host", "evil.example")], body);
        assert_eq!((rebound.status, &rebound.json()["error"]), (421, &json!("unknown_host")), "{path}");
    }
    assert_eq!(place.http("GET", "/", &[("host", "evil.example")], b"").status, 421);
    for heads in [[("origin", "http://evil.example")], [("origin", "null")], [("host", "evil.example")]] {
        assert!(Socket::new(place.address(), &heads).is_err(), "{heads:?}");
    }
    let own = format!("http://127.0.0.1:{}", place.address().port());
    let host = place.address().to_string();
    assert!(Socket::new(place.address(), &[("origin", &own), ("host", &host)]).is_ok());
    // No other page may be told what an answer holds, nor show it in a frame.
    let answer = place.http("GET", "/api/session", &[], b"");
    assert!(answer.head("access-control-allow-origin").is_none());
    assert_eq!(answer.head("cross-origin-resource-policy"), Some("same-origin"));
}

/// A control that other computers reach.
struct Remote {
    place: Place,
    folder: TempDir,
    store: Arc<Store>,
    tls: Arc<ClientConfig>,
}

fn store(folder: &TempDir) -> Arc<Store> {
    let store = Store::open(folder.path(), ferrocut_memory::Settings::new("gsk990mc")).unwrap();
    let author = Author::Maintenance { name: "test".into() };
    store.set_password(&author, Level::Shop, PASSWORD, Seat::Machine).unwrap();
    Arc::new(store)
}

impl Remote {
    fn new() -> Remote {
        let folder = tempfile::tempdir().unwrap();
        let store = store(&folder);
        let panel = Panel::new(control(Some(store.clone())));
        let own = Certificate::Own(Some(folder.path().to_owned()));
        let place = Place::new(panel, Some(store.clone()), "0.0.0.0:0", Some(own));
        let chain = std::fs::read(folder.path().join("panel-certificate.pem")).unwrap();
        let mut roots = RootCertStore::empty();
        roots.add(CertificateDer::from_pem_slice(&chain).unwrap()).unwrap();
        let tls = ClientConfig::builder_with_provider(Arc::new(default_provider()))
            .with_safe_default_protocol_versions()
            .unwrap()
            .with_root_certificates(roots)
            .with_no_client_auth();
        Remote { place, folder, store, tls: Arc::new(tls) }
    }

    fn stream(&self) -> StreamOwned<ClientConnection, TcpStream> {
        let stream = TcpStream::connect(("127.0.0.1", self.place.address().port())).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        let name = ServerName::try_from("localhost").unwrap();
        StreamOwned::new(ClientConnection::new(self.tls.clone(), name).unwrap(), stream)
    }

    fn http(&self, method: &str, path: &str, cookie: &str, body: &[u8]) -> Answer {
        ask(self.stream(), method, path, &[("cookie", cookie)], body)
    }

    fn log_in(&self, password: &str) -> Answer {
        let body = json!({ "level": Level::Shop.number(), "password": password }).to_string();
        self.http("POST", "/api/session", "", body.as_bytes())
    }
}

#[test]
fn other_computers_must_log_in() {
    let remote = Remote::new();
    let shop = Level::Shop.number();
    assert!(remote.place.web.url().starts_with("https://"));
    // The files are there for whoever wants to log in, and nothing else.
    assert_eq!(remote.http("GET", "/", "", b"").status, 200);
    let session = remote.http("GET", "/api/session", "", b"").json();
    assert_eq!(session, json!({ "level": 0, "needs_log_in": true }));
    let token = "A".repeat(43);
    for cookie in ["", "ferrocut=x", &format!("__Host-ferrocut={token}"), "__Host-ferrocut=%00"] {
        for path in ["/api/parameters", "/api/search?q=g1", "/api/programs/O1", "/api/openapi.json"] {
            let refused = remote.http("GET", path, cookie, b"");
            assert_eq!((refused.status, &refused.json()["error"]), (401, &json!("log_in")), "{path}");
        }
        assert_eq!(remote.http("POST", "/api/check", cookie, b"G0").status, 401);
        assert!(Socket::over(remote.stream(), "wss", &[("cookie", cookie)]).is_err(), "{cookie}");
    }
    let wrong = remote.log_in("wrong password");
    assert_eq!(wrong.status, 409, "{}", wrong.text());
    assert!(wrong.head("set-cookie").is_none());
    let right = remote.log_in(PASSWORD);
    assert_eq!(right.json(), json!({ "level": shop, "needs_log_in": true }));
    let head = right.head("set-cookie").unwrap();
    assert!(
        ["Secure", "HttpOnly", "SameSite=Strict", "__Host-"].iter().all(|word| head.contains(word)),
        "{head}"
    );
    let cookie = right.cookie();
    assert_eq!(remote.http("GET", "/api/parameters", &cookie, b"").status, 200);
    let mut socket = Socket::over(remote.stream(), "wss", &[("cookie", &cookie)]).unwrap();
    assert_eq!(socket.hello["session"]["level"], json!(shop));
    // The log has both tries, and from where.
    let log = socket.ask(json!({ "do": "operation_log", "most": 50 }));
    let is_try = |line: &&serde_json::Value| line["name"] == json!(format!("log in {shop}"));
    let tries: Vec<_> = log["entries"].as_array().unwrap().iter().filter(is_try).collect();
    let results: Vec<_> = tries.iter().map(|line| line["to"].as_str().unwrap()).collect();
    assert_eq!(results, ["right", "wrong"], "{log}");
    assert!(tries[0]["who"].as_str().unwrap().contains("127.0.0.1"));
    // Rights are those of the level: a shop's level sets no machine parameter.
    socket.take_command();
    let ladder = socket.ask(json!({ "do": "force", "signal": "KEY_START", "value": true }));
    assert!(ladder["refused"].is_object(), "{ladder}");
    // With the session its sockets end.
    assert_eq!(remote.http("DELETE", "/api/session", &cookie, b"").status, 200);
    let mut last = json!(null);
    while let Ok(next) = socket.try_hear() {
        last = next;
    }
    assert_eq!(last["end"], json!("logged_out"));
    // The log has who commanded, and that he logged out.
    let is_noted = || {
        let log = remote.store.reader().log(50).unwrap();
        let of = |entry: &LogEntry| (entry.name.clone(), entry.to.clone(), entry.who.contains("127.0.0.1"));
        let mut notes: Vec<_> =
            log.iter().map(of).filter(|(name, ..)| name == "command" || name == "log out").collect();
        notes.sort();
        let note = |name: &str, to: &str| (name.to_owned(), to.to_owned(), true);
        notes == [note("command", "left"), note("command", "taken"), note("log out", "")]
    };
    let began = Instant::now();
    while !is_noted() {
        assert!(began.elapsed() < Duration::from_secs(10), "{:?}", remote.store.reader().log(50));
    }
    assert_eq!(remote.http("GET", "/api/parameters", &cookie, b"").status, 401);
    drop(remote.folder);
}

#[test]
fn passwords_cannot_be_tried_at_will() {
    let remote = Remote::new();
    let remote = &remote;
    let statuses: Vec<u16> = std::thread::scope(|scope| {
        let tries: Vec<_> = (0..24).map(|_| scope.spawn(|| remote.log_in("guess guess").status)).collect();
        tries.into_iter().map(|one| one.join().unwrap()).collect()
    });
    assert!(statuses.contains(&429), "{statuses:?}");
    assert!(!statuses.contains(&200));
}

#[test]
fn other_computers_are_not_served_without_encryption_and_passwords() {
    let folder = tempfile::tempdir().unwrap();
    let place = Place::local();
    let settings = |certificate, store| Settings {
        address: "0.0.0.0:0".parse().unwrap(),
        certificate,
        names: Vec::new(),
        machine: ferrocut_machine::Machine::demo_mill(),
        store,
    };
    let start = |settings| Web::start(settings, place.hub.clone()).map(|_| ());
    assert!(matches!(start(settings(None, Some(store(&folder)))), Err(StartError::NotEncrypted)));
    let own = || Some(Certificate::Own(None));
    assert!(matches!(start(settings(own(), None)), Err(StartError::WithoutPassword)));
    let empty = tempfile::tempdir().unwrap();
    let without = Store::open(empty.path(), ferrocut_memory::Settings::new("gsk990mc")).unwrap();
    assert!(matches!(start(settings(own(), Some(Arc::new(without)))), Err(StartError::WithoutPassword)));
    let missing = Certificate::Files { chain: "/nowhere.pem".into(), key: "/nowhere.key".into() };
    let other = tempfile::tempdir().unwrap();
    assert!(matches!(start(settings(Some(missing), Some(store(&other)))), Err(StartError::Certificate(_))));
}

#[test]
fn a_key_of_ones_own_is_for_nobody_else() {
    use std::os::unix::fs::PermissionsExt;
    let remote = Remote::new();
    let key = std::fs::metadata(remote.folder.path().join("panel-key.pem")).unwrap();
    assert_eq!(key.permissions().mode() & 0o777, 0o600);
    // Not over HTTP either.
    assert_eq!(remote.http("GET", "/panel-key.pem", "", b"").status, 404);
}

/// Whether the machine and those who watch it go on: periods are done, and statuses come and are answered.
struct Watch {
    socket: Socket,
}

impl Watch {
    fn new(place: &Place) -> Watch {
        let mut socket = place.socket();
        socket.tell(json!({ "do": "watch", "status": true }));
        Watch { socket }
    }

    /// Sees 100 periods go by. On a computer with nothing else to do that takes 0.1 s; how long it may take says
    /// nothing of the machine, which shares this one with all other tests.
    fn goes_on(&mut self, place: &Place) {
        let (began, from) = (Instant::now(), place.periods());
        while self.socket.status()["periods"].as_u64().unwrap() < from + 100 {
            assert!(began.elapsed() < Duration::from_secs(20), "the machine or its status stands still");
        }
        let pushed = loop {
            let heard = self.socket.hear();
            if heard["status"]["periods"].as_u64().unwrap() >= from {
                break began.elapsed();
            }
        };
        eprintln!("100 periods and a status within {pushed:?}");
    }
}

#[test]
fn too_much_is_not_read() {
    let place = Place::local();
    let mut watch = Watch::new(&place);
    let huge = [("content-length", "1000000000")];
    assert_eq!(place.http("POST", "/api/check", &huge, b"G0").status, 413);
    assert_eq!(place.http("POST", "/api/session", &[("content-length", "100000")], b"{").status, 413);
    // One that does not say how much comes is read to the bound.
    let mut stream = TcpStream::connect(place.address()).unwrap();
    let head = b"POST /api/session HTTP/1.1\r\nhost: localhost\r\ntransfer-encoding: chunked\r\n\r\n";
    stream.write_all(head).unwrap();
    let chunk = [b"10000\r\n".as_slice(), &[b' '; 0x10000], b"\r\n"].concat();
    for _ in 0..16 {
        if stream.write_all(&chunk).is_err() {
            break;
        }
    }
    let mut all = Vec::new();
    let _ = stream.read_to_end(&mut all);
    assert!(all.is_empty() || answer(&all).status == 413, "{}", String::from_utf8_lossy(&all));
    // A head without end, and one with very many lines.
    let long = "x".repeat(200_000);
    let refused = place.http("GET", "/", &[("x-long", &long)], b"");
    assert!(matches!(refused.status, 0 | 431 | 400), "{}", refused.status);
    let many: Vec<(String, String)> = (0..500).map(|n| (format!("x-{n}"), "1".to_owned())).collect();
    let many: Vec<(&str, &str)> = many.iter().map(|(name, value)| (name.as_str(), value.as_str())).collect();
    assert!(matches!(place.http("GET", "/", &many, b"").status, 0 | 431 | 400));
    for path in
        [format!("/api/search?q={}", "a".repeat(5000)), format!("/api/explain?word={}", "a".repeat(5000))]
    {
        assert_eq!(place.get(&path).status, 413);
    }
    // A message that is longer than any line ends its socket.
    let mut socket = place.socket();
    let line = "x".repeat(5 << 20);
    let _ = socket.socket.send(tungstenite::Message::Text(line.into()));
    while socket.try_hear().is_ok() {}
    watch.goes_on(&place);
}

#[test]
fn slow_clients_hold_up_nobody() {
    let _alone = MANY.lock().unwrap_or_else(PoisonError::into_inner);
    let place = Place::local();
    let mut watch = Watch::new(&place);
    // Heads that never end, and bodies that never come.
    let half_heads: Vec<TcpStream> = (0..100)
        .map(|_| {
            let mut stream = TcpStream::connect(place.address()).unwrap();
            stream.write_all(b"GET /api/session HTTP/1.1\r\nhost: localhost\r\nx-slow: ").unwrap();
            stream
        })
        .collect();
    let half_bodies: Vec<TcpStream> = (0..40)
        .map(|_| {
            let mut stream = TcpStream::connect(place.address()).unwrap();
            let head = b"POST /api/check HTTP/1.1\r\nhost: localhost\r\ncontent-length: 1000000\r\n\r\nG0";
            stream.write_all(head).unwrap();
            stream
        })
        .collect();
    // Readers that take nothing of a long answer.
    let readers: Vec<TcpStream> = (0..10)
        .map(|_| {
            let mut stream = TcpStream::connect(place.address()).unwrap();
            for _ in 0..20 {
                stream.write_all(b"GET /api/parameters HTTP/1.1\r\nhost: localhost\r\n\r\n").unwrap();
            }
            stream
        })
        .collect();
    let began = Instant::now();
    while began.elapsed() < Duration::from_secs(3) {
        assert_eq!(place.get("/api/session").status, 200);
        watch.goes_on(&place);
    }
    // Long bodies have their places; who finds none is told so, and small requests need none.
    let mut told = 0;
    for mut stream in half_bodies {
        stream.set_read_timeout(Some(Duration::from_millis(10))).unwrap();
        let mut start = [0; 16];
        told += u32::from(
            stream.read(&mut start).is_ok_and(|count| start[..count].ends_with(b"503 "))
                || start.starts_with(b"HTTP/1.1 503"),
        );
    }
    assert!(told >= 30, "{told} were told that there is no room");
    // Heads that do not end are ended.
    let mut ended = 0;
    for mut stream in half_heads {
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        let mut rest = Vec::new();
        ended += u32::from(stream.read_to_end(&mut rest).is_ok());
    }
    assert_eq!(ended, 100);
    drop(readers);
    watch.goes_on(&place);
}

#[test]
fn a_socket_that_takes_nothing_is_cut_off() {
    let place = Place::local();
    let mut watch = Watch::new(&place);
    let mut slow = place.socket();
    slow.tell(json!({ "do": "watch", "events": true, "status": true }));
    let began = Instant::now();
    // It asks and asks, and reads nothing.
    let line = json!({ "do": "parameters", "names": [] }).to_string();
    while began.elapsed() < Duration::from_secs(20) {
        if slow.socket.send(tungstenite::Message::Text(line.clone().into())).is_err() {
            break;
        }
    }
    assert!(began.elapsed() < Duration::from_secs(20), "it was never cut off");
    watch.goes_on(&place);
}

#[test]
fn five_hundred_sockets_are_too_many_and_harm_nobody() {
    let _alone = MANY.lock().unwrap_or_else(PoisonError::into_inner);
    let place = Place::local();
    let mut watch = Watch::new(&place);
    let mut streams = Vec::new();
    for _ in 0..500 {
        streams.push(TcpStream::connect(place.address()).unwrap());
    }
    std::thread::sleep(Duration::from_millis(500));
    watch.goes_on(&place);
    let mut told = 0;
    for stream in &mut streams {
        stream.set_read_timeout(Some(Duration::from_millis(5))).unwrap();
        let mut all = [0; 256];
        if let Ok(count) = stream.read(&mut all) {
            // Told, or closed without a word.
            told += 1;
            assert!(count == 0 || all.starts_with(b"HTTP/1.1 503"), "{}", String::from_utf8_lossy(&all));
        }
    }
    assert!(told >= 200, "{told} of 500 were sent away");
    watch.goes_on(&place);
    drop(streams);
    // Places come back.
    let began = Instant::now();
    while place.get("/api/session").status != 200 {
        assert!(began.elapsed() < Duration::from_secs(10));
        std::thread::sleep(Duration::from_millis(50));
    }
    // The same with sockets that talk: as many as there is room for, and the others hear why not.
    let mut open = Vec::new();
    let mut refused = 0;
    for _ in 0..500 {
        match Socket::new(place.address(), &[]) {
            Ok(socket) if socket.hello["hello"] == json!("ferrocut") => open.push(socket),
            Ok(socket) => {
                assert_eq!(socket.hello["end"], json!("too_many_connections"));
                refused += 1;
            }
            Err(error) => {
                assert!(error.contains("503"), "{error}");
                refused += 1;
            }
        }
    }
    assert_eq!((open.len(), refused), (MOST_CONNECTIONS - 1, 500 - MOST_CONNECTIONS + 1));
    watch.goes_on(&place);
}

/// GSK990MC operation 3.4.4.
#[test]
fn backups_are_listed_and_taken_away_by_right() {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let author = Author::Maintenance { name: "test".into() };
    store.set_password(&author, Level::Commissioning, "crew of machine 3", Seat::Machine).unwrap();
    let panel = Panel::new(control(Some(store.clone())));
    let place = Place::new(panel, Some(store), "127.0.0.1:0", None);
    let cookie = place.get("/").cookie();
    assert_eq!(place.get("/api/backups").json(), json!([]));
    let mut socket = Socket::new(place.address(), &[("cookie", &cookie)]).unwrap();
    socket.take_command();
    assert_eq!(socket.ask(json!({ "do": "backup", "file": "shop.backup", "items": [] }))["reply"], "done");
    std::fs::write(folder.path().join("notes.txt"), "x").unwrap();
    std::os::unix::fs::symlink("/etc/passwd", folder.path().join("away.backup")).unwrap();
    let list = place.get("/api/backups").json();
    let bytes = std::fs::read(folder.path().join("shop.backup")).unwrap();
    assert_eq!(list.as_array().unwrap().len(), 1, "{list}");
    assert_eq!((&list[0]["name"], &list[0]["bytes"]), (&json!("shop.backup"), &json!(bytes.len())));
    assert!(list[0]["changed"].as_i64().unwrap() > 1_700_000_000_000);
    let take = |name: &str, cookie: &str| {
        place.http("GET", &format!("/api/backups/{name}"), &[("cookie", cookie)], b"")
    };
    let refused = take("shop.backup", &cookie);
    assert_eq!((refused.status, &refused.json()["refused"]["alarm"]["id"]), (409, &json!("FC-1213")));
    let log_in = |level: u8, password: &str| {
        let body = json!({ "level": level, "password": password }).to_string();
        place.http("POST", "/api/session", &[("cookie", &cookie)], body.as_bytes())
    };
    let shop = log_in(4, PASSWORD).cookie();
    assert_eq!(take("shop.backup", &shop).status, 409);
    let body = json!({ "level": 3, "password": "crew of machine 3" }).to_string();
    let crew = place.http("POST", "/api/session", &[("cookie", &shop)], body.as_bytes()).cookie();
    let taken = take("shop.backup", &crew);
    assert_eq!((taken.status, taken.body == bytes), (200, true));
    assert_eq!(taken.head("content-disposition"), Some("attachment; filename=\"shop.backup\""));
    for name in ["away.backup", "notes.txt", "none.backup", "..%2fshop.backup", "%2fetc%2fpasswd", ".backup"]
    {
        assert_eq!(take(name, &crew).status, 404, "{name}");
    }
}

/// GSK990MC operation 3.4.4.
#[test]
fn backups_are_brought_by_right_and_only_whole() {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let author = Author::Maintenance { name: "test".into() };
    store.set_password(&author, Level::Commissioning, "crew of machine 3", Seat::Machine).unwrap();
    let panel = Panel::new(control(Some(store.clone())));
    let place = Place::new(panel, Some(store.clone()), "127.0.0.1:0", None);
    let cookie = place.get("/").cookie();
    let mut socket = Socket::new(place.address(), &[("cookie", &cookie)]).unwrap();
    socket.take_command();
    assert_eq!(socket.ask(json!({ "do": "backup", "file": "shop.backup", "items": [] }))["reply"], "done");
    let whole = std::fs::read(folder.path().join("shop.backup")).unwrap();
    let bring = |name: &str, cookie: &str, body: &[u8]| {
        place.http("PUT", &format!("/api/backups/{name}"), &[("cookie", cookie)], body)
    };
    let refused = bring("new.backup", &cookie, &whole);
    assert_eq!((refused.status, &refused.json()["refused"]["alarm"]["id"]), (409, &json!("FC-1213")));
    let body = json!({ "level": 3, "password": "crew of machine 3" }).to_string();
    let crew = place.http("POST", "/api/session", &[("cookie", &cookie)], body.as_bytes()).cookie();
    assert_eq!(socket.ask(json!({ "do": "give_command" }))["reply"], "done");
    let refused = bring("new.backup", &crew, &whole);
    assert_eq!((refused.status, &refused.json()["error"]), (403, &json!("not_in_command")));
    socket.take_command();
    socket.ask(json!({ "do": "watch", "events": true }));

    let brought = bring("new.backup", &crew, &whole);
    assert_eq!((brought.status, &brought.json()["bytes"]), (200, &json!(whole.len())), "{}", brought.text());
    assert_eq!(std::fs::read(folder.path().join("new.backup")).unwrap(), whole);
    while socket.hear() != json!({ "event": "changed", "item": "backups" }) {}
    assert_eq!(
        socket.ask(json!({ "do": "restore", "file": "new.backup", "items": ["offsets"] }))["reply"],
        "done"
    );
    let log = socket.ask(json!({ "do": "operation_log", "most": 10 }));
    let logged = log["reply"]["entries"].as_array().or(log["entries"].as_array()).unwrap();
    assert!(logged.iter().any(|line| line["name"] == "uploaded" && line["to"] == "new.backup"), "{log}");

    // What is no backup, is cut off, was changed or is of another control leaves what was there.
    let mut changed = whole.clone();
    let middle = changed.len() / 2;
    changed[middle] ^= 1;
    let other = String::from_utf8(whole.clone()).unwrap().replacen("\"gsk990mc\"", "\"rs274\"", 1);
    for (body, alarm) in [
        (&b"not a backup"[..], "FC-1209"),
        (b"", "FC-1209"),
        (&whole[..whole.len() - 1], "FC-1210"),
        (&changed, "FC-1210"),
        (other.as_bytes(), "FC-1210"),
    ] {
        let refused = bring("new.backup", &crew, body);
        assert_eq!((refused.status, &refused.json()["refused"]["alarm"]["id"]), (409, &json!(alarm)));
        assert_eq!(std::fs::read(folder.path().join("new.backup")).unwrap(), whole);
    }
    for name in ["notes.txt", "..%2fnew.backup", "%2ftmp%2fnew.backup", ".backup", "upload.part"] {
        let refused = bring(name, &crew, &whole);
        assert!(matches!(refused.status, 404 | 409), "{name}: {}", refused.status);
    }
    let told = [("cookie", crew.as_str()), ("content-length", "300000000")];
    assert_eq!(place.http("PUT", "/api/backups/new.backup", &told, b"").status, 413);
    // Nothing but backups and the memory is left in the folder, and no link leads out of it.
    std::os::unix::fs::symlink(folder.path().join("outside"), folder.path().join("upload.part")).unwrap();
    assert_eq!(bring("new.backup", &crew, &whole).status, 200);
    assert!(!folder.path().join("outside").exists() && !folder.path().join("upload.part").exists());
}

/// Rights are judged before a ladder is looked at; a fault has the number that the document says.
#[test]
fn a_ladder_is_exchanged_by_right_and_only_without_faults() {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let author = Author::Maintenance { name: "test".into() };
    store.set_password(&author, Level::Builder, PASSWORD, Seat::Machine).unwrap();
    let panel = Panel::new(control(Some(store.clone())));
    let place = Place::new(panel, Some(store.clone()), "127.0.0.1:0", None);
    let mut socket = place.socket();
    socket.take_command();
    let own = socket.ask(json!({"do": "ladder"}))["text"].as_str().unwrap().to_owned();
    let faulty = [("<project>\n<a>\n</project>", "1028", 3), ("RD X0.0\nDANCE R0.0\n", "1002", 2)];
    let good = format!("; Another one.\n{own}");
    for (text, _, _) in faulty.iter().chain(&[(good.as_str(), "", 0)]) {
        let answer = socket.ask(json!({"do": "exchange_ladder", "text": text}));
        assert_eq!(answer["refused"]["alarm"]["id"], json!("FC-1213"), "{answer}");
    }
    socket.ask(json!({"do": "log_in", "level": 2, "password": PASSWORD}));
    for (text, number, line) in faulty {
        let answer = socket.ask(json!({"do": "exchange_ladder", "text": text}));
        let alarm = &answer["refused"]["alarm"];
        assert_eq!(
            (&alarm["id"], &alarm["line"]),
            (&json!(format!("gsk990mc:{number}")), &json!(line)),
            "{answer}"
        );
    }
    assert_eq!(socket.ask(json!({"do": "exchange_ladder", "text": good}))["reply"], json!("done"));
    // It is kept, by name of who exchanged it.
    let began = Instant::now();
    loop {
        let log = socket.ask(json!({"do": "operation_log", "most": 20})).to_string();
        if log.contains("\"ladder\"") {
            break;
        }
        assert!(began.elapsed() < Duration::from_secs(20), "{log}");
        std::thread::sleep(Duration::from_millis(50));
    }
}
