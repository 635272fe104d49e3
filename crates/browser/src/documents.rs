//! The file that was read last: the next question is mostly about the same text.

use crate::reply::{Failure, refused};
use epicyclic_formats::{Document, Position};
use std::cell::RefCell;
use std::rc::Rc;

thread_local! {
    static LAST: RefCell<Option<([String; 2], Rc<Document>)>> = const { RefCell::new(None) };
}

/// A file, read.
pub(crate) fn of(name: &str, file: &str) -> Result<Rc<Document>, Failure> {
    LAST.with_borrow_mut(|last| {
        if let Some((known, document)) = last
            && *known == [name, file]
        {
            return Ok(Rc::clone(document));
        }
        let document = Document::parse_one(name, file.as_bytes()).map_err(|error| refused(error.into()))?;
        let (_, document) = last.insert(([name, file].map(str::to_owned), Rc::new(document)));
        Ok(Rc::clone(document))
    })
}

/// Reuses the parsed document for a text in which only numbers have changed.
///
/// `numbers` gives the position and the new text of each, from the last in the file to the first. If one of
/// them cannot be replaced, the next question parses the text anew.
pub(crate) fn take_over(name: &str, file: &str, changed: &str, numbers: &[(Position, &str)]) {
    LAST.with_borrow_mut(|last| {
        // Half changed it would be of no text: then the next question reads it anew.
        *last = last.take().filter(|(known, _)| *known == [name, file]).and_then(|(_, document)| {
            let mut document = Rc::try_unwrap(document).ok()?;
            let are_all = numbers.iter().all(|(at, to)| document.renumber(*at, to));
            are_all.then(|| ([name, changed].map(str::to_owned), Rc::new(document)))
        });
    });
}
