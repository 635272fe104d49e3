//! Keys that a file lacks for its sizes or its strength, with usual values to paste into it.

use super::materials::material;
use super::rated_set::Of;
use crate::analyze::answer::{Input, Worked};
use crate::error::Error;
use crate::shared::basis::{Basis, BasisKey, flow};
use crate::shared::gearbox::{Choice, Gearbox, one};
use epicyclic_formats::document::Segment;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_formats::yaml::{Mapping, Value, to_string};
use epicyclic_formats::{Document, Path, Problem};
use epicyclic_gears::geometry::GearKind;
use epicyclic_strength::factor::{Side, Symbol};
use epicyclic_strength::material::Class;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::set::SetKind;
use epicyclic_train::{Gear, InputLoad, PlanetSet};
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Torque};

/// Torque in N·m and speed in rpm of the duty that serves as an example.
const EXAMPLE: [f64; 2] = [100.0, 1450.0];

/// Calculations that need keys.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// Sizes over a duty.
    Sizes,
    /// Strength over a duty, or against overloads.
    OverDuty,
    /// Strength at one load.
    AtPoint,
    /// Data sheets.
    Sheets,
    /// Vibration.
    Vibration,
}

impl Purpose {
    /// Whether materials, oil and life are needed.
    const fn is_strength(self) -> bool {
        matches!(self, Self::Sizes | Self::OverDuty | Self::AtPoint)
    }
}

/// Example of what the vibration of a simple set needs beside its teeth and sizes.
fn vibration() -> Value {
    let inertia = |value: &str| {
        Value::Mapping([(Value::from("inertia"), Value::from(value))].into_iter().collect::<Mapping>())
    };
    let all = [
        ("planet_bearing", Value::from("300 N/µm")),
        ("ring", inertia("0.05 kg·m²")),
        ("carrier", inertia("0.02 kg·m²")),
    ];
    Value::Mapping(all.into_iter().map(|(key, value)| (Value::from(key), value)).collect())
}

/// Key that a file lacks.
struct Missing {
    /// Path of the mapping that lacks it.
    at: Path,
    /// Name of the set; `None` for the gearbox.
    set: Option<String>,
    key: String,
    /// Usual value; `None` of teeth, for which no value is usual.
    usual: Option<Value>,
}

/// Keys that one mapping of the file lacks.
struct Part<'m> {
    at: &'m Path,
    /// Name of the set; `None` for the gearbox.
    set: Option<&'m str>,
    entries: Vec<(&'m str, &'m Value)>,
}

impl Missing {
    /// Name of the key in its set or gearbox: `strength.shaper`.
    fn name(&self) -> String {
        let below = self.at.segments().iter().filter_map(|segment| match segment {
            Segment::Key(key) if key != "sets" && key != "compound_sets" => Some(key.as_str()),
            _ => None,
        });
        below.chain([self.key.as_str()]).collect::<Vec<_>>().join(".")
    }
}

/// Keys that a file lacks.
pub(crate) struct MissingKeys<'d> {
    /// The file.
    pub(crate) document: &'d Document,
    purpose: Purpose,
    keys: Vec<Missing>,
}

impl<'d> MissingKeys<'d> {
    /// Keys that a file lacks for a calculation, with the values of a basis.
    ///
    /// # Errors
    /// [`Error::Document`] for a material that there is not.
    pub(crate) fn of(
        subject: &'d Gearbox,
        file: &GearboxFile,
        basis: &Basis,
        purpose: Purpose,
    ) -> Result<Self, Error> {
        let mut all = Self { document: &subject.document, purpose, keys: vec![] };
        let root = Path::root();
        for (key, is_stated) in [("life", file.life.is_some()), ("oil", file.oil.is_some())] {
            let usual = basis.keys.iter().find(|(own, _)| own == key);
            if let Some((_, usual)) = usual.filter(|_| !is_stated && purpose.is_strength()) {
                all.add(&root, None, key, usual.clone());
            }
        }
        let is_due = match purpose {
            Purpose::Sizes => true,
            Purpose::OverDuty => file.overload.is_empty(),
            Purpose::AtPoint | Purpose::Sheets | Purpose::Vibration => false,
        };
        if is_due && file.duty.is_empty() {
            all.add(&root, None, "duty", example(subject));
        }
        for set in subject.train.sets() {
            let Some(data) = file.set_data(set) else { continue };
            // Bevel gears are not rated.
            if data.of.iter().all(|gear| set.gear_kind(*gear).is_some()) {
                all.add_set(&Of { subject, file, set, data }, basis)?;
            }
        }
        Ok(all)
    }

    /// Adds the keys of a set.
    fn add_set(&mut self, of: &Of<'_>, basis: &Basis) -> Result<(), Error> {
        let (set, data) = (of.set, &of.data);
        let is_known = |planets: bool| {
            let mut own = data.of.iter().filter(|gear| matches!(gear, GearOf::Planet(..)) == planets);
            own.all(|gear| set.teeth_or_coaxial(*gear).is_some())
        };
        let of_planets = if set.short().is_some() { "planet_teeth" } else { "planet_gears" };
        // Those of the planets may follow from the others.
        let teeth = if !is_known(false) { Some("teeth") } else { (!is_known(true)).then_some(of_planets) };
        self.keys.extend(teeth.map(|key| Missing {
            at: data.path.clone(),
            set: Some(set.id().to_owned()),
            key: key.to_owned(),
            usual: None,
        }));
        if self.purpose != Purpose::Sizes {
            let sizes = [
                ("planets", set.is_pair() || set.planet_count().is_some(), Value::from(3)),
                ("module", data.modules.iter().any(Option::is_some), Value::from("4 mm")),
                ("face_width", data.face_widths.iter().any(Option::is_some), Value::from("40 mm")),
            ];
            let is_due = |key: &str| self.purpose != Purpose::Sheets || key == "module";
            let lacking: Vec<_> = sizes.into_iter().filter(|size| !size.1 && is_due(size.0)).collect();
            for (key, _, example) in lacking {
                self.add(&data.path, Some(set), key, example);
            }
        }
        if self.purpose == Purpose::Vibration && set.kind() == Some(SetKind::Simple) {
            self.add(&data.path, Some(set), "vibration", vibration());
        }
        if !self.purpose.is_strength() {
            return Ok(());
        }
        let strength = usual_strength(of, basis, self.purpose)?;
        if !strength.is_empty() {
            self.add(&data.path, Some(set), "strength", Value::Mapping(strength));
        }
        Ok(())
    }

    /// Adds a key, of a mapping that the file has the keys in it that it lacks.
    fn add(&mut self, at: &Path, set: Option<&PlanetSet>, key: &str, usual: Value) {
        let inner = at.clone().key(key);
        match (self.document.value_at(&inner), &usual) {
            (Some(Value::Mapping(_)), Value::Mapping(usual)) => {
                for (key, value) in usual {
                    self.add(&inner, set, key.as_str().unwrap_or_default(), value.clone());
                }
            }
            (Some(_), _) => {}
            (None, _) => self.keys.push(Missing {
                at: at.clone(),
                set: set.map(|set| set.id().to_owned()),
                key: key.to_owned(),
                usual: Some(usual),
            }),
        }
    }

    /// The refusal of a calculation of one set, or of all, that lacks keys; `None` if no key with a usual value
    /// is missing.
    pub(crate) fn refused_of(mut self, set: Option<&str>) -> Option<Error> {
        self.keys.retain(|key| set.is_none() || key.set.as_deref() == set);
        self.have_values().then(|| self.refused())
    }

    /// Whether a key of the gearbox is missing, without which no set has a result.
    pub(crate) fn are_of_gearbox(&self) -> bool {
        self.keys.iter().any(|key| key.set.is_none())
    }

    /// Whether values can be given that the file lacks.
    pub(crate) fn have_values(&self) -> bool {
        self.keys.iter().any(|key| key.usual.is_some())
    }

    /// The gearbox with the usual values and required safeties, and these values; `None` if it lacks none. No
    /// load is assumed.
    ///
    /// # Errors
    /// Those of the reader.
    pub(crate) fn assumed(mut self, basis: &Basis) -> Result<Option<(Gearbox, Vec<BasisKey>)>, Error> {
        self.keys.retain(|missing| missing.key != "duty" && missing.usual.is_some());
        let required = basis.keys.iter().find(|(own, _)| own == "required");
        required.inspect(|(key, usual)| self.add(&Path::root(), None, key, usual.clone()));
        if self.keys.is_empty() {
            return Ok(None);
        }
        let (mut file, mut listed) = (self.document.value().clone(), vec![]);
        for missing in &self.keys {
            let Missing { at, key, usual: Some(usual), .. } = missing else { continue };
            list(&mut listed, &missing.name(), usual);
            if let Some(of) = mapping_at(&mut file, at) {
                of.insert(key.as_str().into(), usual.clone());
            }
        }
        let text = to_string(&file).map_err(|error| Error::Json(error.to_string()))?;
        let document = Document::parse_one(self.document.file(), text.as_bytes())?;
        Ok(Some((one(&document, &Choice::default())?, listed)))
    }

    /// The refusal that names all keys, with the lines to paste.
    pub(crate) fn refused(&self) -> Error {
        let mut sets: Vec<Option<&str>> = self.keys.iter().map(|missing| missing.set.as_deref()).collect();
        sets.dedup();
        let of_set = |set: &Option<&str>| {
            let own = self.keys.iter().filter(|missing| missing.set.as_deref() == *set);
            let names: Vec<String> = own.map(|missing| format!("`{}`", missing.name())).collect();
            let of = set.map(|set| format!(" of set `{set}`")).unwrap_or_default();
            format!("{}{of}", names.join(", "))
        };
        let is_missing = |key: &str| self.keys.iter().any(|missing| missing.key == key);
        let is_assumed = self.keys.iter().any(|missing| missing.key != "duty" && missing.usual.is_some());
        let remedy = match self.purpose {
            Purpose::Sizes if is_assumed => "; --application takes usual values for all but teeth and `duty`",
            Purpose::OverDuty if is_missing("duty") => "; --torque and --speed are a load in place of `duty`",
            _ => "",
        };
        let teeth = match self.keys.iter().any(|missing| missing.usual.is_none()) {
            true => {
                ". Teeth have no usual values: write them in place of `k`; `epicyclic teeth --ratio` finds some"
            }
            false => "",
        };
        let message = format!(
            "missing: {}. Paste the lines below and put your values in place of these examples{remedy}{teeth}",
            sets.iter().map(of_set).collect::<Vec<_>>().join("; ")
        );
        let first = self.keys.first().map_or_else(Path::root, |missing| missing.at.clone());
        let at = self.document.error(&first, Problem::refused("missing-key", message));
        Error::MissingKeys { at: Box::new(at), lines: self.lines() }
    }

    /// Lines to paste, with where each part belongs. The parts begin at the end of the file, so that the
    /// lines of the next parts keep their numbers.
    fn lines(&self) -> String {
        let mut parts: Vec<Part<'_>> = vec![];
        for missing in &self.keys {
            let Some(usual) = &missing.usual else { continue };
            let entry = (missing.key.as_str(), usual);
            match parts.iter_mut().find(|part| part.at == &missing.at) {
                Some(part) => part.entries.push(entry),
                None => {
                    let set = missing.set.as_deref();
                    parts.push(Part { at: &missing.at, set, entries: vec![entry] });
                }
            }
        }
        parts.sort_by_key(|part| {
            let position = self.document.position(part.at);
            std::cmp::Reverse((part.at.is_root(), position.line, position.column))
        });
        parts.iter().map(|part| self.pasted(part)).collect::<Vec<_>>().join("\n")
    }

    /// A part with the place where it belongs.
    fn pasted(&self, part: &Part<'_>) -> String {
        let Part { at, set, entries } = part;
        let position = self.document.position(at);
        let of = set.map(|set| format!(", set `{set}`")).unwrap_or_default();
        if self.is_in_braces(at) {
            let all: Vec<String> =
                entries.iter().map(|(key, value)| format!("{key}: {}", inline(value))).collect();
            let line = position.line;
            return format!(
                "# in the braces of line {line}{of}, after their last value\n, {}\n",
                all.join(", ")
            );
        }
        let (header, indent) = match at.is_root() {
            true => ("# at the end of the file".to_owned(), 0),
            false => (format!("# below line {}{of}", self.line_above(at)), position.column - 1),
        };
        let all: String = entries.iter().map(|(key, value)| lines_of(indent, key, value)).collect();
        format!("{header}\n{all}")
    }

    /// Whether a mapping is written in braces.
    fn is_in_braces(&self, at: &Path) -> bool {
        let keys = self.document.value_at(at).and_then(Value::as_mapping).map(Mapping::keys);
        let first = keys.and_then(|mut keys| keys.next()?.as_str());
        // A mapping without braces stands where its first key does.
        first.is_none_or(|first| {
            self.document.key_position(&at.clone().key(first)) != self.document.position(at)
        })
    }

    /// Line below which keys of a mapping can be inserted.
    fn line_above(&self, at: &Path) -> usize {
        let id = at.clone().key("id");
        // The value of `id` ends on its line.
        let place = if self.document.has(&id) { id } else { at.clone() };
        self.document.key_position(&place).line
    }
}

/// The mapping at a path of a file; `None` where the file has something else.
pub(crate) fn mapping_at<'v>(file: &'v mut Value, path: &Path) -> Option<&'v mut Mapping> {
    let found = path.segments().iter().try_fold(file, |value, segment| match segment {
        Segment::Key(key) => value.get_mut(key.as_str()),
        Segment::Index(index) => value.get_mut(*index),
    });
    found?.as_mapping_mut()
}

/// Usual values of what the strength of a set lacks.
fn usual_strength(of: &Of<'_>, basis: &Basis, purpose: Purpose) -> Result<Mapping, Error> {
    let (set, data) = (of.set, &of.data);
    let kind = |gear: &GearOf| match (gear, set.gear_kind(*gear)) {
        (GearOf::Planet(..), _) => 1,
        (_, Some(GearKind::Internal)) => 2,
        _ => 0,
    };
    let kinds: Vec<usize> = data.of.iter().map(kind).collect();
    let usual = |key: &str| basis.strength.get(key).cloned().unwrap_or_default();
    let per_gear = data.strength.map(|strength| of.per_gear(strength));
    let mut all = Mapping::new();
    for (key, of_kinds) in ["materials", "flank_roughness", "root_roughness"].map(|key| (key, usual(key))) {
        let stated = of.subject.document.has(&data.path.clone().key("strength").key(key));
        let values = kinds.iter().map(|kind| of_kinds.get(*kind).cloned().unwrap_or_default());
        all.insert(
            key.into(),
            match stated {
                false if data.gears.has_order => Value::Sequence(values.collect()),
                _ => {
                    let names = data.gears.names.iter().map(|name| Value::from(name.as_str()));
                    Value::Mapping(names.zip(values).collect())
                }
            },
        );
    }
    if kinds.contains(&2) && of.shaper().is_none() {
        all.insert("shaper".into(), usual("shaper"));
    }
    let of_meshes = (0..set.meshes().len()).map(|mesh| set.gears_of_mesh(mesh));
    let given: Vec<_> = of_meshes
        .map(|gears| {
            (gears, data.strength.map(|strength| of.method(strength, gears).given).unwrap_or_default())
        })
        .collect();
    // Deviations of the teeth give these factors only once the size is known.
    let is_calculated = |symbol| {
        let has_accuracy = data.strength.is_some_and(|strength| strength.accuracy.is_some());
        let of_accuracy = [Symbol::Dynamic, Symbol::TransverseContact, Symbol::TransverseRoot];
        purpose != Purpose::Sizes && has_accuracy && of_accuracy.contains(&symbol)
    };
    let is_missing = |(key, _): &(&Value, &Value)| {
        let symbol = key.as_str().and_then(Symbol::named);
        symbol.is_some_and(|symbol| {
            !is_calculated(symbol) && given.iter().any(|(_, given)| given.of(Side::First, symbol).is_none())
        })
    };
    let factors: Mapping = basis
        .strength
        .get("factors")
        .and_then(Value::as_mapping)
        .into_iter()
        .flatten()
        .filter(is_missing)
        .map(|(key, value)| (key.clone(), value.clone()))
        .collect();
    if !factors.is_empty() {
        all.insert("factors".into(), Value::Mapping(factors));
    }
    // No formula is known of this factor for steels that are not hardened at their surface.
    let symbol = Symbol::StaticNotchSensitivity;
    for (place, gear) in data.of.iter().enumerate() {
        let stated = per_gear.as_ref().map_or("", |all| all.material(place));
        let usual = usual("materials");
        let name =
            if stated.is_empty() { usual.get(kinds[place]).and_then(Value::as_str) } else { Some(stated) };
        let at = data.path.clone().key("strength").key("materials");
        let class = material(of.subject, of.file, &at, name.unwrap_or_default())?.class;
        let is_given = given.iter().all(|(ends, given)| {
            let mut own = Side::BOTH.into_iter().zip(ends).filter(|(_, end)| *end == gear);
            own.all(|(side, _)| data.strength.is_some() && given.of(side, symbol).is_some())
        });
        if is_given || matches!(class, Class::CaseHardened | Class::SurfaceHardened) {
            continue;
        }
        let factor: Mapping = [(Value::from("Y_delta_rel_T_stat"), Value::from(1))].into_iter().collect();
        let (key, factors) = match ["sun_factors", "planet_factors", "ring_factors"][kinds[place]] {
            "sun_factors" if set.is_pair() => {
                let name = data.gears.names[place].as_str();
                ("gear_factors", [(Value::from(name), Value::Mapping(factor))].into_iter().collect())
            }
            key => (key, factor),
        };
        let own = all.entry(key.into()).or_insert_with(|| Value::Mapping(Mapping::new()));
        own.as_mapping_mut().into_iter().for_each(|own| own.extend(factors.clone()));
    }
    Ok(all)
}

/// An example of a duty: the same load in every gear that carries it.
fn example(subject: &Gearbox) -> Value {
    let [torque, speed] = EXAMPLE;
    let input = Input {
        speed: Some(AngularVelocity::from_rpm(speed)),
        load: Some(InputLoad::Torque(Torque::from_si(torque))),
    };
    let carries =
        |gear: &&str| Worked::new(&subject.train, gear, input).is_ok_and(|worked| worked.operation.is_some());
    let gears: Vec<&str> = subject.train.gears().iter().map(Gear::name).filter(carries).collect();
    let step = |(place, gear): (usize, &&str)| {
        // Whole percents, of which the first gear has what is left.
        let share = 100 / gears.len() + if place == 0 { 100 % gears.len() } else { 0 };
        let step = [
            ("gear", (*gear).to_owned()),
            ("share", format!("{share} %")),
            ("torque", format!("{torque} N·m")),
            ("speed", format!("{speed} rpm")),
        ];
        Value::Mapping(step.into_iter().map(|(key, value)| (key.into(), value.into())).collect())
    };
    Value::Sequence(gears.iter().enumerate().map(step).collect())
}

/// Adds a value, that of a set key by key; sets with the same value share it.
fn list(listed: &mut Vec<BasisKey>, key: &str, value: &Value) {
    if let ("strength", Value::Mapping(own)) = (key, value) {
        for (inner, value) in own {
            list(listed, &format!("strength.{}", inner.as_str().unwrap_or_default()), value);
        }
        return;
    }
    let one = BasisKey { key: key.to_owned(), value: flow(value) };
    if !listed.contains(&one) {
        listed.push(one);
    }
}

/// Lines of YAML for a key: one of what has one line in a file, else one for each entry.
fn lines_of(indent: usize, key: &str, value: &Value) -> String {
    let is_nested = |value: &Value| value.is_mapping() || value.is_sequence();
    let start = " ".repeat(indent);
    let comment = match key {
        "duty" => " # parts of the time, at torque and speed of the input",
        "oil" => " # at 40 °C",
        "planets" | "module" | "face_width" => " # epicyclic size finds it",
        _ => "",
    };
    match value {
        Value::Mapping(own) if own.values().any(is_nested) => {
            let inner = own.iter().map(|(key, value)| lines_of(indent + 2, &inline(key), value));
            format!("{start}{key}:{comment}\n{}", inner.collect::<String>())
        }
        Value::Sequence(own) if own.iter().any(is_nested) => {
            let inner = own.iter().map(|value| format!("{start}  - {}\n", inline(value)));
            format!("{start}{key}:{comment}\n{}", inner.collect::<String>())
        }
        value => format!("{start}{key}: {}{comment}\n", inline(value)),
    }
}

/// A value as YAML in one line.
fn inline(value: &Value) -> String {
    match value {
        Value::Sequence(items) => format!("[{}]", items.iter().map(inline).collect::<Vec<_>>().join(", ")),
        Value::Mapping(pairs) => {
            let pair = |(key, value): (&Value, &Value)| format!("{}: {}", inline(key), inline(value));
            format!("{{ {} }}", pairs.iter().map(pair).collect::<Vec<_>>().join(", "))
        }
        Value::String(text) => {
            // Names such as `1` or `a, b` are texts only in quotes.
            let plain = Document::parse_one("", format!("[{text}]").as_bytes());
            let is_plain = plain.is_ok_and(|plain| *plain.value() == Value::Sequence(vec![value.clone()]));
            if is_plain { text.clone() } else { quoted(text) }
        }
        other => flow(other),
    }
}

/// A text in double quotes.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
