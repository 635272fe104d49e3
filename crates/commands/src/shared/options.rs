//! Options that errors of shared calculations refer to.

use crate::failure::Failure;
use epicyclic_formats::Span;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::mesh::USUAL_PLANET_GAP;
use epicyclic_gears::quantity::SimpleGear;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_gears::{Error, Quantity};
use epicyclic_units::Quantity as Given;
use std::ops::RangeInclusive;
use uom::si::f64::Ratio;

/// The option that a search for tooth numbers refuses; the number of planets has its own name in each
/// command.
pub(crate) fn of_teeth(error: &Error, planets: &'static str) -> Option<&'static str> {
    Some(match error {
        Error::PlanetNumber { .. } => planets,
        Error::RingToSunRange { .. } => "--k",
        Error::Tolerance { .. } => "--tolerance",
        Error::Ratio { .. } => "--ratio",
        Error::ToothRange { gear: SimpleGear::Sun, .. } => "--sun",
        Error::ToothRange { gear: SimpleGear::Planet, .. } => "--planet",
        Error::ToothRange { gear: SimpleGear::Ring, .. } => "--ring",
        Error::PlanetAngles { .. } => "--angles",
        Error::ModuleRatio { .. } => "--module-ratio",
        Error::RingOffset { .. } => "--ring-offset",
        Error::Negative { quantity: Quantity::TipThickness, .. } => "--tip-thickness",
        Error::Negative { quantity: Quantity::TipGap, .. } => "--tip-gap",
        Error::Negative { quantity: Quantity::AddendumCoefficient, .. } => "--addendum",
        Error::OutOfRange { quantity: Quantity::PressureAngle, .. } => "--pressure-angle",
        _ => return None,
    })
}

/// Converts an error of the synthesis to a failure with the option that caused it.
pub(crate) fn of_synthesis(error: crate::error::Error) -> Failure {
    match error {
        crate::error::Error::Synthesis(epicyclic_synthesis::Error::Teeth(error)) => {
            let option = of_teeth(&error, "--planet-count").unwrap_or("--teeth");
            Failure::of_option(option, &error)
        }
        error @ crate::error::Error::Synthesis(
            epicyclic_synthesis::Error::Contradiction { .. } | epicyclic_synthesis::Error::Solver(_),
        ) => error.into(),
        crate::error::Error::Synthesis(error) => {
            let option = match error {
                epicyclic_synthesis::Error::Steps { .. } => "--step",
                epicyclic_synthesis::Error::RisingSteps { .. } => "--falling-steps",
                _ => "--ratios",
            };
            Failure::of_option(option, &error)
        }
        error => error.into(),
    }
}

/// Bounds of the teeth of gearboxes that are proposed, by --sun, --planet and --ring: planets keep the usual
/// gap.
pub(crate) fn proposed([sun, planet, ring]: [Span<u32>; 3]) -> Result<Bounds, Failure> {
    let usual = Bounds { tip_gap: USUAL_PLANET_GAP, ..Bounds::default() };
    Ok(Bounds {
        sun: of_wheel("--sun", sun, usual.sun)?,
        planet: of_wheel("--planet", planet, usual.planet)?,
        ring: of_wheel("--ring", ring, usual.ring)?,
        ..usual
    })
}

/// A range of tooth numbers, its open ends closed as usual; a wheel has at least one tooth.
pub(crate) fn of_wheel(
    option: &'static str,
    span: Span<u32>,
    usual: RangeInclusive<u32>,
) -> Result<RangeInclusive<u32>, Failure> {
    let range = span.closed(usual).map_err(|error| Failure::Range { option, error })?;
    if *range.start() == 0 {
        let message = format!("{span}: a wheel has at least 1 tooth");
        return Err(Failure::invalid(option, message));
    }
    Ok(range)
}

/// The efficiency of a set that `--efficiency` gives.
pub(crate) fn efficiency(eta: Given<Ratio>) -> Result<MeshEfficiency, Failure> {
    MeshEfficiency::new(eta.0.value).map_err(|error| Failure::of_option("--efficiency", &error))
}
