//! Stages in series, asked and reached, with what came next.

use crate::design::answer::arranged::{MOST_SIZED, MOST_TRIED};
use crate::design::answer::backlash::OutputBacklash;
use crate::design::answer::stage_kind::StageKind;
use crate::design::answer::stages::Stages;
use crate::design::answer::stages_ways_out::{PLANETS, RINGS, STAGES, suns};
use crate::design::answer::trains::TrainsOf;
use crate::design::answer::ways_out::WayOutOfStages;
use crate::design::table::{
    ASSUMED, DIGITS, OF_FRONT, SMALLER_RINGS, assumed, beside, lightest, limits, masses, of_found, of_sizes,
    options_of, or_none, parts_of_sizes,
};
use crate::select::table::percent;
use crate::size::table::basis;
use crate::table::columns::Table;
use crate::table::figure::{Figure, text};
use crate::table::quantities::{quantity, words};
use crate::table::report::{AsReport, Part, Records, Report, Row, Section, Text};
use epicyclic_units::Dimension;
use epicyclic_units::format::trimmed;

impl AsReport for Stages {
    fn report(&self) -> Report {
        let mut parts = parts_of_stages(self);
        parts.extend(self.sizes.iter().flat_map(parts_of_sizes));
        Report { title: Some(in_short(self)), parts, warnings: of_found(&self.warnings, self.file.is_some()) }
    }
}

/// Ratio and speeds asked and reached, the trains, and assumed values.
pub(crate) fn parts_of_stages(stages: &Stages) -> Vec<Part> {
    let mut parts = vec![Part::Facts(asked(stages))];
    parts.extend(in_the_way(stages).map(|why| Part::Text(Text::paragraph(why))));
    let ways = stages.ways_out.as_deref().unwrap_or_default();
    if !ways.is_empty() {
        parts.push(Part::Records(ways_out(ways)));
    }
    parts.push(Part::Records(trains(stages)));
    parts.extend(stages.front.as_deref().map(|front| or_none(front, smaller_rings)));
    parts.push(Part::Records(searched(stages)));
    parts.extend(limits(&stages.limits, stages.masses.as_ref(), stages.sizes.as_ref()));
    parts.extend(stages.masses.as_ref().map(|of| Part::Facts(masses(of))));
    parts.push(Part::Records(basis(&stages.basis, &format!("{ASSUMED}, --efficiency"))));
    parts.push(Part::Records(assumed(&stages.assumed)));
    parts
}

/// Limits that keep stages from being found; `None` with stages.
fn in_the_way(stages: &Stages) -> Option<String> {
    let ways = stages.ways_out.as_ref()?;
    let of_teeth = stages.trains.iter().filter(|trains| trains.compared == 0).filter_map(reach);
    let mut all: Vec<String> = of_teeth.collect();
    let has_trains = |trains: &&TrainsOf| trains.compared > 0;
    let of_strength = stages.trains.iter().filter(has_trains).map(|trains| count(trains.stages));
    let of_strength: Vec<String> = of_strength.collect();
    if !all.is_empty() {
        all[0] = format!("With {} the ratios reach {}", ranges(stages), all[0]);
    }
    let mut text = all.join("; ");
    if !text.is_empty() {
        text.push('.');
    }
    let without_teeth =
        stages.trains.iter().find(|trains| trains.kind != StageKind::Simple && trains.compared == 0);
    if let Some(of) = without_teeth.and_then(|trains| of_kind(trains.kind)) {
        text.push_str(&format!(
            " No {of} with teeth and numbers of planets within the bounds has the ratio."
        ));
    }
    if let Some(lightest) = lightest(&stages.limits) {
        text.push_str(&format!(" The lightest train found has {lightest}, above --max-mass."));
    } else if let Some(shortest) = stages.limits.shortest_m {
        text.push_str(&format!(
            " The shortest train found has {}, above --max-length.",
            beside(Dimension::Length, shortest, (stages.limits.length_m, 3))
        ));
    } else if !of_strength.is_empty() {
        text.push_str(&format!(
            " No trains of {} with the ratio have sizes that hold within the limits of modules, face widths, planets, rings and bearings.",
            of_strength.join(" or ")
        ));
    }
    let asked = stages.asked_ratio.abs();
    if stages.asked_ratio > 0.0 && asked.max(1.0 / asked) <= LEAST_RATIO && !has_pairs(stages) {
        text.push_str(&format!(
            " A stage with a held ring has a ratio above {LEAST_RATIO}; --ratios {} designs a gearbox of two gears, this one and direct drive, with other members held.",
            trimmed(asked, 6)
        ));
    } else if ways.is_empty() {
        text.push_str(&format!(
            " No limit relaxed alone gives stages that hold, nor do those of sizes, stages and tolerance together: the tolerance up to 10 %, {} to {} stages, \
             {}, ring offsets and sizes were tried.",
            STAGES.start(),
            STAGES.end(),
            options_of_teeth([suns(asked.max(1.0 / asked)), PLANETS, RINGS])
        ));
    }
    Some(text.trim_start().to_owned())
}

/// Ratio that a stage with a held ring always exceeds.
const LEAST_RATIO: f64 = 2.0;

/// Tooth numbers allowed, with their options.
fn ranges(stages: &Stages) -> String {
    let teeth = &stages.teeth;
    options_of_teeth([teeth.sun, teeth.planet, teeth.ring])
}

/// Options of tooth numbers of suns, planets and rings.
fn options_of_teeth([sun, planet, ring]: [[u32; 2]; 3]) -> String {
    let of = |option: &str, [least, most]: [u32; 2]| format!("--{option} {least}..{most}");
    format!("{}, {} and {}", of("sun", sun), of("planet", planet), of("ring", ring))
}

/// Ratios that a number of stages reaches.
fn reach(trains: &TrainsOf) -> Option<String> {
    let [one, other] = trains.reachable?.map(of_ratio);
    let pair = if trains.has_pair { ", the fast one a pair" } else { "" };
    Some(format!("{one} to {other} with {}{pair}", count(trains.stages)))
}

/// Number of stages in words.
fn count(stages: usize) -> String {
    if stages == 1 { "1 stage".to_owned() } else { format!("{stages} stages") }
}

/// Message if no stages are found: the first way out, or the limits in the way.
pub(crate) fn why_no_stages(stages: &Stages) -> String {
    let ways = stages.ways_out.as_deref().unwrap_or_default();
    let why = match ways.first() {
        Some(way) => {
            let mass =
                way.whole_kg.map(|mass| format!(", whole about {}", words(Dimension::Mass, mass, DIGITS)));
            let of = count(way.teeth.len());
            let ratio = of_ratio(way.ratio);
            format!("{} gives {of}, i = {ratio}{}", options_of(&way.limits), mass.unwrap_or_default())
        }
        None => {
            let why = in_the_way(stages).unwrap_or_default();
            let (first, rest) = why.split_at(usize::from(why.is_char_boundary(1)));
            format!("{}{}", first.to_lowercase(), rest.trim_end_matches('.'))
        }
    };
    format!("no stages that hold were found; {why}")
}

/// Limits that would have to give, each with its stages.
fn ways_out(ways: &[WayOutOfStages]) -> Records {
    with_limits("ways_out", "Limits that would have to give, and the stages behind each", ways)
        .note("Each line is the result of the same search with this option.")
        .records()
}

/// The best stages with smaller and smaller rings.
fn smaller_rings(front: &[WayOutOfStages]) -> Records {
    with_limits("front", SMALLER_RINGS, front).note(OF_FRONT).records()
}

fn with_limits<'a>(
    name: &'static str,
    title: &'static str,
    all: &'a [WayOutOfStages],
) -> Table<&'a WayOutOfStages> {
    Table::new(name, all.iter())
        .words("option", "option", |way| options_of(&way.limits))
        .words("teeth", "sun, planet, ring", |way| teeth(&way.teeth))
        .words("ratio", "i", |way| of_ratio(way.ratio))
        .number("efficiency", "η", |way| way.efficiency)
        .quantity("ring_diameter", "ring", Dimension::Length, |way| {
            Some(way.ring_diameter_m).filter(|ring| *ring > 0.0)
        })
        .quantity("mass", "whole", Dimension::Mass, |way| way.whole_kg)
        .number("rules_missed", "rules missed", |way| f64::from(way.rules_missed))
        .view(title, "option teeth ratio efficiency ring_diameter mass rules_missed")
}

/// The train with its ratio, ring, mass, least safeties and life.
pub(crate) fn in_short(stages: &Stages) -> String {
    let asked = format!("{} ± {} %", of_ratio(stages.asked_ratio), trimmed(100.0 * stages.tolerance, DIGITS));
    let steps_up = stages.asked_ratio.abs() < 1.0;
    let (Some(ratio), Some(sizes)) = (stages.ratio, &stages.sizes) else {
        let steps_up = if steps_up { format!(", which {STEPS_UP},") } else { String::new() };
        return format!("No stages with i = {asked}{steps_up} that hold were found.");
    };
    let mut all = vec![count(sizes.sets.len())];
    let has_pair = stages.taken().is_some_and(|trains| trains.has_pair);
    all.extend(has_pair.then(|| match sizes.sets.len() {
        1 => format!("a pair of gears, {TURNS_AROUND}"),
        _ => format!("the fast one a pair of gears, {TURNS_AROUND}"),
    }));
    let kind = stages.taken().map_or(StageKind::Simple, |trains| trains.kind);
    all.extend(of_kind(kind).map(|of| format!("a {of}")));
    all.extend((ratio < 0.0 && !has_pair && kind == StageKind::Simple).then(|| RINGS_TURN.to_owned()));
    all.extend(steps_up.then(|| STEPS_UP.to_owned()));
    all.push(format!("i = {} (asked {asked})", of_ratio(ratio)));
    all.extend(stages.efficiency.map(|of| format!("η = {}", trimmed(of, 3))));
    let diameter = if kind == StageKind::Stepped { "diameter" } else { "ring" };
    all.extend(of_sizes(sizes, stages.masses.as_ref(), (&stages.limits, diameter)));
    format!("{}.", all.join(", "))
}

/// A ratio, of a train that steps up as 1/99.2.
fn of_ratio(ratio: f64) -> String {
    if ratio.abs() >= 1.0 {
        return trimmed(ratio, DIGITS);
    }
    let sign = if ratio < 0.0 { "-" } else { "" };
    format!("{sign}1/{}", trimmed(1.0 / ratio.abs(), DIGITS))
}

/// Words for a ratio below 1: the output is faster than the input.
const STEPS_UP: &str = "steps up";

/// Words for a negative ratio: the output turns against the input.
const RINGS_TURN: &str = "rings turning with the slow shaft, its carrier held";

/// Effect of a pair of external gears.
const TURNS_AROUND: &str = "which turns the direction around";

fn asked(stages: &Stages) -> Section {
    let of = |dimension, value: Option<f64>| value.map_or(Figure::None, |value| quantity(dimension, value));
    // The load is asked for at one of both shafts.
    let is_of_input = stages.asked_output_torque_n_m.is_none();
    let of_input = |name, label, symbol, dimension, value: Option<f64>| {
        let asked = of(dimension, value.filter(|_| is_of_input));
        Row::new(name, label, symbol, [asked, of(dimension, value), Figure::None])
    };
    let deviation = stages.ratio.map(|ratio| percent((ratio / stages.asked_ratio).abs() - 1.0));
    let mut rows = vec![
        Row::new(
            "ratio",
            "ratio",
            "i",
            [
                Figure::Number(stages.asked_ratio),
                stages.ratio.map_or(Figure::None, Figure::Number),
                deviation.map_or(Figure::None, text),
            ],
        ),
        Row::new(
            "output_speed",
            "speed of the output",
            "n",
            [
                quantity(Dimension::AngularSpeed, stages.asked_output_speed_rad_s),
                of(Dimension::AngularSpeed, stages.output_speed_rad_s),
                Figure::None,
            ],
        ),
        Row::new(
            "output_torque",
            "torque on the output, with losses",
            "T",
            [
                of(Dimension::Torque, stages.asked_output_torque_n_m),
                of(Dimension::Torque, stages.output_torque_n_m),
                Figure::None,
            ],
        ),
        Row::new(
            "efficiency",
            "efficiency of all meshes",
            "η",
            [Figure::None, stages.efficiency.map_or(Figure::None, Figure::Number), Figure::None],
        ),
        Row::new(
            "back_driving_efficiency",
            "efficiency, driven by the output",
            "η back",
            [
                Figure::None,
                match stages.back_driving_efficiency {
                    Some(efficiency) => Figure::Number(efficiency),
                    None if stages.file.is_some() => text("self-locking".to_owned()),
                    None => Figure::None,
                },
                Figure::None,
            ],
        ),
        of_input("input_torque", "torque on the input", "T_in", Dimension::Torque, stages.input_torque_n_m),
        of_input("input_power", "power into the input", "P", Dimension::Power, stages.input_power_w),
    ];
    rows.extend(stages.backlash.as_ref().map(backlash));
    const COLUMNS: &[(&str, &str)] =
        &[("asked", "asked"), ("reached", "reached"), ("deviation", "deviation")];
    Section { name: "asked_and_reached", title: "Asked and reached", columns: COLUMNS, rows, note: "" }
}

/// Greatest backlash of the output, asked and reached.
fn backlash(of: &OutputBacklash) -> Row {
    let [_, greatest] = of.reached_rad;
    // In the unit of servo drives.
    let minutes = |angle: f64| text(format!("{} arcmin", trimmed(60.0 * angle.to_degrees(), DIGITS)));
    let [asked, reached] = [of.asked_rad, greatest].map(minutes);
    Row::new("backlash", "greatest backlash of the output, of the teeth", "φ", [asked, reached, Figure::None])
}

/// Kind of a set with planets of two gears in words; `None` of simple sets.
const fn of_kind(kind: StageKind) -> Option<&'static str> {
    match kind {
        StageKind::Simple => None,
        StageKind::Stepped => Some("set with stepped planets"),
        StageKind::Wolfrom => Some("Wolfrom set"),
    }
}

/// Teeth of each stage, with its kind unless it is a simple set.
fn teeth(stages: &[Vec<u32>]) -> String {
    let numbers = |teeth: &Vec<u32>| {
        let all: Vec<String> = teeth.iter().map(u32::to_string).collect();
        let kind = match StageKind::of(teeth) {
            StageKind::Simple if teeth.len() == 2 => "pair ",
            StageKind::Simple => "",
            StageKind::Stepped => "stepped ",
            StageKind::Wolfrom => "Wolfrom ",
        };
        format!("{kind}{}", all.join(" "))
    };
    let all: Vec<String> = stages.iter().map(numbers).collect();
    all.join(" + ")
}

fn trains(stages: &Stages) -> Records {
    let rows =
        stages.trains.iter().flat_map(|of| [(of, of.best.as_ref(), true), (of, of.next.as_ref(), false)]);
    // A second line only where there is a second train; none for tooth numbers that do not give the ratio where
    // the other kind of fast stage has trains.
    let has_train =
        |of: &TrainsOf| stages.trains.iter().any(|other| other.stages == of.stages && other.best.is_some());
    let rows = rows
        .filter(|(of, train, is_best)| train.is_some() || *is_best && (of.compared > 0 || !has_train(of)));
    let columns = if has_kinds(stages) {
        "stages fast_stage taken teeth ratio mass rules_missed"
    } else {
        "stages taken teeth ratio mass rules_missed"
    };
    Table::new("trains", rows.collect::<Vec<_>>())
        .words("fast_stage", "fast stage", |(of, ..)| Some(fast_stage(of)))
        .number("stages", "stages", |(of, ..)| of.stages as f64)
        .words("taken", "", |(of, _, is_best)| (of.taken && *is_best).then_some("taken"))
        .words("teeth", "sun, planet, ring", |(of, train, _)| match train {
            Some(train) => teeth(&train.teeth),
            None if of.compared == 0 => match of.reachable.map(|ends| ends.map(of_ratio)) {
                Some([one, other]) => format!("none: the teeth give {one} to {other}"),
                None => "none: no teeth within the bounds".to_owned(),
            },
            None if of.complete => "none holds".to_owned(),
            None => "none found before the search ended".to_owned(),
        })
        .number("ratio", "i", |(_, train, _)| train.map(|train| train.ratio))
        .quantity("mass", "mass", Dimension::Mass, |(_, train, _)| train.map(|train| train.mass_kg))
        .number("rules_missed", "rules missed", |(_, train, _)| train.map(|train| f64::from(train.rules_missed)))
        .view("The best trains of each number of stages", columns)
        .note(format!(
            "The teeth are those of {}. Trains that keep to usual practice come first, then less mass, of which each rule missed counts a quarter and each stage 15 %: \
             of gears, carriers and housing by a rule, or what --minimise says. Slow shaft and flanges are not in this mass. \
             --stages decides otherwise.{}{}",
            ranges(stages),
            if has_pairs(stages) { " Pairs have the teeth of --axes." } else { "" },
            arranged(stages).map(|note| format!(" {note}")).unwrap_or_default()
        ))
        .records()
}

/// Whether trains were searched whose fast stage is a pair.
fn has_pairs(stages: &Stages) -> bool {
    stages.trains.iter().any(|trains| trains.has_pair)
}

/// Order of the teeth of sets with planets of two gears, and how the sets were chosen; `None` without such sets.
fn arranged(stages: &Stages) -> Option<String> {
    let has = |kind| stages.trains.iter().any(|trains| trains.kind == kind);
    let order = [
        has(StageKind::Stepped).then_some("stepped: sun, both steps, ring"),
        has(StageKind::Wolfrom)
            .then_some("Wolfrom: sun, first step, its ring at rest, second step, its ring"),
    ];
    let order: Vec<&str> = order.into_iter().flatten().collect();
    (!order.is_empty()).then(|| {
        format!(
            "Teeth of {}. Of sets with planets of two gears the {MOST_TRIED} with the least estimated volume are sized coarsely at most, the {MOST_SIZED} best of these in full: a few teeth more or fewer may be lighter. Their losses are a rule of practice like the others. Without --sun their suns have up to 60 teeth.",
            order.join("; of ")
        )
    })
}

/// Whether trains of several kinds were searched, or of another kind than simple sets.
fn has_kinds(stages: &Stages) -> bool {
    stages.trains.iter().any(|trains| trains.has_pair || trains.kind != StageKind::Simple)
}

/// Kind of the fast stage.
const fn fast_stage(of: &TrainsOf) -> &'static str {
    match of.kind {
        StageKind::Simple if of.has_pair => "pair",
        StageKind::Simple => "set",
        StageKind::Stepped => "stepped",
        StageKind::Wolfrom => "Wolfrom",
    }
}

fn searched(stages: &Stages) -> Records {
    let columns = if has_kinds(stages) {
        "stages fast_stage compared sized complete"
    } else {
        "stages compared sized complete"
    };
    Table::new("searched", stages.trains.iter())
        .words("fast_stage", "fast stage", |of| Some(fast_stage(of)))
        .number("stages", "stages", |of| of.stages as f64)
        .number("compared", "trains", |of| of.compared as f64)
        .number("sized", "stages sized", |of| of.sized as f64)
        .words("complete", "all compared", |of| if of.complete { "yes" } else { "no" })
        .view("How they were found", columns)
        .note("trains: within the part of the tolerance from which the train is taken. A stage is sized only where a bound below its mass leaves it a chance.")
        .records()
}
