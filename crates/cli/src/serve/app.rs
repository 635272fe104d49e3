//! The files of the app: in the program, or in a folder.

use super::http::Reply;
use epicyclic_commands::failure::Failure;
use std::fs;
use std::path::{Path, PathBuf};

/// Page for a request without a path.
const PAGE: &str = "index.html";

/// Files with their names, compressed by gzip.
#[cfg(feature = "app")]
const BUILT_IN: &[(&str, &[u8])] = include!(concat!(env!("OUT_DIR"), "/app.rs"));
#[cfg(not(feature = "app"))]
const BUILT_IN: &[(&str, &[u8])] = &[];

/// The app.
pub(super) enum App {
    /// App that is built into the program.
    BuiltIn,
    /// App in a folder, with the names of its files; nothing else of the disk is served.
    Folder(PathBuf, Vec<String>),
}

impl App {
    /// App of a folder, or the one in the program.
    pub(super) fn of(folder: Option<&Path>) -> Result<Self, Failure> {
        let refuse = |message: String| Failure::invalid("--app", message);
        let Some(folder) = folder else {
            let is_there = !BUILT_IN.is_empty();
            return is_there.then_some(Self::BuiltIn).ok_or_else(|| {
                refuse(
                    "this program was built without the app; scripts/web build makes it in target/app, for --app target/app, and the feature \
                     `app` builds it in"
                        .to_owned(),
                )
            });
        };
        let unread = |source| Failure::Read { file: folder.to_owned(), source };
        let mut names = vec![];
        for entry in fs::read_dir(folder).map_err(unread)? {
            let entry = entry.map_err(unread)?;
            if entry.file_type().map_err(unread)?.is_file() {
                names.extend(entry.file_name().into_string());
            }
        }
        if !names.iter().any(|name| name == PAGE) {
            return Err(refuse(format!(
                "{}: there is no {PAGE} in it; scripts/web build leaves the app in target/app",
                folder.display()
            )));
        }
        Ok(Self::Folder(folder.to_owned(), names))
    }

    /// Reply with a file of the app and this media type; the built-in one remains compressed for clients that
    /// accept it.
    pub(super) fn reply(&self, name: &str, kind: &'static str, takes_gzip: bool) -> Option<Reply> {
        match self {
            Self::BuiltIn => {
                let (_, packed) = BUILT_IN.iter().find(|(of, _)| *of == name)?;
                if takes_gzip {
                    return Some(Reply::packed(packed.to_vec(), kind));
                }
                unpacked(packed).map(|bytes| Reply::of(bytes, kind))
            }
            Self::Folder(folder, names) => {
                let name = names.iter().find(|of| *of == name)?;
                fs::read(folder.join(name)).ok().map(|bytes| Reply::of(bytes, kind))
            }
        }
    }
}

#[cfg(feature = "app")]
fn unpacked(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut file = vec![];
    std::io::Read::read_to_end(&mut flate2::read::GzDecoder::new(bytes), &mut file).ok()?;
    Some(file)
}

#[cfg(not(feature = "app"))]
fn unpacked(_: &[u8]) -> Option<Vec<u8>> {
    None
}
