//! The file that was read last: the next question is mostly about the same text.

use crate::reply::{Failure, refused};
use epicyclic_formats::Document;
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
