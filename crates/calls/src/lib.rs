//! The words of a command line, with files in memory: what the program answers, a page in a browser gets.

use epicyclic::desk::{Content, NotWritten, Source, Text};
use epicyclic::{Desk, Memory};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    /// Milliseconds since the page began.
    #[wasm_bindgen(js_namespace = performance, js_name = now)]
    fn now() -> f64;

    /// Takes the progress of a search: its line and the share that is done, below 0 where it is not known.
    #[wasm_bindgen(js_name = epicyclicProgress)]
    fn told(line: &str, share: f64);
}

/// A desk in memory whose progress goes to the page.
struct Page(Memory);

impl Desk for Page {
    fn read(&self, file: Option<&Path>, most: u64) -> io::Result<Text> {
        self.0.read(file, most)
    }

    fn exists(&self, file: &Path) -> bool {
        self.0.exists(file)
    }

    fn are_one_file(&self, one: &Path, other: &Path) -> bool {
        self.0.are_one_file(one, other)
    }

    fn write(&self, files: &[Content], streamed: Option<(&Path, &mut Source)>) -> Result<(), NotWritten> {
        self.0.write(files, streamed)
    }

    fn make_folder(&self, folder: &Path) -> io::Result<()> {
        self.0.make_folder(folder)
    }

    fn remove(&self, file: &Path) -> io::Result<()> {
        self.0.remove(file)
    }

    fn answer(&self, source: &mut Source) -> io::Result<()> {
        self.0.answer(source)
    }

    fn message(&self, text: &str) {
        self.0.message(text);
    }

    fn shows_progress(&self) -> bool {
        true
    }

    fn progress(&self, progress: Option<(&str, Option<f64>)>) {
        if let Some((line, share)) = progress {
            told(line, share.unwrap_or(-1.0));
        }
    }

    fn seconds(&self) -> f64 {
        self.0.seconds()
    }
}

/// Result of a call: exit code, standard output, messages and written files.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Called {
    code: u8,
    answer: String,
    messages: String,
    written: Vec<(String, Vec<u8>)>,
}

#[wasm_bindgen]
impl Called {
    /// The exit code of the program.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn code(&self) -> u8 {
        self.code
    }

    /// Text that the program writes to standard output.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn answer(&self) -> String {
        self.answer.clone()
    }

    /// Messages of the program apart from the answer.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn messages(&self) -> String {
        self.messages.clone()
    }

    /// Names of the files that the program wrote.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn written(&self) -> Vec<String> {
        self.written.iter().map(|(name, _)| name.clone()).collect()
    }

    /// Content of a written file, by its index in `written`.
    #[must_use]
    pub fn file(&self, place: usize) -> Option<Vec<u8>> {
        self.written.get(place).map(|(_, content)| content.clone())
    }
}

/// Answers a command line: its words without the name of the program, and the files that it may read, names
/// and texts.
#[wasm_bindgen]
#[must_use]
pub fn call(line: Vec<String>, names: Vec<String>, texts: Vec<String>) -> Called {
    let texts = texts.into_iter().map(String::into_bytes);
    let files: BTreeMap<PathBuf, Vec<u8>> = names.into_iter().map(PathBuf::from).zip(texts).collect();
    let desk = Page(Memory::new(files, Some(|| now() / 1000.0)));
    let code = epicyclic::call(line, &desk);
    let kept = desk.0.into_kept();
    let written = kept
        .written
        .iter()
        .filter_map(|name| Some((name.display().to_string(), kept.files.get(name)?.clone())));
    Called {
        code,
        written: written.collect(),
        answer: String::from_utf8_lossy(&kept.answer).into_owned(),
        messages: kept.messages.join("\n"),
    }
}
