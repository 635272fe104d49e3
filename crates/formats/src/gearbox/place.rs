//! Where in a file of a gearbox the fault is that an error names.

use super::DescriptionError;
use crate::document::Segment;
use crate::yaml::Value;
use crate::{Document, Error, Path, Problem};
use epicyclic_gears::Quantity;
use epicyclic_train::{CompoundFault, DragFault, Error as SolverError, Named, Place, Terminal};
use std::vec::IntoIter;

/// The lists whose entries may bear the name of a shift element.
const SHIFT_ELEMENTS: [&str; 4] = ["brakes", "clutches", "shift_elements", "one_way"];

/// The lists whose entries may bear the name of a set.
const SETS: [&str; 2] = ["sets", "compound_sets"];

/// The keys of a set that name its members.
const MEMBERS: [&str; 5] = ["sun", "gear_a", "ring", "gear_b", "carrier"];

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
    document.error(&file.place(error), Problem::refused(error.name(), error.to_string()))
}

/// The place of a key of a gear, of a gear that has it; else the gear's.
#[must_use]
pub fn gear_place(document: &Document, base: &Path, gear: &str, key: &str) -> Path {
    let file = File { document, base };
    file.key(file.entry(&["gears"], gear), key)
}

/// The place of a set or shift element by its name, where the gearbox has one.
#[must_use]
pub fn part_place(document: &Document, base: &Path, name: &str) -> Option<Path> {
    let file = File { document, base };
    file.entries(&SETS, name).chain(file.entries(&SHIFT_ELEMENTS, name)).next()
}

struct File<'a> {
    document: &'a Document,
    base: &'a Path,
}

impl File<'_> {
    fn place(&self, error: &DescriptionError) -> Path {
        use DescriptionError as E;
        match error {
            E::RowKnownInOneWay { set } => self.key(self.set(set), "teeth"),
            E::Losses { set, .. } => self.key(self.set(set), "meshes"),
            E::Missing { set, .. } => self.set(set),
            E::Set { set, at, source } if at.is_root() => self.first_key(self.set(set), keys_of(source)),
            E::Set { set, at, .. } => self.within(self.set(set), at.segments()),
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
            E::Tools { set, at, .. } => {
                let there = |path, step: &Segment| {
                    if let Segment::Key(key) = step { self.key(path, key) } else { path }
                };
                at.segments().iter().fold(self.set(set), there)
            }
            E::HelixAngle { set } => self.key(self.set(set), "helix_angle"),
            E::Shifts { set } => self.first_key(self.set(set), &["profile_shifts", "tip_alterations"]),
            E::Values { set, key, .. } => self.key(self.set(set), key),
            E::SpacingTwice { set } => self.spacing(set),
            E::PlanetTeeth { set, .. } => self.key(self.set(set), "planet_teeth"),
            E::MemberInNoLink { set, member } => {
                let named = self.reference(&self.set(set), &MEMBERS, member);
                named.unwrap_or_else(|| self.part_of_set(self.set(set), member))
            }
            E::NoSuchPlanet { set, planet } => self.key(self.key(self.set(set), "planet_sizes"), planet),
            E::Clutch { clutch } => self.entry(&SHIFT_ELEMENTS, clutch),
            E::MemberInTwoLinks { member, first, second } => {
                let path = self.base.clone().key("links").key(second.as_str());
                // In one link twice it is the second that is too many.
                let nth = usize::from(first == second);
                self.listed(&path, member).nth(nth).unwrap_or(path)
            }
            E::Gearbox(error) => self.of_engine(error),
        }
    }

    fn of_engine(&self, error: &SolverError) -> Path {
        match error {
            SolverError::Unknown { name, place, .. } => {
                let path = self.named(place);
                self.reference(&path, &["link", "links", "one_way", "engaged", "between"], name)
                    .unwrap_or(path)
            }
            SolverError::EngagedTwice { place, name } => {
                let path = self.named(place);
                self.listed(&path, name).nth(1).unwrap_or(path)
            }
            SolverError::GroundedTerminal { place } => self.named(place),
            SolverError::Duplicate { what, name } => self.second(*what, name),
            SolverError::CoincidentMembers { set, .. }
            | SolverError::StepsMissing { set, .. }
            | SolverError::BasicRatio { set, .. } => self.set(set),
            SolverError::PlanetCount { set, .. } => self.first_key(self.set(set), &["planets", "n_p"]),
            SolverError::RingToSunRatio { set, .. } => {
                self.first_key(self.set(set), &["k", "teeth", "z_r", "z_b"])
            }
            SolverError::Spacing { set, .. } => self.spacing(set),
            SolverError::Compound { set, fault } => self.of_compound(set, fault),
            SolverError::TooMany { what, limit, .. } => self.beyond(*what, *limit),
            SolverError::Drag { drag, fault } => self.of_drag(drag, fault),
            SolverError::NoSets | SolverError::Spread { .. } => self.first_key(self.base.clone(), &SETS),
            SolverError::ShiftElementJoinsItself { shift_element, .. } => {
                self.entry(&SHIFT_ELEMENTS, shift_element)
            }
            SolverError::CyclicGrounds { number, .. } => self.connection(*number),
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
            Place::Connection(number) => self.connection(*number),
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
            | CompoundFault::Proportion { gear, .. } => self.part_of_set(path, &gear.of),
            CompoundFault::NameTwice { name } => {
                let mut parts = self.parts_of_set(&path, &name.of);
                let first = parts.next();
                parts.next().or(first).unwrap_or(path)
            }
            CompoundFault::PlanetGears { planet: name, .. }
            | CompoundFault::PlanetTeeth { planet: name }
            | CompoundFault::TwoShafts { name, .. }
            | CompoundFault::Apart { name } => self.part_of_set(path, name),
            CompoundFault::UnknownGear { name, .. } => {
                let meshes = path.clone().key("meshes");
                let shafts = path.clone().key("planet_shafts");
                self.listed(&shafts, name)
                    .next()
                    .or_else(|| {
                        let gears =
                            (0..self.length(&meshes)).map(|mesh| meshes.clone().index(mesh).key("gears"));
                        gears.flat_map(|gears| self.listed(&gears, name)).next()
                    })
                    .unwrap_or(path)
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
        self.parts_of_set(&set, name).next().unwrap_or(set)
    }

    /// All central gears and planets of a name.
    fn parts_of_set(&self, set: &Path, name: &str) -> IntoIter<Path> {
        let maps = ["suns", "rings", "bevels_left", "bevels_right", "planet_shafts", "planet_gears"];
        let paths = maps.into_iter().map(|map| set.clone().key(map).key(name));
        paths.filter(|path| self.document.value_at(path).is_some()).collect::<Vec<_>>().into_iter()
    }

    /// A permanent connection: `grounds` come first, then `ties`.
    fn connection(&self, number: usize) -> Path {
        let grounds = self.base.clone().key("grounds");
        match number.checked_sub(self.length(&grounds)) {
            None => grounds.index(number),
            Some(tie) => self.base.clone().key("ties").index(tie),
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

    /// The entry of these lists that bears a name, which only one does.
    fn entry(&self, lists: &[&str], name: &str) -> Path {
        self.entries(lists, name).next().unwrap_or_else(|| self.base.clone())
    }

    /// All entries of these lists that bear a name, in the order of the lists.
    fn entries(&self, lists: &[&str], name: &str) -> IntoIter<Path> {
        let bears = |entry: &Value| ["id", "name"].iter().any(|key| text_of(entry.get(key)) == Some(name));
        let mut found = vec![];
        for list in lists {
            let path = self.base.clone().key(*list);
            match self.document.value_at(&path) {
                Some(Value::Sequence(entries)) => {
                    let named = entries.iter().enumerate().filter(|(_, entry)| bears(entry));
                    found.extend(named.map(|(index, _)| path.clone().index(index)));
                }
                Some(Value::Mapping(entries)) if entries.contains_key(name) => found.push(path.key(name)),
                _ => {}
            }
        }
        found.into_iter()
    }

    /// Of two things with one name the one too many.
    fn second(&self, what: Named, name: &str) -> Path {
        let mut found = match what {
            Named::Set => self.entries(&SETS, name),
            Named::ShiftElement => self.entries(&SHIFT_ELEMENTS, name),
            Named::Gear => self.entries(&["gears"], name),
            // A drag may have the name of a shift element and not of another drag.
            Named::Drag => self.entries(&["drags"], name),
            _ => self.entries(&["links"], name),
        };
        let first = found.next();
        found.next().or(first).unwrap_or_else(|| self.base.clone())
    }

    /// The value of a key, where there is one.
    fn key(&self, path: Path, key: &str) -> Path {
        let inner = path.clone().key(key);
        if self.document.value_at(&inner).is_some() { inner } else { path }
    }

    /// The value of the first of these keys that there is.
    fn first_key(&self, path: Path, keys: &[&str]) -> Path {
        let inner = keys.iter().map(|key| path.clone().key(*key));
        inner.into_iter().find(|inner| self.document.value_at(inner).is_some()).unwrap_or(path)
    }

    /// The longest part of a way that there is.
    fn within(&self, path: Path, way: &[Segment]) -> Path {
        let Some((step, rest)) = way.split_first() else { return path };
        let inner = match step {
            Segment::Key(key) => path.clone().key(key),
            Segment::Index(index) => path.clone().index(*index),
        };
        if self.document.value_at(&inner).is_some() { self.within(inner, rest) } else { path }
    }

    /// A name under one of the keys of an entry whose values are names; of an entry without keys, itself a
    /// list of names.
    fn reference(&self, entry: &Path, keys: &[&str], name: &str) -> Option<Path> {
        let lists = keys.iter().map(|key| entry.clone().key(*key)).chain([entry.clone()]);
        lists.flat_map(|list| self.listed(&list, name)).next()
    }

    /// A text itself, or the entries of a list or map that are this text.
    fn listed(&self, path: &Path, text: &str) -> IntoIter<Path> {
        let is_it = |value: &Value| value.as_str() == Some(text);
        let found: Vec<Path> = match self.document.value_at(path) {
            Some(Value::Sequence(entries)) => {
                let found = entries.iter().enumerate().filter(|(_, entry)| is_it(entry));
                found.map(|(index, _)| path.clone().index(index)).collect()
            }
            Some(Value::Mapping(entries)) => {
                let found = entries.iter().filter(|(_, entry)| is_it(entry));
                found.filter_map(|(key, _)| Some(path.clone().key(key.as_str()?))).collect()
            }
            Some(value) if is_it(value) => vec![path.clone()],
            _ => vec![],
        };
        found.into_iter()
    }

    /// How many entries a list has.
    fn length(&self, path: &Path) -> usize {
        self.document.value_at(path).and_then(Value::as_sequence).map_or(0, Vec::len)
    }
}

/// The keys of a set that may hold what a gear refuses.
fn keys_of(error: &epicyclic_gears::Error) -> &'static [&'static str] {
    use epicyclic_gears::Error as E;
    match error {
        E::Efficiency { .. } | E::EfficiencyTooSmall { .. } => &["efficiency", "meshes", "friction"],
        E::NoTeeth => &["teeth"],
        E::NotAbove { quantity: Quantity::ContactRatio, .. } => &["profile_shifts", "teeth"],
        E::ShiftOutOfRange { .. } | E::ShiftSumOutOfRange { .. } => &["profile_shifts", "tools", "teeth"],
        E::Uncut { .. } => &["tools", "strength", "teeth"],
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
