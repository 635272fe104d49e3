//! The options of searches for tooth numbers with profile shift.

use crate::failure::Failure;
use crate::shared::options::of_teeth;
use epicyclic_gears::involute::Profile;
use epicyclic_gears::involute::closing::Closing;
use epicyclic_gears::involute::family::Aim;
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::involute::set::Limits;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_units::Number;
use std::ops::RangeInclusive;

/// Sets with profile shift.
#[derive(Debug, Clone, clap::Args)]
pub struct ShiftOptions {
    /// Simple sets with profile shift: teeth of the ring less those of the sun and twice those of a planet, a
    /// range from -9 to 9. Without it sets have no profile shift.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, value_parser = offsets)]
    pub ring_offset: Option<RangeInclusive<i32>>,

    /// With --ring-offset: what picks the shifts, of which the sums are fixed.
    #[arg(long, value_enum, requires = "ring_offset", default_value_t = Aim::BalancedSliding)]
    pub aim: Aim,

    /// With --ring-offset: least thickness of the tips, in modules; 0.4 is usual of case-hardened teeth.
    #[arg(
        long,
        value_name = "MODULES",
        requires = "ring_offset",
        default_value = "0.2",
        allow_hyphen_values = true
    )]
    pub tip_thickness: Number,
}

/// Requirements of the profile shifts.
#[derive(Debug, Clone, PartialEq)]
pub struct WantedShifts {
    /// Ring offsets, `z_r − z_s − 2·z_p`.
    pub offsets: RangeInclusive<i32>,
    /// Aim of the profile shifts.
    pub aim: Aim,
    /// Minimum normal tip thickness, in modules.
    pub tip_thickness: f64,
}

impl WantedShifts {
    /// Profile shift for these bounds, with their rack and their gap between planets.
    #[must_use]
    pub fn within(&self, bounds: &Bounds) -> ProfileShift {
        let limits = self.limits(bounds);
        let closing = Closing {
            profiles: Profile::of_rack(bounds.rack).into(),
            aim: self.aim,
            limits,
            ..Closing::default()
        };
        ProfileShift { offsets: self.offsets.clone(), closing }
    }

    /// Limits of the gears, with the gap between planets of these bounds.
    #[must_use]
    pub fn limits(&self, bounds: &Bounds) -> Limits {
        Limits { tip_thickness: self.tip_thickness, planet_gap: bounds.tip_gap, ..Limits::default() }
    }
}

impl ShiftOptions {
    /// Requirements on the profile shifts; `None` for sets without profile shift.
    pub(crate) fn wanted(&self) -> Option<WantedShifts> {
        let offsets = self.ring_offset.clone()?;
        Some(WantedShifts { offsets, aim: self.aim, tip_thickness: self.tip_thickness.get() })
    }

    /// Refuses offsets and limits that cannot be.
    pub(crate) fn check(&self, bounds: &Bounds) -> Result<(), Failure> {
        let Some(wanted) = self.wanted() else { return Ok(()) };
        wanted.within(bounds).within(bounds).check().map_err(|error| {
            match of_teeth(&error, "--planet-count") {
                Some(option) => Failure::of_option(option, &error),
                None => error.into(),
            }
        })
    }

    /// Refuses the options if no tooth numbers are searched.
    pub(crate) fn only_with_teeth(&self, teeth: bool) -> Result<(), Failure> {
        if self.ring_offset.is_some() && !teeth {
            let message = "offsets are of tooth numbers: add --teeth".to_owned();
            return Err(Failure::invalid("--ring-offset", message));
        }
        Ok(())
    }
}

/// A range of offsets: `-3..3`, or one.
pub(crate) fn offsets(text: &str) -> Result<RangeInclusive<i32>, String> {
    let whole = |text: &str| {
        text.trim().parse::<i32>().map_err(|_| format!("{text:?} is not a whole number; write -3..3, or 2"))
    };
    let ends = text.split_once("..=").or_else(|| text.split_once(".."));
    let (from, to) = ends.unwrap_or((text, text));
    let (from, to) = (whole(from)?, whole(to)?);
    if from > to { Err(format!("write the smaller number first: {to}..{from}")) } else { Ok(from..=to) }
}
