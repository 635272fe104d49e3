//! Errors of this crate.

use crate::arrangement::{Arrangement, ArrangementMode};
use crate::gear_kind::GearKind;
use crate::involute::check::Check;
use crate::involute::fault::{ShiftFault, ToolFault};
use crate::involute::left_out::LeftOut;
use crate::message::{shown, with_unit};
use crate::mode::{Member, Mode};
use crate::quantity::{Counted, Quantity, SimpleGear};
use crate::tolerance;

/// An input that describes no gear, or a requirement that no gear meets.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// A search that the caller cancelled.
    #[error("the search was cancelled")]
    Cancelled,
    /// A gear without teeth.
    #[error("a tooth count of 0: a gear has at least 1 tooth")]
    NoTeeth,
    /// A ring-to-sun ratio that no simple set has.
    #[error("ring-to-sun ratio k = {k}: k = z_b/z_a of a simple set is finite and greater than 1")]
    RingToSunRatio {
        /// The value given.
        k: f64,
    },
    /// A basic ratio that no gear set has.
    #[error("basic ratio {i0}: it is finite and not 0")]
    BasicRatio {
        /// The value given.
        i0: f64,
    },
    /// Input and output on one member.
    #[error("the {0} cannot be both input and output: name two different members")]
    SameMember(Member),
    /// A carrier speed or torque asked of a gear set whose central gears turn alike.
    #[error("basic ratio 1: the central gears always turn alike and say nothing of the carrier")]
    CarrierUndetermined,
    /// A number of known speeds other than two.
    #[error("{known} of the three speeds of a gear set are known: exactly 2 determine the third")]
    KnownSpeeds {
        /// How many were given.
        known: usize,
    },
    /// An efficiency outside its range.
    #[error("mesh efficiency {}: it lies above 0 and at or below 1{}", shown(*eta), in_percent(*eta))]
    Efficiency {
        /// The value given.
        eta: f64,
    },
    /// An efficiency so small that nothing can be computed with it.
    #[error("mesh efficiency {eta:e}: at least {least} and at most 1")]
    EfficiencyTooSmall {
        /// The value given.
        eta: f64,
        /// The least taken.
        least: f64,
    },
    /// A range of teeth that holds no gear.
    #[error("{gear} teeth from {from} to {to}: write the smaller first, and at most {most}")]
    ToothRange {
        /// The gear concerned.
        gear: SimpleGear,
        /// Lower end.
        from: u32,
        /// Upper end.
        to: u32,
        /// The greatest count allowed.
        most: u32,
    },
    /// A number of planets that the synthesis does not place.
    #[error("{}: from 2 to {most}, the smaller first", planets(*from, *to))]
    PlanetNumber {
        /// Lower end.
        from: u32,
        /// Upper end.
        to: u32,
        /// The greatest number allowed.
        most: u32,
    },
    /// A range of ring-to-sun ratios that holds no simple set.
    #[error("ring-to-sun ratio from {from} to {to}: above 1, finite, the smaller first")]
    RingToSunRange {
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// A tolerance that is no part of a ratio.
    #[error("tolerance {}: at least 0 and below 1, which is 100 %; 0.01 means one per cent", short(*tolerance))]
    Tolerance {
        /// The value given.
        tolerance: f64,
    },
    /// A ratio of speeds that no gear set has.
    #[error("ratio {ratio}: a ratio is finite and not 0, and not 1 where the carrier drives or is driven")]
    Ratio {
        /// The value given.
        ratio: f64,
    },
    /// A ratio that no set of tooth numbers within the bounds reaches.
    #[error(
        "no set of tooth numbers within the bounds has the ratio {} ({mode}) within {}%{}{}{}",
        short(*wanted),
        (tolerance * 1e8).round() / 1e6,
        left_out.as_ref().map(|left_out| format!("; of this ratio {left_out}")).unwrap_or_default(),
        nearest.map_or_else(|| if left_out.is_some() { String::new() } else { String::from("; none assembles at all: widen the bounds") },
            |ratio| if ratio * wanted < 0.0 {
                String::from("; this mode has the other sign: a negative ratio needs the carrier at rest (ab^H), a positive one the carrier turning (aH^b)")
            } else {
                format!("; the nearest is {ratio:.4}: widen the bounds or the tolerance")
            }),
        fewer_planets.map(|planets| format!("; with {planets} planets there are such sets: more stand too close or do not assemble")).unwrap_or_default()
    )]
    NoToothNumbers {
        /// Target ratio.
        wanted: f64,
        /// The mode of the gear set.
        mode: Mode,
        /// The relative tolerance.
        tolerance: f64,
        /// The nearest ratio within the bounds; `None` if they hold no set of tooth numbers.
        nearest: Option<f64>,
        /// The sets of this ratio that a check leaves out.
        left_out: Option<Box<LeftOut>>,
        /// The most planets, fewer than the bounds ask for, with which there are sets of this ratio.
        fewer_planets: Option<u32>,
    },
    /// A ratio that no double-planet set within the bounds reaches.
    #[error(
        "no double-planet set within the bounds has the ratio {} ({mode}) within {}%{}{}",
        short(*wanted),
        (tolerance * 1e8).round() / 1e6,
        left_out.as_ref().map(|left_out| format!("; of this ratio {left_out}")).unwrap_or_default(),
        nearest.map_or_else(|| if left_out.is_some() { String::new() } else { String::from("; none assembles at all: widen the bounds") },
            |ratio| if ratio * wanted < 0.0 {
                String::from("; this mode has the other sign: with the ring at rest (aH^b) the ratio is negative, with the carrier or the sun at rest (ab^H, bH^a) positive")
            } else {
                format!("; the nearest is {ratio:.4}: widen the bounds or the tolerance")
            })
    )]
    NoDoublePlanetSet {
        /// Target ratio.
        wanted: f64,
        /// The mode of the gear set.
        mode: Mode,
        /// The relative tolerance.
        tolerance: f64,
        /// The nearest ratio found; `None` if the bounds hold no set of tooth numbers.
        nearest: Option<f64>,
        /// The pairs of sun and ring of this ratio whose planets a check leaves out.
        left_out: Option<Box<LeftOut>>,
    },
    /// A ratio that no arrangement of gears within the bounds reaches.
    #[error(
        "no {arrangement} within the bounds has the ratio {} ({mode}) within {}%{}{}",
        short(*wanted),
        (tolerance * 1e8).round() / 1e6,
        left_out.as_ref().map(|left_out| format!("; of this ratio {left_out}")).unwrap_or_default(),
        nearest.map_or_else(
            || if left_out.is_some() { String::new() } else { String::from("; none has this sign, or none assembles: widen the bounds or choose another mode") },
            |ratio| format!("; the nearest is {ratio:.4}: widen the bounds or the tolerance")
        )
    )]
    NoArrangement {
        /// Arrangement of the gears.
        arrangement: Arrangement,
        /// Target ratio.
        wanted: f64,
        /// Mode of the arrangement.
        mode: ArrangementMode,
        /// Relative tolerance.
        tolerance: f64,
        /// Nearest ratio within the bounds; `None` where no set has this sign.
        nearest: Option<f64>,
        /// Sets of this ratio that a check leaves out.
        left_out: Option<Box<LeftOut>>,
    },
    /// Ratios of modules of an arrangement that has none.
    #[error("module ratio {ratio}, {arrangement}: {}", if arrangement.has_steps() { "must be above 0" } else { "its gears have one module, leave it at 1" })]
    ModuleRatio {
        /// Arrangement of the gears.
        arrangement: Arrangement,
        /// The ratio given.
        ratio: num_rational::Ratio<u32>,
    },
    /// Stated angles of planets that are too few or coincide.
    #[error("{given} angles of planets: give 2 or more finite angles, no two the same")]
    PlanetAngles {
        /// Number of angles given.
        given: usize,
    },
    /// A count below its least value.
    #[error("{count} {what}: at least {at_least} needed")]
    TooFew {
        /// The parts counted.
        what: Counted,
        /// The count given.
        count: u32,
        /// The least count allowed.
        at_least: u32,
    },

    /// A quantity that must be finite and above 0.
    #[error("{quantity} is {}; it must be finite and above 0", with_unit(*value, unit))]
    NotPositive {
        /// The quantity's name.
        quantity: Quantity,
        /// The value given, in `unit`.
        value: f64,
        /// Unit of `value`; empty for a plain number.
        unit: &'static str,
    },

    /// A quantity that must be finite and not below 0.
    #[error("{quantity} is {}; it must be finite and not below 0", with_unit(*value, unit))]
    Negative {
        /// The quantity's name.
        quantity: Quantity,
        /// The value given, in `unit`.
        value: f64,
        /// Unit of `value`; empty for a plain number.
        unit: &'static str,
    },

    /// A quantity outside the range that the other dimensions leave for it.
    #[error("{quantity} is {}; it must lie between {low} and {}", with_unit(*value, unit), with_unit(*high, unit))]
    OutOfRange {
        /// The quantity's name.
        quantity: Quantity,
        /// The value given, in `unit`.
        value: f64,
        /// Lower bound, in `unit`.
        low: f64,
        /// Upper bound, in `unit`.
        high: f64,
        /// Unit of the three numbers.
        unit: &'static str,
    },

    /// A quantity that must exceed another dimension.
    #[error("{quantity} is {}; it must be above {}", with_unit(*value, unit), with_unit(*low, unit))]
    NotAbove {
        /// The quantity's name.
        quantity: Quantity,
        /// The value given, in `unit`.
        value: f64,
        /// Value that it must exceed, in `unit`.
        low: f64,
        /// Unit of both numbers.
        unit: &'static str,
    },

    /// A gear with its teeth on the other side than the calculation is for.
    #[error("the gear is {given}; an {wanted} one is wanted")]
    WrongGearKind {
        /// Kind of the gear given.
        given: GearKind,
        /// The kind that the calculation is for.
        wanted: GearKind,
    },

    /// An external gear so small that its root circle vanishes.
    #[error("{teeth} teeth leave a root diameter of {} mm; at least {at_least} teeth needed", shown(*root_mm))]
    NoRoot {
        /// Teeth given.
        teeth: u32,
        /// The root diameter they would have, mm.
        root_mm: f64,
        /// The fewest teeth with a positive root diameter.
        at_least: u32,
    },

    /// An internal gear so small that its teeth meet on the axis.
    #[error("{teeth} internal teeth leave a tip diameter of {} mm; at least {at_least} teeth needed", shown(*tip_mm))]
    NoInternalTip {
        /// Teeth given.
        teeth: u32,
        /// The tip diameter they would have, mm.
        tip_mm: f64,
        /// The fewest teeth with a positive tip diameter.
        at_least: u32,
    },

    /// Two gears of different module cannot mesh.
    #[error("modules {} and {} mm differ; gears in mesh share one module", shown(*first_mm), shown(*second_mm))]
    ModulesDiffer {
        /// Module of the first gear, mm.
        first_mm: f64,
        /// Module of the second gear, mm.
        second_mm: f64,
    },

    /// Two gears of different pressure angle cannot mesh.
    #[error("pressure angles {}° and {}° differ; gears in mesh share one", shown(*first_deg), shown(*second_deg))]
    PressureAnglesDiffer {
        /// Pressure angle of the first gear, degrees.
        first_deg: f64,
        /// Pressure angle of the second gear, degrees.
        second_deg: f64,
    },

    /// Two gears of different helix angle cannot mesh.
    #[error("helix angles {}° and {}° differ; gears in mesh on parallel axes share one", shown(*first_deg), shown(*second_deg))]
    HelixAnglesDiffer {
        /// Helix angle of the first gear, degrees.
        first_deg: f64,
        /// Helix angle of the second gear, degrees.
        second_deg: f64,
    },

    /// A profile shift or tip alteration that leaves no tooth.
    #[error("{kind} gear of {teeth} teeth, profile shift x = {}, tip alteration k = {}: {}", shown(*shift), shown(*tip_alteration), shift_fault(*fault, *shift))]
    ShiftOutOfRange {
        /// Teeth of the gear.
        teeth: u32,
        /// External or internal.
        kind: GearKind,
        /// Profile shift of the gear, modules.
        shift: f64,
        /// Tip alteration of the gear, modules.
        tip_alteration: f64,
        /// The reason why no tooth is left.
        fault: ShiftFault,
    },

    /// A sum of profile shifts at which the flanks have no common working pressure angle.
    #[error(
        "sum of the profile shifts {}: the gears have no mesh without backlash; it must be {} {limit:.4}",
        shown(*sum), if *sum < *limit { "above" } else { "below" }
    )]
    ShiftSumOutOfRange {
        /// Sum of both shifts, modules.
        sum: f64,
        /// Limit that the sum must exceed; the sum of an internal pair must be below it.
        limit: f64,
    },

    /// A tool that does not cut its gear.
    #[error("{kind} gear of {teeth} teeth: {}", fault.map_or_else(|| "no tool cuts it".to_owned(), |fault| fault.to_string()))]
    Uncut {
        /// Teeth of the gear.
        teeth: u32,
        /// External or internal.
        kind: GearKind,
        /// The reason, if it is known.
        fault: Option<ToolFault>,
    },

    /// Teeth of a set for which no profile shifts keep the limits at a centre distance.
    #[error(
        "{sun}/{planet}/{ring} at a centre distance of {centre_distance:.4} modules: no profile shifts let the gears run together; {fault}"
    )]
    NoShifts {
        /// Teeth of the sun.
        sun: u32,
        /// Teeth of a planet.
        planet: u32,
        /// Teeth of the ring.
        ring: u32,
        /// Centre distance, modules.
        centre_distance: f64,
        /// The check that fails in the set nearest to the aim.
        fault: Check,
    },

    /// Offsets of the ring that hold none, or go too far.
    #[error("ring offsets from {from} to {to}: write the smaller first, from -{most} to {most}")]
    RingOffset {
        /// Lower end.
        from: i32,
        /// Upper end.
        to: i32,
        /// The largest taken.
        most: i32,
    },

    /// Limits of a deviation that are no numbers or in the wrong order.
    #[error("{quantity} from {} to {} modules: two finite numbers are needed, the smaller first", shown(*lower), shown(*upper))]
    Deviation {
        /// The deviating quantity.
        quantity: Quantity,
        /// Lower limit given, modules.
        lower: f64,
        /// Upper limit given, modules.
        upper: f64,
    },

    /// Two internal gears cannot mesh.
    #[error(
        "both gears are internal ({first} and {second} teeth); an internal gear meshes with an external one"
    )]
    BothInternal {
        /// Teeth of the first gear.
        first: u32,
        /// Teeth of the second gear.
        second: u32,
    },

    /// Gears whose meshes are no tree over all of them.
    #[error("{meshes} meshes do not join {gears} gears in a tree")]
    NotJoined {
        /// Number of gears.
        gears: usize,
        /// Number of meshes.
        meshes: usize,
    },

    /// An internal gear must have more teeth than the gear inside it.
    #[error(
        "internal gear has {internal} teeth and the gear inside it {external}; the internal one must have more"
    )]
    InternalNotLarger {
        /// Teeth of the internal gear.
        internal: u32,
        /// Teeth of the external gear.
        external: u32,
    },

    /// A shaft thicker than the largest diameter of the series.
    #[error("a shaft of {} mm is needed; the largest standard diameter listed is {largest_mm} mm", shown(*needed_mm))]
    NoStandardDiameter {
        /// Diameter that the formula requires, mm.
        needed_mm: f64,
        /// The largest listed, mm.
        largest_mm: f64,
    },

    /// A bearing designation that the table does not hold.
    #[error("no deep-groove ball bearing {designation}; {}", offer(.same_bore))]
    UnknownBearing {
        /// The designation given.
        designation: String,
        /// Designations in the table with the bore that the given one names; empty if it names no bore.
        same_bore: Vec<&'static str>,
    },

    /// A series without a bearing of this very bore.
    #[error("no bearing of series {series} with a bore of {bore_mm} mm; neighbouring bores are {}", list_mm(.neighbours_mm))]
    NoSuchBore {
        /// Series of the search: 200, 300 or 400.
        series: u16,
        /// Bore of the search, mm.
        bore_mm: f64,
        /// The next bores of the series below and above, mm.
        neighbours_mm: Vec<f64>,
    },

    /// A shaft thicker than every bore of a series.
    #[error(
        "no bearing of series {series} takes a shaft of {} mm; its largest bore is {largest_mm} mm",
        shown(*shaft_mm)
    )]
    NoBearingForShaft {
        /// Series of the search: 200, 300 or 400.
        series: u16,
        /// Shaft diameter, mm.
        shaft_mm: f64,
        /// Largest bore of the series, mm.
        largest_mm: f64,
    },
}

impl Error {
    /// Name of the fault, which does not change with the message: `no-teeth`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.into()
    }
}

fn shift_fault(fault: ShiftFault, shift: f64) -> String {
    match fault {
        ShiftFault::NotFinite => "a number is needed".to_owned(),
        ShiftFault::NoCircle => "no root or tip circle is left: take a shift nearer to 0".to_owned(),
        ShiftFault::NoTooth => "its tips lie at or below its roots: shorten them less".to_owned(),
        ShiftFault::Pointed { tip_thickness } => {
            // A smaller shift helps only where the shift itself has made the teeth pointed.
            let remedy =
                if shift > 0.0 { "take a smaller shift or a shorter tooth" } else { "take a shorter tooth" };
            format!(
                "its teeth are pointed before the tip circle (thickness {tip_thickness:.3} modules): {remedy}"
            )
        }
    }
}

/// A number with an exponent where its digits alone would fill a line.
fn short(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(tolerance::PLAIN..1e15).contains(&size) {
        format!("{value:e}")
    } else {
        value.to_string()
    }
}

fn planets(from: u32, to: u32) -> String {
    match (from, to) {
        (1, 1) => "1 planet".to_owned(),
        (from, to) if from == to => format!("{from} planets"),
        (from, to) => format!("{from} to {to} planets"),
    }
}

fn offer(same_bore: &[&str]) -> String {
    if same_bore.is_empty() {
        "listed are series 200, 300 and 400 with size codes 04 to 20, e.g. 310 (or 6310)".to_owned()
    } else {
        format!("for that bore there are {}", same_bore.join(", "))
    }
}

fn list_mm(values: &[f64]) -> String {
    values.iter().map(|&value| format!("{} mm", shown(value))).collect::<Vec<_>>().join(", ")
}

/// The percentage to write for a number that is most likely meant as one.
fn in_percent(eta: f64) -> String {
    if (50.0..=100.0).contains(&eta) { format!("; write {}%", shown(eta)) } else { String::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_name_the_value_and_what_is_allowed() {
        let error =
            Error::UnknownBearing { designation: "510".to_owned(), same_bore: vec!["210", "310", "410"] };
        assert_eq!(
            error.to_string(),
            "no deep-groove ball bearing 510; for that bore there are 210, 310, 410"
        );
        let error = Error::NoSuchBore { series: 300, bore_mm: 51.0, neighbours_mm: vec![50.0, 55.0] };
        assert_eq!(
            error.to_string(),
            "no bearing of series 300 with a bore of 51 mm; neighbouring bores are 50 mm, 55 mm"
        );
        let error = Error::Tolerance { tolerance: 1e308 };
        assert_eq!(
            error.to_string(),
            "tolerance 1e308: at least 0 and below 1, which is 100 %; 0.01 means one per cent"
        );
        let error =
            Error::OutOfRange { quantity: Quantity::Bore, value: 9.0, low: 0.0, high: 8.0, unit: "mm" };
        assert_eq!(error.to_string(), "bore is 9 mm; it must lie between 0 and 8 mm");
    }
}
