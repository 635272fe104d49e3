//! Modules of teeth, which are read as lengths or as diametral pitches, and kept as lengths.

use epicyclic_units::{Module, Quantity};
use serde::{Deserialize, Deserializer};
use uom::si::f64::Length;

fn length(module: Quantity<Module>) -> Quantity<Length> {
    Quantity(module.0.length())
}

/// Reads a module.
pub(crate) fn one<'de, D: Deserializer<'de>>(reader: D) -> Result<Quantity<Length>, D::Error> {
    Quantity::deserialize(reader).map(length)
}

/// Reads a module that may be left out.
pub(crate) fn optional<'de, D: Deserializer<'de>>(reader: D) -> Result<Option<Quantity<Length>>, D::Error> {
    Option::deserialize(reader).map(|module| module.map(length))
}

/// Reads a list of modules that may be left out.
pub(crate) fn list<'de, D: Deserializer<'de>>(reader: D) -> Result<Option<Vec<Quantity<Length>>>, D::Error> {
    let modules: Option<Vec<_>> = Option::deserialize(reader)?;
    Ok(modules.map(|modules| modules.into_iter().map(length).collect()))
}

#[cfg(test)]
mod tests {
    use crate::Document;
    use crate::gearbox::GearboxFile;

    fn read(text: &str) -> Result<(), crate::Error> {
        Document::parse_one("box.yaml", text.as_bytes())?.read::<GearboxFile>().map(drop)
    }

    /// Every length in millimetres of a file that has every key is replaced in turn.
    #[test]
    fn a_diametral_pitch_is_read_of_modules_alone() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/every-gearbox-key.yaml");
        let text = std::fs::read_to_string(file).unwrap();
        read(&text).unwrap();
        let (mut modules, mut lengths) = (0, 0);
        for (end, _) in text.match_indices(" mm") {
            let rest = &text[end + " mm".len()..];
            let line = text[..end].rfind('\n').map_or(0, |at| at + 1);
            let start = text[..end].rfind(|c: char| !c.is_ascii_digit() && c != '.' && c != '-').unwrap() + 1;
            if text[line..start].contains('#') || rest.starts_with(['²', '/', '2']) {
                continue;
            }
            let before = text[line..start].trim_end_matches([' ', '[']);
            let key = before.rsplit([' ', '{']).find(|word| word.ends_with(':')).unwrap();
            let changed = format!("{}8 DP{rest}", &text[..start]);
            let is_module = matches!(key, "module:" | "modules:");
            match read(&changed) {
                Ok(()) => assert!(is_module, "{key}"),
                Err(error) => {
                    assert!(!is_module, "{key} {error}");
                    assert_eq!(error.name(), "wrong-dimension", "{key} {error}");
                    assert!(
                        error.to_string().contains("DP is a unit of module, and a length is due"),
                        "{error}"
                    );
                }
            }
            *if is_module { &mut modules } else { &mut lengths } += 1;
        }
        assert!(modules >= 3 && lengths >= 20, "{modules} {lengths}");
    }
}
