//! Modes of the whole gearbox as tables: torsional with what excites them, and coupled in the plane.

use super::{SECONDS_A_MINUTE, branch_kind, hertz, kind, member, most, ray_name, share, source};
use crate::table::figure::{Figure, count, rpm, text};
use crate::table::quantities::column;
use crate::table::report::{Column, Records, View};
use crate::vibrate::answer::Vibration;
use crate::vibrate::answer::records::Source;
use crate::vibrate::answer::train_records::{
    CoupledKinetic, CoupledMode, CoupledModes, KineticPart, StrainPart, TorsionalMode, TorsionalModes,
    TorsionalOrder, TorsionalResonance, TorsionalStrain,
};
use epicyclic_pictures::campbell::{self, Branch, Campbell, Ray};
use epicyclic_units::Dimension::{AngularSpeed, Frequency, Mass, Stiffness};

/// The torsional frequencies of a gear over the speed as a Campbell diagram; its place is that in the answer.
/// Zero modes are left out.
#[must_use]
pub fn torsional_campbell(all: &Vibration, place: usize) -> Option<Campbell> {
    let one = all.torsional.get(place)?;
    let ends = one.input_speeds_rad_s?;
    let several = all.sets.iter().any(|set| set.set != all.sets[0].set);
    let ray = |order: &TorsionalOrder| {
        let name = ray_name(order.source, order.harmonic);
        let of = match order.source {
            Source::LinkTurn => format!("turn of {}", order.of),
            _ if several => format!("{}: {name}", order.of),
            _ => name,
        };
        Ray { name: of, slope: order.of_input / SECONDS_A_MINUTE }
    };
    let branch = |mode: &TorsionalMode| Branch {
        kind: branch_kind(mode.kind),
        frequencies: vec![mode.frequency_hz; ends.len()],
    };
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
    let name = match one.part {
        StrainPart::SunMeshes => format!("sun meshes of {of}"),
        StrainPart::RingMeshes => format!("ring meshes of {of}"),
        StrainPart::PlanetBearings => format!("planet bearings of {of}"),
        StrainPart::Shaft => format!("shaft {of}"),
        StrainPart::Bending => format!("bending of shaft {of}"),
        StrainPart::Support | StrainPart::CentreSupport => format!("support of {of}"),
    };
    (one.share, name)
}

/// Columns of a mode of the whole gearbox, then one given, then where its energy is.
fn mode_columns(given: Option<Column>) -> Vec<Column> {
    let mut all = vec![
        Column::words("gear", "gear"),
        Column::number("mode", "mode"),
        Column::words("kind", "kind"),
        Column::number("multiplicity", "×"),
        Column::headed("frequency", "f, Hz", Frequency),
    ];
    all.extend(given);
    all.extend([Column::words("moves", "moves most, %"), Column::words("strained", "strained most, %")]);
    all
}

pub(super) fn torsional(all: &[TorsionalModes]) -> Records {
    let rows = all.iter().flat_map(|gear| {
        gear.modes.iter().map(move |mode| {
            let kinetic = mode.kinetic.iter().map(|one| {
                let name = one.planets_of.as_ref().map(|set| format!("planets of {set}"));
                (one.share, name.unwrap_or_else(|| one.links.join("+")))
            });
            vec![
                text(&gear.gear),
                count(mode.mode),
                Figure::choice(mode.kind, kind(mode.kind)),
                count(mode.multiplicity),
                hertz(mode.frequency_hz),
                most(kinetic),
                most(mode.strain.iter().map(strained)),
            ]
        })
    });
    Records {
        name: "torsional",
        columns: mode_columns(None),
        rows: rows.collect(),
        views: vec![View {
            note: "The whole gearbox with centres at rest: links as inertias, meshes and shafts as springs. Rotational: links rotate; planet: they are at rest. At 0 Hz as many motions as the gear has \
                   freedoms."
                .to_owned(),
            ..View::new(
                "Torsional frequencies",
                &["gear", "mode", "kind", "multiplicity", "frequency", "moves", "strained"],
            )
        }],
        is_answer: false,
    }
}

pub(super) fn resonances(all: &[TorsionalModes]) -> Records {
    let row = |gear: &TorsionalModes, one: &TorsionalResonance| {
        vec![
            text(&gear.gear),
            column(AngularSpeed, Some(one.input_speed_rad_s)),
            text(&one.of),
            Figure::choice(one.source, source(one.source)),
            count(one.harmonic),
            count(one.mode),
            hertz(one.frequency_hz),
            share(one.share),
        ]
    };
    let rows = all.iter().flat_map(|gear| gear.resonances.iter().map(move |one| row(gear, one)));
    Records {
        name: "torsional_resonances",
        columns: vec![
            Column::words("gear", "gear"),
            Column::headed("input_speed", "n in, rpm", AngularSpeed),
            Column::words("of", "of"),
            Column::words("source", "excited by"),
            Column::number("harmonic", "harm."),
            Column::number("mode", "mode"),
            Column::headed("frequency", "f, Hz", Frequency),
            Column::number("share", "share, %"),
        ],
        rows: rows.collect(),
        views: vec![View {
            note: "Speeds of the input at which what excites has the frequency of a torsional mode that it can excite. Share: of the meshes of the set in the strain energy \
                   of the mode, or of the shaft in its kinetic energy; where it is small, the resonance is."
                .to_owned(),
            ..View::new(
                "Torsional resonances",
                &["gear", "input_speed", "of", "source", "harmonic", "mode", "frequency", "share"],
            )
        }],
        is_answer: false,
    }
}

pub(super) fn orders(all: &[TorsionalModes]) -> Records {
    let row = |gear: &TorsionalModes, one: &TorsionalOrder| {
        vec![
            text(&gear.gear),
            text(&one.of),
            Figure::choice(one.source, source(one.source)),
            count(one.harmonic),
            Figure::Multiple(one.of_input),
            one.excites.map_or(text("all"), |of| Figure::choice(of, kind(of))),
        ]
    };
    let rows = all.iter().flat_map(|gear| gear.orders.iter().map(move |one| row(gear, one)));
    Records {
        name: "torsional_orders",
        columns: vec![
            Column::words("gear", "gear"),
            Column::words("of", "of"),
            Column::words("source", "excited by"),
            Column::number("harmonic", "harm."),
            Column::number("of_input", "order"),
            Column::words("excites", "excites"),
        ],
        rows: rows.collect(),
        views: vec![View {
            note: "Which torsional modes the phases of the planets of a set let it excite; a shaft excites those in which it rotates."
                .to_owned(),
            ..View::new("Torsional orders", &["gear", "of", "source", "harmonic", "of_input", "excites"])
        }],
        is_answer: false,
    }
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
    let rows = all.iter().flat_map(|gear| {
        gear.modes.iter().map(move |mode| {
            vec![
                text(&gear.gear),
                count(mode.mode),
                Figure::choice(mode.kind, kind(mode.kind)),
                count(mode.multiplicity),
                hertz(mode.frequency_hz),
                in_sets(mode),
                most(mode.kinetic.iter().map(moved)),
                most(mode.strain.iter().map(strained)),
            ]
        })
    });
    Records {
        name: "coupled",
        columns: mode_columns(Some(Column::words("sets", "sets"))),
        rows: rows.collect(),
        views: vec![
            View {
                note: "The whole gearbox in the plane, at rest: sets on common links and centres. Kind: rotational, links rotate; translational, centres move; planet, the planets of \
                       a set alone. Sets: what the sun, ring and carrier of each do."
                    .to_owned(),
                ..View::new("Coupled frequencies", &["gear", "mode", "kind", "multiplicity", "frequency", "sets"])
            },
            View::new("Where the energy of coupled modes is", &["gear", "mode", "moves", "strained"]),
        ],
        is_answer: false,
    }
}

pub(super) fn centres(all: &[CoupledModes]) -> Records {
    let rows = all.iter().flat_map(|gear| {
        gear.centres.iter().map(move |centre| {
            let of = centre.members.iter().map(|one| format!("{} of {}", member(one.member), one.set));
            vec![
                text(&gear.gear),
                Figure::Texts(of.collect()),
                column(Mass, centre.mass_kg),
                column(Stiffness, centre.support_n_m),
            ]
        })
    });
    Records {
        name: "centres",
        columns: vec![
            Column::words("gear", "gear"),
            Column::words("members", "members"),
            Column::headed("mass", "m, kg", Mass),
            Column::headed("support", "k, N/µm", Stiffness),
        ],
        rows: rows.collect(),
        views: vec![View {
            note: "What moves in the plane as one piece: mass, carriers without planets, and radial support. Without a mass the centre is held.".to_owned(),
            ..View::new("Centres", &["gear", "members", "mass", "support"])
        }],
        is_answer: false,
    }
}
