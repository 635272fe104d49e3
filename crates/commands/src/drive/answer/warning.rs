//! Warnings of a drive in words.

use crate::answer::Warning;
use epicyclic_dynamics::drive::{BoredGear, DriveDesign, Shaft, Start, Warning as Finding};
use epicyclic_units::Physical as _;
use epicyclic_units::format::trimmed;

/// Lists all warnings of a design.
pub(super) fn all(design: &DriveDesign) -> Vec<Warning> {
    let of_design =
        design.warnings.iter().map(|finding| Warning { name: finding.name(), message: message(finding) });
    of_design.chain(start(design)).collect()
}

/// Warning about the start. Balance needs none: any drive whose load is its nominal one is in balance, and
/// the outcome reports it.
fn start(design: &DriveDesign) -> Option<Warning> {
    let [least, greatest] = design.with_losses.held.map(|load| trimmed(load.si(), 5));
    match design.with_losses.start {
        Start::After(_) | Start::InBalance => None,
        Start::Held => Some(Warning {
            name: "no-start",
            message: format!(
                "it does not start: with this driving torque the friction of the meshes holds loads from {least} to \
                 {greatest} N·m; the drive starts forward below them and runs backward above"
            ),
        }),
        Start::Backward(_) => Some(Warning {
            name: "runs-backward",
            message: format!(
                "the load turns the drive backward: with this driving torque the friction of the meshes holds no more \
                 than {greatest} N·m; it starts forward below {least} N·m"
            ),
        }),
    }
}

const fn shaft(shaft: Shaft) -> &'static str {
    match shaft {
        Shaft::Sun => "sun's shaft",
        Shaft::Planet => "planet pin",
        Shaft::Carrier => "carrier's shaft",
    }
}

const fn part(of: Shaft) -> &'static str {
    match of {
        Shaft::Sun => "sun",
        Shaft::Planet => "planet",
        Shaft::Carrier => "carrier",
    }
}

const fn gear(gear: BoredGear) -> &'static str {
    match gear {
        BoredGear::Sun => "sun",
        BoredGear::Planet => "planet",
    }
}

fn message(finding: &Finding) -> String {
    match *finding {
        Finding::ShaftTooThin { shaft: which, diameter_mm, needed_mm, stress_mpa, allowable_mpa } => format!(
            "the {} of {diameter_mm:.1} mm is too thin: {stress_mpa:.1} MPa where {allowable_mpa:.1} MPa are allowed; \
             at least {needed_mm:.1} mm needed",
            shaft(which)
        ),
        Finding::BearingTooNarrow { shaft: which, bearing, bore_mm, diameter_mm } => format!(
            "bearing {bearing} with its bore of {bore_mm:.0} mm does not go on the {} of {diameter_mm:.1} mm",
            shaft(which)
        ),
        Finding::NoBearing { shaft: which, series, diameter_mm } => {
            format!("no bearing of series {series} goes on the {} of {diameter_mm:.1} mm", shaft(which))
        }
        Finding::UnverifiedBearing { shaft: which, bearing } => format!(
            "bearing {bearing} of the {} was not found in a catalogue: check its dimensions",
            shaft(which)
        ),
        Finding::StressOutsideUsualRange { allowable_mpa } => {
            format!("an allowable stress of {allowable_mpa:.1} MPa is outside the usual 15 to 20 MPa")
        }
        Finding::Undercut { gear: which, teeth, at_least } => {
            format!("the {} with {teeth} teeth is undercut; {at_least} teeth are not", gear(which))
        }
        Finding::NoPlanetClearance { planets, gap_mm, most_planets } => format!(
            "{planets} planets do not clear each other: their tips overlap by {:.2} mm; at most {most_planets} do",
            -gap_mm
        ),
        Finding::TipGapBelowWanted { gap_mm, wanted_mm } => format!(
            "the tips of adjacent planets clear each other by {gap_mm:.2} mm; {wanted_mm:.2} mm are wanted"
        ),
        Finding::UnequalSpacing { planets, slots, deviation_deg } => format!(
            "{planets} planets do not assemble at equal angles (z_a + z_b = {slots} is no multiple); the least unequal \
             spacing departs by {deviation_deg:.3}°"
        ),
        Finding::RatioDeparts { wanted, ratio, tolerance } => format!(
            "the given teeth have the ratio {ratio:.4}, {:+.2} % off the wanted {wanted}; the tolerance is {:.2} %",
            100.0 * (ratio / wanted - 1.0),
            100.0 * tolerance
        ),
        Finding::RatioOutsideUsualRange { ratio } => {
            format!("a ratio of {ratio:.4} is outside the usual 3 to 10 of a single stage")
        }
        Finding::PlanetPinOffCentre { hole_mm, centre_distance_mm } => format!(
            "the carrier's holes stand at a radius of {hole_mm:.2} mm, the planets at {centre_distance_mm:.2} mm"
        ),
        Finding::PlanetBearingTooLarge { bearing, outside_mm, pin_mm, root_mm } => format!(
            "bearing {bearing} on the planet pin of {pin_mm:.1} mm has an outside diameter of {outside_mm:.1} mm and does not go into the \
             planet, whose root circle is {root_mm:.1} mm: the planet was taken as solid; give shafts.planet.diameter by the bending of \
             the pin, or gear_set.planet_bore"
        ),
        Finding::PlanetBoreTooNarrow { bore_mm, pin_mm, bearing } => {
            let goes_in = bearing.map_or_else(
                || format!("planet pin of {pin_mm:.1} mm"),
                |(name, outside_mm)| {
                    format!("bearing {name} ({outside_mm:.1} mm) on the planet pin of {pin_mm:.1} mm")
                },
            );
            format!(
                "the planet's bore of {bore_mm:.1} mm is narrower than the {goes_in}: give shafts.planet.diameter and \
                 shafts.planet.bearing that go in, or a wider gear_set.planet_bore"
            )
        }
        Finding::PartUnlikeShape { part: which, is_inertia, given, of_shape } => {
            let (quantity, unit) = if is_inertia { ("inertia", "kg·m²") } else { ("mass", "kg") };
            let times = given / of_shape;
            format!(
                "the {quantity} of the {}, {} {unit}, is {} times that of its shape, {} {unit}: check its digits and unit, or \
                 the shape",
                part(which),
                trimmed(given, 5),
                trimmed(times, 3),
                trimmed(of_shape, 5)
            )
        }
        Finding::CarrierNeglected => {
            "the carrier was taken as massless: give its shape or its inertia".to_owned()
        }
        // A finding without a text here is shown by its name.
        ref other => other.name().replace('-', " "),
    }
}
