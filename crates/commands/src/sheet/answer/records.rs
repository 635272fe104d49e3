//! Records of data sheets: gears, meshes, sets.

use crate::answer::Warning;
use crate::shared::tool::{CuttingTool, ToolKind};
use crate::strength::answer::names::MeshName;
use crate::tolerance::{PRESSED_M, SAME};
use epicyclic_gears::Error;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::InvoluteGear;
use epicyclic_gears::involute::play::Deviation;
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::toothed::{ToothedMesh, ToothedSet};
use epicyclic_units::Physical;
use epicyclic_units::format::significant;
use schemars::JsonSchema;
use serde::Serialize;

/// Lower and upper limit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Limits {
    /// Lower limit.
    pub lower: f64,
    /// Upper limit.
    pub upper: f64,
}

impl Limits {
    pub(super) const fn of([lower, upper]: [f64; 2]) -> Self {
        Self { lower, upper }
    }
}

/// Allowances, in modules, and deviations.
pub(super) struct Allowed {
    /// Allowances of the normal tooth thickness of each gear.
    pub(super) thickness: Vec<Deviation>,
    /// Lower and upper deviation of the centre distance, in m.
    pub(super) centre_distance_m: [f64; 2],
}

/// Backlash and stiffness at the output in a gear while the input is held.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct AtOutput {
    /// Name of the gear.
    pub gear: String,
    /// Angle by which the output turns freely in rad, with the least and the greatest allowed play; null if
    /// the tooth numbers of a set with torque are unknown.
    pub backlash_rad: Option<Limits>,
    /// Torsional stiffness of the meshes in N·m per radian. Null if the number of planets or the face width
    /// of a set with torque is missing, or if no set has torque.
    pub stiffness_n_m: Option<f64>,
    /// Data that are missing.
    pub missing: Vec<String>,
}

/// Set with its gears and meshes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SetSheet {
    /// Name of the set.
    pub set: String,
    /// Normal module `m_n`, in m; null if its meshes have several.
    pub module_m: Option<f64>,
    /// Normal pressure angle `α_n`, in rad.
    pub pressure_angle_rad: f64,
    /// Helix angle `β` at the reference cylinders, in rad; null if its meshes have several.
    pub helix_angle_rad: Option<f64>,
    /// Helix angle at the base cylinders `β_b`, in rad; null if its meshes have several.
    pub base_helix_angle_rad: Option<f64>,
    /// Transverse module `m_t`, in m; null if its meshes have several.
    pub transverse_module_m: Option<f64>,
    /// Transverse pressure angle `α_t`, in rad; null if its meshes have several.
    pub transverse_pressure_angle_rad: Option<f64>,
    /// Addendum of the basic rack `h_aP*`, in modules.
    pub addendum: f64,
    /// Clearance of the basic rack `c_P*`, in modules.
    pub clearance: f64,
    /// Number of planets; null if the file does not give it.
    pub planets: Option<u32>,
    /// Face width of all gears in m; null if the file does not give it, or gives several.
    pub face_width_m: Option<f64>,
    /// Centre distance `a` of all meshes, in m; null if they have several.
    pub centre_distance_m: Option<f64>,
    /// Lower and upper deviation of the centre distance in m; null if the file gives none.
    pub centre_distance_deviations_m: Option<Limits>,
    /// Lower and upper allowance of the normal tooth thickness of each gear, `E_sni` and `E_sns`, in m; null
    /// if the file gives none.
    pub thickness_allowances_m: Option<Vec<Limits>>,
    /// Data of the gears; of a simple set sun, planet and ring.
    pub gears: Vec<GearSheet>,
    /// Data of the meshes.
    pub meshes: Vec<MeshSheet>,
}

/// Hand of a helix relative to that of the first gear of the set, which the file leaves open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Hand {
    /// Hand of the first gear, in a simple set the sun.
    OfSun,
    /// Hand opposite to that.
    Opposite,
}

/// A gear of a set in mesh.
pub(super) struct Toothed<'t> {
    pub(super) name: String,
    pub(super) gear: &'t InvoluteGear,
    pub(super) module_m: f64,
    pub(super) hand: Option<Hand>,
}

impl<'t> Toothed<'t> {
    pub(super) fn of(set: &PlanetSet, toothed: &'t ToothedSet, gear: GearOf) -> Option<Self> {
        let own = toothed.gear(gear)?;
        let mesh = toothed.meshes.iter().find(|mesh| mesh.gears.contains(&gear))?;
        let hand = own.profile().is_helical().then(|| hand(set, toothed, gear)).flatten();
        Some(Self { name: set.gear_name(gear), gear: own, module_m: mesh.module, hand })
    }
}

/// Hand of a gear: external gears in mesh have opposite hands, a ring has the hand of its planets. That of
/// another gear of a stepped planet does not follow.
fn hand(set: &PlanetSet, toothed: &ToothedSet, gear: GearOf) -> Option<Hand> {
    let mut known = vec![(*set.gears().first()?, Hand::OfSun)];
    for _ in 0..toothed.meshes.len() {
        for mesh in &toothed.meshes {
            let [one, other] = mesh.gears;
            for (from, to) in [(one, other), (other, one)] {
                let of = |of: GearOf| known.iter().find(|known| known.0 == of).map(|known| known.1);
                if let (Some(hand), None) = (of(from), of(to)) {
                    let opposite = if hand == Hand::OfSun { Hand::Opposite } else { Hand::OfSun };
                    known.push((to, if mesh.pair.is_internal() { hand } else { opposite }));
                }
            }
        }
    }
    known.into_iter().find(|known| known.0 == gear).map(|known| known.1)
}

/// The value that all have, to the last digits of its rounding.
pub(super) fn same(mut values: impl Iterator<Item = Option<f64>>) -> Option<f64> {
    let first = values.next()??;
    let is_same = |value: Option<f64>| value.is_some_and(|value| (value - first).abs() <= SAME * first.abs());
    values.all(is_same).then_some(first)
}

/// Data of a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearSheet {
    /// Name of the gear; in a simple set sun, planet or ring.
    pub toothed_gear: String,
    /// Tooth number `z`.
    pub teeth: u32,
    /// Hand of the helix; null for spur teeth.
    pub hand: Option<Hand>,
    /// Lead of the helix `p_z`, in m; null for spur teeth.
    pub lead_m: Option<f64>,
    /// Profile shift coefficient `x`; a positive one moves the tip circle outwards, for a ring inwards.
    pub profile_shift: f64,
    /// Tip alteration `k·m_n` in m; negative for shorter teeth.
    pub tip_alteration_m: f64,
    /// Reference diameter `d`, in m.
    pub reference_diameter_m: f64,
    /// Base diameter `d_b`, in m.
    pub base_diameter_m: f64,
    /// Tip diameter `d_a`, in m.
    pub tip_diameter_m: f64,
    /// Root diameter `d_f` as cut by the tool, in m.
    pub root_diameter_m: f64,
    /// Root form diameter `d_Ff` as cut by the tool, in m, where the involute ends at the root.
    pub form_diameter_m: f64,
    /// Normal tooth thickness at the reference circle `s_n` without allowances, in m.
    pub thickness_m: f64,
    /// Transverse tooth thickness at the reference circle `s_t` without allowances, in m.
    pub transverse_thickness_m: f64,
    /// Normal tooth thickness at the tip circle `s_an` without allowances, in m.
    pub tip_thickness_m: f64,
    /// Corner radius of the tool in modules: the fillet `ρ_fP*` of a rack, the tips `ρ_a0*` of a shaper, the
    /// fillet of a form tool.
    pub fillet: f64,
    /// Least profile shift coefficient that a rack cuts without undercut; null for a ring.
    pub least_shift: Option<f64>,
    /// Number of teeth `k` in the span; for a ring the number of spaces.
    pub spanned_teeth: u32,
    /// Span `W_k` without allowances, in m.
    pub span_m: f64,
    /// Span `W_k` with the allowances, in m; null without allowances.
    pub span_limits_m: Option<Limits>,
    /// Face width in m that must be exceeded to measure the span, `W_k·sin β_b`; null for spur teeth and for
    /// a ring.
    pub span_face_width_m: Option<f64>,
    /// Diameter of the measuring balls or pins `D_M`, in m.
    pub ball_diameter_m: f64,
    /// Measure over two balls `M_dK` without allowances, in m, for a ring between them; null if the balls
    /// fall through the spaces.
    pub over_balls_m: Option<f64>,
    /// Measure over two balls `M_dK` with the allowances, in m; null without allowances.
    pub over_balls_limits_m: Option<Limits>,
    /// Face width in m; null if the file gives none.
    pub face_width_m: Option<f64>,
    /// Name of the material; null if the file gives none.
    pub material: Option<String>,
    /// Kind of the tool that cuts the gear.
    pub tool: ToolKind,
    /// Whether the file gives the tool; otherwise the usual one is assumed.
    pub tool_stated: bool,
    /// Tooth number of the shaper; null for other tools.
    pub shaper_teeth: Option<u32>,
    /// Profile shift coefficient of the shaper; null for other tools.
    pub shaper_shift: Option<f64>,
    /// Addendum `h_aP0*` of the shaper, in modules; null for other tools.
    pub shaper_addendum: Option<f64>,
}

/// Gear in a mesh.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearInMesh {
    /// Name of the gear; in a simple set sun, planet or ring.
    pub toothed_gear: String,
    /// Working diameter `d_w`, in m.
    pub working_diameter_m: f64,
    /// Active root diameter `d_Nf` in m, where contact with the mate ends at the root.
    pub active_root_diameter_m: f64,
    /// Tip clearance `c` in m: from the tip of the gear to the root circle of its mate.
    pub tip_clearance_m: f64,
    /// Specific sliding `ζ` at the end of contact at the tip; null where it is infinite.
    pub sliding_at_tip: Option<f64>,
    /// Specific sliding `ζ` at the end of contact at the root; null if contact begins at the base circle,
    /// where it is infinite.
    pub sliding_at_root: Option<f64>,
}

/// Data of a mesh.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MeshSheet {
    /// Name of the mesh.
    pub mesh: MeshName,
    /// Normal module `m_n`, in m.
    pub module_m: f64,
    /// Helix angle `β` at the reference cylinders, in rad.
    pub helix_angle_rad: f64,
    /// Centre distance `a`, in m.
    pub centre_distance_m: f64,
    /// Working transverse pressure angle `α_wt`, in rad.
    pub working_angle_rad: f64,
    /// Greatest common factor of both tooth numbers; 1 where every tooth meets every tooth of the mate.
    pub common_factor: u32,
    /// Turns of the first gear after which the same two teeth meet again, of a planet set relative to the
    /// carrier.
    pub turns_to_same_teeth: u32,
    /// Transverse contact ratio `ε_α`.
    pub contact_ratio: f64,
    /// Overlap ratio `ε_β` of the face width, 0 for spur teeth; null if the file gives no face width.
    pub overlap_ratio: Option<f64>,
    /// Total contact ratio `ε_γ`, the sum of transverse contact ratio and overlap ratio; null without a face
    /// width.
    pub total_contact_ratio: Option<f64>,
    /// Circumferential backlash at the working circles `j_wt` without allowances, in m, as rounded shifts
    /// leave it.
    pub backlash_m: f64,
    /// Circumferential backlash `j_wt` with the allowances, in m; null without allowances.
    pub backlash_limits_m: Option<Limits>,
    /// Normal backlash `j_bn` with the allowances, in m; null without allowances.
    pub normal_backlash_limits_m: Option<Limits>,
    /// Data of both gears in the mesh.
    pub gears: Vec<GearInMesh>,
}

impl SetSheet {
    pub(super) fn of(set: &str, gears: Vec<GearSheet>, meshes: Vec<MeshSheet>, toothed: &ToothedSet) -> Self {
        let profile = |mesh: &ToothedMesh| *mesh.pair.gears()[0].profile();
        let rack = profile(&toothed.meshes[0]).rack;
        let all = |of: &dyn Fn(&ToothedMesh) -> f64| same(toothed.meshes.iter().map(|mesh| Some(of(mesh))));
        Self {
            set: set.to_owned(),
            module_m: all(&|mesh| mesh.module),
            pressure_angle_rad: rack.pressure_angle.si(),
            helix_angle_rad: all(&|mesh| profile(mesh).helix_angle.si()),
            base_helix_angle_rad: all(&|mesh| profile(mesh).base_helix_rad()),
            transverse_module_m: all(&|mesh| mesh.module / libm::cos(profile(mesh).helix_angle.si())),
            transverse_pressure_angle_rad: all(&|mesh| profile(mesh).transverse_angle_rad()),
            addendum: rack.addendum,
            clearance: rack.clearance,
            planets: None,
            face_width_m: None,
            centre_distance_m: same(meshes.iter().map(|mesh| Some(mesh.centre_distance_m))),
            centre_distance_deviations_m: None,
            thickness_allowances_m: None,
            gears,
            meshes,
        }
    }

    /// Meshes whose flanks overlap within the allowances and deviations of the file.
    pub(super) fn warnings(&self) -> impl Iterator<Item = Warning> {
        let tight = self.meshes.iter().filter_map(|mesh| Some((mesh, mesh.backlash_limits_m?)));
        tight.filter(|(_, limits)| limits.lower < -PRESSED_M).map(|(mesh, limits)| {
            let [least, most] = [limits.lower, limits.upper].map(|backlash| significant(1e3 * backlash, 3));
            let message = format!(
                "set `{}`: the flanks of {} press into each other within the allowances and deviations: backlash {least} to {most} mm; lower `thickness_allowances`, or raise `centre_distance_deviations`",
                self.set,
                mesh.mesh.gears.join(" and "),
            );
            Warning { name: "backlash", message }
        })
    }
}

impl GearSheet {
    pub(super) fn of(of: &Toothed<'_>, ball_m: f64, allowance: Option<Deviation>) -> Result<Self, Error> {
        let Toothed { name, gear, module_m, hand } = of;
        let module_m = *module_m;
        let tool = CuttingTool::of(gear);
        let spanned = gear.spanned_teeth();
        let helix_angle = gear.profile().helix_angle.si();
        let is_helical = gear.profile().is_helical();
        let lead = std::f64::consts::PI * gear.reference_diameter() / libm::tan(helix_angle);
        let base_helix = gear.profile().base_helix_rad();
        // Only a helical external gear needs a minimum width for the measurement of its span.
        let has_span_width = is_helical && gear.kind() == GearKind::External;
        let thinner = |allowance: f64| gear.with_thickness_allowance(allowance);
        let both = match allowance {
            Some(Deviation { lower, upper }) => Some([thinner(lower)?, thinner(upper)?]),
            None => None,
        };
        let over = |gear: &InvoluteGear| gear.over_balls(ball_m / module_m).map(|measure| measure * module_m);
        // If the balls fall through the spaces at one limit, no range can be given.
        let over_limits = both.and_then(|[lower, upper]| Some([over(&lower)?, over(&upper)?]));
        Ok(Self {
            toothed_gear: name.clone(),
            teeth: gear.teeth().get(),
            hand: *hand,
            lead_m: is_helical.then_some(module_m * lead),
            profile_shift: gear.shift(),
            tip_alteration_m: module_m * gear.tip_alteration(),
            reference_diameter_m: module_m * gear.reference_diameter(),
            base_diameter_m: module_m * gear.base_diameter(),
            tip_diameter_m: module_m * gear.tip_diameter(),
            root_diameter_m: module_m * gear.root_diameter(),
            form_diameter_m: module_m * gear.form_diameter(),
            thickness_m: module_m * gear.normal_thickness(),
            transverse_thickness_m: module_m * gear.normal_thickness() / libm::cos(helix_angle),
            tip_thickness_m: module_m * gear.tip_thickness(),
            fillet: tool.corner_radius_in_modules,
            least_shift: gear.least_shift_without_undercut(),
            spanned_teeth: spanned,
            span_m: module_m * gear.span(spanned),
            span_face_width_m: has_span_width.then(|| module_m * gear.span(spanned) * libm::sin(base_helix)),
            span_limits_m: both.map(|both| sorted(both.map(|gear| module_m * gear.span(spanned)))),
            ball_diameter_m: ball_m,
            over_balls_m: over(gear),
            over_balls_limits_m: over_limits.map(sorted),
            face_width_m: None,
            material: None,
            tool: tool.kind,
            tool_stated: gear.profile().tool.is_some(),
            shaper_teeth: tool.shaper_teeth,
            shaper_shift: tool.shaper_shift,
            shaper_addendum: tool.shaper_addendum_in_modules,
        })
    }
}

/// Thinner teeth of a ring give the larger measures, so the limits are sorted.
fn sorted([one, other]: [f64; 2]) -> Limits {
    Limits { lower: one.min(other), upper: one.max(other) }
}

impl MeshSheet {
    pub(super) fn of(
        mesh: MeshName,
        toothed: &ToothedMesh,
        face_width_m: Option<f64>,
        allowed: Option<([Deviation; 2], Deviation)>,
    ) -> Result<Self, Error> {
        let (pair, module_m) = (&toothed.pair, toothed.module);
        let plays = allowed.map(|(thickness, centre)| pair.plays(thickness, centre)).transpose()?;
        let limits = |of: fn(&epicyclic_gears::involute::play::Play) -> f64| {
            plays.map(|plays| sorted(plays.map(|play| module_m * of(&play))))
        };
        let overlap_ratio = face_width_m.map(|width| pair.overlap_ratio(width / module_m));
        let (working, roots) = (pair.working_diameters(), pair.active_root_diameters());
        let (clearances, sliding) = (pair.tip_clearances(), pair.specific_sliding());
        let [first, second] = pair.gears().map(|gear| gear.teeth());
        let common_factor = first.common_factor(second);
        let gears = mesh.gears.iter().enumerate().map(|(place, toothed_gear)| GearInMesh {
            toothed_gear: toothed_gear.clone(),
            working_diameter_m: module_m * working[place],
            active_root_diameter_m: module_m * roots[place],
            tip_clearance_m: module_m * clearances[place],
            sliding_at_tip: Some(sliding[place][0]).filter(|sliding| sliding.is_finite()),
            // Sliding at the base circle is infinite, which JSON cannot hold.
            sliding_at_root: Some(sliding[place][1]).filter(|sliding| sliding.is_finite()),
        });
        Ok(Self {
            module_m,
            helix_angle_rad: pair.gears()[0].profile().helix_angle.si(),
            centre_distance_m: module_m * pair.centre_distance(),
            working_angle_rad: pair.working_angle_rad(),
            common_factor,
            turns_to_same_teeth: second.get() / common_factor,
            contact_ratio: pair.transverse_contact_ratio(),
            overlap_ratio,
            total_contact_ratio: overlap_ratio.map(|overlap| overlap + pair.transverse_contact_ratio()),
            backlash_m: module_m * pair.backlash(),
            backlash_limits_m: limits(|play| play.circumferential),
            normal_backlash_limits_m: limits(|play| play.normal),
            gears: gears.collect(),
            mesh,
        })
    }
}

/// Set without data sheet.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LeftOut {
    /// Name of the set.
    pub set: String,
    /// Keys that the entry of the set lacks; empty for bevel gears.
    pub missing: Vec<String>,
}

impl LeftOut {
    /// Reason in words.
    #[must_use]
    pub fn why(&self) -> String {
        if self.missing.is_empty() {
            "bevel gears have no data sheet".to_owned()
        } else {
            format!("{} missing", self.missing.join(", "))
        }
    }
}
