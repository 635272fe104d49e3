//! Calculation of the efficiency of a gear from the mesh losses, step by step.

use super::records::{member_name, meshes};
use crate::shared::number::plain;
use crate::tolerance::ROUNDED;
use epicyclic_train::power_flow::SetPower;
use epicyclic_train::{Analysis, Gearbox};
use schemars::JsonSchema;
use serde::Serialize;

/// Torques and powers with losses, driven from the input. Torques are relative to the input torque, speeds to
/// the input speed, powers to the entering power.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct StepLosses {
    /// Sets that carry torque.
    pub sets: Vec<SetSteps>,
    /// Sum of the losses of the sets, relative to the entering power.
    pub loss_of_entering: f64,
    /// Efficiency of the gear: 1 minus the sum of the losses. At or below 0 the gear is self-locking.
    pub efficiency: f64,
}

/// Set that carries torque.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetSteps {
    /// Name of the set.
    pub set: String,
    /// Efficiency η₀ with the carrier fixed; null for more than two central gears, where only meshes have
    /// efficiencies.
    pub efficiency: Option<f64>,
    /// Exponent w in `T_1 : T_2 : T_H = 1 : −i₀·η₀^w : i₀·η₀^w − 1`: 1 if the rolling power runs from gear 1
    /// to gear 2, −1 in the opposite direction, 0 without rolling power. Null for more than two central
    /// gears.
    pub exponent: Option<i8>,
    /// Members of the set, the carrier last.
    pub members: Vec<MemberSteps>,
    /// Meshes of the set.
    pub meshes: Vec<MeshSteps>,
    /// Loss of the set, the sum of the rolling powers, relative to the entering power.
    pub loss_of_entering: f64,
}

/// Member of a set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MemberSteps {
    /// Name of the member.
    pub member: String,
    /// Torque on the member relative to the input torque.
    pub torque_of_input: f64,
    /// Speed of the member relative to the carrier, relative to the input speed.
    pub relative_speed_of_input: f64,
    /// Rolling power relative to the entering power: torque times relative speed, positive into the meshes.
    pub rolling_power_of_entering: f64,
}

/// Mesh in the direction of its power relative to the carrier.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MeshSteps {
    /// Name of the driving gear.
    pub from: String,
    /// Name of the driven gear.
    pub to: String,
    /// Efficiency of the mesh.
    pub efficiency: f64,
    /// Power into the mesh, relative to the entering power.
    pub enters_of_entering: f64,
    /// Power out of the mesh, relative to the entering power.
    pub leaves_of_entering: f64,
}

impl StepLosses {
    /// Steps for a gear; `None` if no set loses power, or torques or speeds cannot be computed.
    pub(super) fn of(gearbox: &Gearbox, analysis: &Analysis<'_>) -> Option<Self> {
        let case = analysis.driving()?;
        let is_lossy = gearbox
            .sets()
            .iter()
            .flat_map(epicyclic_train::PlanetSet::meshes)
            .any(|mesh| mesh.efficiency.get() < 1.0);
        if !is_lossy {
            return None;
        }
        let mut through = meshes(gearbox, |set| case.meshes(gearbox, set)).into_iter();
        let mut sets = vec![];
        for (place, set) in gearbox.sets().iter().enumerate() {
            let of_meshes: Vec<_> = through.by_ref().take(set.meshes().len()).collect();
            let torques = case.members[place].as_ref()?;
            if torques.iter().all(|torque| torque.abs() <= ROUNDED * case.input.abs()) {
                continue;
            }
            let power: &SetPower = case.power.sets[place].as_ref()?;
            let speeds: Vec<f64> =
                set.members().iter().map(|link| analysis.speed(*link)).collect::<Option<_>>()?;
            let carrier = *speeds.last()?;
            let member = |of: usize| MemberSteps {
                member: member_name(set, of),
                torque_of_input: plain(torques[of] / case.input),
                relative_speed_of_input: plain(speeds[of] - carrier),
                rolling_power_of_entering: plain(power.rolling.get(of).copied().unwrap_or(0.0)),
            };
            let is_short = set.short().is_some();
            let exponent = match case.signs_of(gearbox, place) {
                [sign] if is_short => Some(*sign),
                _ => None,
            };
            let of_mesh = |mesh: super::records::MeshFigures| {
                Some(MeshSteps {
                    from: mesh.from,
                    to: mesh.to,
                    efficiency: mesh.efficiency,
                    enters_of_entering: plain(mesh.enters?),
                    leaves_of_entering: plain(mesh.leaves?),
                })
            };
            sets.push(SetSteps {
                set: set.id().to_owned(),
                efficiency: is_short.then(|| set.efficiency()),
                exponent,
                members: (0..torques.len()).map(member).collect(),
                meshes: of_meshes.into_iter().filter_map(of_mesh).collect(),
                loss_of_entering: plain(power.loss),
            });
        }
        let loss_of_entering = sets.iter().map(|set| set.loss_of_entering).sum();
        Some(Self { sets, loss_of_entering, efficiency: case.efficiency })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze::answer::{Input, gear};
    use crate::shared::gearbox::{Choice, one};
    use epicyclic_formats::Document;
    use epicyclic_gears::efficiency::MeshEfficiency;

    /// The steps lead to the efficiency of the gear, and each power follows from the other figures of its
    /// step.
    #[test]
    fn losses_sum_up_to_the_efficiency() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/");
        for (file, gears) in
            [("scheme-ii-3.yaml", &["slow", "middle"][..]), ("ravigneaux.yaml", &["1", "2", "R"])]
        {
            let document =
                Document::parse_one(file, &std::fs::read(format!("{folder}{file}")).unwrap()).unwrap();
            let efficiency = Some(MeshEfficiency::new(0.97).unwrap());
            let subject = one(&document, &Choice { efficiency, ..Choice::default() }).unwrap();
            for name in gears {
                let analysis = subject.train.analyze(name).unwrap();
                let steps = StepLosses::of(&subject.train, &analysis).unwrap();
                let whole = gear::answer(&subject, name, Input::default()).unwrap();
                assert!((1.0 - steps.loss_of_entering - steps.efficiency).abs() < 1e-12, "{file} {name}");
                assert_eq!(Some(steps.efficiency), whole.gear.efficiency);
                for set in &steps.sets {
                    let powers = set.members.iter().map(|member| {
                        let power = member.torque_of_input * member.relative_speed_of_input;
                        assert!((power - member.rolling_power_of_entering).abs() < 1e-12, "{file} {name}");
                        power
                    });
                    assert!((powers.sum::<f64>() - set.loss_of_entering).abs() < 1e-12, "{file} {name}");
                    let meshes =
                        set.meshes.iter().map(|mesh| mesh.enters_of_entering - mesh.leaves_of_entering);
                    assert!((meshes.sum::<f64>() - set.loss_of_entering).abs() < 1e-12, "{file} {name}");
                }
            }
        }
    }

    #[test]
    fn a_gearbox_without_losses_has_no_such_steps() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/six-speed-6hp.yaml");
        let document = Document::parse_one("6hp.yaml", &std::fs::read(file).unwrap()).unwrap();
        let subject = one(&document, &Choice::default()).unwrap();
        assert_eq!(StepLosses::of(&subject.train, &subject.train.analyze("1").unwrap()), None);
    }
}
