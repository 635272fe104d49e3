//! Tools of a gearbox file that cut the gears of a simple set.

use super::{ShaperEntry, ToolMisfit};
use epicyclic_gears::ToothCount;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::profile::{Cutting, Iso53};
use epicyclic_gears::involute::tool::{Shaper, Tool};
use epicyclic_units::Number;
use schemars::JsonSchema;
use serde::Deserialize;

/// Tool that cuts a gear: the basic rack of its hob, a shaper in its place, or a form tool. Default: a hob
/// for external gears, for internal ones a shaper of 30 teeth with corners of 0.3 modules, or of 18 teeth
/// less than a smaller gear; a form tool for those of fewer than 42 teeth.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolEntry {
    /// Basic rack tooth profile of ISO 53, in place of `dedendum` and `fillet`.
    #[serde(default)]
    pub profile: Option<ProfileEntry>,
    /// Dedendum `h_fP*` of the basic rack, in modules. Default 1.25 with an addendum of 1.
    #[serde(default)]
    pub dedendum: Option<Number>,
    /// Root fillet radius `ρ_fP*` of the basic rack, in modules. Default 0.38.
    #[serde(default)]
    pub fillet: Option<Number>,
    /// Protuberance `p_r*` of the hob that cuts it, normal to its flank, in modules. Default 0.
    #[serde(default)]
    pub protuberance: Option<Number>,
    /// Stock `q*` that the hob leaves on the flanks for finishing, in modules. Default 0.
    #[serde(default)]
    pub stock: Option<Number>,
    /// A shaper (pinion-type cutter).
    #[serde(default)]
    pub shaper: Option<CutterEntry>,
    /// Radius of the root fillet that a form tool leaves (broach, mould, electrode), in modules.
    #[serde(default)]
    pub form_fillet: Option<Number>,
}

/// Basic rack tooth profile of ISO 53.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
pub enum ProfileEntry {
    /// Dedendum 1.25, fillet 0.38 modules.
    A,
    /// Dedendum 1.25, fillet 0.30 modules.
    B,
    /// Dedendum 1.25, fillet 0.25 modules.
    C,
    /// Dedendum 1.40, fillet 0.39 modules.
    D,
}

/// A shaper (pinion-type cutter).
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CutterEntry {
    /// Number of teeth of the shaper.
    pub teeth: u32,
    /// Profile shift coefficient of the shaper; sharpening lowers it from about 0.15 to -0.15. Default 0.
    #[serde(default)]
    pub shift: Option<Number>,
    /// Addendum of the shaper, in modules. Default: the one that leaves the root circle of the basic rack;
    /// searches take the dedendum of the rack.
    #[serde(default)]
    pub addendum: Option<Number>,
    /// Radius of its tip corners, in modules. Default 0.3.
    #[serde(default)]
    pub tip_radius: Option<Number>,
}

impl From<ProfileEntry> for Iso53 {
    fn from(entry: ProfileEntry) -> Self {
        match entry {
            ProfileEntry::A => Self::A,
            ProfileEntry::B => Self::B,
            ProfileEntry::C => Self::C,
            ProfileEntry::D => Self::D,
        }
    }
}

impl CutterEntry {
    fn tool(&self) -> Result<Tool, epicyclic_gears::Error> {
        let usual = Shaper::of_teeth(ToothCount::new(self.teeth)?);
        Ok(Tool::Shaper(Shaper {
            shift: self.shift.map_or(usual.shift, Number::get),
            addendum: self.addendum.map(Number::get),
            tip_radius: self.tip_radius.map_or(usual.tip_radius, Number::get),
            ..usual
        }))
    }
}

impl ShaperEntry {
    /// The shaper as a tool, and its corners as the fillet of the rack that stands for it.
    pub(super) fn cutting(&self) -> Result<Cutting, epicyclic_gears::Error> {
        let cutter = CutterEntry {
            teeth: self.teeth,
            shift: self.shift,
            addendum: self.addendum,
            tip_radius: self.fillet,
        };
        Ok(Cutting { fillet: self.fillet.map(Number::get), tool: Some(cutter.tool()?), ..Cutting::default() })
    }
}

impl ToolEntry {
    pub(super) fn cutting(&self, kind: GearKind) -> Result<Cutting, ToolMisfit> {
        let of_profile = self.profile.map(|profile| Cutting::from(Iso53::from(profile)));
        if of_profile.is_some() && (self.dedendum.is_some() || self.fillet.is_some()) {
            return Err(ToolMisfit::Twice("profile", "dedendum and fillet"));
        }
        if self.shaper.is_some() && self.form_fillet.is_some() {
            return Err(ToolMisfit::Twice("shaper", "form_fillet"));
        }
        let is_hobbed = kind == GearKind::External && self.shaper.is_none() && self.form_fillet.is_none();
        for (key, value) in [("protuberance", self.protuberance), ("stock", self.stock)] {
            if !is_hobbed && value.is_some() {
                return Err(ToolMisfit::OfHob(key));
            }
        }
        let tool = match (&self.shaper, self.form_fillet) {
            (Some(shaper), _) => Some(shaper.tool()?),
            (None, Some(fillet)) => Some(Tool::Form { fillet: fillet.get() }),
            (None, None) => None,
        };
        let of_profile = of_profile.unwrap_or_default();
        Ok(Cutting {
            dedendum: of_profile.dedendum.or(self.dedendum.map(Number::get)),
            fillet: of_profile.fillet.or(self.fillet.map(Number::get)),
            protuberance: self.protuberance.map_or(0.0, Number::get),
            stock: self.stock.map_or(0.0, Number::get),
            tool,
        })
    }
}
