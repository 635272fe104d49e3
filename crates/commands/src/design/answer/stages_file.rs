//! The gearbox file of stages in series without their sizes, and what is read from it: efficiencies, and the
//! order as the search takes it.

use super::arranged_file::{self, GEAR, written};
use super::axes::{efficiency_of_pair, first_pair};
use super::making::{Load, MAKING, PAIR, mapping, with_load};
use super::stage_kind::StageKind;
use super::stages_wanted::WantedStages;
use crate::analyze::answer::{analysis, moving};
use crate::error::Error;
use crate::shared::gearbox::{Choice, one};
use crate::size::answer::sizing_of;
use crate::tolerance::ROUNDED;
use epicyclic_formats::Document;
use epicyclic_formats::yaml::Value;
use epicyclic_strength::series::{InputStep, Order};
use epicyclic_strength::sizing::Sizing;
use std::ops::RangeInclusive;
use uom::si::f64::Torque;

/// Efficiencies of the meshes of a train of these teeth, driven from the input and from the output; `None` if their losses
/// hold it.
pub(super) fn efficiencies(wanted: &WantedStages, teeth: &[Vec<u32>]) -> Result<[Option<f64>; 2], Error> {
    let making = text(wanted, teeth, wanted.torque)?;
    let document = Document::parse_one(MAKING, making.as_bytes())?;
    let subject = one(&document, &Choice::default())?;
    let analysis = analysis(&subject.train, GEAR)?;
    Ok([analysis.efficiency(), analysis.back_driving_efficiency()].map(moving))
}

/// The order as the search takes it.
pub(super) fn order(
    wanted: &WantedStages,
    tolerance: f64,
    stages: RangeInclusive<usize>,
) -> Result<Order, Error> {
    let fast = wanted.fast(tolerance, *stages.end());
    // Materials, factors and tools are read from a file, as those of the gearbox will be.
    let sizing = |teeth: &[u32]| -> Result<Sizing, Error> {
        let making = text(wanted, &[teeth.to_vec()], wanted.torque)?;
        let document = Document::parse_one(MAKING, making.as_bytes())?;
        let mut sizing = sizing_of(&one(&document, &Choice::default())?, &wanted.size)?;
        for overload in &mut sizing.overloads {
            overload.sun_torque = fast.torque * wanted.overload.unwrap_or(1.0);
        }
        Ok(sizing)
    };
    let of_stage = sizing(&[24, 30, 84])?;
    let of_pair = wanted.has_pair().then(|| sizing(&[24, 60])).transpose()?;
    // Products of ratios are rounded.
    let [less, more] = [1.0 - tolerance - ROUNDED, 1.0 + tolerance + ROUNDED];
    Ok(Order {
        stages,
        ratio: wanted.product(wanted.ratio * less)..=wanted.product(wanted.ratio * more),
        rings_turn: wanted.rings_turn(),
        first_pair: of_pair.map(first_pair),
        teeth: wanted.teeth.clone(),
        most_unusual: None,
        duty: wanted.spectrum.iter().map(|part| of_part(fast, *part)).collect(),
        of_stage,
    })
}

/// A part of the time with torque and speed over those of the duty.
fn of_part(duty: InputStep, [share, torque, speed]: [f64; 3]) -> InputStep {
    InputStep { share: share * duty.share, torque: duty.torque * torque, speed: duty.speed * speed }
}

/// File of stages without sizes, with a torque on the input; a stage with planets of two gears has no strength yet.
pub(super) fn text(wanted: &WantedStages, teeth: &[Vec<u32>], torque: Torque) -> Result<String, Error> {
    if let Some(stage) = StageKind::compound(teeth) {
        return arranged_file::text(wanted, stage, torque);
    }
    let shaft = |place: usize| match place {
        0 => "input".to_owned(),
        _ if place == teeth.len() => "output".to_owned(),
        _ => format!("shaft {place}"),
    };
    let slow = if wanted.steps_up { "input" } else { "output" };
    let set = |(place, teeth): (usize, &Vec<u32>)| {
        let [of_sun, of_carrier] = if wanted.steps_up { [place + 1, place] } else { [place, place + 1] };
        let id = ("id", format!("stage {}", place + 1).into());
        let numbers = |teeth: &[u32]| Value::Sequence(teeth.iter().map(|teeth| (*teeth).into()).collect());
        let &[sun, planet, ring] = &teeth[..] else {
            return mapping(vec![
                id,
                ("kind", PAIR.into()),
                ("sun", shaft(of_sun).into()),
                ("ring", shaft(of_carrier).into()),
                ("teeth", numbers(teeth)),
                ("efficiency", efficiency_of_pair(wanted.efficiency).into()),
            ]);
        };
        let [mut of_ring, mut of_carrier] = ["ground".to_owned(), shaft(of_carrier)];
        if wanted.rings_turn() {
            of_ring = slow.to_owned();
            if of_carrier == of_ring {
                of_carrier = "ground".to_owned();
            }
        }
        mapping(vec![
            id,
            ("sun", shaft(of_sun).into()),
            ("ring", of_ring.into()),
            ("carrier", of_carrier.into()),
            ("teeth", numbers(&[sun, ring])),
            ("planet_teeth", numbers(&[planet])),
            ("efficiency", wanted.efficiency.into()),
        ])
    };
    let count = if teeth.len() == 1 { "1 stage".to_owned() } else { format!("{} stages", teeth.len()) };
    let sets = ("sets", Value::Sequence(teeth.iter().enumerate().map(set).collect()));
    let load = Load { torque, speed: wanted.speed, overload: wanted.overload, spectrum: &wanted.spectrum };
    written(&count, sets, |file| with_load(file, &wanted.basis, &[(GEAR, 1.0)], load))
}

/// Stages without sizes as the sizes read them, with materials, factors and duty, and a torque on the input.
pub(super) fn document(wanted: &WantedStages, teeth: &[Vec<u32>], torque: Torque) -> Result<Document, Error> {
    if let Some(stage) = StageKind::compound(teeth) {
        return arranged_file::making(wanted, stage, torque);
    }
    Ok(Document::parse_one(MAKING, text(wanted, teeth, torque)?.as_bytes())?)
}
