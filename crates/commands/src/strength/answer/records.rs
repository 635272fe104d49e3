//! Records of the strength of teeth: meshes, gears, governing safeties, parts that are not rated.

pub use super::axial::{AxialForce, AxialForceOfMesh, Thrusts};
pub use super::bearing_records::{BearingOverDuty, BearingStepFigures, ModifiedLife};
pub use super::names::{Against, MeshName};
pub use super::not_rated::{NotRated, Reason};
pub use super::sharing::{LoadSharing, SharingBasis};
use crate::answer::Warning;
use epicyclic_formats::gearbox::{DutyEntry, RequiredEntry};
use epicyclic_strength::factor::{Origin, Side};
use epicyclic_strength::mesh::Load;
use epicyclic_strength::rating::MeshRating;
use epicyclic_strength::rating::Place;
use epicyclic_strength::spectrum::{DutyRating, Worn};
use epicyclic_strength::{self as strength, factor, rating};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// Name of the warnings about safeties below the required ones.
pub(crate) const LOW_SAFETY: &str = "low-safety";

/// Required safeties.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Required {
    /// Required safety of the flanks.
    pub flank: f64,
    /// Required safety of the roots.
    pub root: f64,
}

impl Required {
    /// Required safeties of a file; 1 by default.
    pub(crate) fn of(entry: Option<&RequiredEntry>) -> Self {
        let of = |required: &RequiredEntry| Self { flank: required.flank.get(), root: required.root.get() };
        entry.map_or(Self { flank: 1.0, root: 1.0 }, of)
    }

    pub(crate) fn check(self) -> Result<(), strength::Error> {
        let quantity = strength::Quantity::RequiredSafety;
        let wrong = [self.flank, self.root].into_iter().find(|value| !(value.is_finite() && *value > 0.0));
        wrong.map_or(Ok(()), |value| Err(strength::Error::NotPositive { quantity, value, unit: "" }))
    }

    const fn at(self, place: Place) -> f64 {
        match place {
            Place::Flank => self.flank,
            Place::Root => self.root,
        }
    }
}

/// Factor of the calculation.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Factor {
    /// Symbol of the factor as in ISO 6336.
    pub symbol: String,
    /// Value of the factor; `Z_E` in √(N/mm²), all others without unit.
    pub value: f64,
    /// Document and clause of the factor's formula; null if the factor is given.
    pub formula: Option<String>,
}

impl Factor {
    fn of(factor: factor::Factor) -> Self {
        let formula = match factor.origin {
            Origin::Formula(reference) => Some(reference.to_string()),
            Origin::Given => None,
        };
        Self { symbol: factor.symbol.to_string(), value: factor.value, formula }
    }
}

/// Gear of a mesh at an operating point.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Rated {
    /// Name of the selected gear.
    pub gear: String,
    /// Name of the set.
    pub set: String,
    /// Name of the mesh.
    pub mesh: MeshName,
    /// Gear of the mesh.
    pub toothed_gear: String,
    /// Name of the gear's material.
    pub material: String,
    /// Absolute torque of one mesh on its first gear, in N·m.
    pub mesh_torque_n_m: f64,
    /// Absolute speed of the mesh's first gear relative to the carrier, in rad/s.
    pub mesh_speed_rad_s: f64,
    /// Tangential force of one mesh at the reference circle, `F_t`, in N.
    pub tangential_force_n: f64,
    /// Axial force of one mesh `F_t·tan β`, in N; 0 for spur teeth.
    pub axial_force_n: f64,
    /// Number of load cycles in the required life, `N_L`.
    pub cycles: f64,
    /// Contact stress `σ_H` in Pa; null for a flank in `not_rated`.
    pub contact_stress_pa: Option<f64>,
    /// Contact stress limit `σ_HG` in Pa; null for a flank in `not_rated`.
    pub contact_limit_pa: Option<f64>,
    /// Safety of the flank, `S_H`; null for a flank in `not_rated`.
    pub flank_safety: Option<f64>,
    /// Root stress `σ_F` in Pa; null for a root in `not_rated`.
    pub root_stress_pa: Option<f64>,
    /// Root stress limit `σ_FG` in Pa; null for a root in `not_rated`.
    pub root_limit_pa: Option<f64>,
    /// Safety of the root, `S_F`; null for a root in `not_rated`.
    pub root_safety: Option<f64>,
    /// Factors in the order of the calculation; empty unless they are requested.
    pub factors: Vec<Factor>,
}

/// Mesh at an operating point.
pub(crate) struct MeshAtPoint {
    pub(crate) name: MeshName,
    /// Materials of the gears.
    pub(crate) materials: [String; 2],
    pub(crate) load: Load,
    /// `tan β` at the reference cylinders.
    pub(crate) tan_helix_angle: f64,
    pub(crate) rating: Box<MeshRating>,
}

impl MeshAtPoint {
    /// Records of both gears of the mesh, in a selected gear.
    pub(crate) fn both(&self, gear: &str, set: &str, with_factors: bool) -> [Rated; 2] {
        let of = |side: Side| {
            let own: &rating::GearRating = &self.rating.gears[side as usize];
            let (flank, root) = (own.contact.as_ref().ok(), own.root.as_ref().ok());
            let factors =
                if with_factors { self.rating.chain(side).map(Factor::of).collect() } else { vec![] };
            Rated {
                gear: gear.to_owned(),
                set: set.to_owned(),
                mesh: self.name.clone(),
                toothed_gear: self.name.gears[side as usize].clone(),
                material: self.materials[side as usize].clone(),
                mesh_torque_n_m: self.load.torque.si(),
                mesh_speed_rad_s: self.load.speed.si(),
                tangential_force_n: self.rating.tangential_force.si(),
                axial_force_n: self.rating.tangential_force.si() * self.tan_helix_angle,
                cycles: own.cycles,
                contact_stress_pa: flank.map(|flank| flank.stress.si()),
                contact_limit_pa: flank.map(|flank| flank.limit.si()),
                flank_safety: flank.map(|flank| flank.safety),
                root_stress_pa: root.map(|root| root.stress.si()),
                root_limit_pa: root.map(|root| root.limit.si()),
                root_safety: root.map(|root| root.safety),
                factors,
            }
        };
        Side::BOTH.map(of)
    }

    /// Flanks and roots of a set that are not rated.
    pub(crate) fn not_rated(&self, set: &str) -> Vec<NotRated> {
        let parts = self
            .rating
            .gears
            .each_ref()
            .map(|gear| (gear.contact.as_ref().err().cloned(), gear.root.as_ref().err().cloned()));
        NotRated::parts(set, &self.name, parts)
    }
}

/// Step of the duty.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DutyStep {
    /// Name of the selected gear.
    pub gear: String,
    /// Part of the time, from 0 to 1.
    pub share: f64,
    /// Torque on the input in N·m.
    pub torque_n_m: f64,
    /// Input speed in rad/s.
    pub speed_rad_s: f64,
}

impl DutyStep {
    pub(super) fn of(entry: &DutyEntry) -> Self {
        Self {
            gear: entry.gear.clone(),
            share: entry.share.0.si(),
            torque_n_m: entry.torque.0.si(),
            speed_rad_s: entry.speed.0.si(),
        }
    }
}

/// Factor of the calculation over the steps of a duty.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct FactorOverDuty {
    /// Symbol of the factor as in ISO 6336.
    pub symbol: String,
    /// Least value of the factor; `Z_E` in √(N/mm²), all others without unit.
    pub least: f64,
    /// Greatest value of the factor; `Z_E` in √(N/mm²), all others without unit.
    pub greatest: f64,
    /// Document and clause of the factor's formula; null if the factor is given.
    pub formula: Option<String>,
}

/// Whether a factor depends on a single number of cycles.
const fn is_of_life(symbol: factor::Symbol) -> bool {
    matches!(symbol, factor::Symbol::LifeContact | factor::Symbol::LifeRoot)
}

impl FactorOverDuty {
    /// Combines the factors of all steps.
    fn of(steps: &[MeshRating], side: Side) -> Vec<Self> {
        let mut all: Vec<Self> = vec![];
        for (place, step) in steps.iter().enumerate() {
            let chain = step.chain(side).filter(|factor| !is_of_life(factor.symbol)).map(Factor::of);
            if place == 0 {
                all.extend(chain.map(|Factor { symbol, value, formula }| Self {
                    symbol,
                    least: value,
                    greatest: value,
                    formula,
                }));
            } else {
                for Factor { symbol, value, formula } in chain {
                    match all.iter_mut().find(|one| one.symbol == symbol) {
                        Some(one) => {
                            one.least = one.least.min(value);
                            one.greatest = one.greatest.max(value);
                        }
                        // This flank or root was not rated in the previous steps.
                        None => all.push(Self { symbol, least: value, greatest: value, formula }),
                    }
                }
            }
        }
        all
    }
}

/// Damage of a flank or root over the duty.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Wear {
    /// Damage in the required life, 1 at the end of the life; null if a stress is above the static limit.
    pub damage: Option<f64>,
    /// Safety: the factor on all stresses at which the damage is 1.
    pub safety: f64,
    /// Life in s; null if no load causes damage.
    pub life_s: Option<f64>,
}

impl Wear {
    pub(crate) fn of(worn: &Worn) -> Self {
        let damage = Some(worn.damage).filter(|damage| damage.is_finite());
        Self { damage, safety: worn.safety, life_s: worn.life.map(Physical::si) }
    }
}

/// Gear of a mesh over the duty.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OverDuty {
    /// Name of the set.
    pub set: String,
    /// Name of the mesh.
    pub mesh: MeshName,
    /// Gear of the mesh.
    pub toothed_gear: String,
    /// Name of the gear's material.
    pub material: String,
    /// Damage and safety of the flank; null for a flank in `not_rated`.
    pub flank: Option<Wear>,
    /// Damage and safety of the root; null for a root in `not_rated`.
    pub root: Option<Wear>,
    /// Factors in the order of the calculation; empty unless they are requested. `Z_NT` and `Y_NT` are left
    /// out, because they have no single value in Miner's rule.
    pub factors: Vec<FactorOverDuty>,
}

impl OverDuty {
    /// Records of both gears of a mesh with their materials; `steps` are the ratings whose factors are
    /// listed.
    pub(crate) fn both(
        set: &str,
        (mesh, materials): (&MeshName, &[String; 2]),
        rating: &DutyRating,
        steps: &[MeshRating],
    ) -> [Self; 2] {
        Side::BOTH.map(|side| {
            let own = &rating.gears[side as usize];
            Self {
                set: set.to_owned(),
                mesh: mesh.clone(),
                toothed_gear: mesh.gears[side as usize].clone(),
                material: materials[side as usize].clone(),
                flank: own.contact.as_ref().ok().map(Wear::of),
                root: own.root.as_ref().ok().map(Wear::of),
                factors: FactorOverDuty::of(steps, side),
            }
        })
    }
}

/// Gear of a mesh against an overload: statically, with `K_A` and `K_v` of 1.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Overloaded {
    /// Name of the selected gear.
    pub gear: String,
    /// Torque on the input in N·m.
    pub torque_n_m: f64,
    /// Name of the set.
    pub set: String,
    /// Name of the mesh.
    pub mesh: MeshName,
    /// Gear of the mesh.
    pub toothed_gear: String,
    /// Static safety of the flank, `S_H`; null for a flank in `not_rated`.
    pub flank_safety: Option<f64>,
    /// Static safety of the root, `S_F`; null for a root in `not_rated`.
    pub root_safety: Option<f64>,
    /// Required safeties against this overload.
    pub required: Required,
}

/// Safeties of all gears.
#[derive(Debug, Default)]
pub(super) struct Safeties {
    pub(super) at_point: Vec<Rated>,
    pub(super) over_duty: Vec<OverDuty>,
    pub(super) overload: Vec<Overloaded>,
}

/// Safety with the required value.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Governing {
    /// Load against which the safety is computed.
    pub against: Against,
    /// Name of the selected gear; null over a duty.
    pub gear: Option<String>,
    /// Name of the set.
    pub set: String,
    /// Name of the mesh.
    pub mesh: MeshName,
    /// Gear of the mesh.
    pub toothed_gear: String,
    /// Place on the tooth: flank or root.
    pub place: Place,
    /// Value of the safety.
    pub safety: f64,
    /// Required safety.
    pub required: f64,
}

impl Governing {
    /// Safeties of flank and root of a gear, as far as they are rated.
    fn both(
        (against, gear, set, mesh, toothed_gear): (Against, Option<&String>, &String, &MeshName, &String),
        safeties: [Option<f64>; 2],
        required: Required,
    ) -> impl Iterator<Item = Self> + use<> {
        let (gear, set, mesh, toothed_gear) =
            (gear.cloned(), set.clone(), mesh.clone(), toothed_gear.clone());
        [Place::Flank, Place::Root].into_iter().zip(safeties).filter_map(move |(place, safety)| {
            Some(Self {
                against,
                gear: gear.clone(),
                set: set.clone(),
                mesh: mesh.clone(),
                toothed_gear: toothed_gear.clone(),
                place,
                safety: safety?,
                required: required.at(place),
            })
        })
    }
}

/// Safeties of flank and root of each rated gear: at operating points, over a duty, against overloads.
pub(super) fn all_safeties(
    at_point: &[Rated],
    over_duty: &[OverDuty],
    overload: &[Overloaded],
    required: Required,
) -> impl Iterator<Item = Governing> {
    let points = at_point.iter().flat_map(move |one| {
        let of = (Against::OperatingPoint, Some(&one.gear), &one.set, &one.mesh, &one.toothed_gear);
        Governing::both(of, [one.flank_safety, one.root_safety], required)
    });
    let duties = over_duty.iter().flat_map(move |one| {
        let safety = |wear: &Option<Wear>| wear.as_ref().map(|wear| wear.safety);
        let of = (Against::Duty, None, &one.set, &one.mesh, &one.toothed_gear);
        Governing::both(of, [safety(&one.flank), safety(&one.root)], required)
    });
    let overloads = overload.iter().flat_map(|one| {
        let of = (Against::Overload, Some(&one.gear), &one.set, &one.mesh, &one.toothed_gear);
        Governing::both(of, [one.flank_safety, one.root_safety], one.required)
    });
    points.chain(duties).chain(overloads)
}

impl Safeties {
    fn all(&self, required: Required) -> impl Iterator<Item = Governing> {
        all_safeties(&self.at_point, &self.over_duty, &self.overload, required)
    }

    /// Safety with the least ratio to the required one, the first of equal ones.
    pub(crate) fn governing(&self, required: Required) -> Option<Governing> {
        let over = |one: &Governing| one.safety / one.required;
        self.all(required).reduce(|least, one| if over(&one) < over(&least) { one } else { least })
    }

    /// Warnings about safeties below the required ones.
    pub(crate) fn below(&self, required: Required) -> Vec<Warning> {
        self.all(required)
            .filter(|one| one.safety < one.required)
            .map(|one| Warning {
                name: LOW_SAFETY,
                message: format!("{one} is below the {} required", one.required),
            })
            .collect()
    }
}

impl fmt::Display for Governing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let symbol = match self.place {
            Place::Flank => "S_H",
            Place::Root => "S_F",
        };
        let Self { set, mesh, toothed_gear, place, safety, .. } = self;
        write!(f, "{symbol} = {safety:.3} of the {toothed_gear}'s {place} (set {set}, mesh {mesh}")?;
        match (self.against, &self.gear) {
            (Against::Overload, Some(gear)) => write!(f, ", gear {gear}, against the overload)"),
            (_, Some(gear)) => write!(f, ", gear {gear})"),
            (_, None) => f.write_str(", over the duty)"),
        }
    }
}
