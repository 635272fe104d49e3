//! Quantities that errors of the machine side or of a connection name.

use epicyclic_gears::words;

words! {
    /// A quantity of a machine; displays as in messages, `boom radius`.
    Quantity {
        PickSpacing "pick spacing"
        MeanChip "mean chip thickness"
        GreatestChip "greatest chip thickness"
        Feed "feed"
        DrumDiameter "drum diameter"
        PicksPerLine "picks per line"
        CuttingSpeed "cutting speed"
        OtherCuttingSpeed "other cutting speed"
        CuttingForce "cutting force"
        OtherCuttingForce "other cutting force"
        BoomRadius "boom radius"
        SlewingSpeed "slewing speed"
        ChipWidth "chip width"
        Buckets "number of buckets"
        OptimalSpeed "optimal speed"
        Discharge "Ω"
        FallAcceleration "acceleration of fall"
        WheelRadius "wheel radius"
        GreatestSpeed "greatest speed"
        LeastSpeed "least speed"
    }
}

words! {
    /// A parameter of a series of speeds.
    SeriesParameter {
        SpeedRange "d"
        Step "q"
    }
}

words! {
    /// Part for which a ratio is required.
    ConnectionPart {
        FirstGear "first gear"
        SecondGear "second gear"
        Connection "connection"
    }
}

words! {
    /// Reason why no particle flies from the release to the chute.
    FlightFault {
        OutOfRange "ε is above 0 and all are finite"
        ReleaseBelowAxis "release is above the axis"
        ChuteBehind "the chute lies behind the release"
        ChuteAbove "the chute lies above the tangent of the release"
    }
}
