//! Where in the file a refusal of the calculation belongs.

use crate::Path;
use epicyclic_dynamics::Error;
use epicyclic_dynamics::drive::BoredGear;
use epicyclic_gears::Error as Gear;

/// The key that an error of the design is about; the root where it is about the whole.
///
/// The key need not be written in the file: it is also the one that would help.
#[must_use]
pub fn place(error: &Error) -> Path {
    path(match error {
        Error::Gear(error) => of_gear(error),
        Error::UnequalCentreDistances { .. } => "teeth",
        Error::BoreTooLarge { gear: BoredGear::Sun, .. } => "wheels.sun_bore",
        Error::BoreTooLarge { gear: BoredGear::Planet, .. } => "wheels.planet_bore",
        Error::Impossible { link, .. } => match link.as_str() {
            "motor" => "attached.motor",
            "driven machine" => "attached.machine",
            "carrier" => "carrier.inertia",
            _ => "",
        },
        Error::NotFinite { what: "load torque", .. } => "start.load",
        _ => "",
    })
}

fn of_gear(error: &Gear) -> &'static str {
    match error {
        Gear::NotPositive { quantity, .. }
        | Gear::Negative { quantity, .. }
        | Gear::OutOfRange { quantity, .. }
        | Gear::NotAbove { quantity, .. } => of_quantity(quantity),
        Gear::NoToothNumbers { .. } => "ratio",
        Gear::Tolerance { .. } => "ratio_tolerance",
        Gear::ToothRange { gear: "sun", .. } => "teeth.sun",
        Gear::ToothRange { gear: "planet", .. } => "teeth.planet",
        Gear::ToothRange { gear: "ring", .. } => "teeth.ring",
        Gear::PlanetNumber { .. } => "teeth.planets",
        Gear::NoRoot { .. } | Gear::NoInternalTip { .. } => "teeth",
        Gear::NoStandardDiameter { .. } | Gear::NoBearingForShaft { .. } => "shafts",
        _ => "",
    }
}

/// The key of a quantity, by the name that the errors give it.
fn of_quantity(quantity: &str) -> &'static str {
    match quantity {
        "power" | "torque" => "power",
        "speed" => "speed",
        "ratio" => "ratio",
        "driving torque" => "start.driving_torque",
        "module" => "wheels.module",
        "face width" => "wheels.face_width",
        "addendum coefficient" => "wheels.addendum",
        "clearance coefficient" => "wheels.clearance",
        "pressure angle" => "wheels.pressure_angle",
        "density" => "wheels.density",
        "bore diameter" => "wheels",
        "tip gap" => "teeth.tip_gap",
        "allowable stress" => "shafts.allowable_stress",
        "shaft diameter" => "shafts",
        "arm length" => "carrier.arms.length",
        "arm width" => "carrier.arms.width",
        "arm thickness" => "carrier.arms.thickness",
        "hole radius" => "carrier.arms.hole.radius",
        "distance of the hole from the outer end" => "carrier.arms.hole.from_outer_end",
        "hub outside radius" => "carrier.hub.outside_radius",
        "hub inside radius" => "carrier.hub.inside_radius",
        "width" => "carrier.hub.width",
        _ => "",
    }
}

/// A path from its keys joined by dots.
pub(super) fn path(keys: &str) -> Path {
    keys.split('.').filter(|key| !key.is_empty()).fold(Path::root(), Path::key)
}
