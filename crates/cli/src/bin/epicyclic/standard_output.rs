//! Standard output that accepts nothing: closed, or open for reading only.
//!
//! A write to either succeeds in the standard library, so the answer would be lost with exit code 0. Before
//! `main` the library also opens `/dev/null` instead of a closed stream. After that, a closed stream cannot
//! be distinguished from a real `/dev/null`, so standard output is checked before.

use std::io;
use std::path::Path;

/// Refuses standard output that accepts nothing.
///
/// # Errors
/// The reason why standard output accepts nothing.
#[cfg(unix)]
pub(crate) fn check() -> io::Result<()> {
    use std::fs::File;
    use std::io::Write as _;
    use std::os::fd::AsFd as _;
    use std::sync::atomic::Ordering;
    if at_start::WAS_CLOSED.load(Ordering::Relaxed) {
        return Err(io::Error::other("it is closed"));
    }
    // Writing zero bytes has no effect, but the system reports whether the stream can be written.
    File::from(io::stdout().as_fd().try_clone_to_owned()?).write(&[]).map(drop)
}

/// Other systems report a write that fails.
#[cfg(not(unix))]
pub(crate) fn check() -> io::Result<()> {
    Ok(())
}

/// Whether an output file is another name of standard output.
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
