//! Load of a set in a gear.

use super::rated_set::RatedSet;
use super::records::Reason;
use crate::analyze::answer::Worked;
use crate::answer::Warning;
use crate::tolerance::{ROUNDED, rounded};
use epicyclic_strength::mesh::Load;
use epicyclic_train::PlanetSet;
use epicyclic_train::mesh_loads::MeshLoad;
use epicyclic_train::planet_set::GearOf;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Time, Torque};

/// Torques on the central gears of a set without losses; each is 0 if only a rounding error is left.
fn torques<'w>(place: usize, worked: &'w Worked<'_>) -> Option<impl Iterator<Item = Torque> + use<'w>> {
    let (operation, case) = worked.operation.as_ref().zip(worked.analysis.ideal())?;
    let members = case.members[place].as_ref()?;
    Some(members.iter().map(move |of| operation.input * rounded(of / case.input)))
}

/// Torque on the sun of a set without losses; 0 if only a rounding error is left.
pub(super) fn torque(place: usize, worked: &Worked<'_>) -> Option<Torque> {
    torques(place, worked)?.next()
}

/// Torque on the sun without losses, its speed relative to the carrier, and the carrier speed. Each is 0 if
/// only a rounding error is left.
pub(crate) fn felt(
    place: usize,
    worked: &Worked<'_>,
    speed: AngularVelocity,
) -> Option<(Torque, [AngularVelocity; 2])> {
    let motion = &worked.analysis.sets()[place];
    let turning = rounded(motion.relative?);
    Some((torque(place, worked)?, [speed * turning, speed * motion.carrier().unwrap_or(0.0)]))
}

/// Load of a set without losses.
pub(crate) struct SetLoad {
    /// Torques on the central gears, N·m; each is 0 if only a rounding error is left.
    torques: Vec<f64>,
    /// Speed of the first central gear relative to the carrier.
    pub(crate) speed: AngularVelocity,
}

impl SetLoad {
    /// Load of a set, by its index, in a gear at a speed of the input; without a speed that of a set that
    /// need not roll.
    pub(crate) fn of(
        place: usize,
        worked: &Worked<'_>,
        speed: Option<AngularVelocity>,
    ) -> Result<Self, Reason> {
        let torques = torques(place, worked).ok_or(Reason::NoTorquesFollow)?;
        let torques: Vec<f64> = torques.map(Physical::si).collect();
        if torques.iter().all(|torque| *torque == 0.0) {
            return Err(Reason::NoTorque);
        }
        let Some(speed) = speed else { return Ok(Self { torques, speed: AngularVelocity::from_si(0.0) }) };
        let relative = worked.analysis.sets()[place].relative.ok_or(Reason::NoTorquesFollow)?;
        let turning = rounded(relative);
        if turning == 0.0 {
            return Err(Reason::NoRolling);
        }
        Ok(Self { torques, speed: speed * turning })
    }

    /// No load.
    pub(super) fn idle(set: &RatedSet<'_>) -> Self {
        Self { torques: vec![0.0; set.set.members().len()], speed: AngularVelocity::from_si(0.0) }
    }

    /// Torques of the meshes of the set, in its order; 0 where only a rounding error is left.
    pub(crate) fn of_meshes(&self, set: &PlanetSet) -> Vec<MeshLoad> {
        let largest = self.torques.iter().fold(0.0, |largest: f64, torque| largest.max(torque.abs()));
        // A mesh without load has what rounding leaves of torques that cancel.
        let clean = |torque: f64| if torque.abs() <= ROUNDED * largest { 0.0 } else { torque };
        let loads = set.mesh_loads(&self.torques).unwrap_or_default().into_iter();
        loads.map(|load| MeshLoad { torques: load.torques.map(clean), ..load }).collect()
    }

    /// Gears with several meshes that load the same flank.
    pub(super) fn shared_flanks(&self, set: &RatedSet<'_>) -> Vec<GearOf> {
        let loads = self.of_meshes(set.set);
        let is_shared = |gear: &GearOf| {
            let torque = |(mesh, load): (usize, &MeshLoad)| {
                let end = set.set.gears_of_mesh(mesh).iter().position(|one| one == gear)?;
                Some(load.torques[end])
            };
            let torques: Vec<f64> = loads.iter().enumerate().filter_map(torque).collect();
            [1.0, -1.0].iter().any(|flank| torques.iter().filter(|torque| **torque * flank > 0.0).count() > 1)
        };
        set.set.gears().into_iter().filter(is_shared).collect()
    }

    /// Loads of the meshes of the set, in its order.
    pub(super) fn meshes(&self, set: &RatedSet<'_>, life: Time) -> Vec<Load> {
        let load = |load: MeshLoad| Load {
            torque: Torque::from_si(load.torques[0].abs()),
            speed: AngularVelocity::from_si((self.speed.si() * load.speeds[0]).abs()),
            life,
            contacts: load.contacts,
        };
        self.of_meshes(set.set).into_iter().map(load).collect()
    }
}

/// A gear with several meshes that load the same flank, and the gears of the gearbox in which they do.
pub(super) struct LoadedGear {
    set: String,
    toothed_gear: String,
    gears: Vec<String>,
}

/// Gears with several meshes that load the same flank, each once.
#[derive(Default)]
pub(super) struct SharedFlanks(Vec<LoadedGear>);

impl SharedFlanks {
    /// Adds those of a set in a gear.
    pub(super) fn add(&mut self, set: &RatedSet<'_>, gear: &str, load: &SetLoad) {
        for of in load.shared_flanks(set) {
            let name = set.set.gear_name(of);
            let known = self.0.iter_mut().find(|one| one.set == set.id && one.toothed_gear == name);
            match known {
                Some(one) if one.gears.iter().any(|known| known == gear) => {}
                Some(one) => one.gears.push(gear.to_owned()),
                None => self.0.push(LoadedGear {
                    set: set.id.to_owned(),
                    toothed_gear: name,
                    gears: vec![gear.to_owned()],
                }),
            }
        }
    }

    pub(super) fn warnings(&self) -> impl Iterator<Item = Warning> {
        self.0.iter().map(|LoadedGear { set, toothed_gear, gears }| Warning {
            name: "shared-flank",
            message: format!(
                "set {set}: several meshes load the same flank of the {toothed_gear} in {} {}; each is rated alone, and their damage together is more",
                if gears.len() == 1 { "gear" } else { "gears" },
                gears.join(", ")
            ),
        })
    }
}
