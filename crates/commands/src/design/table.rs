//! A design from speeds and power, step by step, and stages in series for one ratio.

pub(crate) mod stages;
pub(crate) mod transmission;

use crate::answer::Warning;
use crate::design::answer::Design;
use crate::design::answer::limits::{OrderLimits, length_m};
use crate::design::answer::masses::Masses;
use crate::design::answer::records::{OtherScheme, SchemeStep, SizesStep, TeethStep, TeethTaken};
use crate::design::answer::ways_out::{Limit, RelaxedLimit, WayOut};
use crate::select::answer::reached::largest_deviation;
use crate::select::table::{percent, speeds_reached};
use crate::shared::basis::BasisKey;
use crate::shared::judgement::table as judgement;
use crate::size::answer::records::{SizedDesign, SizedFamily, SizedSet};
use crate::size::table::{basis, designs, gears, left_out};
use crate::strength::table::{Worn, over_duty};
use crate::table::columns::Table;
use crate::table::figure::{Figure, hours, text};
use crate::table::quantities::{quantity, words};
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Row, Section, Text, warned};
use epicyclic_judge::Rule;
use epicyclic_strength::sizing::Requirement;
use epicyclic_units::Dimension;
use epicyclic_units::format::trimmed;

/// Ring, masses, least safeties and life of the best sizes. The diameter is named by whose it is: that of a ring, or
/// of planets that reach beyond it. A value with a limit has the digits that show on which side of it the value is.
pub(crate) fn of_sizes(
    sizes: &SizesStep,
    masses: Option<&Masses>,
    (limits, diameter): (&OrderLimits, &str),
) -> Vec<String> {
    let found: Vec<&SizedDesign> = sizes.sets.iter().filter_map(|set| set.found.first()).collect();
    let mut all = vec![];
    let rings = found.iter().filter_map(|design| design.ring_diameter_m);
    all.extend(
        rings.reduce(f64::max).map(|ring| format!("{diameter} {}", words(Dimension::Length, ring, DIGITS))),
    );
    let is_known = masses.is_some_and(Masses::are_of_sets);
    all.extend(is_known.then(|| {
        format!("length about {}", beside(Dimension::Length, length_m(sizes), (limits.length_m, 2)))
    }));
    all.extend(sizes.mass_kg.map(|mass| format!("gears {}", words(Dimension::Mass, mass, 3))));
    all.extend(
        masses
            .map(|of| format!("whole about {}", beside(Dimension::Mass, of.whole_kg, (limits.whole_kg, 2)))),
    );
    let gears = || found.iter().flat_map(|design| &design.over_duty);
    let least = |values: &mut dyn Iterator<Item = f64>| values.reduce(f64::min);
    all.extend(
        least(&mut gears().map(|gear| gear.flank.safety)).map(|of| format!("least S_H {}", trimmed(of, 3))),
    );
    all.extend(least(&mut gears().map(|gear| gear.root.safety)).map(|of| format!("S_F {}", trimmed(of, 3))));
    let overloads = found.iter().filter_map(|design| design.overload.as_ref());
    let overload = overloads.min_by(|one, other| one.reserve().total_cmp(&other.reserve()));
    all.extend(overload.map(|of| {
        let symbol = if of.requirement == Requirement::OverloadFlank { "S_H" } else { "S_F" };
        format!("overload {symbol} {} of {}", trimmed(of.value, 3), trimmed(of.required, 3))
    }));
    let bearings =
        found.iter().flat_map(|design| &design.planet_sizes).filter_map(|planet| planet.bearing.as_ref());
    let life = least(&mut bearings.filter_map(|bearing| bearing.life_s));
    all.extend(life.map(|life| format!("L_10 {} h", trimmed(hours(life), 3))));
    all
}

/// A value with the fewest digits, at least so many, that lie on its side of a limit; without one with the least.
pub(super) fn beside(dimension: Dimension, value: f64, (limit, least): (Option<f64>, usize)) -> String {
    let Some(limit) = limit else { return words(dimension, value, least) };
    let is_told = |digits: &usize| {
        let shown = trimmed(value, *digits).parse::<f64>();
        shown.is_ok_and(|shown| (shown <= limit) == (value <= limit))
    };
    words(dimension, value, (DIGITS..MOST_DIGITS).find(is_told).unwrap_or(MOST_DIGITS))
}

/// Digits of a value beside its limit at most.
const MOST_DIGITS: usize = 9;

/// Title of the assumed values.
pub(super) const ASSUMED: &str = "Assumed values; change with --basis, --factors, --life";

/// Schemes that are named beside the one taken.
const MOST_OTHERS: usize = 3;

/// Reserve of torque up to which a requirement is near its limit.
const NEAR: f64 = 1.15;

/// Digits of ratios and of lengths in words.
const DIGITS: usize = 4;

impl AsReport for Design {
    fn report(&self) -> Report {
        let mut parts = parts_of_choice(self);
        parts.extend(self.sizes.iter().flat_map(parts_of_sizes));
        Report { title: Some(in_short(self)), parts, warnings: of_found(&self.warnings, self.file.is_some()) }
    }
}

/// Warnings of a design; without a gearbox there is nothing that could be without warnings.
pub(super) fn of_found(warnings: &[Warning], is_found: bool) -> Option<Vec<(&'static str, String)>> {
    warned(warnings).filter(|_| is_found || !warnings.is_empty())
}

/// The speeds asked for and reached, the steps, ways out, and assumed values.
pub(crate) fn parts_of_choice(design: &Design) -> Vec<Part> {
    let mut parts = vec![];
    if !design.speeds.is_empty() {
        parts.push(Part::Records(speeds_reached(&design.speeds)));
    }
    parts.push(Part::Records(steps(design)));
    parts.extend(design.front.as_deref().map(|front| or_none(front, smaller_rings)));
    parts.extend(stopped(design).map(|why| Part::Text(Text::paragraph(why))));
    if let Some(ways) = design.ways_out.as_deref().filter(|ways| !ways.is_empty()) {
        parts.push(Part::Records(ways_out(ways)));
        parts.extend(ways.iter().map(|way| Part::Records(speeds_of(way))));
    }
    parts.extend(limits(&design.limits, design.masses.as_ref(), design.sizes.as_ref()));
    parts.extend(design.masses.as_ref().map(|of| Part::Facts(masses(of))));
    parts.push(Part::Records(basis(&design.basis, ASSUMED)));
    parts.push(Part::Records(assumed(&design.assumed)));
    parts
}

/// Limits of the whole gearbox, asked and reached; `None` without any.
pub(crate) fn limits(of: &OrderLimits, masses: Option<&Masses>, sizes: Option<&SizesStep>) -> Option<Part> {
    let is_found = masses.is_some();
    let figure =
        |dimension, value: Option<f64>| value.map_or(Figure::None, |value| quantity(dimension, value));
    let whole = masses.map(|of| of.whole_kg).or(of.lightest_kg);
    let length = sizes.filter(|_| is_found).map(length_m).or(of.shortest_m);
    let number = |value: f64| Figure::Number(value);
    let mut rows = vec![];
    let mut row = |name, label, asked: Option<Figure>, reached| {
        rows.extend(asked.map(|asked| Row::new(name, label, "", [asked, reached])));
    };
    let mass = of.whole_kg.map(|mass| quantity(Dimension::Mass, mass));
    row("whole", "mass of the whole, at most", mass, figure(Dimension::Mass, whole));
    let most = of.length_m.map(|length| quantity(Dimension::Length, length));
    row("length", "length of the stages, at most", most, figure(Dimension::Length, length));
    let runaway = of.runaway_over_speed.map(number);
    let speed = figure(Dimension::AngularSpeed, of.runaway_speed_rad_s);
    row("runaway", "greatest speed without load, over that of the load", runaway, speed);
    let checks = sizes.iter().flat_map(|sizes| &sizes.judgement.checks);
    let pitch_line = checks.filter(|check| check.is_of(&[Rule::SpurSpeed, Rule::HelicalSpeed]));
    let fastest = pitch_line.filter_map(|check| check.value).reduce(f64::max);
    let is_asked = of.runaway_over_speed.map(|_| Figure::None);
    row("pitch_line_speed", "greatest pitch-line speed at it", is_asked, figure(Dimension::Speed, fastest));
    let force = of.side_load_n.map(|force| quantity(Dimension::Force, force));
    row("side_load", "side load of the output, not judged", force, Figure::None);
    const COLUMNS: &[(&str, &str)] = &[("asked", "asked"), ("reached", "reached")];
    let note = match is_found {
        true if of.runaway_over_speed == Some(1.0) => {
            "A runaway of 1 is the speed of the load, which is judged in any case."
        }
        true => "",
        false => "Reached: the least that was found, which exceeds a limit.",
    };
    let section = Section { name: "limits", title: "Limits of the whole", columns: COLUMNS, rows, note };
    of.is_any().then_some(Part::Facts(section))
}

/// Masses of the whole and of its parts.
pub(crate) fn masses(of: &Masses) -> Section {
    let row = |name, label, mass| Row::new(name, label, "", [quantity(Dimension::Mass, mass)]);
    let mut rows =
        vec![row("gears", "gears", of.gears_kg), row("structure", "carriers, housing", of.structure_kg)];
    let others = [
        ("slow_shaft", "slow shaft, its bearings, seals", of.slow_shaft_kg),
        ("flanges", "flanges, motor adapter, output bearings", of.flanges_kg),
        ("shift_elements", "brakes, clutches", of.shift_elements_kg),
    ];
    rows.extend(others.into_iter().filter_map(|(name, label, mass)| Some(row(name, label, mass?))));
    rows.push(row("whole", "whole", of.whole_kg));
    let note = match of.are_of_sets() {
        false => {
            "All but the gears by rules usual of the trade; oil, lubrication, actuation and the motor are not in them."
        }
        true => {
            "All but the gears by rules usual of the trade; oil, lubrication, actuation and the motor are not in them. The length above is that of the gears with carriers and covers, 0.12 of the ring's diameter a set, without shafts."
        }
    };
    Section { name: "masses", title: "Masses", columns: &[], rows, note }
}

/// Assumptions that are no keys of the file.
pub(crate) fn assumed(all: &[BasisKey]) -> Records {
    Table::new("assumed", all.iter())
        .text("what", "what", |one| &one.key)
        .text("value", "value", |one| &one.value)
        .view("Also assumed", "what value")
        .note("--planets, --bearing-type, --modules, --face-widths, --shares, --overload, --helix-angle and --factors 'K_gamma …, Y_M …' change them.")
        .records()
}

/// The sizes with their safeties, and what was left out.
pub(crate) fn parts_of_sizes(sizes: &SizesStep) -> Vec<Part> {
    let sets = &sizes.sets;
    let mut parts = vec![];
    if sets.iter().any(|set| !set.found.is_empty()) {
        parts.push(Part::Records(Records {
            is_answer: false,
            ..designs("designs", "Best sizes", sets, |set| &set.found)
        }));
        parts.push(Part::Records(gears(sets)));
        parts.push(Part::Records(over_duty(sets.iter().flat_map(safeties))));
    }
    if sets.iter().any(|set| set.nearest_miss.is_some()) {
        let misses = designs("nearest_misses", "Nearest misses", sets, |set| set.nearest_miss.as_slice());
        parts.push(Part::Records(misses));
    }
    parts.push(Part::Records(left_out(sets)));
    parts.extend(judgement::parts(&sizes.judgement));
    parts
}

/// The gears of the best size of a set.
fn safeties(set: &SizedSet) -> impl Iterator<Item = Worn<'_>> {
    let best = set.found.first();
    best.into_iter().flat_map(|best| &best.over_duty).map(|of| Worn {
        set: &set.set,
        mesh: &of.mesh,
        toothed_gear: &of.toothed_gear,
        material: &of.material,
        flank: Some(&of.flank),
        root: Some(&of.root),
    })
}

/// The scheme with the speeds that it reaches, ring, masses, least safeties and life.
pub(crate) fn in_short(design: &Design) -> String {
    let name = design.scheme.taken.as_deref();
    let (Some(name), Some(sizes), Some(_)) = (name, &design.sizes, &design.file) else {
        let best = name.map(|name| format!("; the best scheme is {name}")).unwrap_or_default();
        return format!("No gearbox with these speeds that holds was found{best}.");
    };
    let off = percent(largest_deviation(&design.speeds)).replace('+', "");
    let asked = trimmed(100.0 * design.scheme.criteria.tolerance, 3);
    let mut all = vec![name.to_owned(), format!("speeds within {off} (asked {asked} %)")];
    all.extend(of_sizes(sizes, design.masses.as_ref(), (&design.limits, "ring")));
    format!("{}.", all.join(", "))
}

/// Why a design ends before its last step.
fn stopped(design: &Design) -> Option<String> {
    let why = match (&design.teeth, &design.sizes, &design.file) {
        (.., Some(_)) => return None,
        (None, ..) => {
            "No scheme meets the criteria. `epicyclic select` with the same speeds and --tolerance lists the criteria that each one fails."
        }
        (Some(_), None, _) => "No tooth numbers within the bounds give the ratios, or not so many.",
        (Some(teeth), Some(_), _) if design.limits.lightest_kg.is_some() => {
            return Some(too_heavy(design, teeth));
        }
        (Some(_), Some(_), _) => {
            "No size of a set holds over the duty; the nearest misses list what they lack."
        }
    };
    let none = if design.ways_out.as_ref().is_some_and(Vec::is_empty) {
        " No single limit relaxed gives a gearbox: the tolerance up to 10 %, the criteria, directions of rotation, structures, tooth numbers, \
         ring offsets and sizes were tried, as far as they apply."
    } else {
        ""
    };
    Some(format!("{why}{none}"))
}

/// Number of gearboxes compared where every one is above the limit of the mass, and the lightest.
fn too_heavy(design: &Design, teeth: &TeethStep) -> String {
    let [count, within] = [teeth.compared.to_string(), trimmed(100.0 * teeth.tolerance, DIGITS)];
    let end = match teeth.complete {
        true => String::new(),
        false => format!(
            " The search ended early, after {} sets were sized: another gearbox may keep it; fewer teeth, such as --sun 20..40, or --scheme let it come to \
             its end.",
            teeth.sized
        ),
    };
    format!(
        "None of the gearboxes with the {count} tooth numbers within {within} % keeps --max-mass, with the sizes that are best of each; the lightest found \
         has {}.{end}",
        lightest(&design.limits).unwrap_or_default()
    )
}

/// The least mass found where it is above its limit.
pub(super) fn lightest(limits: &OrderLimits) -> Option<String> {
    limits.lightest_kg.map(|mass| beside(Dimension::Mass, mass, (limits.whole_kg, 3)))
}

/// Limits that would have to give, each with its gearbox.
fn ways_out(ways: &[WayOut]) -> Records {
    with_limits("ways_out", "Limits that would have to give, and the gearbox behind each", ways)
        .note(
            "Each line is the result of the same search with this option. Deviation: the largest of a gear.",
        )
        .records()
}

/// The best gearboxes with smaller and smaller rings.
fn smaller_rings(front: &[WayOut]) -> Records {
    with_limits("front", SMALLER_RINGS, front)
        .note(format!("{OF_FRONT} Deviation: the largest of a gear."))
        .records()
}

fn with_limits<'a>(name: &'static str, title: &'static str, ways: &'a [WayOut]) -> Table<&'a WayOut> {
    Table::new(name, ways.iter())
        .words("option", "option", |way| options(way))
        .words("scheme", "scheme", |way| {
            let reverses = if way.speeds.iter().any(|speed| speed.reversed) { ", reverses" } else { "" };
            format!("{}{reverses}", way.scheme)
        })
        .words("teeth", "teeth", |way| sets(&way.teeth))
        .number("deviation", "deviation", |way| percent(largest_deviation(&way.speeds)).replace('+', ""))
        .quantity("ring_diameter", "ring", Dimension::Length, |way| Some(way.ring_diameter_m))
        .quantity("mass", "whole", Dimension::Mass, |way| way.whole_kg)
        .number("rules_missed", "rules missed", |way| way.teeth.rules_missed.map(f64::from))
        .view(title, "option scheme teeth deviation ring_diameter mass rules_missed")
}

/// Title and note of a front.
pub(super) const SMALLER_RINGS: &str = "Smaller rings, and the gearbox behind each";
pub(super) const OF_FRONT: &str = "Each line is the result of the same search with this option, whose ring is 5 % below that of the line before. After the last none holds \
     with the same kinds of bearings, or it is the twelfth.";

/// A front, or a sentence if it is empty.
pub(super) fn or_none<T>(front: &[T], records: fn(&[T]) -> Records) -> Part {
    match front {
        [] => Part::Text(Text::paragraph(
            "No gearbox with rings 5 % smaller or more holds with the same kinds of bearings.",
        )),
        front => Part::Records(records(front)),
    }
}

/// Speeds that a way out reaches.
fn speeds_of(way: &WayOut) -> Records {
    let mut records = speeds_reached(&way.speeds);
    for view in &mut records.views {
        view.title = format!("{}: {}", options(way), view.title.to_lowercase());
    }
    records
}

/// A way out in words: the options and what they give.
#[must_use]
pub fn way_out(way: &WayOut) -> String {
    let whole = way.whole_kg.map(|mass| format!(", whole about {}", words(Dimension::Mass, mass, DIGITS)));
    format!("{} gives {}{}{}", options(way), way.scheme, whole.unwrap_or_default(), missed(&way.teeth))
}

fn options(way: &WayOut) -> String {
    options_of(&way.limits)
}

/// The options that relax the limits, as they are typed.
pub(super) fn options_of(limits: &[RelaxedLimit]) -> String {
    let all: Vec<String> = limits.iter().map(option).collect();
    all.join(" ")
}

fn option(one: &RelaxedLimit) -> String {
    let number = |value: Option<f64>| trimmed(value.unwrap_or_default(), 6);
    let (least, greatest) = (number(one.least), number(one.greatest));
    let end = |value: Option<f64>| value.map(|value| trimmed(value, 6)).unwrap_or_default();
    let range = || format!("{}..{}", end(one.least), end(one.greatest));
    match one.limit {
        Limit::Tolerance => format!("--tolerance {}%", trimmed(100.0 * one.greatest.unwrap_or_default(), 6)),
        Limit::RingToSunRatio => format!("--k {least}..{greatest}"),
        Limit::Efficiency => format!("--least-efficiency {least}"),
        Limit::LinkSpeed => format!("--link-speed {greatest}"),
        Limit::PlanetSpeed => format!("--planet-speed {greatest}"),
        Limit::ClutchSlip => format!("--clutch-slip {greatest}"),
        Limit::Circulation => format!("--circulation {greatest}"),
        Limit::SameDirection => "--may-reverse".to_owned(),
        Limit::Drawable => "--allow-crossing".to_owned(),
        Limit::Structures => "--all-structures".to_owned(),
        Limit::SunTeeth => format!("--sun {}", range()),
        Limit::PlanetTeeth => format!("--planet {}", range()),
        Limit::RingTeeth => format!("--ring {}", range()),
        Limit::RingOffset => format!("--ring-offset {least}..{greatest}"),
        Limit::WidthRatio => format!("--width-ratio {greatest}"),
        Limit::Modules => "without --modules".to_owned(),
        Limit::FaceWidths => "without --face-widths".to_owned(),
        Limit::LargestRing => match one.greatest {
            Some(ring) => format!("--max-ring {}mm", trimmed(1e3 * ring, 6)),
            None => "without --max-ring".to_owned(),
        },
        Limit::WholeMass => format!("--max-mass {greatest}kg"),
        Limit::Length => format!("--max-length {}mm", trimmed(1e3 * one.greatest.unwrap_or_default(), 6)),
        Limit::Planets => format!("--planets ..{greatest}"),
        Limit::Stages => format!("--stages {}", range()),
        Limit::HuntingTeeth => "without --hunting-teeth".to_owned(),
        Limit::PlainBearings => "--bearing-type plain".to_owned(),
        Limit::Bearings => "--no-bearings".to_owned(),
        Limit::Axes => "--axes either".to_owned(),
        Limit::StageKinds => "--kind simple,stepped,wolfrom".to_owned(),
    }
}

fn steps(design: &Design) -> Records {
    let mut rows = vec![scheme(&design.scheme)];
    rows.extend(design.teeth.as_ref().map(teeth));
    rows.extend(design.sizes.as_ref().map(sizes));
    rows.extend(design.sizes.as_ref().and_then(strength));
    let cell = |row: &[String; 5], place: usize| Some(text(&row[place])).filter(|_| !row[place].is_empty());
    Table::new("steps", rows)
        .words("step", "step", |row| cell(row, 0))
        .words("taken", "taken", |row| cell(row, 1))
        .words("among", "among", |row| cell(row, 2))
        .words("next", "next", |row| cell(row, 3))
        .words("chosen_otherwise_by", "otherwise by", |row| cell(row, 4))
        .view("Steps: what was taken", "step taken")
        .view(
            "Steps: among what, what came next, and how to choose otherwise",
            "step among next chosen_otherwise_by",
        )
        .note(
            "Scheme, tooth numbers and sizes are chosen together: the fewest sets beyond usual practice, then the least mass of gears, carriers and housing, or what --minimise says, a quarter more \
             for each rule missed.",
        )
        .the_answer()
        .records()
}

fn scheme(step: &SchemeStep) -> [String; 5] {
    let among = match step.asked_for {
        true => "asked for".to_owned(),
        false => format!("{} of {} that meet the criteria", step.accepted, step.compared),
    };
    let taken = step.taken.clone().unwrap_or_else(|| "none".to_owned());
    let other =
        |other: &OtherScheme| format!("{}: {}{}", other.scheme, sets(&other.teeth), mass(&other.teeth));
    let others: Vec<String> = step.others.iter().take(MOST_OTHERS).map(other).collect();
    ["scheme".to_owned(), taken, among, others.join("; "), "--scheme".to_owned()]
}

/// Teeth of sun, planet and ring of each set.
fn sets(of: &TeethTaken) -> String {
    let all: Vec<String> =
        of.sets.iter().map(|[sun, planet, ring]| format!("{sun} {planet} {ring}")).collect();
    all.join(" + ")
}

fn teeth(step: &TeethStep) -> [String; 5] {
    let taken = step.taken.as_ref().map_or_else(
        || "none".to_owned(),
        |of| {
            let ratios: Vec<String> = of.ratios.iter().map(|ratio| trimmed(*ratio, DIGITS)).collect();
            format!("{}, i = {}", sets(of), ratios.join(" and "))
        },
    );
    let within = trimmed(100.0 * step.tolerance, DIGITS);
    let ended = if step.complete { "" } else { "; the search ended early" };
    let among = format!("{} within {within} %, {} sets sized{ended}", step.compared, step.sized);
    let next = step.next.as_ref().map(|of| format!("{}{}", sets(of), mass(of)));
    ["teeth".to_owned(), taken, among, next.unwrap_or_default(), "--tooth-design, --tolerance".to_owned()]
}

/// Mass that decides, and the rules missed.
fn mass(of: &TeethTaken) -> String {
    let mass = of.mass_kg.map(|mass| format!(", {}", words(Dimension::Mass, mass, DIGITS)));
    format!("{}{}", mass.unwrap_or_default(), missed(of))
}

/// Rules missed.
fn missed(of: &TeethTaken) -> String {
    match of.rules_missed {
        None | Some(0) => String::new(),
        Some(1) => ", misses 1 rule".to_owned(),
        Some(missed) => format!(", misses {missed} rules"),
    }
}

fn sizes(step: &SizesStep) -> [String; 5] {
    let lengths = |design: &SizedDesign, of: fn(&SizedFamily) -> f64| {
        let all = design.families.iter().map(|family| words(Dimension::Length, of(family), DIGITS));
        all.collect::<Vec<_>>().join("/")
    };
    let of = |design: &SizedDesign| {
        format!(
            "m {}, b {}, {} planets",
            lengths(design, |family| family.module_m),
            lengths(design, |family| family.face_width_m),
            design.planets
        )
    };
    let all = |place: usize| {
        let each = step.sets.iter().map(|set| set.found.get(place).map_or("none".to_owned(), of));
        each.collect::<Vec<_>>().join(" + ")
    };
    let next = if step.sets.iter().all(|set| set.found.len() > 1) { all(1) } else { String::new() };
    ["sizes".to_owned(), all(0), format!("{} designs", step.designs), next, "--modules …, --save".to_owned()]
}

fn strength(step: &SizesStep) -> Option<[String; 5]> {
    let governing = step.governing.as_ref()?;
    let of = &governing.requirement;
    let what = match of.requirement {
        Requirement::Flank => format!("S_H of the {}'s flank", of.toothed_gear),
        Requirement::Root => format!("S_F of the {}'s root", of.toothed_gear),
        Requirement::OverloadFlank => format!("S_H of the {}'s flank against the overload", of.toothed_gear),
        Requirement::OverloadRoot => format!("S_F of the {}'s root against the overload", of.toothed_gear),
        Requirement::BearingLife => {
            "of the planet bearing, the load that it carries for the required life over its own".to_owned()
        }
    };
    let reserve = of.reserve();
    let steps = if reserve > NEAR {
        "; nothing is near its limit: the steps of modules, widths and bearings decide"
    } else {
        ""
    };
    let taken = format!(
        "{} of {} required: {what} of set {}, {} % of torque to spare{steps}",
        trimmed(of.value, DIGITS),
        trimmed(of.required, DIGITS),
        governing.set,
        trimmed(100.0 * (reserve - 1.0), 2)
    );
    Some(["strength".to_owned(), taken, String::new(), String::new(), "--basis, --factors".to_owned()])
}
