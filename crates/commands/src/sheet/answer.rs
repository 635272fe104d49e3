//! Data sheets of the gears of sets: circles, tooth thickness, measures, meshes.
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
use crate::shared::basis::Basis;
use crate::shared::fault::{Fault, Named, refused};
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::shared::toothed::{lacking, toothed};
use crate::strength::answer::missing::{MissingKeys, Purpose};
use crate::strength::answer::names::MeshName;
use epicyclic_formats::Document;
use epicyclic_formats::gearbox::{GearboxFile, SetData};
use epicyclic_gears::involute::play::Deviation;
use epicyclic_gears::{Error as GearError, Quantity};
use epicyclic_train::PlanetSet;
use epicyclic_train::toothed::{ToothedMesh, ToothedSet};
use epicyclic_units::Dimension::Length;
use epicyclic_units::Physical;
use epicyclic_units::format::{in_unit, significant};
use output::Known;
use records::{Allowed, AtOutput, GearSheet, LeftOut, Limits, MeshSheet, SetSheet, Toothed, same};
use schemars::JsonSchema;
use serde::Serialize;

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
    /// Judgement of the gearbox, or of the one set, by rules of practice.
    pub judgement: Judgement,
    /// Warnings about the data sheets.
    pub warnings: Vec<Warning>,
}

impl Answer for DataSheets {
    const NAME: &'static str = "sheet";
}

/// Computes the data sheets of all sets, or of one.
///
/// # Errors
/// - [`Error::NoSet`]; [`Error::MissingKeys`] or [`Error::NothingDescribed`] if no set has enough data.
/// - [`Error::Document`] for invalid data in the file, with the place.
pub(crate) fn answer(subject: &Gearbox, set: Option<&str>) -> Result<DataSheets, Error> {
    let sheets = described(subject, set)?;
    if sheets.sets.is_empty() {
        let file: GearboxFile = subject.document.read()?;
        let missing = MissingKeys::of(subject, &file, &Basis::default(), Purpose::Sheets)?;
        if let Some(refused) = missing.refused_of(set) {
            return Err(refused);
        }
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

/// Backlash and stiffness at the output in each gear; none where no set can be described.
///
/// # Errors
/// As of [`chapter`].
pub(crate) fn at_output(subject: &Gearbox) -> Result<Vec<AtOutput>, Error> {
    Ok(chapter(subject)?.map(|sheets| sheets.at_output).unwrap_or_default())
}

fn described(subject: &Gearbox, wanted: Option<&str>) -> Result<DataSheets, Error> {
    let file: GearboxFile = subject.document.read()?;
    subject.check_set(wanted)?;
    let is_wanted = |id: &str| wanted.is_none_or(|wanted| wanted == id);
    let (mut sets, mut left_out, mut known, mut unstated) = (vec![], vec![], vec![], vec![]);
    for (place, set) in subject.train.sets().iter().enumerate().filter(|(_, set)| is_wanted(set.id())) {
        let Some(data) = file.set_data(set) else { continue };
        let toothed = toothed(subject, &data, set)?;
        let has_module = data.modules.iter().any(Option::is_some);
        match toothed {
            Ok(toothed) if has_module => {
                let (sheet, allowed) =
                    Of { document: &subject.document, set, data: &data, toothed: &toothed }.sheet()?;
                unstated.extend(assumed_allowances(set.id(), &data));
                sets.push(sheet);
                let gears =
                    toothed.meshes.iter().map(|mesh| mesh.gears.map(|gear| data.place(gear))).collect();
                let face_widths = toothed.meshes.iter().map(|mesh| data.common_width(mesh.gears)).collect();
                known.push(Known { place, set, toothed, gears, face_widths, allowed });
            }
            Err(None) => left_out.push(LeftOut { set: set.id().to_owned(), missing: vec![] }),
            toothed => {
                let key = toothed.as_ref().err().copied().flatten().unwrap_or_default();
                let missing = lacking(&[(key, toothed.is_ok()), ("module", has_module)]);
                left_out.push(LeftOut { set: set.id().to_owned(), missing });
            }
        }
    }
    let tooth_checks =
        ToothChecks::of(subject.tooth_checks(), |of| sets.iter().any(|set: &SetSheet| set.set == of));
    let of_sets = sets.iter().flat_map(SetSheet::warnings);
    let judgement = Judgement::of(subject, wanted, None, None);
    let judged = judgement.warnings(&[]);
    let warnings = tooth_checks.warnings().chain(of_sets).chain(unstated).chain(judged).collect();
    let at_output =
        if wanted.is_none() && !sets.is_empty() { output::of_gears(subject, &known)? } else { vec![] };
    Ok(DataSheets {
        gearbox: subject.train.name().to_owned(),
        sets,
        at_output,
        left_out,
        judgement,
        warnings,
    })
}

/// Warns of gears without allowances in a set where others have some: their limits are those of 0.
fn assumed_allowances(set: &str, data: &SetData<'_>) -> Option<Warning> {
    let given = data.of_gears(data.data_sheet?.thickness_allowances.as_ref()?);
    let unstated = data.gears.names.iter().zip(&given).filter(|(_, own)| own.is_none());
    let unstated: Vec<&str> = unstated.map(|(name, _)| name.as_str()).collect();
    (!unstated.is_empty()).then(|| Warning {
        name: "allowances-assumed",
        message: format!(
            "set `{}`: `thickness_allowances` has nothing of {}; both limits are taken as 0: state them, `[0 um, 0 um]` if they are 0",
            set,
            unstated.join(" and "),
        ),
    })
}

/// A set of the file with its gears in mesh.
struct Of<'a> {
    document: &'a Document,
    set: &'a PlanetSet,
    data: &'a SetData<'a>,
    toothed: &'a ToothedSet,
}

impl<'a> Of<'a> {
    fn sheet(&self) -> Result<(SetSheet, Option<Allowed>), Error> {
        for mesh in &self.toothed.meshes {
            if !(mesh.module.is_finite() && mesh.module > 0.0) {
                return Err(self.refused(&["module"], &Named("not-positive", "the module must be above 0")));
            }
        }
        let of = self.data.data_sheet;
        let gears: Vec<Toothed<'_>> =
            self.data.of.iter().filter_map(|gear| Toothed::of(self.set, self.toothed, *gear)).collect();
        let balls = self.balls(&gears)?;
        let allowances = of.and_then(|of| of.thickness_allowances.as_ref());
        let allowances = allowances.map(|given| self.data.of_gears(given));
        let allowances: Option<Vec<[f64; 2]>> = allowances.map(|all| {
            all.into_iter()
                .map(|own| own.map_or([0.0; 2], |limits| limits.map(|limit| limit.0.si())))
                .collect()
        });
        let centre = of.and_then(|of| of.centre_distance_deviations).map(|all| all.map(|limit| limit.0.si()));
        let deviation = |[lower, upper]: [f64; 2], module_m: f64| Deviation {
            lower: lower / module_m,
            upper: upper / module_m,
        };
        let allowed = (allowances.is_some() || centre.is_some()).then(|| Allowed {
            thickness: gears
                .iter()
                .enumerate()
                .map(|(place, gear)| {
                    let own = allowances.as_ref().map_or([0.0; 2], |all| all[place]);
                    deviation(own, gear.module_m)
                })
                .collect(),
            centre_distance_m: centre.unwrap_or_default(),
        });
        let fault = |(error, module_m): (GearError, f64)| {
            let key = match error {
                GearError::NotAbove { .. }
                | GearError::Deviation { quantity: Quantity::CentreDistanceDeviation, .. } => {
                    "centre_distance_deviations"
                }
                _ => "thickness_allowances",
            };
            let name = error.name();
            self.refused(&["data_sheet", key], &Named(name, in_millimetres(error, module_m)))
        };
        let materials = self.data.strength.map(|strength| self.data.of_gears(&strength.materials));
        let material = |place: usize| materials.as_ref().and_then(|all| all[place].cloned());
        let sheets = gears.iter().zip(&balls).enumerate().map(|(place, (gear, ball))| {
            let allowance = allowed.as_ref().map(|allowed| allowed.thickness[place]);
            let sheet = GearSheet::of(gear, *ball, allowance).map_err(|error| (error, gear.module_m))?;
            let face_width_m = self.data.face_widths[place].map(Physical::si);
            Ok(GearSheet { face_width_m, material: material(place), ..sheet })
        });
        let mesh = |mesh: &ToothedMesh| {
            let width = self.data.common_width(mesh.gears).map(Physical::si);
            let places = mesh.gears.map(|gear| self.data.place(gear));
            let allowed = allowed.as_ref().map(|allowed| {
                (
                    places.map(|place| allowed.thickness[place]),
                    deviation(allowed.centre_distance_m, mesh.module),
                )
            });
            let sheet = MeshSheet::of(MeshName::of(self.set, mesh.gears), mesh, width, allowed);
            sheet.map_err(|error| (error, mesh.module))
        };
        let meshes = self.toothed.meshes.iter().map(mesh);
        let sheet = SetSheet {
            planets: self.set.planet_count(),
            face_width_m: same(self.data.face_widths.iter().map(|width| width.map(Physical::si))),
            centre_distance_deviations_m: centre.map(Limits::of),
            thickness_allowances_m: allowances.map(|all| all.into_iter().map(Limits::of).collect()),
            ..SetSheet::of(
                self.set.id(),
                sheets.collect::<Result<_, _>>().map_err(fault)?,
                meshes.collect::<Result<_, _>>().map_err(fault)?,
                self.toothed,
            )
        };
        Ok((sheet, allowed))
    }

    /// Diameters of measuring balls in metres.
    fn balls(&self, gears: &[Toothed<'_>]) -> Result<Vec<f64>, Error> {
        let given = self.data.data_sheet.and_then(|of| of.ball_diameters.as_ref());
        let given = given.map(|given| self.data.of_gears(given));
        let refused = |why: Named<String>| Err(self.refused(&["data_sheet", "ball_diameters"], &why));
        let mut balls = vec![];
        for (place, Toothed { gear, module_m, name, .. }) in gears.iter().enumerate() {
            let Some(ball) = given.as_ref().and_then(|all| all[place]) else {
                balls.push(rounded_up(gear.ball_diameter() * module_m));
                continue;
            };
            let ball = ball.0.si();
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
            balls.push(ball);
        }
        Ok(balls)
    }

    /// Error at the longest part of a path that exists in the file.
    fn refused(&self, keys: &[&str], why: &dyn Fault) -> Error {
        refused(self.document, &self.data.path, keys, why)
    }
}

/// Message of an error with lengths in the unit of files, since gears have them in modules.
fn in_millimetres(error: GearError, module_m: f64) -> String {
    let mm = |modules: f64| in_unit(modules * module_m, Length.usual_unit(), 6);
    match error {
        GearError::Deviation { quantity, lower, upper } => format!(
            "{quantity} from {} to {}: two finite numbers are needed, the smaller first",
            mm(lower),
            mm(upper)
        ),
        GearError::NotAbove { quantity, value, low, unit: "modules" } => {
            format!("{quantity} is {}; it must be above {}", mm(value), mm(low))
        }
        error => error.to_string(),
    }
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
