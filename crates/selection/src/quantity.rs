//! Quantities of the requirements that errors name.

use epicyclic_gears::words;

words! {
    /// A range of ring-to-sun ratios of the requirements.
    KRange {
        Allowed "allowed"
        Preferred "preferred"
    }
}

words! {
    /// A quantity with a limit.
    Limited {
        Efficiency "efficiency"
        LinkSpeed "link speed"
        PlanetSpeed "planet speed"
        ClutchSlip "clutch slip"
        Circulation "circulation"
        Module "module"
        RingDiameter "ring diameter"
    }
}

words! {
    /// A quantity by which the size of a gearbox is rated.
    Rated {
        FaceWidthRatio "face-width ratio"
        MeshLoadFactor "mesh load factor"
        InputTorque "input torque"
        LoadFactor "load factor K"
    }
}
