//! Where in a file of a gearbox the fault is that an error names.

use super::DescriptionError;
use crate::document::Segment;
use crate::yaml::Value;
use crate::{Document, Error, Path, Problem};
use epicyclic_schemes::{Error as Engine, Named};

/// The lists whose entries may bear the name of a control.
const CONTROLS: [&str; 3] = ["brakes", "clutches", "elements"];

/// The error at its place in the document; `base` is the gearbox's own path, the root of a file with one.
///
/// ```
/// use epicyclic_formats::gearbox::{GearboxFile, located};
/// use epicyclic_formats::{Document, Path};
///
/// # fn main() -> Result<(), epicyclic_formats::Error> {
/// let text = b"gearbox: I\ninput: D\noutput: B\nrows:\n- { id: P, sun: D, ring: T1, carrier: B, k: 0.9 }\n";
/// let document = Document::parse_one("box.yaml", text)?;
/// let refused = document.read::<GearboxFile>()?.gearbox().unwrap_err();
/// let error = located(&document, &Path::root(), &refused);
/// assert!(error.to_string().starts_with("box.yaml:5:45: rows[0].k: k = 0.9 of row `P`"));
/// # Ok(())
/// # }
/// ```
#[must_use]
pub fn located(document: &Document, base: &Path, error: &DescriptionError) -> Error {
    let file = File { document, base };
    document.error(&file.place(error), Problem::Refused { message: error.to_string() })
}

struct File<'a> {
    document: &'a Document,
    base: &'a Path,
}

impl File<'_> {
    fn place(&self, error: &DescriptionError) -> Path {
        use DescriptionError as E;
        match error {
            E::RowKnownInOneWay { row } | E::Losses { row, .. } | E::Missing { row, .. } => self.row(row),
            E::Row { row, source } => {
                keys_of(source).iter().fold(self.row(row), |path, key| self.key(path, key))
            }
            E::Carrier { row, .. } => self.key(self.row(row), "carrier"),
            E::PlanetTeeth { row, .. } => self.key(self.row(row), "planet_teeth"),
            E::MemberInNoNode { row, member } => self.text(self.row(row), member),
            E::MemberInTwoNodes { member, second, .. } => {
                self.text(self.base.clone().key("nodes").key(second.as_str()), member)
            }
            E::Gearbox(error) => self.of_engine(error),
        }
    }

    fn of_engine(&self, error: &Engine) -> Path {
        match error {
            Engine::Unknown { name, place, .. } => self.text(self.named(place), name),
            Engine::GroundedTerminal { place } => self.text(self.named(place), epicyclic_schemes::GROUND),
            Engine::Duplicate { what, name } => match what {
                Named::Row => self.row(name),
                Named::Control => self.entry(&CONTROLS, name),
                Named::Gear => self.entry(&["gears"], name),
                _ => self.text(self.base.clone().key("links"), name),
            },
            Engine::CoincidentMembers { row, .. } | Engine::StepsMissing { row, .. } => self.row(row),
            Engine::RowParameter { row, .. } => {
                ["k", "teeth", "z_r"].iter().fold(self.row(row), |path, key| self.key(path, key))
            }
            Engine::ControlJoinsItself { control, .. } => self.entry(&CONTROLS, control),
            Engine::CyclicGrounds { first, .. } => {
                let places = ["ties", "grounds"].map(|key| self.text(self.base.clone().key(key), first));
                self.first_that_exists(places)
            }
            Engine::SharedMesh { second, .. } => {
                self.text(self.base.clone().key("shared_ring_meshes"), second)
            }
            _ => self.base.clone(),
        }
    }

    /// The entry that an error calls ``row `P1` ``, ``input of gear `1` `` or the like.
    fn named(&self, place: &str) -> Path {
        let name = place.split('`').nth(1).unwrap_or_default();
        let (what, _) = place.split_once('`').unwrap_or((place, ""));
        match what.trim() {
            "row" => self.row(name),
            "control" => self.entry(&CONTROLS, name),
            "gear" => self.key(self.entry(&["gears"], name), "engaged"),
            "input of gear" => self.key(self.entry(&["gears"], name), "input"),
            "output of gear" => self.key(self.entry(&["gears"], name), "output"),
            "a shared mesh" => self.base.clone().key("shared_ring_meshes"),
            terminal => self.key(self.base.clone(), terminal),
        }
    }

    fn row(&self, id: &str) -> Path {
        self.entry(&["rows"], id)
    }

    /// The last entry of these lists that bears a name: of two with one name, the one too many.
    fn entry(&self, lists: &[&str], name: &str) -> Path {
        let bears = |entry: &Value| ["id", "name"].iter().any(|key| text_of(entry.get(key)) == Some(name));
        for list in lists.iter().rev() {
            let path = self.base.clone().key(*list);
            match self.document.value_at(&path) {
                Some(Value::Sequence(entries)) => {
                    if let Some(index) = entries.iter().rposition(bears) {
                        return path.index(index);
                    }
                }
                Some(Value::Mapping(entries)) if entries.contains_key(name) => return path.key(name),
                _ => {}
            }
        }
        self.base.clone()
    }

    /// The value of a key, where there is one.
    fn key(&self, path: Path, key: &str) -> Path {
        let inner = path.clone().key(key);
        if self.document.value_at(&inner).is_some() { inner } else { path }
    }

    /// Where a text stands within an entry.
    fn text(&self, path: Path, text: &str) -> Path {
        let found = self.document.value_at(&path).and_then(|value| find(value, text));
        let extend = |path: Path, segment: Segment| match segment {
            Segment::Key(key) => path.key(key),
            Segment::Index(index) => path.index(index),
        };
        found.unwrap_or_default().into_iter().rev().fold(path, extend)
    }

    fn first_that_exists(&self, paths: [Path; 2]) -> Path {
        let exists = |path: &Path| self.document.value_at(path).is_some_and(|value| value.as_str().is_some());
        paths.into_iter().find(exists).unwrap_or_else(|| self.base.clone())
    }
}

/// The keys of a row that may hold what a gear refuses.
fn keys_of(error: &epicyclic_gears::Error) -> &'static [&'static str] {
    use epicyclic_gears::Error as E;
    match error {
        E::Efficiency { .. } | E::EfficiencyTooSmall { .. } => &["efficiency", "meshes"],
        E::NoTeeth => &["teeth"],
        E::NotPositive { quantity, .. } | E::OutOfRange { quantity, .. } => match *quantity {
            "module" => &["module"],
            "radius of the planets' centres" => &["carrier_radius"],
            "face width" | "width" => &["face_width"],
            "bore of a planet" | "bore diameter" => &["planet_bore"],
            "mass of a planet" => &["planet_mass"],
            "capacity of the bearing" => &["bearing_capacity"],
            _ => &[],
        },
        _ => &[],
    }
}

fn text_of(value: Option<&Value>) -> Option<&str> {
    value.and_then(Value::as_str)
}

/// The way to a text within a value, last step first.
fn find(value: &Value, text: &str) -> Option<Vec<Segment>> {
    let step = |inner: &Value, segment: Segment| {
        let mut way = find(inner, text)?;
        way.push(segment);
        Some(way)
    };
    match value {
        Value::String(found) => (found == text).then(Vec::new),
        Value::Sequence(entries) => {
            entries.iter().enumerate().find_map(|(index, entry)| step(entry, Segment::Index(index)))
        }
        Value::Mapping(entries) => {
            entries.iter().find_map(|(key, entry)| step(entry, Segment::Key(key.as_str()?.to_owned())))
        }
        _ => None,
    }
}
