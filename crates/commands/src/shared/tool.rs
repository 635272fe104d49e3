//! Cutting tool of a gear, as answers state it.

use crate::tolerance::rounded;
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::InvoluteGear;
use epicyclic_gears::involute::profile::Cutting;
use epicyclic_gears::involute::tool::{Shaper, Tool};
use schemars::JsonSchema;
use serde::Serialize;

/// Kind of a tool that cuts teeth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ToolKind {
    /// A hob, or another rack.
    Rack,
    /// A shaper (pinion-type cutter).
    Shaper,
    /// A form tool: broach, mould, electrode.
    Form,
}

/// A tool that cuts a gear; lengths in modules.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CuttingTool {
    /// Kind of tool.
    pub kind: ToolKind,
    /// Radius of its corners: fillet `ρ_fP*` of a rack, tips `ρ_a0*` of a shaper, fillet of a form tool.
    pub corner_radius_in_modules: f64,
    /// Teeth `z_0` of a shaper; `null` of others.
    pub shaper_teeth: Option<u32>,
    /// Profile shift coefficient `x_0` of a shaper; `null` of others.
    pub shaper_shift: Option<f64>,
    /// Addendum `h_aP0*` of a shaper; `null` of others, and where it does not mesh with the gear.
    pub shaper_addendum_in_modules: Option<f64>,
}

impl CuttingTool {
    /// The tool of a gear.
    #[must_use]
    pub fn of(gear: &InvoluteGear) -> Self {
        let plain = |kind, corner_radius_in_modules| Self {
            kind,
            corner_radius_in_modules,
            shaper_teeth: None,
            shaper_shift: None,
            shaper_addendum_in_modules: None,
        };
        match gear.tool() {
            Tool::Rack => plain(ToolKind::Rack, gear.profile().fillet),
            Tool::Form { fillet } => plain(ToolKind::Form, *fillet),
            Tool::Shaper(shaper) => Self {
                shaper_teeth: Some(shaper.teeth.get()),
                shaper_shift: Some(shaper.shift),
                shaper_addendum_in_modules: gear.shaper_addendum().map(rounded),
                ..plain(ToolKind::Shaper, shaper.tip_radius)
            },
        }
    }

    /// Returns the tool for the solver; no tool for a hob.
    pub(crate) fn cutting(&self) -> Cutting {
        let tool = match self.kind {
            ToolKind::Rack => None,
            ToolKind::Form => Some(Tool::Form { fillet: self.corner_radius_in_modules }),
            ToolKind::Shaper => {
                let shaper =
                    self.shaper_teeth.and_then(|teeth| ToothCount::new(teeth).ok()).map(Shaper::of_teeth);
                shaper.map(|usual| {
                    Tool::Shaper(Shaper {
                        shift: self.shaper_shift.unwrap_or(usual.shift),
                        addendum: self.shaper_addendum_in_modules,
                        tip_radius: self.corner_radius_in_modules,
                        ..usual
                    })
                })
            }
        };
        Cutting { tool, ..Cutting::default() }
    }
}
