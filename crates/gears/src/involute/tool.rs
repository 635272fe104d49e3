//! Tools that cut the teeth of a gear: a hob, a pinion-type cutter (shaper), or a form tool.
//!
//! Hobs cut external gears, shapers both kinds, form tools (broaches, moulds, electrodes) both kinds. No rack
//! cuts a ring.

use crate::gear_kind::GearKind;
use crate::{Error, Quantity, ToothCount};

/// Tool that cuts a gear; lengths in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tool {
    /// A hob with the basic rack of the gear, for external gears.
    Rack,
    /// A pinion-type cutter.
    Shaper(Shaper),
    /// A broach, mould or electrode: root circle as the basic rack has it, with a fillet that touches it and
    /// the flank.
    Form {
        /// Radius of the fillet.
        fillet: f64,
    },
}

/// A shaper (pinion-type cutter), with the pressure and helix angle of the gear that it cuts; lengths in
/// modules.
///
/// | symbol | field | meaning | usual |
/// |---|---|---|---|
/// | `z_0` | `teeth` | teeth | 30 |
/// | `x_0` | `shift` | profile shift coefficient; sharpening lowers it from about 0.15 to −0.15 | 0 |
/// | `h_aP0*` | `addendum` | addendum | 1.25 |
/// | `ρ_a0*` | `tip_radius` | radius of the tip corners in the transverse section | 0.3 |
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaper {
    /// Teeth `z_0`.
    pub teeth: ToothCount,
    /// Profile shift coefficient `x_0`.
    pub shift: f64,
    /// Addendum `h_aP0*`; `None`: the one that cuts the root circle `d − 2·(h_fP* − x)` of the gear's basic
    /// rack.
    pub addendum: Option<f64>,
    /// Radius of the tip corners `ρ_a0*`.
    pub tip_radius: f64,
}

/// Teeth of the usual shaper.
const USUAL_TEETH: u32 = 30;

/// Teeth that a ring must have more than a shaper without shift so that it can be fed radially, nearly
/// whatever their number.
const RADIAL_FEED: u32 = 18;

/// Teeth of the smallest ring without shift whose tips the usual shaper leaves whole: 24 teeth are the fewest
/// that reach them.
const SMALLEST_SHAPED: u32 = 42;

/// Radius of the tip corners of the usual shaper, and of the fillet of the usual form tool.
const USUAL_CORNER: f64 = 0.3;

/// Profile shifts of shapers are within; new ones have about 0.15.
const MOST_SHAPER_SHIFT: f64 = 1.0;

impl Shaper {
    /// Usual cutter with this number of teeth: without shift, tips rounded by 0.3 modules.
    #[must_use]
    pub const fn of_teeth(teeth: ToothCount) -> Self {
        Self { teeth, shift: 0.0, addendum: None, tip_radius: USUAL_CORNER }
    }
}

impl Tool {
    /// Usual tool of a gear whose own tool is not known.
    ///
    /// External gears have a hob. Rings have a shaper with 30 teeth, or with 18 less than the ring if that is
    /// fewer. Rings of fewer than 42 teeth have a form tool, since such a shaper would cut away their tips.
    /// Corners are rounded by 0.3, or by the radius that the cutter of a steep rack has room for.
    #[must_use]
    pub fn usual(kind: GearKind, teeth: ToothCount) -> Self {
        if kind == GearKind::External {
            return Self::Rack;
        }
        let cutter = teeth.get().saturating_sub(RADIAL_FEED).min(USUAL_TEETH);
        match ToothCount::new(cutter) {
            Ok(cutter) if teeth.get() >= SMALLEST_SHAPED => Self::Shaper(Shaper::of_teeth(cutter)),
            _ => Self::Form { fillet: USUAL_CORNER },
        }
    }

    /// Tool with this addendum if it is a shaper without an addendum of its own. A search takes an existing
    /// cutter, not one made for each ring.
    #[must_use]
    pub fn with_addendum(self, addendum: f64) -> Self {
        match self {
            Self::Shaper(shaper) => {
                Self::Shaper(Shaper { addendum: shaper.addendum.or(Some(addendum)), ..shaper })
            }
            other => other,
        }
    }

    /// Refuses a tool that does not cut gears of this kind, or whose dimensions are invalid.
    ///
    /// # Errors
    /// [`Error::WrongGearKind`] for a hob of a ring; [`Error::Negative`] for radii; [`Error::NotPositive`]
    /// for the addendum; [`Error::OutOfRange`] for a shift beyond ±1.
    pub fn check(&self, kind: GearKind) -> Result<(), Error> {
        match self {
            Self::Rack if kind == GearKind::Internal => {
                Err(Error::WrongGearKind { given: GearKind::Internal, wanted: GearKind::External })
            }
            Self::Rack => Ok(()),
            Self::Form { fillet } => {
                crate::checks::not_negative(Quantity::FormFillet, *fillet, "modules").map(drop)
            }
            Self::Shaper(shaper) => {
                crate::checks::not_negative(Quantity::ShaperTipRadius, shaper.tip_radius, "modules")?;
                if !(-MOST_SHAPER_SHIFT..=MOST_SHAPER_SHIFT).contains(&shaper.shift) {
                    return Err(Error::OutOfRange {
                        quantity: Quantity::ShaperShift,
                        value: shaper.shift,
                        low: -MOST_SHAPER_SHIFT,
                        high: MOST_SHAPER_SHIFT,
                        unit: "modules",
                    });
                }
                let addendum = shaper
                    .addendum
                    .map(|addendum| crate::checks::positive(Quantity::ShaperAddendum, addendum, "modules"));
                addendum.transpose().map(drop)
            }
        }
    }
}
