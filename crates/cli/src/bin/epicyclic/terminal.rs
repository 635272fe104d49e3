//! Desk of a terminal and the disk, or of what a shell connects instead of a terminal.

use crate::interrupt::{WIDTH, answers, asked, hear, line_stands, search_hears};
use crate::standard_output;
use epicyclic::desk::disk;
use epicyclic_commands::desk::{Content, Desk, NotWritten, Source, Text};
use std::io::{self, BufWriter, IsTerminal as _, Write as _, stderr};
use std::path::Path;
use std::time::Instant;
use terminal_size::terminal_size_of;

/// The desk of the program.
pub(crate) struct Terminal {
    begun: Instant,
}

impl Terminal {
    /// Desk of the program; installs the signal handlers.
    pub(crate) fn new() -> Self {
        hear();
        Self { begun: Instant::now() }
    }
}

impl Desk for Terminal {
    fn read(&self, file: Option<&Path>, most: u64) -> io::Result<Text> {
        match file {
            Some(file) => disk::read(file, most),
            None => disk::limited(io::stdin().lock(), most),
        }
    }

    fn exists(&self, file: &Path) -> bool {
        file.exists()
    }

    fn are_one_file(&self, one: &Path, other: &Path) -> bool {
        disk::are_one_file(one, other)
    }

    fn write(&self, files: &[Content], streamed: Option<(&Path, &mut Source)>) -> Result<(), NotWritten> {
        let named = files.iter().map(|(file, _)| file.as_path());
        for file in named.chain(streamed.as_ref().map(|(file, _)| *file)) {
            if standard_output::is_name(file) {
                standard_output::check().map_err(|why| NotWritten { file: file.to_owned(), why })?;
            }
        }
        disk::write(files, streamed)
    }

    fn make_folder(&self, folder: &Path) -> io::Result<()> {
        disk::make_folder(folder)
    }

    fn remove(&self, file: &Path) -> io::Result<()> {
        disk::remove(file)
    }

    fn answer(&self, source: &mut Source) -> io::Result<()> {
        standard_output::check()?;
        answers(false);
        let mut out = BufWriter::new(io::stdout().lock());
        source(&mut out)?;
        let done = out.flush();
        answers(true);
        done
    }

    /// A message that cannot be written is lost, because there is no other place for it.
    fn message(&self, text: &str) {
        let _ = writeln!(stderr(), "{}", text);
    }

    fn usage(&self, usage: &clap::Error) -> io::Result<()> {
        if !usage.use_stderr() {
            standard_output::check()?;
        }
        usage.print()
    }

    fn is_seen(&self) -> bool {
        io::stdout().is_terminal()
    }

    /// Width of the terminal, or `COLUMNS` if the answer goes to a pipe.
    fn columns(&self) -> Option<usize> {
        let out = io::stdout();
        let terminal = out.is_terminal().then(|| terminal_size_of(&out)).flatten();
        let columns = || std::env::var("COLUMNS").ok()?.trim().parse::<usize>().ok();
        // A terminal that does not know its size says 0.
        terminal.map(|(width, _)| usize::from(width.0)).or_else(columns).filter(|columns| *columns > 0)
    }

    fn shows_progress(&self) -> bool {
        let shows = stderr().is_terminal();
        if shows {
            line_stands(true);
        }
        shows
    }

    fn progress(&self, told: Option<(&str, Option<f64>)>) {
        let _ = match told {
            Some((line, _)) => write!(stderr(), "\r{line:WIDTH$}"),
            None => write!(stderr(), "\r{:WIDTH$}\r", ""),
        };
        line_stands(told.is_some());
    }

    fn hears(&self, hears: bool) {
        search_hears(hears);
    }

    fn asked_to_end(&self) -> Option<f64> {
        asked()
    }

    fn threads(&self) -> usize {
        std::thread::available_parallelism().map_or(1, usize::from)
    }

    fn seconds(&self) -> f64 {
        self.begun.elapsed().as_secs_f64()
    }
}
