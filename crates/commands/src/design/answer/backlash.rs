//! Backlash of the output: the allowances of the tooth thickness that keep an order's limit.
//!
//! All gears have the same allowances: from an upper one of half the lower one. The play of the output grows in
//! proportion to them, beyond what rounded shifts leave:
//!
//! ```text
//! φ = φ_0 + s·A        A = (φ_max − φ_0)/s, rounded down
//! ```
//!
//! The sheet of the gearbox gives `φ` with two allowances.

use super::making::MAKING;
use crate::answer::Warning;
use crate::error::Error;
use crate::shared::basis::BasisKey;
use crate::shared::gearbox::{Choice, one};
use crate::sheet::answer as sheet;
use crate::strength::answer::missing::mapping_at;
use epicyclic_formats::Document;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_formats::yaml::{Value, to_string};
use epicyclic_units::Physical;
use epicyclic_units::format::trimmed;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Angle;

/// Allowances in m with which the growth of the play is found; they are far larger than errors of rounding.
const TRIED: [f64; 2] = [100e-6, 200e-6];

/// Step of the allowances in µm.
const STEP_UM: f64 = 0.1;

/// Tolerance of the tooth thickness in m below which teeth are sorted or matched, by this program: the finest of
/// DIN 3967 is 3 to 6 µm up to 125 mm.
const FINEST: f64 = 5e-6;

/// Backlash of the output while the input is held.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OutputBacklash {
    /// Greatest backlash asked for, in rad.
    pub asked_rad: f64,
    /// Least and greatest backlash with the allowances, in rad.
    pub reached_rad: [f64; 2],
    /// Lower and upper allowance of the tooth thickness of all gears, in m.
    pub thickness_allowances_m: [f64; 2],
}

impl OutputBacklash {
    /// The file with the allowances of all gears that keep a backlash, and what it then is.
    ///
    /// # Errors
    /// Those of the reader.
    pub(super) fn of(file: &str, asked: Angle) -> Result<(String, Self), Error> {
        let play = |allowance: f64| -> Result<(String, [f64; 2]), Error> {
            let text = with_allowances(file, allowance)?;
            let document = Document::parse_one(MAKING, text.as_bytes())?;
            let subject = one(&document, &Choice::default())?;
            let play = sheet::at_output(&subject)?.first().and_then(|of| of.backlash_rad);
            Ok((text, play.map_or([0.0; 2], |play| [play.lower, play.upper])))
        };
        let [low, high] = TRIED;
        let [at_low, at_high] = [play(low)?.1[1], play(high)?.1[1]];
        let growth = (at_high - at_low) / (high - low);
        let allowance = (asked.si() - at_low) / growth + low;
        let allowance = ((1e6 * allowance / STEP_UM).floor() * STEP_UM / 1e6).max(0.0);
        let (text, reached_rad) = play(allowance)?;
        let thickness_allowances_m = [-allowance, -allowance / 2.0];
        Ok((text, Self { asked_rad: asked.si(), reached_rad, thickness_allowances_m }))
    }

    /// The allowances among the assumed values.
    pub(super) fn assumed(&self) -> BasisKey {
        BasisKey {
            key: "data_sheet.thickness_allowances".to_owned(),
            value: format!("{} of all gears", self.range()),
        }
    }

    fn range(&self) -> String {
        let [lower, upper] = self.thickness_allowances_m.map(|of| trimmed(1e6 * of, 4));
        format!("{lower} to {upper} µm")
    }

    /// A warning of a tolerance finer than teeth are usually made with, or of a backlash that no allowance keeps.
    pub(super) fn warning(&self) -> Option<Warning> {
        let [lower, upper] = self.thickness_allowances_m;
        (upper - lower < FINEST).then(|| Warning {
            name: "fine-backlash",
            message: format!(
                "the backlash asked for leaves allowances of {} of the tooth thickness, finer than the {} µm to which teeth are usually ground: \
                 sort the gears by thickness, or allow more --backlash",
                self.range(),
                trimmed(1e6 * FINEST, 3)
            ),
        })
    }
}

/// The file with the same allowances of all gears.
fn with_allowances(file: &str, allowance: f64) -> Result<String, Error> {
    let micrometres = |of: f64| Value::from(format!("{} µm", trimmed(1e6 * of, 6)));
    let limits = Value::Sequence([-allowance, -allowance / 2.0].map(micrometres).to_vec());
    let document = Document::parse_one(MAKING, file.as_bytes())?;
    let subject = one(&document, &Choice::default())?;
    let gearbox: GearboxFile = document.read()?;
    let mut value = document.value().clone();
    for data in subject.train.sets().iter().filter_map(|set| gearbox.set_data(set)) {
        let of_gears = data.gears.names.iter().map(|name| (Value::from(name.as_str()), limits.clone()));
        let keys = [(Value::from("thickness_allowances"), Value::Mapping(of_gears.collect()))];
        if let Some(set) = mapping_at(&mut value, &data.path) {
            set.insert("data_sheet".into(), Value::Mapping(keys.into_iter().collect()));
        }
    }
    let comments: String =
        file.lines().take_while(|line| line.starts_with('#')).map(|line| format!("{line}\n")).collect();
    Ok(comments + &to_string(&value).map_err(|error| Error::Json(error.to_string()))?)
}
