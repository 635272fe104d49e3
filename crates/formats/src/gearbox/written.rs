//! A gearbox as the text of a file in our own format.
//!
//! What is read back from it is the same gearbox, but for the order of its links and shift elements: sets
//! with their `k` or teeth, planets and losses, compound sets gear by gear, shift elements, permanent
//! connections, gears with their inputs and outputs.

use epicyclic_gears::involute::profile::Cutting;
use epicyclic_gears::involute::tool::{Shaper, Tool};
use epicyclic_gears::synthesis::Placement;
use epicyclic_train::compound::{CentralKind, CentralSpec, CompoundSpec, MeshSpec, PlanetSpec};
use epicyclic_train::planet_set::Description;
use epicyclic_train::set::{Gearing, MeshLoss, SetKind, SetSpec, Shifts};
use epicyclic_train::spacing::Spacing;
use epicyclic_train::{Gear, Gearbox, LinkId, ShiftElement};
use epicyclic_units::format::{in_unit, trimmed};
use epicyclic_units::{Dimension, Physical};
use std::fmt::Write as _;
use std::iter;
use uom::si::f64::{Angle, Length};

/// Significant digits of lengths.
const DIGITS: usize = 5;

/// Significant digits of angles in degrees, and of modules whose ratio matters.
const FULL_DIGITS: usize = 12;

/// A central gear that a file cannot name: there each is named as its link.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "gear `{gear}` of set `{set}` is on link `{link}`: in a file the central gears of a compound set are named as their links"
)]
pub struct NotWritable {
    /// The set.
    pub set: String,
    /// The gear.
    pub gear: String,
    /// Link of the gear.
    pub link: String,
}

/// The file of a gearbox, below these lines of comment.
///
/// ```
/// use epicyclic_formats::Document;
/// use epicyclic_formats::gearbox::{GearboxFile, written};
/// use epicyclic_train::{Gearbox, set::SetSpec};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let gearbox = Gearbox::builder("I")
///     .links(["D", "T1", "B"])
///     .set(SetSpec::simple("1", ["D", "T1", "B"], 2.94))
///     .brake("K1", "T1")
///     .input("D")
///     .output("B")
///     .gear("slow", ["K1"])
///     .build()?;
/// let text = written(&gearbox, &[])?;
/// let file: GearboxFile = Document::parse_one("i.yaml", text.as_bytes())?.read()?;
/// assert_eq!(file.gearbox()?, gearbox);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`NotWritable`] for a compound set with a central gear of another name than its link.
pub fn written(gearbox: &Gearbox, comment: &[String]) -> Result<String, NotWritable> {
    written_with_sizes(gearbox, &[], comment)
}

/// Size of a set, which a gearbox itself does not have.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenSize {
    /// Module of all meshes, or of each.
    pub modules: Vec<Length>,
    /// Face width of its gears.
    pub face_width: Option<Length>,
}

/// The file of a gearbox with the sizes of the first sets, to five digits.
///
/// # Errors
/// As [`written`].
pub fn written_with_sizes(
    gearbox: &Gearbox,
    sizes: &[WrittenSize],
    comment: &[String],
) -> Result<String, NotWritable> {
    let mut text: String =
        comment.iter().flat_map(|line| line.lines()).map(|line| format!("# {line}\n")).collect();
    let link = |link: LinkId| scalar(gearbox.link_name(link));
    let mut line = |line: String| {
        let _ = writeln!(text, "{line}");
    };
    line(format!("gearbox: {}", scalar(gearbox.name())));
    line(format!("input: {}", link(gearbox.input())));
    line(format!("output: {}", link(gearbox.output())));
    let on_no_member = |id: &LinkId| !gearbox.sets().iter().any(|set| set.members().contains(id));
    let shafts: Vec<String> = gearbox.link_ids().skip(1).filter(on_no_member).map(link).collect();
    if !shafts.is_empty() {
        line(format!("links: [{}]", shafts.join(", ")));
    }
    let (mut short, mut compound) = (Vec::new(), Vec::new());
    for (place, set) in gearbox.sets().iter().enumerate() {
        match set.description() {
            Description::Short(spec) => {
                let keys = iter::once(of_set(spec)).chain(of_size(sizes.get(place)));
                short.push(format!("  - {{ {} }}", list(keys)));
            }
            Description::Compound(spec) => compound.extend(of_compound_set(spec, sizes.get(place))?),
        }
    }
    for (key, sets) in [("compound_sets:", compound), ("sets:", short)] {
        if !sets.is_empty() {
            line(key.to_owned());
        }
        sets.into_iter().for_each(&mut line);
    }
    let pair = |element: &ShiftElement| element.links().map(link).join(", ");
    let (brakes, clutches): (Vec<&ShiftElement>, Vec<&ShiftElement>) =
        gearbox.shift_elements().iter().partition(|element| element.is_brake() && !element.is_one_way());
    if !brakes.is_empty() {
        line("brakes:".to_owned());
    }
    for brake in brakes {
        let [held, _] = brake.links();
        line(format!("  - {{ id: {}, link: {} }}", scalar(brake.id()), link(held)));
    }
    if !clutches.is_empty() {
        line("clutches:".to_owned());
    }
    for clutch in clutches {
        let key = if clutch.is_one_way() { "one_way" } else { "links" };
        line(format!("  - {{ id: {}, {key}: [{}] }}", scalar(clutch.id()), pair(clutch)));
    }
    if !gearbox.permanent().is_empty() {
        line("ties:".to_owned());
    }
    for tie in gearbox.permanent() {
        line(format!("  - [{}]", tie.map(link).join(", ")));
    }
    if !gearbox.gears().is_empty() {
        line("gears:".to_owned());
    }
    for gear in gearbox.gears() {
        line(format!("  - {{ {} }}", of_gear(gearbox, gear)));
    }
    Ok(text)
}

fn of_set(spec: &SetSpec) -> String {
    let [sun, ring, carrier] = spec.members.each_ref().map(|member| scalar(member));
    let mut keys = vec![format!("id: {}", scalar(&spec.id))];
    if spec.kind != SetKind::Simple {
        keys.push(format!("kind: {}", kind(spec.kind)));
    }
    keys.extend([format!("sun: {sun}"), format!("ring: {ring}")]);
    if !spec.kind.is_pair() {
        keys.push(format!("carrier: {carrier}"));
    }
    keys.push(match spec.gearing {
        Gearing::BasicRatio(k) => format!("k: {k}"),
        Gearing::Teeth(sun, ring) => format!("teeth: [{sun}, {ring}]"),
    });
    let planets: Vec<String> =
        [spec.planet, spec.second_planet].iter().flatten().map(ToString::to_string).collect();
    if !planets.is_empty() {
        keys.push(format!("planet_teeth: [{}]", planets.join(", ")));
    }
    if let Some(count) = spec.planet_count {
        keys.push(format!("planets: {count}"));
    }
    keys.extend(of_spacing(&spec.spacing));
    if let Some(Shifts { profile, tips }) = &spec.tooth_shape.shifts {
        keys.push(format!("profile_shifts: [{}]", list(profile.iter().map(ToString::to_string))));
        if let Some(tips) = tips {
            keys.push(format!("tip_alterations: [{}]", list(tips.iter().map(ToString::to_string))));
        }
    }
    let gears = spec.kind.gears();
    let tools = gears.iter().map(|gear| gear.0).zip(&spec.tooth_shape.cutting);
    let tools: Vec<String> = tools.filter_map(|(gear, cutting)| of_tool(gear, cutting)).collect();
    if !tools.is_empty() {
        keys.push(format!("tools: {{ {} }}", tools.join(", ")));
    }
    if spec.is_helical() {
        let angles = (0..spec.kind.meshes()).map(|mesh| angle(spec.tooth_shape.signed_helix_angle(mesh)));
        let angles: Vec<String> = angles.collect();
        keys.push(match angles.iter().all(|one| *one == angles[0]) {
            true => format!("helix_angle: {}", angles[0]),
            false => format!("helix_angles: [{}]", angles.join(", ")),
        });
    }
    match spec.loss {
        loss if loss == MeshLoss::IDEAL => {}
        MeshLoss::Set(eta) => keys.push(format!("efficiency: {}", eta.get())),
        MeshLoss::Meshes { first, between, second } => {
            let meshes = match spec.kind {
                SetKind::DoublePlanet | SetKind::MeshingSuns => vec![first, between, second],
                _ => vec![first, second],
            };
            keys.push(format!("meshes: [{}]", list(meshes.iter().map(|eta| eta.get().to_string()))));
        }
    }
    keys.join(", ")
}

/// The key of where planets stand; none of equal angles.
fn of_spacing(spacing: &Spacing) -> Option<String> {
    match spacing {
        Spacing::Placed(Placement::Equal) => None,
        Spacing::Placed(Placement::LeastUnequal) => Some("spacing: least_unequal".to_owned()),
        Spacing::At(angles) => {
            Some(format!("planet_angles: [{}]", list(angles.iter().map(|one| angle(*one)))))
        }
    }
}

fn of_tool(gear: &str, cutting: &Cutting) -> Option<String> {
    let mut keys = vec![];
    let number = |key: &str, value: f64| format!("{key}: {value}");
    keys.extend(cutting.dedendum.map(|value| number("dedendum", value)));
    keys.extend(cutting.fillet.map(|value| number("fillet", value)));
    for (key, value) in [("protuberance", cutting.protuberance), ("stock", cutting.stock)] {
        keys.extend((value != 0.0).then(|| number(key, value)));
    }
    match cutting.tool {
        None | Some(Tool::Rack) => {}
        Some(Tool::Form { fillet }) => keys.push(number("form_fillet", fillet)),
        Some(Tool::Shaper(Shaper { teeth, shift, addendum, tip_radius })) => {
            let addendum = addendum.map(|value| number(", addendum", value)).unwrap_or_default();
            keys.push(format!(
                "shaper: {{ teeth: {teeth}, shift: {shift}{addendum}, tip_radius: {tip_radius} }}"
            ));
        }
    }
    (!keys.is_empty()).then(|| format!("{gear}: {{ {} }}", keys.join(", ")))
}

/// The lines of a compound set.
fn of_compound_set(spec: &CompoundSpec, size: Option<&WrittenSize>) -> Result<Vec<String>, NotWritable> {
    if let Some(CentralSpec { name, link, .. }) = spec.centrals.iter().find(|one| one.name != one.link) {
        return Err(NotWritable { set: spec.id.clone(), gear: name.clone(), link: link.clone() });
    }
    let mut lines =
        vec![format!("  - id: {}", scalar(&spec.id)), format!("    carrier: {}", scalar(&spec.carrier))];
    let kinds = [
        ("suns", CentralKind::Sun),
        ("rings", CentralKind::Ring),
        ("bevels_left", CentralKind::BevelLeft),
        ("bevels_right", CentralKind::BevelRight),
        ("planet_shafts", CentralKind::PlanetShaft),
    ];
    for (key, kind) in kinds {
        let of = |one: &CentralSpec| {
            let value = one.planet.as_deref().map_or_else(|| one.teeth.to_string(), scalar);
            format!("{}: {value}", scalar(&one.link))
        };
        let gears = list(spec.centrals.iter().filter(|one| one.kind == kind).map(of));
        if !gears.is_empty() {
            lines.push(format!("    {key}: {{ {gears} }}"));
        }
    }
    if spec.proportional {
        lines.push("    proportional: true".to_owned());
    }
    let planet = |one: &PlanetSpec| {
        format!("{}: [{}]", scalar(&one.name), list(one.teeth.iter().map(ToString::to_string)))
    };
    lines.push(format!("    planet_gears: {{ {} }}", list(spec.planets.iter().map(planet))));
    lines.push("    meshes:".to_owned());
    let mesh = |(place, MeshSpec { between: [first, second], efficiency }): (usize, &MeshSpec)| {
        let of_loss = match efficiency.get() {
            1.0 => String::new(),
            eta => format!(", efficiency: {eta}"),
        };
        let of_helix = match spec.tooth_shape.signed_helix_angle(place) {
            none if none.si() == 0.0 => String::new(),
            of_mesh => format!(", helix_angle: {}", angle(of_mesh)),
        };
        let of_module = match size.map(|size| &size.modules[..]) {
            Some(modules @ [_, _, ..]) => format!(", module: {}", length(modules[place], FULL_DIGITS)),
            _ => String::new(),
        };
        format!("      - {{ gears: [{}, {}]{of_loss}{of_helix}{of_module} }}", scalar(first), scalar(second))
    };
    lines.extend(spec.meshes.iter().enumerate().map(mesh));
    let names: Vec<String> = spec.gears().iter().map(ToString::to_string).collect();
    let by_gear = |key: &str, values: &[f64]| {
        let values = names.iter().zip(values).map(|(gear, value)| format!("{}: {value}", scalar(gear)));
        format!("    {key}: {{ {} }}", list(values))
    };
    if let Some(Shifts { profile, tips }) = &spec.tooth_shape.shifts {
        lines.push(by_gear("profile_shifts", profile));
        lines.extend(tips.iter().map(|tips| by_gear("tip_alterations", tips)));
    }
    let tools = names.iter().zip(&spec.tooth_shape.cutting);
    let tools = list(tools.filter_map(|(gear, cutting)| of_tool(&scalar(gear), cutting)));
    lines.extend((!tools.is_empty()).then(|| format!("    tools: {{ {tools} }}")));
    lines.extend(of_size(size).into_iter().map(|key| format!("    {key}")));
    lines.extend(spec.planet_count.map(|count| format!("    planets: {count}")));
    lines.extend(of_spacing(&spec.spacing).map(|key| format!("    {key}")));
    Ok(lines)
}

/// In degrees, where they are read as the same angle.
fn angle(angle: Angle) -> String {
    let unit = Dimension::Angle.usual_unit();
    let written = trimmed(angle.si() / unit.factor, FULL_DIGITS);
    let is_same = written.parse::<f64>().is_ok_and(|number| number * unit.factor == angle.si());
    if is_same { format!("{written} {}", unit.symbol) } else { format!("{} rad", angle.si()) }
}

/// Keys of the module of all meshes and of the face width.
fn of_size(size: Option<&WrittenSize>) -> Vec<String> {
    let Some(WrittenSize { modules, face_width }) = size else { return vec![] };
    let module = match modules[..] {
        [module] => Some(format!("module: {}", length(module, DIGITS))),
        _ => None,
    };
    module
        .into_iter()
        .chain(face_width.map(|width| format!("face_width: {}", length(width, DIGITS))))
        .collect()
}

fn length(length: Length, digits: usize) -> String {
    in_unit(length.si(), Dimension::Length.usual_unit(), digits)
}

fn of_gear(gearbox: &Gearbox, gear: &Gear) -> String {
    let engaged = gear.engaged().iter().map(|&place| scalar(gearbox.shift_elements()[place].id()));
    let mut keys = vec![format!("name: {}", scalar(gear.name())), format!("engaged: [{}]", list(engaged))];
    let own = [("input", gear.input(), gearbox.input()), ("output", gear.output(), gearbox.output())];
    let own = own.into_iter().filter(|(_, of_gear, usual)| of_gear != usual);
    keys.extend(own.map(|(key, link, _)| format!("{key}: {}", scalar(gearbox.link_name(link)))));
    keys.join(", ")
}

fn list(items: impl Iterator<Item = String>) -> String {
    items.collect::<Vec<_>>().join(", ")
}

/// The word of the file for a kind.
const fn kind(kind: SetKind) -> &'static str {
    match kind {
        SetKind::Simple => "simple",
        SetKind::DoublePlanet => "double_planet",
        SetKind::SteppedSunRing => "stepped_sun_ring",
        SetKind::SteppedSuns => "stepped_suns",
        SetKind::SteppedRings => "stepped_rings",
        SetKind::MeshingSuns => "meshing_suns",
        SetKind::Bevel => "bevel",
        SetKind::ExternalPair => "external_pair",
        SetKind::InternalPair => "internal_pair",
    }
}

/// A text, quoted: a name such as `1`, `y` or `null` stays a text.
fn scalar(text: &str) -> String {
    let mut quoted = String::from("\"");
    for character in text.chars() {
        match character {
            '"' | '\\' => quoted.extend(['\\', character]),
            other if other.is_control() => {
                let _ = write!(quoted, "\\U{:08x}", u32::from(other));
            }
            other => quoted.push(other),
        }
    }
    quoted.push('"');
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Document;
    use crate::gearbox::{GearboxFile, KindEntry};
    use epicyclic_gears::efficiency::MeshEfficiency;
    use epicyclic_gears::involute::profile::Iso53;
    use epicyclic_gears::teeth::ToothCount;
    use epicyclic_train::GearSpec;

    fn read(text: &str) -> Gearbox {
        let file: GearboxFile = Document::parse_one("box.yaml", text.as_bytes()).unwrap().read().unwrap();
        file.gearbox().unwrap()
    }

    #[test]
    fn what_is_read_back_is_the_same_gearbox() {
        let eta = |value| MeshEfficiency::new(value).unwrap();
        let z = |count| ToothCount::new(count).unwrap();
        let teeth = SetSpec::teeth("2", SetKind::DoublePlanet, ["y", "in", "null"], 30, 72).unwrap();
        let shifts = Shifts { profile: vec![0.1 + 0.2, -0.0426, 0.0], tips: Some(vec![-0.07, 0.0, 0.0]) };
        let shifted = SetSpec::teeth("3", SetKind::Simple, ["y", "in", "free"], 21, 108).unwrap();
        let shifted = shifted.planet_teeth(z(43), None).shifted(shifts);
        let shaper = Shaper { addendum: Some(1.25), ..Shaper::of_teeth(z(30)) };
        let hob = Cutting { protuberance: 0.05, stock: 0.02, ..Cutting::from(Iso53::D) };
        let ring = Cutting { tool: Some(Tool::Shaper(shaper)), ..Cutting::default() };
        let shifted = shifted.cut(vec![hob, Cutting::default(), ring]);
        let degrees = Angle::from_degrees;
        let helical = |id, angle| {
            let set = SetSpec::teeth(id, SetKind::Simple, ["y", "in", "free"], 20, 60).unwrap();
            set.helical(degrees(angle))
        };
        let spaced = |id, spacing| {
            let set = SetSpec::teeth(id, SetKind::Simple, ["y", "in", "free"], 26, 96).unwrap();
            set.planet_count(4).spaced(spacing)
        };
        let losses = MeshLoss::Meshes { first: eta(0.98), between: eta(0.97), second: eta(0.99) };
        let gearbox = Gearbox::builder("a \"box\": #1\n\\")
            .links(["in", "y", "out", "null", "free", "shaft"])
            .set(SetSpec::simple("1", ["in", "y", "out"], 0.1 + 2.2).with_loss(MeshLoss::Set(eta(0.97))))
            .set(teeth.planet_teeth(z(19), Some(z(20))).planet_count(3).with_loss(losses))
            .set(shifted)
            .set(helical("4", 8.0))
            .set(helical("5", 0.1 + 0.2))
            .set(spaced("6", Spacing::Placed(Placement::LeastUnequal)))
            .set(spaced("7", Spacing::At([0.0, 88.524_590_163_934_43, 180.0, -91.475].map(degrees).to_vec())))
            .set(SetSpec::pair("p", ["free", "out"], 20, 41).unwrap())
            .brake("1", "y")
            .clutch("in-y", "in", "shaft")
            .one_way_clutch("f", "null", "ground")
            .tie("null", "out")
            .input("in")
            .output("out")
            .gear("1", ["1", "f"])
            .gear_spec(GearSpec {
                name: "~".into(),
                engaged: vec!["in-y".into()],
                input: Some("free".into()),
                output: None,
            })
            .build()
            .unwrap();
        // Brakes stand before clutches in a file.
        assert_eq!(read(&written(&gearbox, &["two".into(), "lines\nand three".into()]).unwrap()), gearbox);
    }

    #[test]
    fn compound_sets_are_read_back_as_they_were() {
        for name in ["ravigneaux", "every-gearbox-key"] {
            let file = format!("{}/../../examples/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
            let gearbox = read(&std::fs::read_to_string(file).unwrap());
            assert_eq!(read(&written(&gearbox, &[]).unwrap()).sets(), gearbox.sets(), "{name}");
        }
    }

    #[test]
    fn a_central_gear_of_another_name_than_its_link_is_refused() {
        let mut set = CompoundSpec::new("1", "arm").sun("in", 20).ring("out", 60).planet("p", &[20]);
        set = set.mesh("in", "p", MeshEfficiency::IDEAL).mesh("p", "big", MeshEfficiency::IDEAL);
        set.centrals[1].name = "big".into();
        let gearbox = Gearbox::builder("box").links(["in", "arm", "out"]).compound_set(set);
        let gearbox = gearbox.brake("b", "arm").input("in").output("out").build().unwrap();
        let refused = written(&gearbox, &[]).unwrap_err().to_string();
        assert!(refused.contains("gear `big` of set `1` is on link `out`"), "{refused}");
    }

    #[test]
    fn every_kind_has_the_word_of_the_file() {
        let kinds = [
            SetKind::Simple,
            SetKind::DoublePlanet,
            SetKind::SteppedSunRing,
            SetKind::SteppedSuns,
            SetKind::SteppedRings,
            SetKind::MeshingSuns,
            SetKind::Bevel,
            SetKind::ExternalPair,
            SetKind::InternalPair,
        ];
        for one in kinds {
            let entry: KindEntry = serde_yaml::from_str(kind(one)).unwrap();
            assert_eq!(SetKind::from(entry), one);
        }
    }
}
