//! Torsional model of the whole gearbox in a gear: links as inertias, with all sets, and shafts as springs;
//! and its excitation.
//!
//! Centres are at rest, so no frequency depends on the speed, and an order meets a mode at `n = f/order`.
//! In a gear with one freedom the motion at 0 Hz gives the inertia of the whole gearbox at its input and
//! output.
//!
//! Teeth and planets of a set excite, by [`phasing::torsional`], either modes in which links rotate, or only
//! those of the planets of this set. A link excites the modes in which it rotates.

use super::links::{Bodies, Train, TrainSet};
use super::orders::{self, Phased};
use super::records::{NotCalculated, Source, What};
use super::settled::Settled;
use super::train_records::{
    StrainPart, TorsionalKinetic, TorsionalMode, TorsionalModes, TorsionalOrder, TorsionalResonance,
    TorsionalStrain,
};
use super::{Prepared, number};
use crate::analyze::answer::analysis;
use crate::answer::Warning;
use crate::error::Error;
use crate::tolerance::{ROUNDED, rounded};
use epicyclic_train::{Analysis, Gear, LinkId};
use epicyclic_units::Physical;
use epicyclic_units::format::trimmed;
use epicyclic_vibration::Kind;
use epicyclic_vibration::train::{Placed, Shaft, TrainParts, torsional};
use epicyclic_vibration::{Group, Model, SpringId, phasing};
use std::f64::consts::TAU;

/// Relative difference of the ratio by the vibration data from that of the gear, from which on a warning is
/// due.
const OFF_RATIO: f64 = 1e-4;

/// Torsional modes in a gear with their excitation, or the set that lacks data; with a warning where the data
/// contradict the ratio of the gear.
pub(super) fn modes(
    train: &Train<'_>,
    gear: &Gear,
    sets: &[TrainSet<'_>],
    settled: &Settled,
) -> Result<Result<(TorsionalModes, Option<Warning>), NotCalculated>, Error> {
    let laid = match train.laid(gear, sets, What::Torsional, Prepared::torsional)? {
        Ok(laid) => laid,
        Err(missing) => return Ok(Err(missing)),
    };
    let bodies = &laid.bodies;
    let between = laid.shafts.iter().filter_map(|shaft| Some((shaft, shaft.between?)));
    let shafts: Vec<Shaft> = between
        .map(|(shaft, (links, stiffness))| Shaft { name: shaft.entry.id.clone(), links, stiffness })
        .collect();
    let placed = std::iter::zip(sets, laid.sets);
    let placed: Vec<Placed> = placed
        .map(|(one, (set, links))| Placed { name: format!("{} ", one.of.set.id()), set, links })
        .collect();
    let refuse = |error| train.refused(gear, &error);
    let (model, parts) = torsional(&bodies.links, &placed, &shafts).map_err(refuse)?;
    let groups = model.groups(&parts.links).map_err(refuse)?;
    let modes: Result<Vec<TorsionalMode>, _> = groups
        .iter()
        .enumerate()
        .map(|(index, group)| mode(index, group, &model, &parts, bodies, sets, &shafts))
        .collect();
    let zeros: Vec<&Group> = groups.iter().filter(|group| group.is_zero()).collect();
    // Of the mass-normalised motion of a gear with one freedom the energy is ½, so J = 1/θ² at an angle θ.
    let angle = |link: LinkId| {
        let [[shape]] = zeros.iter().map(|group| &group.shapes[..]).collect::<Vec<_>>()[..] else {
            return None;
        };
        let root = laid.roots[link.index()];
        let (_, place) = bodies.of_root.iter().find(|(own, _)| *own == root)?;
        let [_, _, angle] = shape.of(parts.links[*place])?;
        Some(angle).filter(|angle| angle.abs() > ROUNDED)
    };
    let angles = [gear.input(), gear.output()].map(angle);
    let analysis = analysis(&train.subject.train, gear.name())?;
    let ratio = match (angles, analysis.ratio()) {
        ([Some(one), Some(other)], Some(ratio)) if (one / other / ratio - 1.0).abs() > OFF_RATIO => {
            Some((one / other, ratio))
        }
        _ => None,
    };
    let warning = ratio.map(|(own, ratio)| Warning {
        name: "vibration-data",
        message: format!(
            "gear {}: the base radii, pressure angles and carrier radii of the vibration have the ratio {}, and the gear has {}; \
             the inertia of the whole gearbox is left out",
            gear.name(),
            trimmed(own, 5),
            trimmed(ratio, 5)
        ),
    });
    let reduced = angles.map(|angle| angle.filter(|_| ratio.is_none()).map(|angle| 1.0 / (angle * angle)));
    let mut all = TorsionalModes {
        gear: gear.name().to_owned(),
        freedoms: zeros.iter().map(|group| group.multiplicity() as u32).sum(),
        inertia_at_input_kg_m2: reduced[0],
        inertia_at_output_kg_m2: reduced[1],
        modes: modes.map_err(refuse)?,
        orders: vec![],
        resonances: vec![],
        input_speeds_rad_s: settled.ends(),
    };
    if let Some([low, high]) = all.input_speeds_rad_s {
        all.orders = of_links(&analysis, bodies, settled.fastest());
        for one in sets {
            all.orders.extend(of_set(&analysis, one, (settled.harmonics, settled.fastest())));
        }
        for order in &all.orders {
            all.resonances.extend(met(order, &all.modes, [low, high]));
        }
        all.resonances.sort_by(|one, other| one.input_speed_rad_s.total_cmp(&other.input_speed_rad_s));
    }
    Ok(Ok((all, warning)))
}

/// Orders for a turn of each link that turns.
fn of_links(analysis: &Analysis<'_>, bodies: &Bodies, fastest: f64) -> Vec<TorsionalOrder> {
    let order = |(root, place): &(usize, usize)| {
        let of_input = analysis.speeds().get(*root).copied().flatten()?.abs();
        (of_input > ROUNDED).then(|| TorsionalOrder {
            of: bodies.links[*place].name.clone(),
            source: Source::LinkTurn,
            part: None,
            harmonic: 1,
            of_input,
            frequency_hz: of_input * fastest / TAU,
            excites: Some(Kind::Rotational),
        })
    };
    bodies.of_root.iter().filter_map(order).collect()
}

/// Orders of the teeth and planets of a set, in coordinates on its carrier; empty if tooth numbers or speeds
/// are unknown.
fn of_set(analysis: &Analysis<'_>, one: &TrainSet<'_>, harmonics: (u32, f64)) -> Vec<TorsionalOrder> {
    let members = analysis.sets()[one.place].members.iter().copied().collect::<Option<Vec<f64>>>();
    let Some(members) = members.filter(|_| !one.prepared.teeth.is_empty()) else { return vec![] };
    let all = orders::all(&one.of, &one.prepared, analysis.gear().name(), &members, harmonics);
    all.into_iter()
        .map(|phased| {
            let Phased { order, periods, .. } = phased;
            // The rule applies only to equally spaced planets.
            let periods = periods.filter(|_| one.prepared.is_equally_spaced());
            let planets = one.prepared.planets;
            let excites = periods.and_then(|periods| phasing::torsional(periods, planets).ok());
            TorsionalOrder {
                of: order.set,
                source: order.source,
                part: order.part,
                harmonic: order.harmonic,
                of_input: order.of_input,
                frequency_hz: order.frequency_hz,
                excites,
            }
        })
        .collect()
}

/// Resonances of an order with modes that it can excite.
fn met(order: &TorsionalOrder, modes: &[TorsionalMode], [low, high]: [f64; 2]) -> Vec<TorsionalResonance> {
    let mut all = vec![];
    for mode in modes.iter().filter(|mode| mode.frequency_hz > 0.0) {
        let share = share(order, mode);
        // A part that is only a rounding error is rounded to 0.
        if share == 0.0 || order.excites.is_some_and(|kind| kind != mode.kind) {
            continue;
        }
        let speed = TAU * mode.frequency_hz / order.of_input;
        for input_speed_rad_s in [-speed, speed].into_iter().filter(|speed| (low..=high).contains(speed)) {
            all.push(TorsionalResonance {
                input_speed_rad_s,
                of: order.of.clone(),
                source: order.source,
                part: order.part.clone(),
                harmonic: order.harmonic,
                mode: mode.mode,
                frequency_hz: mode.frequency_hz,
                share,
            });
        }
    }
    all
}

/// Part of a mode's energy at the place where an order acts.
fn share(order: &TorsionalOrder, mode: &TorsionalMode) -> f64 {
    if order.source == Source::LinkTurn {
        let own =
            mode.kinetic.iter().filter(|one| one.planets_of.is_none() && one.links.join("+") == order.of);
        return own.map(|one| one.share).sum();
    }
    let meshes = mode.strain.iter().filter(|one| one.mesh.is_some() && one.of == order.of);
    meshes.map(|one| one.share).sum()
}

fn mode(
    index: usize,
    group: &Group,
    model: &Model,
    parts: &TrainParts,
    bodies: &Bodies,
    sets: &[TrainSet<'_>],
    shafts: &[Shaft],
) -> Result<TorsionalMode, epicyclic_vibration::Error> {
    let energy = model.modal_energy(group)?;
    let links = parts.links.iter().zip(&bodies.names).zip(&bodies.links).filter(|(_, link)| !link.held);
    let mut kinetic: Vec<TorsionalKinetic> = links
        .map(|((body, names), _)| TorsionalKinetic {
            links: names.clone(),
            planets_of: None,
            share: rounded(energy.kinetic_of(*body)),
        })
        .collect();
    let with_planets = parts.sets.iter().zip(sets).filter(|(own, _)| !own.planets.is_empty());
    kinetic.extend(with_planets.map(|(own, set)| TorsionalKinetic {
        links: vec![],
        planets_of: Some(set.of.set.id().to_owned()),
        share: rounded(own.planets.iter().map(|planet| energy.kinetic_of(*planet)).sum()),
    }));
    let mut strain: Vec<TorsionalStrain> = vec![];
    if !group.is_zero() {
        let share = |springs: &[SpringId]| rounded(energy.strain_of(springs));
        for (set, own) in sets.iter().zip(&parts.sets) {
            strain.extend(TorsionalStrain::of_meshes(set, &own.meshes, share));
        }
        let mut add = |part, of: String, springs: &[SpringId]| {
            strain.push(TorsionalStrain { part, of, mesh: None, share: share(springs) });
        };
        for (shaft, spring) in shafts.iter().zip(&parts.shafts) {
            add(StrainPart::Shaft, shaft.name.clone(), &[*spring]);
        }
        for (link, springs) in bodies.links.iter().zip(&parts.supports).filter(|(_, own)| !own.is_empty()) {
            add(StrainPart::Support, link.name.clone(), springs);
        }
    }
    Ok(TorsionalMode {
        mode: number(index),
        kind: group.kind,
        multiplicity: group.multiplicity() as u32,
        frequency_hz: group.frequency.si(),
        kinetic,
        strain,
    })
}
