//! Tooth numbers of a simple set with profile shift for a ratio.

use super::{Listed, gearbox, listed};
use crate::answer::Answer;
use crate::error::Error;
use crate::shared::judgement::answer::Judgement;
use crate::shared::profile_shift::WantedShifts;
use crate::shared::records::{Fraction, Motion};
use crate::shared::tool::CuttingTool;
use crate::shared::tooth_checks::answer::{TeethLeftOut, ToothChecks};
use crate::teeth::options::Request;
use crate::tolerance::{ROUNDED, rounded};
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::InvoluteGear;
use epicyclic_gears::involute::family::Aim;
use epicyclic_gears::involute::profile::Cutting;
use epicyclic_gears::involute::search::{ProfileShift, Shifted};
use epicyclic_gears::synthesis::{Bounds, ToothNumbers};
use epicyclic_train::Gearbox;
use epicyclic_train::set::{SetKind, SetSpec, Shifts};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;

/// Requirements of the profile shifts of a search.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct RequiredShifts {
    /// Least and greatest ring offset, `z_r − z_s − 2·z_p`.
    pub ring_offsets: [i32; 2],
    /// Aim of the profile shifts.
    pub aim: Aim,
    /// Minimum normal tip thickness, in modules.
    pub least_tip_thickness_in_modules: f64,
}

impl RequiredShifts {
    pub(crate) fn of(wanted: &WantedShifts) -> Self {
        Self {
            ring_offsets: [*wanted.offsets.start(), *wanted.offsets.end()],
            aim: wanted.aim,
            least_tip_thickness_in_modules: wanted.tip_thickness,
        }
    }
}

/// Profile shifts of a simple set found by a search; lengths in modules.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetShifts {
    /// Ring offset, `z_r − z_s − 2·z_p`.
    pub ring_offset: i32,
    /// Centre distance, in modules.
    pub centre_distance_in_modules: f64,
    /// Profile shift coefficients of sun, planets and ring; for a ring positive inwards.
    pub profile_shifts: [f64; 3],
    /// Tip alterations of sun, planets and ring, in modules; negative for shorter teeth.
    pub tip_alterations: [f64; 3],
    /// Whether the aim is met; otherwise it is met only as far as the limits allow.
    pub aim_met: bool,
    /// Tool that cuts the ring.
    pub ring_tool: CuttingTool,
}

impl SetShifts {
    /// Profile shifts of a set that a search with this shift found.
    pub(crate) fn of(shift: &ProfileShift, teeth: &ToothNumbers) -> Result<Self, Error> {
        let choice = shift.close(teeth)?;
        let gears = choice.set.gears();
        Ok(Self {
            ring_offset: teeth.ring_offset(),
            centre_distance_in_modules: choice.set.centre_distance(),
            // A sum of shifts that should be 0 leaves a rounding error, which is set to 0.
            profile_shifts: gears.map(|gear| rounded(gear.shift())),
            tip_alterations: gears.map(|gear| rounded(gear.tip_alteration())),
            aim_met: choice.limited_by.is_none(),
            ring_tool: CuttingTool::of(gears[2]),
        })
    }

    /// Set with these profile shifts and tools.
    pub(crate) fn put_into(&self, set: SetSpec) -> SetSpec {
        shifted(set, self.profile_shifts, self.tip_alterations, self.ring_tool)
    }
}

/// Set with these profile shifts and tip alterations, and this tool for its ring.
fn shifted(set: SetSpec, profile: [f64; 3], tips: [f64; 3], ring_tool: CuttingTool) -> SetSpec {
    let hob = Cutting::default();
    let shifts = Shifts { profile: profile.to_vec(), tips: Some(tips.to_vec()) };
    set.shifted(shifts).cut(vec![hob, hob, ring_tool.cutting()])
}

/// Sets with profile shift that give a ratio, the most exact first.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftedTeeth {
    /// Required ratio, input speed over output speed.
    pub ratio: f64,
    /// Driving, driven and fixed member.
    pub mode: Motion,
    /// Allowed relative deviation of the ratio.
    pub tolerance: f64,
    /// Aim of the profile shifts.
    pub aim: Aim,
    /// Minimum normal tip thickness, in modules.
    pub least_tip_thickness_in_modules: f64,
    /// Number of sets found.
    pub found: u64,
    /// Sets of this ratio that are left out because a tooth check fails; null if no set is left out.
    pub left_out: Option<TeethLeftOut>,
    /// Number of sets listed.
    pub shown: usize,
    /// Listed sets of tooth numbers.
    pub tooth_numbers: Vec<ShiftedNumbers>,
    /// Tooth checks of one set, the first unless another is requested.
    pub tooth_checks: ToothChecks,
    /// Judgement of the same set by rules of practice.
    pub judgement: Judgement,
}

/// Tooth numbers of a simple set with its profile shifts, and the properties that follow; lengths in modules.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ShiftedNumbers {
    /// Tooth number of the sun.
    pub sun: u32,
    /// Tooth number of a planet.
    pub planet: u32,
    /// Tooth number of the ring.
    pub ring: u32,
    /// Ring offset, `z_r − z_s − 2·z_p`.
    pub ring_offset: i32,
    /// Number of planets.
    pub planets: u32,
    /// Ratio, input speed over output speed.
    pub ratio: f64,
    /// Exact ratio as a fraction.
    pub exact_ratio: Fraction,
    /// Relative deviation from the required ratio.
    pub ratio_error: f64,
    /// Centre distance, in modules.
    pub centre_distance_in_modules: f64,
    /// Profile shift coefficients of sun, planets and ring; for a ring positive inwards.
    pub profile_shifts: [f64; 3],
    /// Tip alterations of sun, planets and ring, in modules; negative for shorter teeth.
    pub tip_alterations: [f64; 3],
    /// Working pressure angles of the meshes of sun and planet, planet and ring, in rad.
    pub working_angles_rad: [f64; 2],
    /// Transverse contact ratios of the meshes of sun and planet, planet and ring.
    pub contact_ratios: [f64; 2],
    /// Normal tip thicknesses of sun, planets and ring, in modules.
    pub tip_thicknesses_in_modules: [f64; 3],
    /// Gap between the tip circles of neighbouring planets, in modules.
    pub planet_gap_in_modules: f64,
    /// Tool that cuts the ring.
    pub ring_tool: CuttingTool,
    /// Whether the aim is met; otherwise it is met only as far as the limits allow.
    pub aim_met: bool,
    /// Whether the planets are equally spaced.
    pub equal_spacing: bool,
    /// Angle of each planet about the axis, in rad.
    pub planet_angles_rad: Vec<f64>,
    /// Imbalance: distance of the planets' common centre of mass from the axis over the radius of their
    /// centres.
    pub imbalance: f64,
}

impl Answer for ShiftedTeeth {
    const NAME: &'static str = "teeth-shifted";
}

/// Finds all sets with profile shift for a ratio.
///
/// # Errors
/// Those of [`super::answer`].
pub(in crate::teeth) fn answer(
    request: &Request,
    bounds: &Bounds,
    shifts: &WantedShifts,
    done: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<ShiftedTeeth, Error> {
    let search = shifts.within(bounds).within(bounds);
    let mode = request.simple_mode()?;
    let Listed { ratio, tolerance, found, left_out, sets, tooth_checks, judgement } = listed(
        request,
        &bounds.rack,
        |ratio, tolerance, most| search.first_for_ratio(ratio, mode, tolerance, most, done),
        ShiftedNumbers::of,
        ShiftedNumbers::gearbox,
    )?;
    Ok(ShiftedTeeth {
        ratio,
        mode: Motion::of(mode),
        tolerance,
        aim: shifts.aim,
        least_tip_thickness_in_modules: shifts.tip_thickness,
        found,
        left_out,
        shown: sets.len(),
        tooth_numbers: sets,
        tooth_checks,
        judgement,
    })
}

impl ShiftedNumbers {
    /// Set as a gearbox without losses, with its shifts, tip alterations and tools.
    ///
    /// # Errors
    /// No error is known for a set that an answer to this request lists.
    pub fn gearbox(&self, request: &Request) -> Result<Gearbox, Error> {
        let members = gearbox::members(request.simple_mode()?);
        let set = SetSpec::teeth(gearbox::NAME, SetKind::Simple, members, self.sun, self.ring)?;
        let set = set.planet_teeth(ToothCount::new(self.planet)?, None).planet_count(self.planets);
        gearbox::built(request, shifted(set, self.profile_shifts, self.tip_alterations, self.ring_tool))
    }

    fn of(found: &Shifted) -> Self {
        let set = &found.choice.set;
        let meshes = [set.sun_mesh(), set.ring_mesh()];
        let spacing = set.spacing();
        let imbalance = spacing.imbalance();
        Self {
            sun: found.teeth.sun.get(),
            planet: found.teeth.planet.get(),
            ring: found.teeth.ring.get(),
            ring_offset: found.offset(),
            planets: found.teeth.planets,
            ratio: found.ratio,
            exact_ratio: Fraction::of(found.exact_ratio),
            ratio_error: found.ratio_error,
            centre_distance_in_modules: set.centre_distance(),
            profile_shifts: set.gears().map(InvoluteGear::shift),
            tip_alterations: set.gears().map(InvoluteGear::tip_alteration),
            working_angles_rad: meshes.map(epicyclic_gears::involute::Pair::working_angle_rad),
            contact_ratios: meshes.map(epicyclic_gears::involute::Pair::transverse_contact_ratio),
            tip_thicknesses_in_modules: set.gears().map(InvoluteGear::tip_thickness),
            planet_gap_in_modules: set.planet_gap(),
            ring_tool: CuttingTool::of(set.gears()[2]),
            aim_met: found.choice.limited_by.is_none(),
            equal_spacing: spacing.is_equal(),
            planet_angles_rad: spacing.angles().into_iter().map(Physical::si).collect(),
            // Vectors of equally spaced planets cancel except for a rounding error.
            imbalance: if imbalance < ROUNDED { 0.0 } else { imbalance },
        }
    }
}
