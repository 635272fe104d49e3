//! The command `serve`: the app in a browser, given out by the program itself, on this machine alone.
//!
//! It listens on 127.0.0.1 and answers who asks for that or `localhost` by name: no other machine reaches it,
//! and no page of another host reads from it under a name of its own. A client that stalls keeps nobody
//! waiting but itself.

mod app;
mod http;

use app::App;
use clap::ValueHint;
use epicyclic_commands::desk::Call;
use epicyclic_commands::failure::Failure;
use epicyclic_commands::input;
use http::{Reply, Request};
use std::net::{Ipv4Addr, TcpListener};
use std::path::{Path, PathBuf};

/// Where the page asks for the file it is to open.
const OPENED: &str = "opened";

/// The media type of a file that is opened, and of why it is not.
const TEXT: &str = "text/plain; charset=utf-8";

/// The app in a browser: gearboxes and hydromotors to look at, change and choose, as the program calculates
/// them.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  epicyclic serve gearbox.yaml

The page is reached from this machine alone, asks no other, and calculates by
itself: it stays usable when the program has ended.")]
pub(crate) struct Args {
    /// Gearbox or hydromotor to open, as YAML; read each time the address is opened. - reads standard input.
    file: Option<PathBuf>,

    /// Port on 127.0.0.1. With 0 any that is free.
    #[arg(long, default_value_t = 8414)]
    port: u16,

    /// Tells the address and opens no browser.
    #[arg(long)]
    no_browser: bool,

    /// The app as `scripts/web build` leaves it in a folder, in place of the one in the program.
    #[arg(long, value_name = "FOLDER", value_hint = ValueHint::DirPath)]
    app: Option<PathBuf>,
}

/// Runs the command; it ends with the program.
pub(crate) fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let app = App::of(args.app.as_deref())?;
    let file = args.file.as_deref();
    // What cannot be read is told here and not in the page; of standard input there is one reading.
    let read = file.map(|file| input::text(call, file)).transpose()?;
    let listened = TcpListener::bind((Ipv4Addr::LOCALHOST, args.port)).map_err(|error| {
        Failure::invalid(
            "--port",
            format!("{} on 127.0.0.1: {error}; give another one, or 0 for any that is free", args.port),
        )
    })?;
    let port = listened.local_addr().map_err(Failure::StandardOutput)?.port();
    let address = format!("http://127.0.0.1:{port}/{}", if file.is_some() { "#open" } else { "" });
    call.desk.answer(&mut |out| writeln!(out, "{address}")).map_err(Failure::StandardOutput)?;
    if !args.no_browser && open::that_detached(&address).is_err() {
        call.complain("no browser was found: open the address in one");
    }
    // A file that cannot be read any more is no reason to show what it was.
    let opened = |file: &Path| match read.clone().filter(|_| input::is_standard_input(file)) {
        Some(text) => Reply::of(text.into_bytes(), TEXT),
        None => match input::text(call, file) {
            Ok(text) => Reply::of(text.into_bytes(), TEXT),
            Err(failure) => Reply::failed(failure.told().into_bytes(), TEXT),
        },
    };
    http::serve(&listened, &|request| {
        if !is_of_here(request, port) {
            return Reply::refusal(403);
        }
        if !matches!(request.method.as_str(), "GET" | "HEAD") {
            return Reply::refusal(405);
        }
        let asked = request.url.split(['?', '#']).next().unwrap_or_default().trim_start_matches('/');
        match (asked, file) {
            (OPENED, Some(file)) => Some(opened(file)),
            ("", _) => app.reply("index.html", kind("index.html"), request.takes_gzip),
            (name, _) => app.reply(name, kind(name), request.takes_gzip),
        }
        .unwrap_or_else(|| Reply::refusal(404))
    });
    Ok(())
}

/// Whether this machine is asked under its own name.
fn is_of_here(request: &Request, port: u16) -> bool {
    let here = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
    request.host.as_ref().is_some_and(|host| here.contains(host))
}

/// The media type of a file of the app.
fn kind(name: &str) -> &'static str {
    match name.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("wasm") => "application/wasm",
        Some("svg") => "image/svg+xml",
        Some("json") => "application/json",
        Some("webmanifest") => "application/manifest+json",
        _ => "application/octet-stream",
    }
}
