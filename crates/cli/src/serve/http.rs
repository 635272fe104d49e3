//! Part of HTTP/1.1 that the app needs: GET and HEAD, one reply per connection, and limits on size and time
//! of requests.

use std::io::{self, ErrorKind, Read as _, Write as _};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// Maximum size of a request's head in bytes.
const MOST_HEAD: usize = 16 << 10;
/// Time limit for a request to arrive.
const TO_ASK: Duration = Duration::from_secs(5);
/// Time limit for a reply to be received.
const TO_TAKE: Duration = Duration::from_secs(30);
/// Time to wait for the rest of a request that gets its reply before it is read.
const TO_LEAVE: Duration = Duration::from_millis(200);
/// Maximum number of simultaneous connections; further clients are asked to try again.
const MOST_CONNECTIONS: usize = 64;

/// A request without a body.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Request {
    /// Method: GET, HEAD or another word.
    pub(super) method: String,
    /// Path of the request with its query.
    pub(super) url: String,
    /// Name under which the client addresses this machine.
    pub(super) host: Option<String>,
    /// Whether the client accepts compression by gzip.
    pub(super) takes_gzip: bool,
    /// Whether the request announces a body.
    has_body: bool,
}

/// A reply.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Reply {
    status: u16,
    kind: &'static str,
    body: Vec<u8>,
    is_packed: bool,
}

impl Reply {
    /// Reply with a file of this media type.
    pub(super) const fn of(body: Vec<u8>, kind: &'static str) -> Self {
        Self { status: 200, kind, body, is_packed: false }
    }

    /// Reply with a file of this media type, compressed by gzip.
    pub(super) const fn packed(body: Vec<u8>, kind: &'static str) -> Self {
        Self { status: 200, kind, body, is_packed: true }
    }

    /// Reply that no file can be given because of a fault of this program.
    pub(super) const fn failed(body: Vec<u8>, kind: &'static str) -> Self {
        Self { status: 500, kind, body, is_packed: false }
    }

    /// Reply without a file, with a status.
    pub(super) const fn refusal(status: u16) -> Self {
        Self { status, kind: "text/plain", body: Vec::new(), is_packed: false }
    }

    fn reason(&self) -> &'static str {
        match self.status {
            200 => "OK",
            400 => "Bad Request",
            403 => "Forbidden",
            404 => "Not Found",
            405 => "Method Not Allowed",
            408 => "Request Timeout",
            413 => "Content Too Large",
            431 => "Request Header Fields Too Large",
            500 => "Internal Server Error",
            _ => "Service Unavailable",
        }
    }

    fn head(&self) -> String {
        // A newer program has newer files under equal names, so nothing may be cached.
        format!(
            "HTTP/1.1 {} {}\r\nContent-Type: {}\r\n{}Content-Length: {}\r\nVary: Accept-Encoding\r\nCache-Control: no-cache\r\n\
             X-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n",
            self.status,
            self.reason(),
            self.kind,
            if self.is_packed { "Content-Encoding: gzip\r\n" } else { "" },
            self.body.len()
        )
    }
}

/// Replies to every request, each connection on its own thread, as long as the program runs.
pub(super) fn serve(listener: &TcpListener, reply: &(dyn Fn(&Request) -> Reply + Sync)) {
    let open = AtomicUsize::new(0);
    let open = &open;
    thread::scope(|scope| {
        for stream in listener.incoming() {
            let Ok(stream) = stream else {
                // With too many open files, some will be closed soon.
                thread::sleep(Duration::from_millis(10));
                continue;
            };
            if open.fetch_add(1, Ordering::SeqCst) >= MOST_CONNECTIONS {
                let _ = write(&stream, &Reply::refusal(503), false, Instant::now() + TO_LEAVE);
                open.fetch_sub(1, Ordering::SeqCst);
                continue;
            }
            let answered = move || {
                // The client may be gone.
                let _ = answer(&stream, reply);
                open.fetch_sub(1, Ordering::SeqCst);
            };
            if thread::Builder::new().spawn_scoped(scope, answered).is_err() {
                open.fetch_sub(1, Ordering::SeqCst);
            }
        }
    });
}

fn answer(stream: &TcpStream, reply: &dyn Fn(&Request) -> Reply) -> io::Result<()> {
    let asked = read(stream, Instant::now() + TO_ASK)?;
    let (answer, is_head, is_whole) = match &asked {
        Ok(request) if request.has_body => (Reply::refusal(413), false, false),
        Ok(request) => (reply(request), request.method == "HEAD", true),
        Err(status) => (Reply::refusal(*status), false, false),
    };
    write(stream, &answer, is_head, Instant::now() + TO_TAKE)?;
    stream.shutdown(Shutdown::Write)?;
    if !is_whole {
        // Closing a connection with unread data would discard the reply.
        let until = Instant::now() + TO_LEAVE;
        let mut left = [0; 4096];
        while read_some(stream, &mut left, until)? > 0 {}
    }
    Ok(())
}

/// Waits until this time for some bytes.
fn read_some(mut stream: &TcpStream, into: &mut [u8], until: Instant) -> io::Result<usize> {
    let left = until.saturating_duration_since(Instant::now());
    if left.is_zero() {
        return Err(ErrorKind::TimedOut.into());
    }
    stream.set_read_timeout(Some(left))?;
    stream.read(into)
}

/// Reads the head of a request; otherwise returns the status of its fault.
fn read(stream: &TcpStream, until: Instant) -> io::Result<Result<Request, u16>> {
    let (mut head, mut some) = (Vec::new(), [0; 2048]);
    loop {
        let count = match read_some(stream, &mut some, until) {
            Ok(count) => count,
            Err(error) if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::WouldBlock) => {
                return Ok(Err(408));
            }
            Err(error) => return Err(error),
        };
        if count == 0 {
            return Err(ErrorKind::UnexpectedEof.into());
        }
        let before = head.len().saturating_sub(3);
        head.extend_from_slice(&some[..count]);
        if let Some(end) = head[before..].windows(4).position(|bytes| bytes == b"\r\n\r\n") {
            return Ok(parsed(&head[..before + end]).ok_or(400));
        }
        if head.len() > MOST_HEAD {
            return Ok(Err(431));
        }
    }
}

fn parsed(head: &[u8]) -> Option<Request> {
    let mut lines = std::str::from_utf8(head).ok()?.split("\r\n");
    let mut words = lines.next()?.split(' ');
    let (method, url, version) = (words.next()?, words.next()?, words.next()?);
    if words.next().is_some() || !version.starts_with("HTTP/1.") {
        return None;
    }
    let (mut host, mut takes_gzip, mut has_body) = (None, false, false);
    for line in lines {
        let (name, value) = line.split_once(':')?;
        let value = value.trim();
        if name.eq_ignore_ascii_case("Host") {
            host = Some(value.to_owned());
        } else if name.eq_ignore_ascii_case("Accept-Encoding") {
            takes_gzip |= value.split(',').any(|coding| coding.trim().eq_ignore_ascii_case("gzip"));
        } else if name.eq_ignore_ascii_case("Content-Length") {
            has_body |= value != "0";
        } else if name.eq_ignore_ascii_case("Transfer-Encoding") {
            has_body = true;
        }
    }
    Some(Request { method: method.to_owned(), url: url.to_owned(), host, takes_gzip, has_body })
}

fn write(mut stream: &TcpStream, reply: &Reply, is_head: bool, until: Instant) -> io::Result<()> {
    let head = reply.head();
    let body = if is_head { &[][..] } else { &reply.body };
    for mut part in [head.as_bytes(), body] {
        while !part.is_empty() {
            let left = until.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Err(ErrorKind::TimedOut.into());
            }
            stream.set_write_timeout(Some(left))?;
            match stream.write(part)? {
                0 => return Err(ErrorKind::WriteZero.into()),
                count => part = &part[count..],
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_head_is_read_or_refused() {
        let head =
            b"GET /a.js?x HTTP/1.1\r\nhost: localhost:1\r\naccept-encoding: br, gzip\r\nContent-Length: 0";
        let request = parsed(head).unwrap();
        assert_eq!((request.method.as_str(), request.url.as_str()), ("GET", "/a.js?x"));
        assert_eq!((request.host.as_deref(), request.has_body), (Some("localhost:1"), false));
        assert!(request.takes_gzip);
        for more in ["Content-Length: 5", "Transfer-Encoding: chunked"] {
            assert!(parsed(format!("POST / HTTP/1.1\r\n{more}").as_bytes()).unwrap().has_body);
        }
        for head in [
            &b""[..],
            b"GET /",
            b"GET / HTTP/2",
            b"GET / a HTTP/1.1",
            b"GET / HTTP/1.1\r\nHost",
            b"\xff / HTTP/1.1",
        ] {
            assert_eq!(parsed(head), None);
        }
    }
}
