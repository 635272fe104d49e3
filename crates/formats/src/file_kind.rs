//! Kinds of files, recognized by their keys.

use crate::{Document, Error, Path, Problem};

/// Kind of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FileKind {
    /// A gearbox.
    Gearbox,
    /// A list of published gearboxes.
    Transmissions,
    /// A motion to simulate.
    Scenario,
    /// A drive whose planetary set is designed.
    Drive,
    /// A hydromotor.
    Motor,
}

impl FileKind {
    /// Name of the kind with its article.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Gearbox => "a gearbox",
            Self::Transmissions => "a list of transmissions",
            Self::Scenario => "a scenario",
            Self::Drive => "a drive",
            Self::Motor => "a hydromotor",
        }
    }

    /// The commands that take such a file, besides `report`, as messages name them.
    #[must_use]
    pub const fn commands(self) -> &'static str {
        match self {
            Self::Gearbox | Self::Transmissions => "`analyze`",
            Self::Scenario => "`simulate`",
            Self::Drive => "`drive`",
            Self::Motor => "`motor`, `draw`",
        }
    }
}

impl Document {
    /// Kind of the file by its first keys; `None` if they belong to no file that the program reads.
    #[must_use]
    pub fn kind(&self) -> Option<FileKind> {
        let has = |key: &str| self.value().get(key).is_some();
        let is_map = |key: &str| self.value().get(key).is_some_and(crate::yaml::Value::is_mapping);
        if has("scenario") || has("gearbox_file") || is_map("gearbox") {
            Some(FileKind::Scenario)
        } else if has("gearbox") {
            Some(FileKind::Gearbox)
        } else if has("transmissions") {
            Some(FileKind::Transmissions)
        } else if has("power") {
            Some(FileKind::Drive)
        } else if has("stator") || has("rotor") {
            Some(FileKind::Motor)
        } else {
            None
        }
    }

    /// Refuses a file that describes something else than required; the message says which commands read it.
    ///
    /// # Errors
    /// [`Problem::Refused`] at the beginning of the document. What describes nothing known is left to whoever
    /// reads its keys.
    pub fn must_be(&self, due: FileKind) -> Result<(), Error> {
        match self.kind() {
            Some(other) if other != due => {
                let (is, reads, due) = (other.name(), other.commands(), due.name());
                let message = format!("this is {is}, which {reads} and `report` read; {due} is due");
                Err(self.error(&Path::root(), Problem::refused("other-kind-of-file", message)))
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_what_its_keys_say() {
        let kind = |text: &str| Document::parse_one("x.yaml", text.as_bytes()).unwrap().kind();
        assert_eq!(kind("gearbox: x\nsets: []"), Some(FileKind::Gearbox));
        assert_eq!(kind("transmissions: []"), Some(FileKind::Transmissions));
        assert_eq!(kind("scenario: x\ngearbox: { gearbox: y }"), Some(FileKind::Scenario));
        assert_eq!(kind("gearbox: { gearbox: y }"), Some(FileKind::Scenario));
        assert_eq!(kind("gearbox_file: y.yaml"), Some(FileKind::Scenario));
        assert_eq!(kind("power: 1 kW"), Some(FileKind::Drive));
        assert_eq!(kind("rotor: 3"), Some(FileKind::Motor));
        assert_eq!(kind("[1, 2]"), None);
        assert_eq!(kind("sets: []"), None);
    }

    #[test]
    fn another_file_is_refused_with_who_reads_it() {
        let document = Document::parse_one("x.yaml", b"# a shift\nscenario: x").unwrap();
        assert!(document.must_be(FileKind::Scenario).is_ok());
        let refused = document.must_be(FileKind::Gearbox).unwrap_err().to_string();
        assert_eq!(
            refused,
            "x.yaml:2:1: this is a scenario, which `simulate` and `report` read; a gearbox is due"
        );
        assert!(Document::parse_one("x.yaml", b"sets: []").unwrap().must_be(FileKind::Gearbox).is_ok());
    }
}
