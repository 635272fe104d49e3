//! Errors of this crate.

use crate::symbol::Symbol;
use epicyclic_gears::{shown, with_unit};

epicyclic_gears::words! {
    /// A quantity that an error refuses; displays as in messages, `face width`.
    Quantity {
        Module "module"
        FaceWidth "face width"
        Torque "torque of the mesh"
        Speed "speed"
        Life "required life"
        Contacts "contacts of a tooth per revolution"
        FlankRoughness "roughness Rz of the flank"
        RootRoughness "roughness Rz of the root"
        Viscosity "viscosity of the oil at 40 °C"
        ContactLimit "contact stress limit σ_Hlim"
        RootLimit "root stress limit σ_Flim"
        Strength "yield or tensile strength of the material"
        Hardness "Brinell hardness"
        YoungsModulus "Young's modulus"
        PoissonRatio "Poisson's ratio"
        Density "density"
        Rim "rim thickness of the external gear"
        RingRim "rim thickness of the ring"
        RimOverHeight "rim thickness over tooth height"
        RimOverModule "rim thickness over module"
        ContactRatio "contact ratio of the virtual gears ε_αn"
        TransverseContactRatio "transverse contact ratio ε_α"
        TotalContactRatio "total contact ratio ε_γ"
        NotchParameter "notch parameter q_s"
        ShaperTeeth "teeth of the shaper"
        ShaperShift "profile shift coefficient of the shaper"
        StressRatio "stress ratio R"
        MeanStressSensitivity "mean stress sensitivity M"
        AccuracyGrade "accuracy grade"
        LongLifeFactor "life factor at 10¹⁰ cycles"
        BlankFactor "gear blank factor C_R"
        PitchDeviation "base pitch deviation f_pb"
        ProfileDeviation "profile form deviation f_fα"
        TipRelief "tip relief C_a"
        Bore "inside diameter of a rim"
        RingOutside "outside diameter of the ring"
        Planets "number of planets"
        Share "share of time"
        RequiredSafety "required safety"
        LoadRating "basic dynamic load rating"
        FatigueLoadLimit "fatigue load limit"
        BearingLoad "load of the bearing"
        ViscosityRatio "viscosity ratio κ"
        Contamination "contamination factor e_C"
        LifeModification "life modification factor a_ISO"
        MeanDiameter "mean diameter of the bearing"
        Friction "coefficient of friction"
        Power "power of the mesh"
        CentreDistance "centre distance"
        CentreDistanceStep "step of the centre distances"
        CentreDistanceReach "reach of the centre distances"
        WidthRatio "face width over the sun's diameter"
        LargestRing "largest ring"
        LeastRim "least rim of the planets"
        RingRimInModules "rim of the ring"
        PlanetBore "bore of the planets"
    }
}

/// An input that describes no gear, no load or no duty, or one outside what the standard holds for.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// A search that the caller cancelled.
    #[error("the search was cancelled")]
    Cancelled,
    /// A quantity that must be finite and above 0.
    #[error("{quantity} is {}; it must be finite and above 0", with_unit(*value, unit))]
    NotPositive {
        /// The quantity.
        quantity: Quantity,
        /// The value given.
        value: f64,
        /// Unit of the value.
        unit: &'static str,
    },
    /// A quantity that must be finite and not below 0.
    #[error("{quantity} is {}; it must be finite and not below 0", with_unit(*value, unit))]
    Negative {
        /// The quantity.
        quantity: Quantity,
        /// The value given.
        value: f64,
        /// Unit of the value.
        unit: &'static str,
    },
    /// A quantity outside its range.
    #[error("{quantity} is {}; it must lie between {low} and {}", with_unit(*value, unit), with_unit(*high, unit))]
    OutOfRange {
        /// The quantity.
        quantity: Quantity,
        /// The value given.
        value: f64,
        /// The least allowed.
        low: f64,
        /// The greatest allowed.
        high: f64,
        /// Unit of the values.
        unit: &'static str,
    },
    /// A quantity that must be above a limit.
    #[error("{quantity} is {}; it must be above {}", with_unit(*value, unit), with_unit(*low, unit))]
    NotAbove {
        /// The quantity.
        quantity: Quantity,
        /// The value given.
        value: f64,
        /// Value that it must exceed.
        low: f64,
        /// Unit of both values.
        unit: &'static str,
    },
    /// A factor given that is no factor.
    #[error("factor {symbol} is given as {}; it must be finite and {}", shown(*value), if symbol.is_at_least_one() { "not below 1" } else { "above 0" })]
    GivenFactor {
        /// Symbol of the factor.
        symbol: Symbol,
        /// The value given.
        value: f64,
    },
    /// A factor that is neither given nor can be calculated from what is given.
    #[error("factor {symbol} is not given and cannot be calculated: {because}")]
    MissingFactor {
        /// Symbol of the factor.
        symbol: Symbol,
        /// Data that the calculation needs.
        because: &'static str,
    },
    /// A tool that gives the gear no root of the standard's form.
    #[error("no root section of {teeth} teeth: {because}")]
    NoRootSection {
        /// Teeth of the gear.
        teeth: u32,
        /// Reason why there is no root section.
        because: &'static str,
    },
    /// Shares of a duty that are not the whole time.
    #[error("the shares of the duty sum to {}; they must sum to 1", with_unit(*sum, ""))]
    Shares {
        /// Sum of the shares.
        sum: f64,
    },
    /// A duty without load.
    #[error("the duty has no step with a torque and a speed; at least one is needed")]
    IdleDuty,
    /// A search for a size over nothing.
    #[error("no {quantity} to search; at least one is needed")]
    NothingToSearch {
        /// The missing quantity.
        quantity: Quantity,
    },
    /// A space of more gears than a search holds.
    #[error(
        "the space has {count:.0} centre distances with face widths; at most {most} are searched: a larger step of the centre distances, \
         fewer modules or fewer face widths would help"
    )]
    SpaceTooLarge {
        /// Centre distances of all modules and numbers of planets, times face widths.
        count: f64,
        /// Largest number that is searched.
        most: u32,
    },
    /// A column of a table of bearings that is missing, unknown or named twice.
    #[error(
        "bearings, line {line}, column {column}: missing, unknown or named twice; the columns are {allowed}"
    )]
    BearingColumn {
        /// The line, from 1.
        line: usize,
        /// The column.
        column: String,
        /// Names of all columns.
        allowed: String,
    },
    /// A cell of a table of bearings.
    #[error("bearings, line {line}, column {column}: `{value}`; {allowed} is needed")]
    BearingCell {
        /// The line, from 1.
        line: usize,
        /// The column.
        column: &'static str,
        /// Content of the cell.
        value: String,
        /// Value that is required.
        allowed: &'static str,
    },
    /// A table of bearings without bearings.
    #[error("the table of bearings has no lines; at least one bearing is needed")]
    NoBearings,
    /// Bearings of one row alone for planets that helical teeth tilt.
    #[error(
        "helical teeth and steps tilt their planets, and one bearing row has no rating against a moment; pairs of bearings are needed"
    )]
    OneBearingRow,
    /// A fault of the gears' geometry.
    #[error(transparent)]
    Gears(#[from] epicyclic_gears::Error),
}

impl Error {
    /// Whether the input is a gear or load, but one outside what the standard holds for.
    #[must_use]
    pub const fn is_beyond_standard(&self) -> bool {
        match self {
            Self::NoRootSection { .. } => true,
            // The ranges of these quantities are those of the standard's formulas. Any other range is one of
            // the input.
            Self::OutOfRange { quantity, .. } | Self::NotAbove { quantity, .. } => matches!(
                quantity,
                Quantity::ContactRatio
                    | Quantity::NotchParameter
                    | Quantity::RimOverHeight
                    | Quantity::RimOverModule
                    | Quantity::RootRoughness
                    | Quantity::TotalContactRatio
                    | Quantity::TransverseContactRatio
            ),
            _ => false,
        }
    }

    /// Whether the error ends the calculation of one flank, root or mesh and leaves the others: outside the
    /// range of the standard, or without a factor.
    #[must_use]
    pub const fn is_of_part(&self) -> bool {
        self.is_beyond_standard() || matches!(self, Self::MissingFactor { .. })
    }

    /// Name of the fault, which does not change with the message: `not-positive`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Gears(error) => error.name(),
            named => named.into(),
        }
    }
}
