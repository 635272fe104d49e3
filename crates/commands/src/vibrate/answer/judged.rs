//! Judgement of a gearbox with the distance of its speeds from resonances.

use super::Vibration;
use super::records::{Resonance, Source};
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_judge::Rule;
use epicyclic_units::Physical;

/// Judges a gearbox, or one set of it, and the speeds of its duty by the resonances with the meshing teeth.
/// The reference speed is the speed of the duty over that of the resonance.
pub(super) fn of(
    subject: &Gearbox,
    set: Option<&str>,
    file: &GearboxFile,
    all: &Vibration,
    has_speeds: bool,
) -> Judgement {
    let mut judge = Judgement::collected(subject, set, None, None);
    for modes in &all.sets {
        let mut is_judged = false;
        for gear in &modes.gears {
            let is_own = |met: &&Resonance| {
                let is_of_teeth = met.source == Source::Mesh && met.harmonic == 1;
                met.set == modes.set && met.gear == *gear && is_of_teeth && met.input_speed_rad_s > 0.0
            };
            let met = || all.resonances.iter().filter(is_own).map(|met| met.input_speed_rad_s);
            let speeds =
                file.duty.iter().filter(|step| step.gear == *gear).map(|step| step.speed.0.si().abs());
            let distances = speeds.flat_map(|speed| met().map(move |met| (speed / met - 1.0).abs()));
            if let Some(nearest) = distances.reduce(f64::min) {
                is_judged = true;
                judge.see(Rule::Resonance, &[&modes.set, &format!("gear {gear}")], nearest);
            }
        }
        let missing = [("duty", file.duty.is_empty()), ("--speeds", !has_speeds)];
        let missing: Vec<String> =
            missing.into_iter().filter(|(_, lacks)| *lacks).map(|(key, _)| key.to_owned()).collect();
        if !is_judged {
            let none = vec!["no resonance with the meshes within the speeds".to_owned()];
            let why = if missing.is_empty() { none } else { missing };
            judge.lacks(&modes.set, &[Rule::Resonance], why);
        }
    }
    judge.judgement()
}
