//! Modes, orders and resonances as tables; those of the whole gearbox are in `train`.

mod train;

use crate::shared::judgement::table as judgement;
use crate::table::columns::Table;
use crate::table::figure::{Figure, rpm, text};
use crate::table::quantities::{optional, quantity, words};
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, warned};
use crate::vibrate::answer::Vibration;
use crate::vibrate::answer::records::{
    self, BodyMotion, Mode, NotCalculated, Order, Resonance, Response, SetModes, Shares, Source,
    StiffnessOrigin, What,
};
use epicyclic_pictures::campbell::{self, Branch, Ray};
use epicyclic_pictures::modes;
use epicyclic_pictures::plot::{Curve, Plot};
use epicyclic_units::Dimension::{AngularSpeed, Force, Frequency, Inertia, Length, Mass, Stiffness, Torque};
use epicyclic_units::format::in_unit;
use epicyclic_vibration::Kind;
pub use train::torsional_campbell;

/// By this a turn a minute becomes hertz.
const SECONDS_A_MINUTE: f64 = 60.0;

/// The frequencies over the speed of a set in a gear as a Campbell diagram; its place is that in the answer.
/// Zero modes are left out.
#[must_use]
pub fn campbell(all: &Vibration, place: usize) -> Option<campbell::Campbell> {
    let one = all.campbell.get(place)?;
    let is_own = |set: &str, gear: &str| set == one.set && gear == one.gear;
    let branch =
        |branch: &records::Branch| Branch { kind: branch.kind, frequencies: branch.frequencies_hz.clone() };
    let ray = |order: &Order| Ray {
        name: ray_name(order.source, order.part.as_deref(), order.harmonic),
        slope: order.of_input / SECONDS_A_MINUTE,
    };
    let moves = |branch: &&records::Branch| branch.frequencies_hz.iter().any(|frequency| *frequency > 0.0);
    let met = all.resonances.iter().filter(|met| is_own(&met.set, &met.gear));
    Some(campbell::Campbell {
        title: format!("{}, set {}, gear {}", all.gearbox, one.set, one.gear),
        across: "speed of the input, rpm".to_owned(),
        up: "frequency, Hz".to_owned(),
        speeds: one.input_speeds_rad_s.iter().map(|speed| rpm(*speed)).collect(),
        branches: one.branches.iter().filter(moves).map(branch).collect(),
        rays: all.orders.iter().filter(|order| is_own(&order.set, &order.gear)).map(ray).collect(),
        meetings: met.map(|met| [rpm(met.input_speed_rad_s), met.frequency_hz]).collect(),
        size_mm: campbell::SIZE_MM,
        is_untitled: false,
    })
}

/// A short name of an order.
fn ray_name(of: Source, part: Option<&str>, harmonic: u32) -> String {
    match of {
        Source::Mesh => format!("{} {harmonic}", source(of, part)),
        of => source(of, part),
    }
}

/// The forces that transmission errors make in a set in a gear over the speed as a plot; its place is that in
/// the answer.
#[must_use]
pub fn response(all: &Vibration, place: usize) -> Option<Plot> {
    let one = all.responses.get(place)?;
    let damping = Figure::Share(one.damping_ratio).table();
    let title = format!(
        "{}, set {}, gear {}: forces of the meshes, damping {damping}",
        all.gearbox, one.set, one.gear
    );
    let mut plot = Plot::new(title, "speed of the input, rpm", "amplitude of the force, N");
    for harmonic in &one.harmonics {
        for mesh in &harmonic.meshes {
            let (name, error) = (&mesh.mesh, mesh.error_m);
            let points = std::iter::zip(&harmonic.input_speeds_rad_s, &mesh.forces_n);
            let points = points.map(|(speed, force)| [rpm(*speed), *force]).collect();
            plot = plot.with(Curve::new(
                format!("{name}, harmonic {}: {}", harmonic.harmonic, words(Length, error, 3)),
                points,
            ));
        }
    }
    Some(plot)
}

/// The modes of a set as pictures along the axis; its place is that in the answer.
#[must_use]
pub fn shapes(all: &Vibration, place: usize) -> Option<(String, Vec<modes::Mode>)> {
    let set = all.sets.get(place)?;
    let body = |motion: &BodyMotion| {
        let own = set.bodies.iter().find(|body| body.body == motion.body)?;
        let angle = |number: u32| set.planet_angles_rad.get(number as usize - 1).copied().unwrap_or_default();
        let further = motion.planet.map_or(0.0, |number| angle(number) - angle(1));
        let ([x, y], [cos, sin]) = (own.centre_m, [libm::cos(further), libm::sin(further)]);
        let centre = [x * cos - y * sin, x * sin + y * cos];
        Some(modes::Body {
            part: own.part,
            centre,
            radius: own.radius_m,
            motion: [motion.x, motion.y, motion.u],
        })
    };
    let mode = |mode: &Mode| modes::Mode {
        name: format!(
            "{}: {}, {}",
            mode.mode,
            in_unit(mode.frequency_hz, Frequency.usual_unit(), 5),
            kind(mode.kind)
        ),
        bodies: mode.shape.iter().filter_map(body).collect(),
    };
    let gears = set.gears.join(", ");
    let of_gears = if gears.is_empty() { String::new() } else { format!(", gear {gears}") };
    Some((format!("{}, set {}{of_gears}", all.gearbox, set.set), set.modes.iter().map(mode).collect()))
}

/// A chapter of a page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Chapter {
    /// Frequencies, kinds and energies, with the bodies and springs.
    Frequencies,
    /// Orders and where they meet a mode.
    Resonances,
    /// What transmission errors do.
    Forces,
}

/// The tables of a chapter of a page, which has the warnings elsewhere.
pub(crate) fn chapter(all: &Vibration, of: Chapter) -> Report {
    let parts = tables(all).into_iter().filter(|(chapter, _)| *chapter == of).map(|(_, records)| records);
    Report { parts: parts.map(Part::Records).collect(), ..Report::default() }
}

/// All tables, each with its chapter.
fn tables(all: &Vibration) -> Vec<(Chapter, Records)> {
    use Chapter::{Forces, Frequencies, Resonances};
    let has_sets = !all.sets.is_empty();
    let over_speed = !all.campbell.is_empty();
    let has_resonances = all.torsional.iter().any(|one| !one.orders.is_empty());
    let has_inertias = all.torsional.iter().any(|one| one.inertia_at_input_kg_m2.is_some());
    let tables = [
        (has_sets, Frequencies, of_modes(&all.sets, !over_speed)),
        (over_speed, Resonances, resonances(&all.resonances)),
        (over_speed && !all.responses.is_empty(), Forces, responses(&all.responses)),
        (over_speed, Resonances, orders(&all.orders)),
        (!all.torsional.is_empty(), Frequencies, train::torsional(&all.torsional)),
        (has_inertias, Frequencies, train::inertias(&all.torsional)),
        (has_resonances, Resonances, train::resonances(&all.torsional)),
        (has_resonances, Resonances, train::orders(&all.torsional)),
        (!all.coupled.is_empty(), Frequencies, train::coupled(&all.coupled)),
        (!all.coupled.is_empty(), Frequencies, train::centres(&all.coupled)),
        (has_sets, Frequencies, bodies(&all.sets)),
        (has_sets, Frequencies, springs(&all.sets)),
        (!all.not_calculated.is_empty(), Frequencies, not_calculated(&all.not_calculated)),
    ];
    tables.into_iter().filter(|(is_told, ..)| *is_told).map(|(_, of, records)| (of, records)).collect()
}

impl AsReport for Vibration {
    fn report(&self) -> Report {
        Report {
            title: Some(format!("{}: vibration", self.gearbox)),
            parts: tables(self)
                .into_iter()
                .map(|(_, records)| Part::Records(records))
                .chain(judgement::parts(&self.judgement))
                .collect(),
            warnings: warned(&self.warnings),
        }
    }
}

/// A share in per cent.
fn share(of: f64) -> Figure {
    Figure::Printed(100.0 * of, 1)
}

const fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Rotational => "rotational",
        Kind::Translational => "translational",
        Kind::Planet => "planet",
        Kind::Mixed => "mixed",
    }
}

/// Source of an excitation in words, with the part where the set is not simple.
fn source(source: Source, part: Option<&str>) -> String {
    match (source, part) {
        (Source::Mesh, None) => "meshes".to_owned(),
        (Source::Mesh, Some(part)) => match part.split_once(", ") {
            // Names of many meshes would fill a line.
            Some((first, others)) if others.contains(", ") => {
                format!("meshes {first} and {} more", others.split(", ").count())
            }
            _ => format!("meshes {part}"),
        },
        (Source::SunTurn | Source::RingTurn | Source::GearTurn, Some(part)) => format!("turn of {part}"),
        (Source::PlanetTurn, Some(part)) => format!("turn of a {part}"),
        (Source::SunPlanetPass | Source::RingPlanetPass, Some(part)) => format!("planets pass {part}"),
        (Source::SunTurn, None) => "turn of the sun".to_owned(),
        (Source::RingTurn, None) => "turn of the ring".to_owned(),
        (Source::GearTurn, None) => "turn of a gear".to_owned(),
        (Source::SunPlanetPass, None) => "planets pass the sun".to_owned(),
        (Source::RingPlanetPass, None) => "planets pass the ring".to_owned(),
        (Source::PlanetTurn, None) => "turn of a planet".to_owned(),
        (Source::LinkTurn, _) => "turn of the shaft".to_owned(),
    }
}

/// The part that excites, which tables have in words with the source.
fn part(of: Option<&str>) -> Figure {
    of.map_or(Figure::None, text)
}

/// Source of an excitation for a table.
fn excited_by(of: Source, part: Option<&str>) -> Figure {
    Figure::choice(of, source(of, part))
}

/// The part with most of an energy, with its share.
fn most<N: std::fmt::Display>(shares: impl IntoIterator<Item = (f64, N)>) -> Figure {
    let most = shares.into_iter().max_by(|one, other| one.0.total_cmp(&other.0));
    most.map_or(Figure::None, |(share, name)| text(format!("{name} {:.0}", 100.0 * share)))
}

/// Bodies and springs of simple sets, and the headings of their columns.
const BODIES: [&str; 4] = ["sun", "ring", "carrier", "planets"];
const SPRINGS: [&str; 4] = ["sun_meshes", "ring_meshes", "planet_bearings", "supports"];
const HEADINGS: [&str; 8] = ["sun", "ring", "carrier", "planets", "s mesh", "r mesh", "bearings", "supports"];

/// Least share shown in a list, per cent.
const LEAST_SHOWN: f64 = 1.0;

fn of_modes(sets: &[SetModes], is_answer: bool) -> Records {
    let largest =
        |shares: &Shares| most(shares.0.iter().map(|(name, share)| (*share, name.replace('_', " "))));
    let listed = |shares: &Shares| {
        let shown =
            shares.0.iter().map(|(name, share)| (name, 100.0 * share)).filter(|one| one.1 >= LEAST_SHOWN);
        let shown = shown.map(|(name, share)| format!("{} {share:.1}", name.replace('_', " ")));
        text(shown.collect::<Vec<_>>().join(", "))
    };
    // Parts that only sets have which are not simple.
    let usual = [&BODIES[..], &SPRINGS[..]].concat();
    let mut others: Vec<&str> = vec![];
    for mode in sets.iter().flat_map(|set| &set.modes) {
        let all = mode.kinetic.0.iter().chain(mode.strain.iter().flat_map(|strain| &strain.0));
        for (name, _) in all {
            if !usual.iter().chain(&others).any(|one| one == name) {
                others.push(name);
            }
        }
    }
    // Sets of other parts have no columns in common.
    let parts = if others.is_empty() { &usual[..] } else { &["all_bodies", "all_springs"] };
    // A set has several lines for a mode where its gears have other modes.
    let repeats =
        sets.iter().enumerate().any(|(place, set)| sets[..place].iter().any(|one| one.set == set.set));
    let energies = [if repeats { &["set", "gears", "mode"][..] } else { &["set", "mode"] }, parts].concat();
    let of =
        |mode: &Mode, part: &str| mode.kinetic.of(part).or_else(|| mode.strain.as_ref()?.of(part)).map(share);
    let has = |part: &str| sets.iter().flat_map(|set| &set.modes).any(|mode| of(mode, part).is_some());
    Table::new("modes", sets.iter().flat_map(|set| set.modes.iter().map(move |mode| (set, mode))))
        .text("set", "set", |(set, _)| &set.set)
        .words("gears", "gears", |(set, _)| set.gears.clone())
        .words("held", "held", |(set, _)| set.held.clone())
        .number("mode", "mode", |(_, mode)| mode.mode)
        .words("kind", "kind", |(_, mode)| Figure::choice(mode.kind, kind(mode.kind)))
        .number("multiplicity", "×", |(_, mode)| mode.multiplicity)
        .measured("frequency", "f", Frequency, 1, |(_, mode)| mode.frequency_hz)
        .words("moves", "moves most, %", |(_, mode)| largest(&mode.kinetic))
        .for_people()
        .words("strained", "strained most, %", |(_, mode)| mode.strain.as_ref().map(largest))
        .for_people()
        .words("all_bodies", "bodies", |(_, mode)| listed(&mode.kinetic))
        .for_people()
        .words("all_springs", "springs", |(_, mode)| mode.strain.as_ref().map(listed))
        .for_people()
        .each(std::iter::zip(usual.clone(), HEADINGS), |table, (part, heading)| {
            table.number(part, heading, |(_, mode)| of(mode, part)).only_if(has(part))
        })
        .each(&others, |table, part| {
            table.number("share", &part.replace('_', " "), |(_, mode)| of(mode, part)).of(part)
        })
        .view("Natural frequencies", "set gears mode kind multiplicity frequency moves strained")
        .note(
            "×: how many modes have this frequency. Rotational: sun, ring and carrier rotate and do not translate; translational: \
             they translate; planet: they are at rest. At 0 Hz all turn by their ratios.",
        )
        .view_of("Where the energy is", &energies)
        .note(
            "Shares in per cent: of the bodies in the kinetic energy, of the springs in the strain energy. Springs that stiffen by \
             1 % raise the frequency by half their share of 1 %; a body that grows by 1 % lowers it by half its share.",
        )
        .the_answer_if(is_answer)
        .records()
}

fn resonances(all: &[Resonance]) -> Records {
    let note = "Speeds of the input at which what excites has the frequency of a mode that it can excite.";
    let title = if all.is_empty() { "Resonances: none at these speeds" } else { "Resonances" };
    Table::new("resonances", all.iter())
        .text("set", "set", |one| &one.set)
        .text("gear", "gear", |one| &one.gear)
        .quantity("input_speed", "n in", AngularSpeed, |one| one.input_speed_rad_s)
        .words("source", "excited by", |one| excited_by(one.source, one.part.as_deref()))
        .words("part", "part", |one| part(one.part.as_deref()))
        .only_if(all.iter().any(|one| one.part.is_some()))
        .number("harmonic", "harm.", |one| one.harmonic)
        .number("mode", "mode", |one| one.mode)
        .words("kind", "kind", |one| Figure::choice(one.kind, kind(one.kind)))
        .measured("frequency", "f", Frequency, 1, |one| one.frequency_hz)
        .view(title, "set gear input_speed source harmonic mode kind frequency")
        .note(note)
        .records()
}

fn responses(all: &[Response]) -> Records {
    let rows = all.iter().flat_map(|set| {
        set.harmonics.iter().flat_map(move |one| one.meshes.iter().map(move |mesh| (set, one, mesh)))
    });
    let has_others = all.iter().flat_map(|set| &set.harmonics).any(|one| one.sun_error_m.is_none());
    let torque = if has_others { "T" } else { "T sun" };
    let on = if has_others { "torque on the gear beside it" } else { "torque on the sun" };
    let note = format!(
        "The greatest force F beside the mean one that the transmission error e makes within the speeds. Gyro: with the gyroscopic effect of the carrier's speed. T: {on} \
                   below which the flanks part there, and this is no longer so."
    );
    Table::new("responses", rows)
        .text("set", "set", |(set, _, _)| &set.set)
        .text("gear", "gear", |(set, _, _)| &set.gear)
        .text("mesh", "mesh", |(_, _, mesh)| &mesh.mesh)
        .number("harmonic", "harm.", |(_, one, _)| one.harmonic)
        .column(Column::headed("error", "e", Length), |(_, _, mesh)| quantity(Length, mesh.error_m))
        .quantity("input_speed", "n in", AngularSpeed, |(_, _, mesh)| mesh.greatest.input_speed_rad_s)
        .measured("frequency", "f", Frequency, 1, |(_, _, mesh)| mesh.greatest.frequency_hz)
        .quantity("force", "F", Force, |(_, _, mesh)| mesh.greatest.force_n)
        .quantity("parts_below_sun_torque", torque, Torque, |(_, _, mesh)| {
            mesh.greatest.parts_below_torque_n_m
        })
        .words("torque_on", "on", |(_, _, mesh)| mesh.torque_on.as_deref().map_or(Figure::None, text))
        .only_if(has_others)
        .words("gyroscopic", "gyro", |(set, _, _)| {
            Figure::answer(set.gyroscopic.to_string(), if set.gyroscopic { "yes" } else { "no" })
        })
        .view(
            "Forces by the transmission error",
            "set gear mesh harmonic error input_speed frequency force \
                     parts_below_sun_torque torque_on gyroscopic",
        )
        .note(note)
        .records()
}

fn orders(all: &[Order]) -> Records {
    Table::new("orders", all.iter())
        .text("set", "set", |one| &one.set)
        .text("gear", "gear", |one| &one.gear)
        .words("source", "excited by", |one| excited_by(one.source, one.part.as_deref()))
        .words("part", "part", |one| part(one.part.as_deref()))
        .only_if(all.iter().any(|one| one.part.is_some()))
        .number("harmonic", "harm.", |one| one.harmonic)
        .multiple("of_input", "order", |one| one.of_input)
        .measured("frequency", "f", Frequency, 1, |one| one.frequency_hz)
        .words("excites", "excites", |one| one.excites.map_or(text("all"), |of| Figure::choice(of, kind(of))))
        .view("Orders", "set gear source harmonic of_input frequency excites")
        .note(
            "Order: frequency over that of a turn of the input, in axes on the carrier; f: at the greatest speed of the input. A damaged tooth of a \
             central gear strikes as often as planets pass the gear, one of a planet once a turn in each of its meshes.",
        )
        .records()
}

fn bodies(sets: &[SetModes]) -> Records {
    let note = "Without a mass the centre is held, without an inertia the rotation. r: base radius, of the carrier the radius of the planets' \
                   circle.";
    Table::new("bodies", sets.iter().flat_map(|set| set.bodies.iter().map(move |body| (set, body))))
        .text("set", "set", |(set, _)| &set.set)
        .words("gears", "gears", |(set, _)| set.gears.clone())
        .words("body", "body", |(_, body)| text(&body.body))
        .quantity("mass", "m", Mass, |(_, body)| body.mass_kg)
        .column(Column::headed("inertia", "I", Inertia), |(_, body)| optional(Inertia, body.inertia_kg_m2))
        .quantity("radius", "r", Length, |(_, body)| body.radius_m)
        .view("Bodies", "set gears body mass inertia radius")
        .note(note)
        .records()
}

fn springs(sets: &[SetModes]) -> Records {
    let rows = sets.iter().flat_map(|set| set.springs.iter().map(move |spring| (set, spring)));
    let is_helical = |spring: &records::Spring| spring.helix_angle_rad.is_some_and(|angle| angle != 0.0);
    let by = |spring: &records::Spring| {
        let origin = match spring.by {
            StiffnessOrigin::Given => "given",
            StiffnessOrigin::Iso6336 => "ISO 6336",
        };
        if is_helical(spring) { text(format!("{origin}, transverse")) } else { text(origin) }
    };
    let has_helical = sets.iter().flat_map(|set| &set.springs).any(is_helical);
    let note = "Transverse: helical teeth have their stiffness in the transverse plane; motion along the axis and tilting are left out.";
    Table::new("springs", rows)
        .text("set", "set", |(set, _)| &set.set)
        .words("gears", "gears", |(set, _)| set.gears.clone())
        .text("spring", "spring", |(_, spring)| &spring.spring)
        .quantity("stiffness", "k", Stiffness, |(_, spring)| spring.stiffness_n_m)
        .words("by", "by", |(_, spring)| by(spring))
        .all("Springs")
        .note(if has_helical { note } else { "" })
        .records()
}

fn not_calculated(all: &[NotCalculated]) -> Records {
    Table::new("not_calculated", all.iter())
        .text("set", "set", |one| &one.set)
        .words("gear", "gear", |one| one.gear.as_ref().map_or(text("all"), text))
        .words("what", "what", |one| {
            let what = match one.what {
                What::Modes => "modes",
                What::Resonances => "resonances",
                What::Forces => "forces",
                What::Torsional => "torsional modes",
                What::Coupled => "coupled modes",
            };
            Figure::choice(one.what, what)
        })
        .words("reason", "why", |one| one.why())
        .view("Not calculated", "set gear what reason")
        .records()
}
