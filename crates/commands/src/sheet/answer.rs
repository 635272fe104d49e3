//! Data sheets of the gears of simple sets: circles, tooth thickness, measures, meshes.
//!
//! | module | is |
//! |---|---|
//! | [`records`] | gears, meshes, sets |
//! | `output` | backlash and torsional stiffness at the output, gear by gear |
//!
//! Names and signs are those of ISO 21771; all figures come from [`epicyclic_gears::involute`]. Diameters and
//! centre distances of internal gears are positive. Root and form circles are those that a rack leaves.

mod output;
pub mod records;

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::fault::{Fault, Named};
use crate::shared::gearbox::Gearbox;
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::shared::toothed::{gears, lacking, missing_teeth, simple_sets};
use crate::strength::answer::place::refused;
use epicyclic_formats::gearbox::{DataSheetEntry, GearboxFile, SetEntry};
use epicyclic_formats::{Document, Path};
use epicyclic_gears::involute::PlanetSet as ToothedSet;
use epicyclic_gears::involute::play::Deviation;
use epicyclic_gears::{Error as GearError, Quantity};
use epicyclic_units::Physical;
use epicyclic_units::format::significant;
use output::Known;
use records::{Allowed, AtOutput, LeftOut, Limits, SetSheet};
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Length;

/// Data sheets of the gears of a gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DataSheets {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Sets, each with its gears and meshes.
    pub sets: Vec<SetSheet>,
    /// Backlash and torsional stiffness at the output in each gear; empty if one set is asked for.
    pub at_output: Vec<AtOutput>,
    /// Sets without data sheets.
    pub left_out: Vec<LeftOut>,
    /// Tooth checks of these sets.
    pub tooth_checks: ToothChecks,
    /// Warnings about the data sheets.
    pub warnings: Vec<Warning>,
}

impl Answer for DataSheets {
    const NAME: &'static str = "sheet";
}

/// Computes the data sheets of all sets, or of one.
///
/// # Errors
/// - [`Error::NoSet`]; [`Error::NothingDescribed`] if no set has enough data.
/// - [`Error::Document`] for invalid data in the file, with the place.
pub(crate) fn answer(subject: &Gearbox, set: Option<&str>) -> Result<DataSheets, Error> {
    let sheets = described(subject, set)?;
    if sheets.sets.is_empty() {
        let why = |one: &LeftOut| format!("set {}: {}", one.set, one.why());
        return Err(Error::NothingDescribed { sets: sheets.left_out.iter().map(why).collect() });
    }
    Ok(sheets)
}

/// Data sheets for a report; `None` if the file has enough data for no set.
///
/// # Errors
/// [`Error::Document`] for invalid data in the file, with the place.
pub(crate) fn chapter(subject: &Gearbox) -> Result<Option<DataSheets>, Error> {
    if subject.document.value().get("transmissions").is_some() {
        return Ok(None);
    }
    Ok(Some(described(subject, None)?).filter(|sheets| !sheets.sets.is_empty()))
}

fn described(subject: &Gearbox, wanted: Option<&str>) -> Result<DataSheets, Error> {
    let file: GearboxFile = subject.document.read()?;
    subject.check_set(wanted)?;
    let is_wanted = |id: &str| wanted.is_none_or(|wanted| wanted == id);
    let (mut sets, mut left_out, mut known) = (vec![], vec![], vec![]);
    for (in_gearbox, (set, simple)) in simple_sets(subject, &file).enumerate() {
        if !is_wanted(set.id()) {
            continue;
        }
        let Some((path, entry, spec)) = simple else {
            left_out.push(LeftOut { set: set.id().to_owned(), missing: vec![] });
            continue;
        };
        let toothed = gears(subject, &path, spec)?;
        let place = Place { document: &subject.document, path };
        match (toothed, entry.module) {
            (Some(toothed), Some(module)) => {
                let (sheet, allowed) = sheet(&place, entry, &toothed, module.0)?;
                sets.push(sheet);
                let face_width = entry.face_width.filter(|_| entry.planets.is_some()).map(|width| width.0);
                known.push(Known { place: in_gearbox, set: toothed, module: module.0, face_width, allowed });
            }
            (toothed, module) => {
                let missing =
                    lacking(&[(missing_teeth(entry), toothed.is_some()), ("module", module.is_some())]);
                left_out.push(LeftOut { set: set.id().to_owned(), missing });
            }
        }
    }
    let tooth_checks =
        ToothChecks::of(subject.tooth_checks(), |of| sets.iter().any(|set: &SetSheet| set.set == of));
    let warnings = tooth_checks.warnings().collect();
    let at_output =
        if wanted.is_none() && !sets.is_empty() { output::of_gears(subject, &known)? } else { vec![] };
    Ok(DataSheets {
        gearbox: subject.train.name().to_owned(),
        sets,
        at_output,
        left_out,
        tooth_checks,
        warnings,
    })
}

/// Place of a set in a file.
struct Place<'a> {
    document: &'a Document,
    path: Path,
}

impl Place<'_> {
    /// Error at the longest part of a path that exists in the file.
    fn refused(&self, keys: &[&str], why: &dyn Fault) -> Error {
        refused(self.document, &self.path, keys, why)
    }
}

fn sheet(
    place: &Place<'_>,
    entry: &SetEntry,
    set: &ToothedSet,
    module: Length,
) -> Result<(SetSheet, Option<Allowed>), Error> {
    let module_m = module.si();
    if !(module_m.is_finite() && module_m > 0.0) {
        return Err(place.refused(&["module"], &Named("not-positive", "the module must be above 0")));
    }
    let of = entry.data_sheet.as_ref();
    let balls = balls(place, of, set, module_m)?;
    let deviation = |[lower, upper]: [f64; 2]| Deviation { lower: lower / module_m, upper: upper / module_m };
    let allowances = of.and_then(|of| of.thickness_allowances);
    let allowances = allowances.map(|all| all.map(|limits| limits.map(|limit| limit.0.si())));
    let centre = of.and_then(|of| of.centre_distance_deviations).map(|all| all.map(|limit| limit.0.si()));
    let allowed = match (allowances, centre) {
        (None, None) => None,
        _ => Some(Allowed {
            thickness: allowances.unwrap_or_default().map(deviation),
            centre_distance: centre.map(deviation).unwrap_or_default(),
        }),
    };
    let fault = |error: GearError| {
        let key = match error {
            GearError::NotAbove { .. }
            | GearError::Deviation { quantity: Quantity::CentreDistanceDeviation, .. } => {
                "centre_distance_deviations"
            }
            _ => "thickness_allowances",
        };
        place.refused(&["data_sheet", key], &error)
    };
    let sheet = SetSheet::of(entry, set, module_m, balls, allowed.as_ref()).map_err(fault)?;
    let sheet = SetSheet {
        thickness_allowances_m: allowances.map(|all| all.map(Limits::of).to_vec()),
        centre_distance_deviations_m: centre.map(Limits::of),
        ..sheet
    };
    Ok((sheet, allowed))
}

/// Diameters of measuring balls in metres.
fn balls(
    place: &Place<'_>,
    of: Option<&DataSheetEntry>,
    set: &ToothedSet,
    module_m: f64,
) -> Result<[f64; 3], Error> {
    let Some(given) = of.and_then(|of| of.ball_diameters) else {
        return Ok(set.gears().map(|gear| rounded_up(gear.ball_diameter() * module_m)));
    };
    let given = given.map(|diameter| diameter.0.si());
    let refused = |why: Named<String>| Err(place.refused(&["data_sheet", "ball_diameters"], &why));
    for ((ball, gear), name) in given.into_iter().zip(set.gears()).zip(["sun", "planet", "ring"]) {
        if !(ball.is_finite() && ball > 0.0) {
            return refused(Named("not-positive", "diameters of balls must be above 0".to_owned()));
        }
        let [least, most] = gear.ball_diameters().map(|diameter| diameter * module_m);
        if !(least..=most).contains(&ball) {
            let [ball, least, most] = [ball, least, most].map(|size| significant(1e3 * size, 5));
            let message = format!(
                "a ball of {ball} mm touches no flank of the {name}: from the form circle to the tip circle balls of {least} to {most} mm do"
            );
            return refused(Named("ball", message));
        }
    }
    Ok(given)
}

/// Rounds a size up to two digits.
fn rounded_up(size: f64) -> f64 {
    let unit = libm::pow(10_f64, libm::log10(size).floor() - 1.0);
    // The tolerance keeps a size of two digits that division leaves slightly too large.
    (size / unit - crate::tolerance::SAME).ceil() * unit
}

#[cfg(test)]
mod tests {
    use super::rounded_up;

    #[test]
    fn sizes_are_rounded_up_to_two_digits() {
        for (size, rounded) in [(0.0411, 0.042), (0.042, 0.042), (0.00201, 0.0021), (0.0999, 0.1), (0.5, 0.5)]
        {
            assert!((rounded_up(size) - rounded).abs() < 1e-15, "{size}: {}", rounded_up(size));
        }
    }
}
