//! Quantities that errors name.

use crate::words;
use std::fmt;

words! {
    /// A quantity of a gear, a gear set or what carries it; displays as in messages, `face width`.
    Quantity {
        AddendumCoefficient "addendum coefficient"
        ClearanceCoefficient "clearance coefficient"
        PressureAngle "pressure angle"
        RootFillet "root fillet radius"
        Protuberance "protuberance"
        Stock "stock on the flanks"
        FormFillet "fillet of the form tool"
        HelixAngle "helix angle"
        TipGap "tip gap"
        TipThickness "tip thickness"
        TipClearance "tip clearance"
        ContactRatio "contact ratio"
        Friction "coefficient of friction"
        RingTeeth "teeth of the ring"
        ThicknessAllowance "tooth thickness allowance"
        CentreDistanceDeviation "deviation of the centre distance"
        MeshStiffness "mesh stiffness"
        ShaperTipRadius "tip radius of the shaper"
        ShaperShift "profile shift of the shaper"
        ShaperAddendum "addendum of the shaper"
        ChordDeviation "deviation of the chords"
        Module "module"
        CentreDistance "centre distance"
        PitchRadius "pitch radius"
        OutsideDiameter "outside diameter"
        TipDiameter "tip diameter"
        RootDiameter "root diameter"
        RimDiameter "rim diameter"
        BoreDiameter "bore diameter"
        FaceWidth "face width"
        Width "width"
        Mass "mass"
        Density "density"
        ArmLength "arm length"
        ArmWidth "arm width"
        ArmThickness "arm thickness"
        HoleRadius "hole radius"
        HoleDistance "distance of the hole from the outer end"
        HubOutsideRadius "hub outside radius"
        HubInsideRadius "hub inside radius"
        Torque "torque"
        AllowableStress "allowable stress"
        BoreRatio "bore ratio"
        ShaftDiameter "shaft diameter"
        ShaftBore "shaft bore"
        NeededShaftDiameter "needed shaft diameter"
        Bore "bore"
        LoadRating "basic dynamic load rating of the bearing"
        BearingLoad "load of the bearing"
        BearingSpeed "speed of the bearing"
        CarrierRadius "radius of the planets' centres"
        CarrierSpeed "speed of the carrier"
        CarrierTorque "torque on the carrier"
        CentralGearTorque "torque on a central gear"
        MeshTorque "torque of a mesh"
        PlanetMass "mass of a planet"
        PlanetBore "bore of a planet"
        SizedPlanets "number of planets with a size"
        SizedMeshes "number of meshes with a size"
        SizedFaceWidths "number of face widths of a planet"
        MemberTorques "number of torques on the members"
    }
}

/// A gear of a simple set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "ToothedGear"))]
pub enum SimpleGear {
    /// The sun.
    Sun,
    /// A planet.
    Planet,
    /// The ring.
    Ring,
}

impl SimpleGear {
    /// Sun, planet, ring.
    pub const ALL: [Self; 3] = [Self::Sun, Self::Planet, Self::Ring];
}

impl fmt::Display for SimpleGear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Sun => "sun",
            Self::Planet => "planet",
            Self::Ring => "ring",
        })
    }
}

/// Kind of parts that are counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Counted {
    /// Arms of a carrier.
    Arms,
    /// Planets of a set.
    Planets,
}

impl fmt::Display for Counted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Arms => "arms",
            Self::Planets => "planets",
        })
    }
}
