//! Modes, orders and resonances as tables; those of the whole gearbox are in `train`.

mod train;

use crate::table::columns::Table;
use crate::table::figure::{Figure, rpm, text};
use crate::table::quantities::{optional, quantity, words};
use crate::table::report::AsReport;
use crate::table::report::{Column, Part, Records, Report, warned};
use crate::vibrate::answer::Vibration;
use crate::vibrate::answer::records::{
    self, BodyMotion, KineticShares, Mode, NotCalculated, Order, Resonance, Response, SetModes, Source,
    StiffnessOrigin, StrainShares, What,
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
        name: ray_name(order.source, order.harmonic),
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
fn ray_name(of: Source, harmonic: u32) -> String {
    match of {
        Source::Mesh => format!("meshes {harmonic}"),
        of => source(of).to_owned(),
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
        let own = [
            ("sun", harmonic.sun_error_m, &harmonic.sun_forces_n),
            ("ring", harmonic.ring_error_m, &harmonic.ring_forces_n),
        ];
        for (name, error, forces) in own {
            let points = std::iter::zip(&harmonic.input_speeds_rad_s, forces);
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
    let circle = set.bodies.iter().find(|body| body.body == modes::Part::Carrier)?.radius_m;
    let body = |motion: &BodyMotion| {
        let radius = set.bodies.iter().find(|body| body.body == motion.body)?.radius_m;
        let centre = motion.planet.map_or([0.0; 2], |number| {
            let angle = set.planet_angles_rad.get(number as usize - 1).copied().unwrap_or_default();
            [circle * libm::cos(angle), circle * libm::sin(angle)]
        });
        Some(modes::Body { part: motion.body, centre, radius, motion: [motion.x, motion.y, motion.u] })
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
    let tables = [
        (has_sets, Frequencies, of_modes(&all.sets, !over_speed)),
        (over_speed, Resonances, resonances(&all.resonances)),
        (over_speed && !all.responses.is_empty(), Forces, responses(&all.responses)),
        (over_speed, Resonances, orders(&all.orders)),
        (!all.torsional.is_empty(), Frequencies, train::torsional(&all.torsional)),
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
            parts: tables(self).into_iter().map(|(_, records)| Part::Records(records)).collect(),
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

const fn member(of: modes::Part) -> &'static str {
    match of {
        modes::Part::Sun => "sun",
        modes::Part::Ring => "ring",
        modes::Part::Carrier => "carrier",
        modes::Part::Planet => "planet",
    }
}

const fn source(source: Source) -> &'static str {
    match source {
        Source::Mesh => "meshes",
        Source::SunTurn => "turn of the sun",
        Source::RingTurn => "turn of the ring",
        Source::SunPlanetPass => "planets pass the sun",
        Source::RingPlanetPass => "planets pass the ring",
        Source::PlanetTurn => "turn of a planet",
        Source::LinkTurn => "turn of the shaft",
    }
}

/// The part with most of an energy, with its share.
fn most<N: std::fmt::Display>(shares: impl IntoIterator<Item = (f64, N)>) -> Figure {
    let most = shares.into_iter().max_by(|one, other| one.0.total_cmp(&other.0));
    most.map_or(Figure::None, |(share, name)| text(format!("{name} {:.0}", 100.0 * share)))
}

fn of_modes(sets: &[SetModes], is_answer: bool) -> Records {
    let moved = |kinetic: &KineticShares| {
        most([
            (kinetic.sun, "sun"),
            (kinetic.ring, "ring"),
            (kinetic.carrier, "carrier"),
            (kinetic.planets, "planets"),
        ])
    };
    let strained = |strain: StrainShares| {
        most([
            (strain.sun_meshes, "sun meshes"),
            (strain.ring_meshes, "ring meshes"),
            (strain.planet_bearings, "planet bearings"),
            (strain.supports, "supports"),
        ])
    };
    let held = |set: &SetModes| set.held.iter().map(|one| member(*one).to_owned()).collect::<Vec<_>>();
    Table::new("modes", sets.iter().flat_map(|set| set.modes.iter().map(move |mode| (set, mode))))
        .text("set", "set", |(set, _)| &set.set)
        .words("gears", "gears", |(set, _)| set.gears.clone())
        .words("held", "held", |(set, _)| held(set))
        .number("mode", "mode", |(_, mode)| mode.mode)
        .words("kind", "kind", |(_, mode)| Figure::choice(mode.kind, kind(mode.kind)))
        .number("multiplicity", "×", |(_, mode)| mode.multiplicity)
        .measured("frequency", "f", Frequency, 1, |(_, mode)| mode.frequency_hz)
        .words("moves", "moves most, %", |(_, mode)| moved(&mode.kinetic))
        .for_people()
        .words("strained", "strained most, %", |(_, mode)| mode.strain.map(strained))
        .for_people()
        .number("sun", "sun", |(_, mode)| share(mode.kinetic.sun))
        .number("ring", "ring", |(_, mode)| share(mode.kinetic.ring))
        .number("carrier", "carrier", |(_, mode)| share(mode.kinetic.carrier))
        .number("planets", "planets", |(_, mode)| share(mode.kinetic.planets))
        .number("sun_meshes", "s mesh", |(_, mode)| mode.strain.map(|of| share(of.sun_meshes)))
        .number("ring_meshes", "r mesh", |(_, mode)| mode.strain.map(|of| share(of.ring_meshes)))
        .number("planet_bearings", "bearings", |(_, mode)| mode.strain.map(|of| share(of.planet_bearings)))
        .number("supports", "supports", |(_, mode)| mode.strain.map(|of| share(of.supports)))
        .view("Natural frequencies", "set gears mode kind multiplicity frequency moves strained")
        .note(
            "×: how many modes have this frequency. Rotational: sun, ring and carrier rotate and do not translate; translational: \
             they translate; planet: they are at rest. At 0 Hz all turn by their ratios.",
        )
        .view(
            "Where the energy is",
            "set mode sun ring carrier planets sun_meshes ring_meshes planet_bearings supports",
        )
        .note(
            "Shares in per cent: of the bodies in the kinetic energy, of the springs in the strain energy. Springs that stiffen by \
             1 % raise the frequency by half their share of 1 %; a body that grows by 1 % lowers it by half its share.",
        )
        .the_answer_if(is_answer)
        .records()
}

fn resonances(all: &[Resonance]) -> Records {
    let note = "Speeds of the input at which what excites has the frequency of a mode that it can excite.";
    Table::new("resonances", all.iter())
        .text("set", "set", |one| &one.set)
        .text("gear", "gear", |one| &one.gear)
        .quantity("input_speed", "n in", AngularSpeed, |one| one.input_speed_rad_s)
        .words("source", "excited by", |one| Figure::choice(one.source, source(one.source)))
        .number("harmonic", "harm.", |one| one.harmonic)
        .number("mode", "mode", |one| one.mode)
        .words("kind", "kind", |one| Figure::choice(one.kind, kind(one.kind)))
        .measured("frequency", "f", Frequency, 1, |one| one.frequency_hz)
        .view("Resonances", "set gear input_speed source harmonic mode kind frequency")
        .note(note)
        .records()
}

fn responses(all: &[Response]) -> Records {
    let rows = all.iter().flat_map(|set| {
        set.harmonics.iter().flat_map(move |one| {
            let meshes =
                [("sun", one.sun_error_m, one.greatest_sun), ("ring", one.ring_error_m, one.greatest_ring)];
            meshes.map(|(mesh, error, greatest)| (set, one, mesh, error, greatest))
        })
    });
    let note = "The greatest force F beside the mean one that the transmission error e makes within the speeds. Gyro: with the gyroscopic effect of the carrier's speed. T: torque on the sun \
                   below which the flanks part there, and this is no longer so.";
    Table::new("responses", rows)
        .text("set", "set", |(set, _, _, _, _)| &set.set)
        .text("gear", "gear", |(set, _, _, _, _)| &set.gear)
        .words("mesh", "mesh", |(_, _, mesh, _, _)| *mesh)
        .number("harmonic", "harm.", |(_, one, _, _, _)| one.harmonic)
        .column(Column::headed("error", "e", Length), |(_, _, _, error, _)| quantity(Length, *error))
        .quantity("input_speed", "n in", AngularSpeed, |(_, _, _, _, greatest)| greatest.input_speed_rad_s)
        .measured("frequency", "f", Frequency, 1, |(_, _, _, _, greatest)| greatest.frequency_hz)
        .quantity("force", "F", Force, |(_, _, _, _, greatest)| greatest.force_n)
        .quantity("parts_below_sun_torque", "T sun", Torque, |(_, _, _, _, greatest)| {
            greatest.parts_below_sun_torque_n_m
        })
        .words("gyroscopic", "gyro", |(set, _, _, _, _)| {
            Figure::answer(set.gyroscopic.to_string(), if set.gyroscopic { "yes" } else { "no" })
        })
        .view(
            "Forces by the transmission error",
            "set gear mesh harmonic error input_speed frequency force \
                     parts_below_sun_torque gyroscopic",
        )
        .note(note)
        .records()
}

fn orders(all: &[Order]) -> Records {
    Table::new("orders", all.iter())
        .text("set", "set", |one| &one.set)
        .text("gear", "gear", |one| &one.gear)
        .words("source", "excited by", |one| Figure::choice(one.source, source(one.source)))
        .number("harmonic", "harm.", |one| one.harmonic)
        .multiple("of_input", "order", |one| one.of_input)
        .words("excites", "excites", |one| one.excites.map_or(text("all"), |of| Figure::choice(of, kind(of))))
        .view("Orders", "set gear source harmonic of_input excites")
        .note("Order: frequency over that of a turn of the input, in axes on the carrier.")
        .records()
}

fn bodies(sets: &[SetModes]) -> Records {
    let note = "Without a mass the centre is held, without an inertia the rotation. r: base radius, of the carrier the radius of the planets' \
                   circle.";
    Table::new("bodies", sets.iter().flat_map(|set| set.bodies.iter().map(move |body| (set, body))))
        .text("set", "set", |(set, _)| &set.set)
        .words("gears", "gears", |(set, _)| set.gears.clone())
        .words("body", "body", |(_, body)| Figure::choice(body.body, member(body.body)))
        .quantity("mass", "m", Mass, |(_, body)| body.mass_kg)
        .column(Column::headed("inertia", "I", Inertia), |(_, body)| optional(Inertia, body.inertia_kg_m2))
        .quantity("radius", "r", Length, |(_, body)| body.radius_m)
        .view("Bodies", "set gears body mass inertia radius")
        .note(note)
        .records()
}

fn springs(sets: &[SetModes]) -> Records {
    let rows = sets.iter().flat_map(|set| {
        let of = &set.stiffness;
        let meshes = match of.meshes_by {
            StiffnessOrigin::Given => "given",
            StiffnessOrigin::Iso6336 => "ISO 6336",
        };
        let all = [
            ("sun mesh", Some(of.sun_mesh_n_m), meshes),
            ("ring mesh", Some(of.ring_mesh_n_m), meshes),
            ("planet bearing", Some(of.planet_bearing_n_m), "given"),
            ("sun support", of.sun_support_n_m, "given"),
            ("ring support", of.ring_support_n_m, "given"),
            ("carrier support", of.carrier_support_n_m, "given"),
            ("sun, tangential", of.sun_tangential_support_n_m, "given"),
            ("ring, tangential", of.ring_tangential_support_n_m, "given"),
            ("carrier, tangential", of.carrier_tangential_support_n_m, "given"),
        ];
        all.into_iter().filter(|(_, stiffness, _)| stiffness.is_some()).map(move |spring| (set, spring))
    });
    Table::new("springs", rows)
        .text("set", "set", |(set, _)| &set.set)
        .words("gears", "gears", |(set, _)| set.gears.clone())
        .text("spring", "spring", |(_, (name, _, _))| name)
        .quantity("stiffness", "k", Stiffness, |(_, (_, stiffness, _))| *stiffness)
        .text("by", "by", |(_, (_, _, by))| by)
        .all("Springs")
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
                What::Torsional => "torsional modes",
                What::Coupled => "coupled modes",
            };
            Figure::choice(one.what, what)
        })
        .words("reason", "why", |one| one.why())
        .view("Not calculated", "set gear what reason")
        .records()
}
