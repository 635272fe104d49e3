//! Faults of the description of a gearbox.

use crate::Problem;
use crate::faults::Keys;
use epicyclic_gears::{Error, Quantity};
use epicyclic_units::format::{quantity, trimmed};
use uom::si::f64::Length;

/// A description that is no gearbox.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum DescriptionError {
    /// A set known in no way, or in two.
    #[error("set `{set}`: give either `k` or `teeth`")]
    RowKnownInOneWay {
        /// The set.
        set: String,
    },
    /// A pair with a carrier, or a planet set without.
    #[error("set `{set}`: {}", if *is_pair { "a pair has no `carrier`, since the housing carries it; leave it out" } else { "`carrier` is missing" })]
    Carrier {
        /// The set.
        set: String,
        /// Whether it is a pair.
        is_pair: bool,
    },
    /// Losses of the set and of its meshes at once, or too few or too many meshes.
    #[error("set `{set}`: give `efficiency`, or `meshes` with {expected} efficiencies")]
    Losses {
        /// The set.
        set: String,
        /// How many meshes it has.
        expected: usize,
    },
    /// Friction beside efficiencies.
    #[error("set `{set}`: give one of `efficiency`, `meshes` and `friction`")]
    LossesTwice {
        /// The set.
        set: String,
    },
    /// Friction of a set whose teeth are not known.
    #[error("set `{set}`: friction needs teeth in mesh: {missing}")]
    Friction {
        /// The set.
        set: String,
        /// Missing data, in words.
        missing: String,
    },
    /// The basic rack.
    #[error(transparent)]
    Rack(epicyclic_gears::Error),
    /// More planets than a set has.
    #[error(
        "set `{set}`: {given} counts in `planet_teeth`: one is due of a simple set, one or two of others"
    )]
    PlanetTeeth {
        /// The set.
        set: String,
        /// How many were given.
        given: usize,
    },
    /// Tools that cannot be.
    #[error("set `{set}`: {source}")]
    Tools {
        /// The set.
        set: String,
        /// Why.
        source: ToolMisfit,
    },
    /// Profile shifts of a set whose teeth are not all given, or of bevel gears.
    #[error(
        "set `{set}`: `profile_shifts`, with or without `tip_alterations`, need the teeth of all its gears, and gears that are not bevel"
    )]
    Shifts {
        /// The set.
        set: String,
    },
    /// A helix angle of a set whose teeth are not known or not in mesh.
    #[error("set `{set}`: helical teeth need teeth in mesh: {missing}")]
    HelixAngle {
        /// The set.
        set: String,
        /// Missing data, in words.
        missing: String,
    },
    /// A value of a gear that the set has not.
    #[error("set `{set}`: `{key}` has a value of `{gear}`, and its {of} are {gears}")]
    NoSuchGear {
        /// The set.
        set: String,
        /// The key.
        key: &'static str,
        /// The name.
        gear: String,
        /// Things that the set has: gears, meshes, bodies.
        of: &'static str,
        /// Names of these, and the one that is most like the name given.
        gears: String,
    },
    /// Friction of the gearbox outside its range.
    #[error("`friction` is {}; a coefficient of friction is above 0 and at most 1", trimmed(*given, 6))]
    FrictionRange {
        /// The value.
        given: f64,
    },
    /// A centre distance without what shifts follow from.
    #[error("set `{set}`: `centre_distance` {needs}")]
    CentreDistanceAlone {
        /// The set.
        set: String,
        /// Missing or wrong data, in words.
        needs: &'static str,
    },
    /// Meshes of one planet with central gears at two centre distances.
    #[error("set `{set}`: planet {planet} has the centre distances {} and {} from the axis; it has one", quantity(*first, 6), quantity(*second, 6))]
    TwoRadii {
        /// The set.
        set: String,
        /// The planet.
        planet: String,
        /// Distance of its first mesh.
        first: Length,
        /// Distance of a later one.
        second: Length,
    },
    /// A shift that follows from a centre distance and leaves no teeth.
    #[error("set `{set}`: at this centre distance {gear} gets the profile shift {}, which leaves it no teeth: take another distance, or state other shifts", trimmed(*shift, 4))]
    ShiftFollows {
        /// The set.
        set: String,
        /// The gear.
        gear: String,
        /// The shift.
        shift: f64,
    },
    /// Tip alterations without shifts.
    #[error(
        "set `{set}`: `tip_alterations` stand beside `profile_shifts`: where all shifts are 0, write `profile_shifts: {{}}`"
    )]
    TipsAlone {
        /// The set.
        set: String,
    },
    /// A centre distance at which the gears have no line of action.
    #[error("set `{set}`: the base circles of {} and {} need a centre distance above {}", gears[0], gears[1], quantity(*least, 6))]
    TooNear {
        /// The set.
        set: String,
        /// Names of the gears.
        gears: [String; 2],
        /// The least distance.
        least: Length,
    },
    /// A centre distance that leaves both shifts of a mesh open.
    #[error("set `{set}`: at this centre distance the profile shifts of {} and {} have the sum {}; state one, as `profile_shifts: {{ {}: {} }}`", gears[0], gears[1], trimmed(*sum, 5), gears[0], trimmed(0.5 * sum, 4))]
    ShiftsOpen {
        /// The set.
        set: String,
        /// Names of the gears.
        gears: [String; 2],
        /// Sum of the shifts.
        sum: f64,
    },
    /// A centre distance beside shifts that are all stated.
    #[error("set `{set}`: the centre distance needs the sum {} of the profile shifts of {gears}, and theirs is {}: leave one shift or `centre_distance` out", trimmed(*required, 5), trimmed(*sum, 5))]
    ShiftsFixed {
        /// The set.
        set: String,
        /// Names of the gears.
        gears: String,
        /// Sum of the stated shifts.
        sum: f64,
        /// Sum that the distance requires.
        required: f64,
    },
    /// A key of planets in a pair.
    #[error("set `{set}`: `{key}` is of planets, and a pair has none: leave it out")]
    OfPlanets {
        /// The set.
        set: String,
        /// The key.
        key: &'static str,
    },
    /// Two values of one mesh, named from either gear.
    #[error("set `{set}`: `{key}` gives {name} twice, once from each gear: keep one")]
    ValueTwice {
        /// The set.
        set: String,
        /// The key.
        key: &'static str,
        /// Name of the mesh.
        name: String,
    },
    /// A gear without a value where each needs one.
    #[error("set `{set}`: `{key}` of {gear} is missing")]
    GearLacks {
        /// The set.
        set: String,
        /// The key.
        key: &'static str,
        /// Name of the gear.
        gear: String,
    },
    /// A gear whose meshes state different modules.
    #[error("set `{set}`: {gear} has the modules {} and {}; a gear has one module in all its meshes", quantity(*first, 6), quantity(*second, 6))]
    TwoModules {
        /// The set.
        set: String,
        /// Name of the gear.
        gear: String,
        /// Module of its first mesh.
        first: Length,
        /// Module of a later one.
        second: Length,
    },
    /// Values in a list of a compound set, whose gears have no order.
    #[error("set `{set}`: `{key}` needs the names of the {of}, as `{key}: {{ {}: … }}`; they are {gears}", gears.split(',').next().unwrap_or_default())]
    ByName {
        /// The set.
        set: String,
        /// The key.
        key: &'static str,
        /// Things that the values are of: gears, meshes.
        of: &'static str,
        /// Names of these.
        gears: String,
    },
    /// A key of a body that does not apply to its kind.
    #[error("set `{set}`: `{key}` of the body `{body}` is of {of} alone; leave it out")]
    BodyKey {
        /// The set.
        set: String,
        /// The body.
        body: String,
        /// The key.
        key: &'static str,
        /// Bodies that have the key, in words.
        of: &'static str,
    },
    /// A key that a list of transmissions does not read.
    #[error("set `{set}`: `{key}` is read in a gearbox file alone, not in a list of transmissions")]
    NotListed {
        /// The set.
        set: String,
        /// The key.
        key: &'static str,
    },
    /// Two keys for one thing.
    #[error("set `{set}`: `{first}` and `{second}` say the same: keep one of them")]
    Twice {
        /// The set.
        set: String,
        /// One key.
        first: &'static str,
        /// The other.
        second: &'static str,
    },
    /// A set of a transmission without something its kind needs.
    #[error("set `{set}`: {missing} is missing")]
    Missing {
        /// The set.
        set: String,
        /// Missing key.
        missing: &'static str,
    },
    /// A member of a set in no link.
    #[error("set `{set}`: `{member}` is in no link")]
    MemberInNoLink {
        /// The set.
        set: String,
        /// The member.
        member: String,
    },
    /// A member in two links.
    #[error("`{member}` is in two links, `{first}` and `{second}`: make them one")]
    MemberInTwoLinks {
        /// The member.
        member: String,
        /// One link.
        first: String,
        /// The other.
        second: String,
    },
    /// Error of the gears of a set.
    #[error("set `{set}`: {source}")]
    Set {
        /// The set.
        set: String,
        /// The reason.
        source: epicyclic_gears::Error,
    },
    /// A size of a planet that the set has not.
    #[error("set `{set}`: no planet is called `{planet}`: `planet_sizes` has names of `planet_gears`")]
    NoSuchPlanet {
        /// The set.
        set: String,
        /// The name.
        planet: String,
    },
    /// A clutch with links and with a one-way sense, or with neither.
    #[error("clutch `{clutch}`: give either `links`, or `one_way` for a one-way clutch")]
    Clutch {
        /// The clutch.
        clutch: String,
    },
    /// Another number of values than a set has gears or meshes.
    #[error("set `{set}`: `{key}` has {given} values; {expected} are required: {of}")]
    Values {
        /// The set.
        set: String,
        /// The key.
        key: &'static str,
        /// Gears or meshes that the values belong to.
        of: String,
        /// How many are given.
        given: usize,
        /// How many are required.
        expected: usize,
    },
    /// A stated limit of a rule whose limit follows from the gearbox.
    #[error("`{rule}` cannot be stated: it follows from the gearbox, {limit}; leave it out")]
    OwnLimit {
        /// The rule.
        rule: &'static str,
        /// Limit of the rule in words.
        limit: &'static str,
    },
    /// A stated limit that is one number.
    #[error(
        "{value} allows this value alone; write `..{value}` for at most {value}, or `{value}..` for at least {value}"
    )]
    LimitOfOneValue {
        /// The rule.
        rule: &'static str,
        /// The number.
        value: f64,
    },
    /// A stated limit that no value can meet, or whose end no value can have.
    #[error("{stated}: {what} is {within}; write a range of such values, or leave an end open")]
    ImpossibleLimit {
        /// The range.
        stated: String,
        /// The quantity.
        what: &'static str,
        /// Values that it can have.
        within: String,
    },
    /// A spacing of planets that is stated twice.
    #[error(
        "set `{set}`: the spacing of the planets is stated twice; give one of `planet_angles` and `spacing` (`vibration.planet_angles` is read as `planet_angles`)"
    )]
    SpacingTwice {
        /// The set.
        set: String,
    },
}

impl DescriptionError {
    /// Name of the fault, which does not change with the message: `row-known-in-one-way`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Rack(source) => source.name(),
            Self::Set { source, .. } => source.name(),
            named => named.into(),
        }
    }

    /// Error of the gears of a set.
    pub(super) fn of_set(set: &str, source: epicyclic_gears::Error) -> Self {
        Self::Set { set: set.to_owned(), source }
    }
}

impl From<DescriptionError> for Problem {
    fn from(error: DescriptionError) -> Self {
        Self::refused(error.name(), error.to_string())
    }
}

/// Why the tools of a set cannot be.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ToolMisfit {
    /// Two keys for one thing.
    #[error("`{0}` and `{1}` say the same: keep one of them")]
    Twice(&'static str, &'static str),
    /// A key of hobs at a gear that another tool cuts.
    #[error("`{0}` is of a hob, and none cuts this gear: leave it out")]
    OfHob(&'static str),
    /// An invalid tool.
    #[error("{0}")]
    Invalid(#[from] epicyclic_gears::Error),
}

impl ToolMisfit {
    /// Keys that may hold what is wrong, below the tools of a gear or below the shaper of the strength.
    pub(super) fn keys(&self) -> Keys {
        let error = match self {
            Self::Invalid(error) => error,
            Self::OfHob("stock") => return &["stock"],
            Self::OfHob(_) => return &["protuberance"],
            Self::Twice(..) => return &[],
        };
        match error {
            Error::NoTeeth => &["shaper.teeth", "teeth"],
            Error::OutOfRange { quantity, .. }
            | Error::Negative { quantity, .. }
            | Error::NotPositive { quantity, .. } => match quantity {
                Quantity::RootFillet => &["profile", "fillet"],
                Quantity::Protuberance => &["protuberance"],
                Quantity::Stock => &["stock"],
                Quantity::ClearanceCoefficient => &["dedendum"],
                Quantity::FormFillet => &["form_fillet"],
                Quantity::ShaperTipRadius => &["shaper.tip_radius", "shaper", "fillet"],
                Quantity::ShaperShift => &["shaper.shift", "shaper", "shift"],
                Quantity::ShaperAddendum => &["shaper.addendum", "shaper", "addendum"],
                _ => &[],
            },
            _ => &[],
        }
    }
}
