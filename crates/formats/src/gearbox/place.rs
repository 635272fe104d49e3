//! Where in a file of a gearbox the fault is that an error names.

use super::{DescriptionError, ToolMisfit};
use crate::document::Segment;
use crate::yaml::Value;
use crate::{Document, Error, Path, Problem};
use epicyclic_gears::Quantity;
use epicyclic_train::{CompoundFault, DragFault, Error as SolverError, Named, Place, Terminal};

/// The lists whose entries may bear the name of a shift element.
const SHIFT_ELEMENTS: [&str; 4] = ["brakes", "clutches", "shift_elements", "one_way"];

/// The lists whose entries may bear the name of a set.
const SETS: [&str; 2] = ["sets", "compound_sets"];

/// The error at its place in the document; `base` is the gearbox's own path, the root of a file with one.
///
/// ```
/// use epicyclic_formats::gearbox::{GearboxFile, located};
/// use epicyclic_formats::{Document, Path};
///
/// # fn main() -> Result<(), epicyclic_formats::Error> {
/// let text = b"gearbox: I\ninput: D\noutput: B\nsets:\n- { id: P, sun: D, ring: T1, carrier: B, k: 0.9 }\n";
/// let document = Document::parse_one("box.yaml", text)?;
/// let refused = document.read::<GearboxFile>()?.gearbox().unwrap_err();
/// let error = located(&document, &Path::root(), &refused);
/// assert!(error.to_string().starts_with("box.yaml:5:45: sets[0].k: k = 0.9 of set `P`"));
/// # Ok(())
/// # }
/// ```
#[must_use]
pub fn located(document: &Document, base: &Path, error: &DescriptionError) -> Error {
    let file = File { document, base };
    document.error(&file.place(error), Problem::Refused { message: error.to_string() })
}

/// The place of a key of a gear, of a gear that has it; else the gear's.
#[must_use]
pub fn gear_place(document: &Document, base: &Path, gear: &str, key: &str) -> Path {
    let file = File { document, base };
    file.key(file.entry(&["gears"], gear), key)
}

struct File<'a> {
    document: &'a Document,
    base: &'a Path,
}

impl File<'_> {
    fn place(&self, error: &DescriptionError) -> Path {
        use DescriptionError as E;
        match error {
            E::RowKnownInOneWay { set } | E::Losses { set, .. } | E::Missing { set, .. } => self.set(set),
            E::Set { set, source } => {
                keys_of(source).iter().fold(self.set(set), |path, key| self.key(path, key))
            }
            E::Carrier { set, .. } => self.key(self.set(set), "carrier"),
            E::LossesTwice { set } | E::Friction { set } => self.key(self.set(set), "friction"),
            E::Rack(error) => self.key(
                self.base.clone(),
                if matches!(error, epicyclic_gears::Error::OutOfRange { .. }) {
                    "pressure_angle"
                } else {
                    "addendum"
                },
            ),
            E::ToolsOfKind { set } => self.key(self.set(set), "tools"),
            E::Tools { set, source } => {
                let path = ["tools", "strength"].iter().fold(self.set(set), |path, key| self.key(path, key));
                let keys = if matches!(source, ToolMisfit::Invalid(_)) {
                    ["ring", "shaper"]
                } else {
                    ["ring", "ring"]
                };
                keys.iter().fold(path, |path, key| self.key(path, key))
            }
            E::HelixAngle { set } => self.key(self.set(set), "helix_angle"),
            E::Shifts { set } => {
                let keys = ["tip_alterations", "profile_shifts"];
                keys.iter().fold(self.set(set), |path, key| self.key(path, key))
            }
            E::Values { set, key, .. } => self.key(self.set(set), key),
            E::SpacingTwice { set } => self.spacing(set),
            E::PlanetTeeth { set, .. } => self.key(self.set(set), "planet_teeth"),
            E::MemberInNoLink { set, member } => self.text(self.set(set), member),
            E::NoSuchPlanet { set, planet } => self.key(self.key(self.set(set), "planet_sizes"), planet),
            E::Clutch { clutch } => self.entry(&SHIFT_ELEMENTS, clutch),
            E::MemberInTwoLinks { member, second, .. } => {
                self.text(self.base.clone().key("links").key(second.as_str()), member)
            }
            E::Gearbox(error) => self.of_engine(error),
        }
    }

    fn of_engine(&self, error: &SolverError) -> Path {
        match error {
            SolverError::Unknown { name, place, .. } => self.text(self.named(place), name),
            SolverError::GroundedTerminal { place } => self.text(self.named(place), epicyclic_train::GROUND),
            SolverError::Duplicate { what, name } => match what {
                Named::Set => self.set(name),
                Named::ShiftElement => self.entry(&SHIFT_ELEMENTS, name),
                Named::Gear => self.entry(&["gears"], name),
                Named::Drag => self.entry(&["drags"], name),
                _ => self.text(self.base.clone().key("links"), name),
            },
            SolverError::CoincidentMembers { set, .. }
            | SolverError::StepsMissing { set, .. }
            | SolverError::BasicRatio { set, .. } => self.set(set),
            SolverError::RingToSunRatio { set, .. } => {
                ["k", "teeth", "z_r"].iter().fold(self.set(set), |path, key| self.key(path, key))
            }
            SolverError::PlanetCount { set, .. } => self.key(self.set(set), "planets"),
            SolverError::Spacing { set, .. } => self.spacing(set),
            SolverError::Compound { set, fault } => self.of_compound(set, fault),
            SolverError::TooMany { what, limit, .. } => self.beyond(*what, *limit),
            SolverError::Drag { drag, fault } => self.of_drag(drag, fault),
            SolverError::NoSets => self.key(self.base.clone(), "sets"),
            SolverError::ShiftElementJoinsItself { shift_element, .. } => {
                self.entry(&SHIFT_ELEMENTS, shift_element)
            }
            SolverError::CyclicGrounds { first, .. } => {
                let places = ["ties", "grounds"].map(|key| self.text(self.base.clone().key(key), first));
                self.first_that_exists(places)
            }
            _ => self.base.clone(),
        }
    }

    /// The entry of what names something.
    fn named(&self, place: &Place) -> Path {
        let terminal = |terminal: Terminal| match terminal {
            Terminal::Input => "input",
            Terminal::Output => "output",
        };
        match place {
            Place::Set(id) => self.set(id),
            Place::ShiftElement(id) => self.entry(&SHIFT_ELEMENTS, id),
            Place::Gear(name) => self.key(self.entry(&["gears"], name), "engaged"),
            Place::TerminalOf(which, gear) => self.key(self.entry(&["gears"], gear), terminal(*which)),
            Place::Drag(name) => self.entry(&["drags"], name),
            Place::Terminal(which) => self.key(self.base.clone(), terminal(*which)),
            _ => self.base.clone(),
        }
    }

    fn set(&self, id: &str) -> Path {
        self.entry(&SETS, id)
    }

    /// The key that says where the planets of a set stand.
    fn spacing(&self, id: &str) -> Path {
        let keys = ["spacing", "planet_angles", "vibration", "planet_angles"];
        keys.iter().fold(self.set(id), |path, key| self.key(path, key))
    }

    /// A drag of the gearbox, or that of a shift element.
    fn of_drag(&self, name: &str, fault: &DragFault) -> Path {
        let entry = self.entry(&["drags"], name);
        if let DragFault::OneLink { .. } = fault {
            return self.key(entry, "between");
        }
        let keys = [(entry, "curve"), (self.entry(&SHIFT_ELEMENTS, name), "drag")];
        let exists = |(path, key): &(Path, &str)| self.document.value_at(&path.clone().key(*key)).is_some();
        let Some((path, key)) = keys.into_iter().find(exists) else { return self.base.clone() };
        let curve = path.key(key);
        match fault {
            DragFault::Speed { place, .. } | DragFault::NotAscending { place } => {
                curve.key("speeds").index(*place)
            }
            DragFault::Torque { place, .. } => curve.key("torques").index(*place),
            DragFault::Outside { .. } => self.key(curve, "speeds"),
            _ => curve,
        }
    }

    fn of_compound(&self, set: &str, fault: &CompoundFault) -> Path {
        let path = self.set(set);
        match fault {
            CompoundFault::NoTeeth { gear }
            | CompoundFault::NotWhole { gear, .. }
            | CompoundFault::Proportion { gear, .. }
            | CompoundFault::NameTwice { name: gear } => self.part_of_set(path, &gear.of),
            CompoundFault::PlanetGears { planet: name, .. }
            | CompoundFault::PlanetTeeth { planet: name }
            | CompoundFault::TwoShafts { name, .. }
            | CompoundFault::Apart { name } => self.part_of_set(path, name),
            CompoundFault::UnknownGear { name, .. } => {
                let meshes = path.clone().key("meshes");
                let shafts = path.clone().key("planet_shafts");
                let is_shaft =
                    self.document.value_at(&shafts).is_some_and(|value| find(value, name).is_some());
                self.text(if is_shaft { shafts } else { meshes }, name)
            }
            CompoundFault::Mesh { first, second, .. } | CompoundFault::Loop { first, second } => {
                let meshes = path.clone().key("meshes");
                let names = |mesh: &Value| {
                    let gears = mesh.get("gears")?;
                    Some([text_of(gears.get(0))?.to_owned(), text_of(gears.get(1))?.to_owned()])
                };
                let wanted = Some([first.clone(), second.clone()]);
                match self.document.value_at(&meshes) {
                    Some(Value::Sequence(entries)) => {
                        match entries.iter().rposition(|mesh| names(mesh) == wanted) {
                            Some(index) => meshes.index(index),
                            None => path,
                        }
                    }
                    _ => path,
                }
            }
            _ => path,
        }
    }

    /// A central gear or planet of a compound set.
    fn part_of_set(&self, set: Path, name: &str) -> Path {
        let maps = ["suns", "rings", "bevels_left", "bevels_right", "planet_shafts", "planet_gears"];
        let exists = |map: &&&str| {
            let map = self.document.value_at(&set.clone().key(**map));
            map.is_some_and(|map| map.get(name).is_some())
        };
        match maps.iter().find(exists) {
            Some(map) => set.key(*map).key(name),
            None => set,
        }
    }

    /// The first entry beyond a limit.
    fn beyond(&self, what: Named, limit: usize) -> Path {
        let lists: &[&str] = match what {
            Named::Set => &SETS,
            Named::ShiftElement => &SHIFT_ELEMENTS,
            Named::Gear => &["gears"],
            Named::Drag => &["drags"],
            Named::Link => &["links"],
            _ => &[],
        };
        let mut left = limit;
        for list in lists {
            let path = self.base.clone().key(*list);
            match self.document.value_at(&path) {
                Some(Value::Sequence(entries)) if entries.len() > left => return path.index(left),
                Some(Value::Sequence(entries)) => left -= entries.len(),
                Some(Value::Mapping(entries)) if entries.len() > left => return path,
                Some(Value::Mapping(entries)) => left -= entries.len(),
                _ => {}
            }
        }
        self.base.clone()
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

/// The keys of a set that may hold what a gear refuses.
fn keys_of(error: &epicyclic_gears::Error) -> &'static [&'static str] {
    use epicyclic_gears::Error as E;
    match error {
        E::Efficiency { .. } | E::EfficiencyTooSmall { .. } => &["efficiency", "meshes", "friction"],
        E::NoTeeth => &["teeth"],
        E::NotAbove { quantity: Quantity::ContactRatio, .. } => &["profile_shifts"],
        E::NotPositive { quantity, .. } | E::OutOfRange { quantity, .. } => match quantity {
            Quantity::Module => &["module"],
            Quantity::HelixAngle => &["helix_angle"],
            Quantity::CarrierRadius => &["carrier_radius"],
            Quantity::FaceWidth | Quantity::Width => &["face_width"],
            Quantity::PlanetBore | Quantity::BoreDiameter => &["planet_bore"],
            Quantity::PlanetMass => &["planet_mass"],
            Quantity::LoadRating => &["load_rating"],
            Quantity::Friction => &["friction"],
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
