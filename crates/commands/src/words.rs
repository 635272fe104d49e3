//! Requests from the words of a command line, for a library that fills in few of their many fields.

use clap::{ArgMatches, Args, Command};
use std::ffi::OsString;

/// The request that these words make; what they leave out has the values that the command line has without
/// it.
///
/// ```
/// use epicyclic_commands::select::Request;
/// use epicyclic_commands::words::request;
///
/// let request = Request { nth: 2, ..request(["--speeds", "0.8 m/s, 3.15 m/s"])? };
/// let found = request.answer()?;
/// assert_eq!((found.accepted, found.shown_in_full), (2, Some(2)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// What clap says of the words: an option that there is not, is missing, or cannot have its value.
pub fn request<R: Args>(
    words: impl IntoIterator<Item = impl Into<OsString> + Clone>,
) -> Result<R, clap::Error> {
    let mut command = R::augment_args(Command::new("request").no_binary_name(true));
    let matches: ArgMatches = command.try_get_matches_from_mut(words)?;
    R::from_arg_matches(&matches).map_err(|error| error.format(&mut command))
}
