//! The program as a server: the files that it serves, its clients, and the effect of every option.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::{PROGRAM, examples, output, program, text};
use std::fs;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::{TcpListener, TcpStream};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::{TempDir, tempdir};

/// A folder with an app of two files.
fn app() -> TempDir {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("index.html"), "<title>here</title>").unwrap();
    fs::write(folder.path().join("core.wasm"), [0, 97, 115, 109]).unwrap();
    folder
}

/// The program while it serves.
struct Serving {
    child: Child,
    address: String,
    port: u16,
}

impl Serving {
    fn of(mut command: Command) -> Self {
        let mut child = command.stdout(Stdio::piped()).spawn().unwrap();
        let mut address = String::new();
        BufReader::new(child.stdout.as_mut().unwrap()).read_line(&mut address).unwrap();
        let port = address.split(':').nth(2).unwrap().split('/').next().unwrap().parse().unwrap();
        Self { child, address: address.trim().to_owned(), port }
    }

    fn new(app: &TempDir, words: &[&str]) -> Self {
        let app = app.path().to_str().unwrap();
        let fixed = ["serve", "--app", app, "--port", "0", "--no-browser"];
        Self::of(program(&examples(), &[&fixed, words].concat()))
    }

    /// Status, head and body of what it replies.
    fn asked(&self, method: &str, path: &str, host: &str) -> (u16, String, Vec<u8>) {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        write!(stream, "{method} {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").unwrap();
        let mut reply = vec![];
        stream.read_to_end(&mut reply).unwrap();
        let end = reply.windows(4).position(|bytes| bytes == b"\r\n\r\n").unwrap();
        let head = text(&reply[..end]);
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        (status, head, reply[end + 4..].to_vec())
    }

    fn got(&self, path: &str) -> (u16, String, Vec<u8>) {
        self.asked("GET", path, &format!("127.0.0.1:{}", self.port))
    }
}

impl Drop for Serving {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn the_files_of_the_folder_are_given_out_and_nothing_else() {
    let folder = app();
    let serving = Serving::new(&folder, &[]);
    assert_eq!(serving.address, format!("http://127.0.0.1:{}/", serving.port));
    let (status, head, body) = serving.got("/");
    assert_eq!((status, body.as_slice()), (200, &b"<title>here</title>"[..]));
    assert!(head.contains("text/html") && head.contains("no-cache"), "{head}");
    let (status, head, body) = serving.got("/core.wasm?new");
    assert_eq!((status, body), (200, vec![0, 97, 115, 109]));
    assert!(head.contains("application/wasm"), "{head}");
    for path in ["/../Cargo.toml", "/%2e%2e/Cargo.toml", "//etc/passwd", "/opened", "/more.js"] {
        assert_eq!(serving.got(path).0, 404, "{path}");
    }
    fs::write(folder.path().join("more.js"), "0").unwrap();
    assert_eq!(serving.got("/more.js").0, 404, "it was not there when the program began");
}

#[test]
fn it_answers_this_machine_alone_under_its_own_name() {
    let folder = app();
    let serving = Serving::new(&folder, &["scheme-ii-3.yaml"]);
    for (host, expected) in [
        (format!("localhost:{}", serving.port), 200),
        (format!("elsewhere.example:{}", serving.port), 403),
        ("127.0.0.1".to_owned(), 403),
    ] {
        assert_eq!(serving.asked("GET", "/opened", &host).0, expected, "{host}");
    }
    let here = format!("127.0.0.1:{}", serving.port);
    assert_eq!(serving.asked("POST", "/", &here).0, 405);
    let (status, _, body) = serving.asked("HEAD", "/", &here);
    assert_eq!((status, body.len()), (200, 0));
}

#[test]
fn a_file_is_opened_and_read_anew() {
    let (folder, files) = (app(), tempdir().unwrap());
    let file = files.path().join("box.yaml");
    fs::write(&file, "gearbox: one\n").unwrap();
    let serving = Serving::new(&folder, &[file.to_str().unwrap()]);
    assert!(serving.address.ends_with("/#open"), "{}", serving.address);
    assert_eq!(serving.got("/opened").2, b"gearbox: one\n");
    fs::write(&file, "gearbox: another\n").unwrap();
    assert_eq!(serving.got("/opened").2, b"gearbox: another\n");
    // What it was is not shown in place of what cannot be read.
    for spoil in [
        |file: &Path| fs::write(file, b"gearbox: \xff\n").unwrap(),
        |file: &Path| fs::remove_file(file).unwrap(),
    ] {
        spoil(&file);
        let (status, head, body) = serving.got("/opened");
        assert_eq!(status, 500, "{head}");
        assert!(text(&body).contains("box.yaml: cannot be read: "), "{}", text(&body));
    }
    fs::write(&file, "gearbox: a third\n").unwrap();
    assert_eq!(serving.got("/opened").2, b"gearbox: a third\n");
}

/// Whoever is called in place of a browser writes down with what.
#[cfg(unix)]
#[test]
fn a_browser_is_opened_but_where_none_is_wanted() {
    use std::os::unix::fs::PermissionsExt as _;
    let (folder, tools) = (app(), tempdir().unwrap());
    let (tool, told) = (tools.path().join("xdg-open"), tools.path().join("told"));
    fs::write(&tool, format!("#!/bin/sh\necho \"$1\" > {0}.new && /bin/mv {0}.new {0}\n", told.display()))
        .unwrap();
    fs::set_permissions(&tool, fs::Permissions::from_mode(0o755)).unwrap();
    let app = folder.path().to_str().unwrap();
    for quiet in [true, false] {
        let mut words = vec!["serve", "--app", app, "--port", "0"];
        words.extend(quiet.then_some("--no-browser"));
        let mut command = program(Path::new("/"), &words);
        let serving = Serving::of({
            command.env("PATH", tools.path());
            command
        });
        let begun = Instant::now();
        // A browser that is not opened cannot be waited for; messages before the address would have arrived
        // by now.
        while !told.exists() && begun.elapsed() < Duration::from_secs(if quiet { 1 } else { 60 }) {
            std::thread::sleep(Duration::from_millis(20));
        }
        let opened = fs::read_to_string(&told).ok();
        assert_eq!(opened, (!quiet).then(|| format!("{}\n", serving.address)));
    }
}

/// Clients that announce what does not come, do not read, or do not end their heads keep nobody waiting.
#[test]
fn a_client_that_stalls_keeps_nobody_waiting() {
    let folder = app();
    fs::write(folder.path().join("large.bin"), vec![7; 32 << 20]).unwrap();
    let serving = Serving::new(&folder, &[]);
    let host = format!("Host: 127.0.0.1:{}\r\n", serving.port);
    let connect = |sent: &str| {
        let mut stream = TcpStream::connect(("127.0.0.1", serving.port)).unwrap();
        stream.write_all(sent.as_bytes()).unwrap();
        stream
    };
    let mut stalled = vec![];
    for _ in 0..5 {
        stalled.push(connect(""));
        stalled.push(connect(&format!("POST / HTTP/1.1\r\n{host}Content-Length: 100000\r\n\r\nabc")));
        stalled.push(connect(&format!("GET /large.bin HTTP/1.1\r\n{host}\r\n")));
        stalled.push(connect(&format!("GET / HTTP/1.1\r\n{host}X: ")));
    }
    let begun = Instant::now();
    assert_eq!(serving.got("/").0, 200);
    assert!(begun.elapsed() < Duration::from_secs(4), "{:?}", begun.elapsed());
    let status = |mut stream: TcpStream| {
        let mut reply = vec![];
        let _ = stream.read_to_end(&mut reply);
        text(&reply).split(' ').nth(1).map(str::to_owned)
    };
    let announced = connect(&format!("GET / HTTP/1.1\r\n{host}Content-Length: 100000\r\n\r\nabc"));
    assert_eq!(status(announced).as_deref(), Some("413"));
    let endless = connect(&format!("GET / HTTP/1.1\r\n{host}X: {}", "x".repeat(20_000)));
    assert_eq!(status(endless).as_deref(), Some("431"));
    assert_eq!(status(connect("nonsense\r\n\r\n")).as_deref(), Some("400"));
    // What does not come is not waited for for ever.
    let begun = Instant::now();
    assert_eq!(status(stalled.swap_remove(0)).as_deref(), Some("408"));
    assert!(begun.elapsed() < Duration::from_secs(30), "{:?}", begun.elapsed());
    drop(stalled);
    let whole = serving.got("/large.bin");
    assert_eq!((whole.0, whole.2.len()), (200, 32 << 20));
}

#[test]
fn what_cannot_be_served_is_refused() {
    let (folder, empty) = (app(), tempdir().unwrap());
    let [app, nothing] = [&folder, &empty].map(|folder| folder.path().to_str().unwrap());
    let taken = TcpListener::bind(("127.0.0.1", 0)).unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    for (words, code, told) in [
        (&["--app", app, "--port", &port][..], 2, "--port: "),
        (&["--app", app, "--port", "70000"], 2, "70000"),
        (&["--app", nothing], 2, "there is no index.html in it; scripts/web build"),
        (&["--app", "not-there"], 3, "not-there: cannot be read"),
        (&["--app", app, "not-there.yaml"], 3, "not-there.yaml: cannot be read"),
    ] {
        let done = output(&examples(), &[&["serve", "--no-browser"], words].concat());
        let why = text(&done.stderr);
        assert!(done.status.code() == Some(code) && why.contains(told), "{words:?}: {why}");
    }
    // A program as cargo builds it by default has no app in it.
    let done = Command::new(PROGRAM).args(["serve", "--no-browser"]).output().unwrap();
    assert!(text(&done.stderr).contains("--app target/app"), "{done:?}");
}
