//! Names for errors: quantities, wheels, conditions.

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
    /// A quantity of a motor, of its teeth or of a search; displays as in messages, `pressure drop`.
    Quantity {
        Module "module"
        TroughDistance "l"
        CrestDistance "a"
        TroughRadius "R₁"
        CrestRadius "R₂"
        TroughAngle "Γ"
        CrestAngle "B"
        TroughDistanceLessRadius "l − R₁"
        FamilyPart "part of the family"
        Width "width"
        Speed "speed"
        Rotation "rotation"
        ArcLength "arc length"
        StatorArc "stator arc"
        PolarAngle "polar angle"
        HighPressure "high pressure"
        LowPressure "low pressure"
        PressureDrop "pressure drop"
        Torque "torque"
        Displacement "displacement"
        DisplacementTolerance "tolerance of the displacement"
        WidthOverDiameter "width over diameter"
        OuterDiameter "outer diameter"
        Ripple "ripple at the pitch points"
        FlankRipple "ripple at the flanks"
        LeastRadius "least radius"
        ContactRatio "contact ratio"
        LeastTorque "least torque over the mean"
        ContactStress "pressure of Hertz"
        RootStress "bending stress at the roots"
        AllowedPressure "allowed pressure drop"
        FamilyPoints "points of a family"
        Resolution "resolution"
        Steps "steps"
        Points "points"
        SecondAmplitude "ε₂"
        PressureAngle "pressure angle"
        Addendum "addendum"
        Dedendum "dedendum"
        RotorDedendum "dedendum of the rotor"
        SatelliteDedendum "dedendum of the satellite"
        Clearance "clearance"
        ProfileShift "profile shift"
        Backlash "backlash"
        BacklashShare "the satellite's share of the backlash"
        Fillet "fillet"
        SatelliteTooth "tooth of the satellite"
        WheelTooth "tooth of the wheels"
        StatorOffset "offset of the contact on the stator"
        RotorOffset "offset of the contact on the rotor"
        ContactOffset "offset of the contact"
        ContactModulus "effective modulus"
        ElasticModulus "modulus of elasticity"
        PoissonRatio "Poisson's ratio"
        ContactLimit "limit of the contact pressure"
        RootLimit "limit of the root stress"
        StatorLobes "stator lobes"
        RotorLobes "rotor lobes"
        StatorTeeth "stator teeth"
        RotorTeeth "rotor teeth"
        SatelliteTeeth "satellite teeth"
        HoleDiameter "diameter of the hole"
        PitchCircleRadius "pitch circle radius of the hole"
        PortAngle "angle of the port"
        KidneyInnerRadius "inner radius of the kidney"
        KidneyOuterRadius "outer radius of the kidney"
        KidneySpan "span of the kidney"
        KidneyCorner "corner radius of the kidney"
        ClosedAngle "closed angle"
        ChamberArea "area of the chamber"
        ChamberBend "second derivative of the chamber's area"
        DeadArea "dead area"
        BulkModulus "bulk modulus"
        Density "density"
        Viscosity "viscosity"
        DischargeCoefficient "discharge coefficient"
        Gap "gap"
        SatelliteGap "gap of the satellites"
        RotorGap "gap of the rotor"
        SealedAngle "sealed angle"
        AxialPlay "axial play"
        Expansion "coefficient of thermal expansion"
        TemperatureDifference "temperature difference"
        TurbulentFactor "factor of the turbulent law"
        TurbulentExponent "exponent of the turbulent law"
        FrictionCoefficient "friction coefficient"
        BoreRadius "bore radius of the rotor"
    }
}

words! {
    /// A kind of wheel of a motor, or the tool that cuts one.
    WheelKind {
        Stator "stator"
        Rotor "rotor"
        Satellite "satellite"
        WheelCutter "cutter of the wheels"
        SatelliteRack "rack of the satellite"
    }
}

words! {
    /// The ports of one pressure.
    PortSide {
        High "high-pressure"
        Low "low-pressure"
    }
}

words! {
    /// Things that a search chooses from.
    Choice {
        Families "families"
        Objectives "objectives"
        Crests "crests"
    }
}

words! {
    /// Reason why two parameters of system (1) leave the arcs open.
    OpenPair {
        BothAngles "B − Γ is θ₃, so that the angles leave every length open"
        SameParameter "two different parameters are needed"
    }
}

words! {
    /// Reason why no motor of two arcs closes with some numbers.
    FamilyFault {
        CrestRadius "where R₁ vanishes, the satellite does not fit into the stator's crests"
        RotorCusp "where R₁ vanishes, the rotor already has cusps"
        RadialFlank "the stator's flank is more than radial for every l"
    }
}

words! {
    /// The condition of two arcs that fails.
    ArcsFault {
        NoSolution "the equation for Γ has no solution"
        TroughDistance "l is not positive"
        CrestDistance "a is not positive: the centrode is a circle"
        TroughRadius "R₁ is not positive"
        CrestRadius "R₂ is not positive"
        TroughAngle "Γ is not positive"
        CrestAngle "B reaches half a turn"
    }
}
