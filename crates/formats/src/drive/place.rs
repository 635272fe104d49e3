//! Where in the file a refusal of the calculation belongs.

use crate::Path;
use epicyclic_dynamics::Error;
use epicyclic_dynamics::drive::{BoredGear, Given};
use epicyclic_dynamics::equivalent_inertia::LinkName;
use epicyclic_gears::quantity::SimpleGear;
use epicyclic_gears::{Error as Gear, Quantity};

/// The key that an error of the design is about; the root where it is about the whole.
///
/// The key need not be written in the file: it is also the one that would help.
#[must_use]
pub fn place(error: &Error) -> Path {
    Path::dotted(match error {
        Error::Gear(error) => of_gear(error),
        Error::UnequalCentreDistances { .. } => "teeth",
        Error::BoreTooLarge { gear: BoredGear::Sun, .. } => "gear_set.sun_bore",
        Error::BoreTooLarge { gear: BoredGear::Planet, .. } => "gear_set.planet_bore",
        Error::NotPositive { quantity, .. } => match quantity {
            Given::Power => "power",
            Given::Speed => "speed",
            Given::Ratio => "ratio",
            Given::DrivingTorque => "start.driving_torque",
        },
        Error::Impossible { link, .. } => match link {
            LinkName::Motor => "attached.motor",
            LinkName::Machine => "attached.machine",
            LinkName::Carrier => "carrier.inertia",
            _ => "",
        },
        Error::LoadNotFinite { .. } => "start.load",
        Error::DoesNotStart { .. } => "start.driving_torque",
        Error::SelfLocking => "mesh_efficiency",
        Error::NoInertia | Error::Overflow { .. } => "gear_set",
        _ => "",
    })
}

fn of_gear(error: &Gear) -> &'static str {
    match error {
        Gear::NotPositive { quantity, .. }
        | Gear::Negative { quantity, .. }
        | Gear::OutOfRange { quantity, .. }
        | Gear::NotAbove { quantity, .. } => of_quantity(*quantity),
        Gear::NoToothNumbers { .. } => "ratio",
        Gear::Tolerance { .. } => "ratio_tolerance",
        Gear::ToothRange { gear: SimpleGear::Sun, .. } => "teeth.sun",
        Gear::ToothRange { gear: SimpleGear::Planet, .. } => "teeth.planet",
        Gear::ToothRange { gear: SimpleGear::Ring, .. } => "teeth.ring",
        Gear::PlanetNumber { .. } => "teeth.planets",
        Gear::NoRoot { .. } | Gear::NoInternalTip { .. } => "teeth",
        Gear::NoStandardDiameter { .. } | Gear::NoBearingForShaft { .. } => "shafts",
        _ => "",
    }
}

/// The key of a quantity.
fn of_quantity(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Torque => "power",
        Quantity::Module => "gear_set.module",
        Quantity::FaceWidth => "gear_set.face_width",
        Quantity::AddendumCoefficient => "gear_set.addendum",
        Quantity::ClearanceCoefficient => "gear_set.clearance",
        Quantity::PressureAngle => "gear_set.pressure_angle",
        Quantity::Density => "gear_set.density",
        Quantity::BoreDiameter => "gear_set",
        Quantity::TipGap => "teeth.tip_gap",
        Quantity::AllowableStress => "shafts.allowable_stress",
        Quantity::ShaftDiameter => "shafts",
        Quantity::ArmLength => "carrier.arms.length",
        Quantity::ArmWidth => "carrier.arms.width",
        Quantity::ArmThickness => "carrier.arms.thickness",
        Quantity::HoleRadius => "carrier.arms.hole.radius",
        Quantity::HoleDistance => "carrier.arms.hole.from_outer_end",
        Quantity::HubOutsideRadius => "carrier.hub.outside_radius",
        Quantity::HubInsideRadius => "carrier.hub.inside_radius",
        Quantity::Width => "carrier.hub.width",
        _ => "",
    }
}
