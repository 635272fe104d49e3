//! What an error of the requirements speaks of.

use std::fmt;

macro_rules! words {
    ($(#[$doc:meta])* $type:ident { $($name:ident $text:literal)* }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum $type {$(
            #[doc = $text]
            $name,
        )*}

        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.pad(match self {
                    $(Self::$name => $text,)*
                })
            }
        }
    };
}

words! {
    /// A range of ring-to-sun ratios of the requirements.
    KRange {
        Allowed "allowed"
        Preferred "preferred"
    }
}

words! {
    /// What has a limit.
    Limited {
        Efficiency "efficiency"
        LinkSpeed "link speed"
        PlanetSpeed "planet speed"
        ClutchSlip "clutch slip"
        Module "module"
        RingDiameter "ring diameter"
    }
}

words! {
    /// What the size of a gearbox is rated by.
    Rated {
        FaceWidthRatio "face-width ratio"
        MeshLoadFactor "mesh load factor"
        InputTorque "input torque"
        LoadFactor "load factor K"
    }
}
