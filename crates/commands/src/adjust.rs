//! The numbers of a gearbox's file that can be changed while one looks on: `k` or teeth of its sets, each
//! with its place.

use crate::answer::Answer;
use crate::shared::gearbox::Gearbox;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Numbers that can be changed in a gearbox file.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Adjustable {
    /// Numbers of its sets, in the order of the file.
    pub numbers: Vec<AdjustableNumber>,
}

impl Answer for Adjustable {
    const NAME: &'static str = "adjust";
}

/// A number of a set in a file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AdjustableNumber {
    /// Name of the set.
    pub set: String,
    /// Quantity that the number gives.
    pub of: AdjustableKind,
    /// Present value.
    pub value: f64,
    /// Number as written in the file.
    pub text: String,
    /// Line of the file, from 1.
    pub line: usize,
    /// Column in that line, in characters from 1.
    pub column: usize,
}

/// Quantity that an adjustable number gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AdjustableKind {
    /// Basic ratio `k`.
    K,
    /// Teeth of the sun, or of the first central gear.
    SunTeeth,
    /// Teeth of the ring, or of the second central gear.
    RingTeeth,
}

impl AdjustableKind {
    /// Name for messages.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::K => "k",
            Self::SunTeeth => "teeth of the sun",
            Self::RingTeeth => "teeth of the ring",
        }
    }
}

/// The `k` and teeth of all sets that are written in short.
#[must_use]
pub fn answer(subject: &Gearbox) -> Adjustable {
    let document = &subject.document;
    let sets = subject.base.clone().key("sets");
    let count = document.value_at(&sets).and_then(|sets| sets.as_sequence()).map_or(0, Vec::len);
    let mut numbers = vec![];
    for place in 0..count {
        let set = sets.clone().index(place);
        let Some(id) = document.text_at(&set.clone().key("id")) else { continue };
        let teeth = |index: usize| set.clone().key("teeth").index(index);
        let keyed = |key: &str| set.clone().key(key);
        let places = [
            (AdjustableKind::K, keyed("k")),
            (AdjustableKind::SunTeeth, teeth(0)),
            (AdjustableKind::RingTeeth, teeth(1)),
            (AdjustableKind::SunTeeth, keyed("z_s")),
            (AdjustableKind::RingTeeth, keyed("z_r")),
            (AdjustableKind::SunTeeth, keyed("z_a")),
            (AdjustableKind::RingTeeth, keyed("z_b")),
        ];
        numbers.extend(places.into_iter().filter_map(|(of, path)| {
            let (value, text) = (document.value_at(&path)?.as_f64()?, document.text_at(&path)?);
            let at = document.position(&path);
            let (set, text) = (id.to_owned(), text.to_owned());
            Some(AdjustableNumber { set, of, value, text, line: at.line, column: at.column })
        }));
    }
    Adjustable { numbers }
}

/// Returns the file's text with the number replaced by `to`; `None` if the number is not at its recorded
/// place.
#[must_use]
pub fn changed(file: &str, number: &AdjustableNumber, to: &str) -> Option<String> {
    let mut lines: Vec<String> = file.split_inclusive('\n').map(str::to_owned).collect();
    let line = lines.get_mut(number.line.checked_sub(1)?)?;
    let start = line.char_indices().nth(number.column.checked_sub(1)?)?.0;
    let end = start + number.text.len();
    if line.get(start..end)? != number.text {
        return None;
    }
    line.replace_range(start..end, to);
    Some(lines.concat())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::gearbox::{Choice, one};
    use epicyclic_formats::Document;

    const FILE: &str = "# ü\ngearbox: g\ninput: D\noutput: B\nsets:\n  - { id: P, sun: D, ring: T, carrier: B, k: 2.940 }\n  - id: Q\n    sun: T\n    \
                        ring: E\n    carrier: B\n    teeth: [24, 72]\nbrakes: [{ id: K, link: E }]\ngears: [{ name: '1', engaged: [K] }]\n";

    fn numbers(file: &str) -> Vec<AdjustableNumber> {
        let document = Document::parse_one("g.yaml", file.as_bytes()).unwrap();
        answer(&one(&document, &Choice::default()).unwrap()).numbers
    }

    #[test]
    fn a_changed_number_is_read_back_and_nothing_else_changes() {
        let before = numbers(FILE);
        let kinds: Vec<_> = before.iter().map(|number| (number.set.as_str(), number.of)).collect();
        let expected =
            [("P", AdjustableKind::K), ("Q", AdjustableKind::SunTeeth), ("Q", AdjustableKind::RingTeeth)];
        assert_eq!(kinds, expected);
        let text = changed(FILE, &before[0], "3.1").unwrap();
        assert_eq!(text, FILE.replace("2.940", "3.1"));
        assert_eq!(numbers(&text)[0].value, 3.1);
        let text = changed(FILE, &before[2], "75").unwrap();
        assert_eq!(text, FILE.replace("72", "75"));
    }

    #[test]
    fn a_number_that_stands_elsewhere_is_not_changed() {
        let number = &numbers(FILE)[0];
        assert_eq!(changed(&FILE.replace("# ü\n", ""), number, "3"), None);
        assert_eq!(changed("", number, "3"), None);
    }
}
