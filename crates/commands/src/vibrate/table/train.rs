//! Modes of the whole gearbox as tables: torsional with what excites them, and coupled in the plane.

use super::{SECONDS_A_MINUTE, excited_by, kind, most, part, ray_name, share};
use crate::table::columns::Table;
use crate::table::figure::{Figure, rpm, text};
use crate::table::quantities::optional;
use crate::table::report::{Column, Records};
use crate::vibrate::answer::Vibration;
use crate::vibrate::answer::records::Source;
use crate::vibrate::answer::train_records::{
    CentreBody, CoupledKinetic, CoupledMode, CoupledModes, KineticPart, StrainPart, TorsionalKinetic,
    TorsionalMode, TorsionalModes, TorsionalOrder, TorsionalStrain,
};
use epicyclic_pictures::campbell::{self, Branch, Campbell, Ray};
use epicyclic_units::Dimension::{AngularSpeed, Frequency, Inertia, Mass, Stiffness};

/// The torsional frequencies of a gear over the speed as a Campbell diagram; its place is that in the answer.
/// Zero modes are left out.
#[must_use]
pub fn torsional_campbell(all: &Vibration, place: usize) -> Option<Campbell> {
    let one = all.torsional.get(place)?;
    let ends = one.input_speeds_rad_s?;
    let several = all.sets.iter().any(|set| set.set != all.sets[0].set);
    let ray = |order: &TorsionalOrder| {
        let name = ray_name(order.source, order.part.as_deref(), order.harmonic);
        let of = match order.source {
            Source::LinkTurn => format!("turn of {}", order.of),
            _ if several => format!("{}: {name}", order.of),
            _ => name,
        };
        Ray { name: of, slope: order.of_input / SECONDS_A_MINUTE }
    };
    let branch =
        |mode: &TorsionalMode| Branch { kind: mode.kind, frequencies: vec![mode.frequency_hz; ends.len()] };
    Some(Campbell {
        title: format!("{}, gear {}: torsional", all.gearbox, one.gear),
        across: "speed of the input, rpm".to_owned(),
        up: "frequency, Hz".to_owned(),
        speeds: ends.map(rpm).to_vec(),
        branches: one.modes.iter().filter(|mode| mode.frequency_hz > 0.0).map(branch).collect(),
        rays: one.orders.iter().map(ray).collect(),
        meetings: one.resonances.iter().map(|met| [rpm(met.input_speed_rad_s), met.frequency_hz]).collect(),
        size_mm: campbell::SIZE_MM,
        is_untitled: false,
    })
}

/// A part that springs, in words.
fn strained(one: &TorsionalStrain) -> (f64, String) {
    let of = &one.of;
    let mesh = one.mesh.as_deref().unwrap_or_default();
    let name = match one.part {
        StrainPart::SunMeshes | StrainPart::RingMeshes | StrainPart::PlanetMeshes => {
            format!("{mesh} meshes of {of}")
        }
        StrainPart::PairMesh => format!("mesh of {of}"),
        StrainPart::PlanetBearings => format!("planet bearings of {of}"),
        StrainPart::Shaft => format!("shaft {of}"),
        StrainPart::Bending => format!("bending of shaft {of}"),
        StrainPart::Support | StrainPart::CentreSupport => format!("support of {of}"),
    };
    (one.share, name)
}

pub(super) fn torsional(all: &[TorsionalModes]) -> Records {
    let moved = |one: &TorsionalKinetic| {
        let planets = one.planets_of.as_ref().map(|set| format!("planets of {set}"));
        (one.share, planets.unwrap_or_else(|| one.links.join("+")))
    };
    Table::new("torsional", all.iter().flat_map(|gear| gear.modes.iter().map(move |mode| (gear, mode))))
        .text("gear", "gear", |(gear, _)| &gear.gear)
        .number("mode", "mode", |(_, mode)| mode.mode)
        .words("kind", "kind", |(_, mode)| Figure::choice(mode.kind, kind(mode.kind)))
        .number("multiplicity", "×", |(_, mode)| mode.multiplicity)
        .measured("frequency", "f", Frequency, 1, |(_, mode)| mode.frequency_hz)
        .words("moves", "moves most, %", |(_, mode)| most(mode.kinetic.iter().map(moved)))
        .words("strained", "strained most, %", |(_, mode)| most(mode.strain.iter().map(strained)))
        .all("Torsional frequencies")
        .note(
            "The whole gearbox with centres at rest: links as inertias, meshes and shafts as springs. Rotational: links rotate; planet: they are at rest. At 0 Hz as many motions as the gear has \
             freedoms.",
        )
        .records()
}

pub(super) fn inertias(all: &[TorsionalModes]) -> Records {
    Table::new("inertias", all.iter().filter(|gear| gear.inertia_at_input_kg_m2.is_some()))
        .text("gear", "gear", |gear| &gear.gear)
        .column(Column::headed("at_input", "J in", Inertia), |gear| {
            optional(Inertia, gear.inertia_at_input_kg_m2)
        })
        .column(Column::headed("at_output", "J out", Inertia), |gear| {
            optional(Inertia, gear.inertia_at_output_kg_m2)
        })
        .all("Inertia of the whole gearbox, reduced to its input and output")
        .note("With what its links carry: the kinetic energy is ½·J·ω² at the speed of the input or output.")
        .records()
}

pub(super) fn resonances(all: &[TorsionalModes]) -> Records {
    let rows = all.iter().flat_map(|gear| gear.resonances.iter().map(move |one| (gear, one)));
    let is_none = all.iter().all(|gear| gear.resonances.is_empty());
    let title = if is_none { "Torsional resonances: none at these speeds" } else { "Torsional resonances" };
    Table::new("torsional_resonances", rows)
        .text("gear", "gear", |(gear, _)| &gear.gear)
        .quantity("input_speed", "n in", AngularSpeed, |(_, one)| one.input_speed_rad_s)
        .text("of", "of", |(_, one)| &one.of)
        .words("source", "excited by", |(_, one)| excited_by(one.source, one.part.as_deref()))
        .words("part", "part", |(_, one)| part(one.part.as_deref()))
        .only_if(all.iter().any(|gear| gear.resonances.iter().any(|one| one.part.is_some())))
        .number("harmonic", "harm.", |(_, one)| one.harmonic)
        .number("mode", "mode", |(_, one)| one.mode)
        .measured("frequency", "f", Frequency, 1, |(_, one)| one.frequency_hz)
        .number("share", "share, %", |(_, one)| share(one.share))
        .view(title, "gear input_speed of source harmonic mode frequency share")
        .note(
            "Speeds of the input at which what excites has the frequency of a torsional mode that it can excite. Share: of the meshes of the set in the strain energy \
             of the mode, or of the shaft in its kinetic energy; where it is small, the resonance is.",
        )
        .records()
}

pub(super) fn orders(all: &[TorsionalModes]) -> Records {
    let excited = |one: &TorsionalOrder| one.excites.map_or(text("all"), |of| Figure::choice(of, kind(of)));
    let rows = all.iter().flat_map(|gear| gear.orders.iter().map(move |one| (gear, one)));
    Table::new("torsional_orders", rows)
        .text("gear", "gear", |(gear, _)| &gear.gear)
        .text("of", "of", |(_, one)| &one.of)
        .words("source", "excited by", |(_, one)| excited_by(one.source, one.part.as_deref()))
        .words("part", "part", |(_, one)| part(one.part.as_deref()))
        .only_if(all.iter().any(|gear| gear.orders.iter().any(|one| one.part.is_some())))
        .number("harmonic", "harm.", |(_, one)| one.harmonic)
        .multiple("of_input", "order", |(_, one)| one.of_input)
        .measured("frequency", "f", Frequency, 1, |(_, one)| one.frequency_hz)
        .words("excites", "excites", |(_, one)| excited(one))
        .view("Torsional orders", "gear of source harmonic of_input frequency excites")
        .note("f: at the greatest speed of the input. Which torsional modes the phases of the planets of a set let it excite; a shaft excites those in which it rotates.")
        .records()
}

pub(super) fn coupled(all: &[CoupledModes]) -> Records {
    let moved = |one: &CoupledKinetic| {
        let of = one.of.join("+");
        let name = match one.part {
            KineticPart::Rotation => format!("rotation of {of}"),
            KineticPart::Translation => format!("centre of {of}"),
            KineticPart::Planets => format!("planets of {of}"),
        };
        (one.share, name)
    };
    let in_sets = |mode: &CoupledMode| {
        let of = |kind_of: Option<_>| kind_of.map_or("at rest", kind);
        let all: Vec<String> = mode.sets.iter().map(|one| format!("{} {}", one.set, of(one.kind))).collect();
        text(all.join(", "))
    };
    Table::new("coupled", all.iter().flat_map(|gear| gear.modes.iter().map(move |mode| (gear, mode))))
        .text("gear", "gear", |(gear, _)| &gear.gear)
        .number("mode", "mode", |(_, mode)| mode.mode)
        .words("kind", "kind", |(_, mode)| Figure::choice(mode.kind, kind(mode.kind)))
        .number("multiplicity", "×", |(_, mode)| mode.multiplicity)
        .measured("frequency", "f", Frequency, 1, |(_, mode)| mode.frequency_hz)
        .words("sets", "sets", |(_, mode)| in_sets(mode))
        .words("moves", "moves most, %", |(_, mode)| most(mode.kinetic.iter().map(moved)))
        .words("strained", "strained most, %", |(_, mode)| most(mode.strain.iter().map(strained)))
        .view("Coupled frequencies", "gear mode kind multiplicity frequency sets")
        .note(
            "The whole gearbox in the plane, at rest: sets on common links and centres. Kind: rotational, links rotate; translational, centres move; planet, the planets of \
             a set alone. Sets: what the sun, ring and carrier of each do.",
        )
        .view("Where the energy of coupled modes is", "gear mode moves strained")
        .records()
}

pub(super) fn centres(all: &[CoupledModes]) -> Records {
    let members = |centre: &CentreBody| {
        centre.members.iter().map(|one| format!("{} of {}", one.member, one.set)).collect::<Vec<_>>()
    };
    Table::new("centres", all.iter().flat_map(|gear| gear.centres.iter().map(move |centre| (gear, centre))))
        .text("gear", "gear", |(gear, _)| &gear.gear)
        .words("members", "members", |(_, centre)| members(centre))
        .quantity("mass", "m", Mass, |(_, centre)| centre.mass_kg)
        .quantity("support", "k", Stiffness, |(_, centre)| centre.support_n_m)
        .all("Centres")
        .note("What moves in the plane as one piece: mass, carriers without planets, and radial support. Without a mass the centre is held.")
        .records()
}
