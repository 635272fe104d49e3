//! Long calculations outside Python's lock, with reports of progress and response to Ctrl-C.
//!
//! A forked process has the memory of its parent and none of its threads. Work there needs a pool of its own,
//! because the shared pool would never answer.

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::Duration;
use std::{process, thread};

/// Interval between checks for signals.
const LOOK: Duration = Duration::from_millis(50);
/// Time that work may go on after it was asked to end; then it is abandoned.
const PATIENCE: Duration = Duration::from_secs(2);
/// Searches and readers recurse; a thread of its own has less than the main one otherwise.
const STACK: usize = 16 << 20;

/// The process that loaded the module.
static LOADED_BY: OnceLock<u32> = OnceLock::new();

/// Remembers the process that loads the module.
pub(crate) fn loaded() {
    LOADED_BY.get_or_init(process::id);
}

/// Threads for one piece of work, in a process that was forked from the one that loaded the module.
fn pool_after_fork() -> PyResult<Option<ThreadPool>> {
    if LOADED_BY.get() == Some(&process::id()) {
        return Ok(None);
    }
    let pool = ThreadPoolBuilder::new().stack_size(STACK).build();
    pool.map(Some).map_err(|error| PyRuntimeError::new_err(format!("no threads for a calculation: {error}")))
}

/// State shared by the work and the thread that waits for it.
#[derive(Debug, Default)]
pub(crate) struct Shared {
    ended: AtomicBool,
    progress: Mutex<Option<String>>,
}

impl Shared {
    /// Whether the work is asked to end.
    pub(crate) fn is_ended(&self) -> bool {
        self.ended.load(Ordering::Relaxed)
    }

    /// Stores a line about the progress of the work.
    pub(crate) fn tell(&self, progress: String) {
        *self.progress.lock().unwrap_or_else(PoisonError::into_inner) = Some(progress);
    }

    fn told(&self) -> Option<String> {
        self.progress.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

/// Does work on a thread of its own, without Python's lock.
///
/// `progress` is called with a line of text whenever there is a new one. An exception of it, or of a signal,
/// asks the work to end; what does not is left to itself, and its result is dropped.
pub(crate) fn done<T: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Shared) -> T + Send + 'static,
) -> PyResult<T> {
    let shared = Arc::new(Shared::default());
    let (sender, mut receiver) = channel();
    let own = Arc::clone(&shared);
    let pool = pool_after_fork()?;
    let run = move || {
        let result = match pool {
            Some(pool) => pool.install(|| work(&own)),
            None => work(&own),
        };
        // Nobody waits for the result of work that was left to itself.
        drop(sender.send(result));
    };
    thread::Builder::new().stack_size(STACK).spawn(run).map_err(PyErr::from)?;
    loop {
        let (found, back) = wait(py, receiver, LOOK);
        receiver = back;
        let asked = match found {
            Ok(found) => return Ok(found),
            Err(RecvTimeoutError::Timeout) => py.check_signals().and_then(|()| {
                let Some((callback, line)) = progress.zip(shared.told()) else { return Ok(()) };
                callback.call1((line,)).map(|_| ())
            }),
            Err(RecvTimeoutError::Disconnected) => Err(PyRuntimeError::new_err(
                "a calculation ended without a result; this is an error of epicyclic",
            )),
        };
        if let Err(asked) = asked {
            shared.ended.store(true, Ordering::Relaxed);
            drop(wait(py, receiver, PATIENCE));
            return Err(asked);
        }
    }
}

type Waited<T> = (Result<T, RecvTimeoutError>, Receiver<T>);

fn wait<T: Send>(py: Python<'_>, receiver: Receiver<T>, time: Duration) -> Waited<T> {
    py.detach(move || (receiver.recv_timeout(time), receiver))
}
