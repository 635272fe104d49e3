//! Standard output that takes nothing: one that is closed, or open for reading alone.
//!
//! A write to either succeeds by the standard library, and the answer would be lost with exit code 0. Before
//! `main` the library also opens `/dev/null` in place of a closed stream, and a program that was given
//! `/dev/null` cannot be told from one that was given nothing. So standard output is looked at before that.

use std::io;
use std::path::Path;

/// Refuses standard output that takes nothing.
///
/// # Errors
/// Why it takes nothing.
#[cfg(unix)]
pub(crate) fn check() -> io::Result<()> {
    use std::fs::File;
    use std::io::Write as _;
    use std::os::fd::AsFd as _;
    use std::sync::atomic::Ordering;
    if at_start::WAS_CLOSED.load(Ordering::Relaxed) {
        return Err(io::Error::other("it is closed"));
    }
    // Nothing is written, and the system says whether something could be.
    File::from(io::stdout().as_fd().try_clone_to_owned()?).write(&[]).map(drop)
}

/// Other systems report a write that fails.
#[cfg(not(unix))]
pub(crate) fn check() -> io::Result<()> {
    Ok(())
}

/// Whether a file to write is standard output by another name.
pub(crate) fn is_name(file: &Path) -> bool {
    ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"].map(Path::new).contains(&file)
}

#[cfg(unix)]
mod at_start {
    use std::io;
    use std::os::fd::AsFd as _;
    use std::sync::atomic::{AtomicBool, Ordering};

    /// Whether standard output was closed when the program began.
    pub(super) static WAS_CLOSED: AtomicBool = AtomicBool::new(false);

    #[ctor::ctor(unsafe)]
    fn look() {
        WAS_CLOSED.store(io::stdout().as_fd().try_clone_to_owned().is_err(), Ordering::Relaxed);
    }
}
