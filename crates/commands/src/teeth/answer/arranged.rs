//! Tooth numbers of stepped, Wolfrom and Ravigneaux sets and of pairs for a ratio.

use super::{Listed, gearbox, listed};
use crate::answer::Answer;
use crate::error::Error;
use crate::shared::judgement::answer::Judgement;
use crate::shared::records::Fraction;
use crate::shared::tool::CuttingTool;
use crate::shared::tooth_checks::answer::{TeethLeftOut, ToothChecks};
use crate::teeth::options::Request;
use crate::tolerance::{ROUNDED, rounded};
use epicyclic_gears::arrangement::{
    ArrangedCandidate, Arrangement, ArrangementBounds, ArrangementMember, ArrangementMode, ModuleRatio,
    least_angle_rad,
};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::involute::family::Aim;
use epicyclic_gears::quantity::SimpleGear;
use epicyclic_gears::spacing::imbalance;
use epicyclic_train::compound::{CentralKind, CompoundSpec};
use epicyclic_train::set::{SetKind, SetSpec, Shifts};
use epicyclic_train::spacing::Spacing;
use epicyclic_train::{GROUND, Gearbox};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// Sets of one arrangement of gears that give a ratio, the most exact first, equally exact ones by size.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ArrangedSets {
    /// Required ratio, input speed over output speed.
    pub ratio: f64,
    /// Arrangement of the gears.
    pub arrangement: Arrangement,
    /// Driving, driven and fixed member.
    pub mode: ArrangedMotion,
    /// Allowed relative deviation of the ratio.
    pub tolerance: f64,
    /// Aim of the profile shifts; null without ring offsets.
    pub aim: Option<Aim>,
    /// Minimum normal tip thickness of gears with profile shift, in modules; null without ring offsets.
    pub least_tip_thickness_in_modules: Option<f64>,
    /// Number of sets found.
    pub found: u64,
    /// Sets of this ratio that are left out because a tooth check fails; null if no set is left out.
    pub left_out: Option<TeethLeftOut>,
    /// Number of sets listed.
    pub shown: usize,
    /// Listed sets of tooth numbers.
    pub tooth_numbers: Vec<ArrangedNumbers>,
    /// Tooth checks of one set, the first unless another is requested.
    pub tooth_checks: ToothChecks,
    /// Judgement of the same set by rules of practice.
    pub judgement: Judgement,
}

/// Driving, driven and fixed member of an arrangement, by the names of its gears or `carrier`; of a pair the
/// `housing` is fixed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ArrangedMotion {
    /// Letters of the three: `ae^b`.
    pub letters: String,
    /// The member that drives.
    pub input: &'static str,
    /// The member that is driven.
    pub output: &'static str,
    /// The member at rest.
    pub fixed: &'static str,
}

/// Tooth numbers of an arrangement, with the properties that follow from them.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ArrangedNumbers {
    /// Gears with their teeth. Both steps of a planet have the same teeth and module where it has one gear.
    pub gears: Vec<ArrangedGear>,
    /// Number of planets, of a Ravigneaux set of pairs of planets; null of a pair of gears.
    pub planets: Option<u32>,
    /// Ratio, input speed over output speed.
    pub ratio: f64,
    /// Exact ratio as a fraction.
    pub exact_ratio: Fraction,
    /// Relative deviation from the required ratio.
    pub ratio_error: f64,
    /// Module of the second step of the planet over that of the first.
    pub module_ratio: f64,
    /// Diameter that the reference circles reach to, in modules of the first step.
    pub size_in_modules: f64,
    /// Greatest common divisor of the teeth in each mesh; 1 where every tooth meets every other (hunting
    /// tooth).
    pub common_divisors: Vec<u32>,
    /// Number of angles per turn at which a planet can be assembled; null of a pair, and where any angle will
    /// do.
    pub assembly_positions: Option<u64>,
    /// Least gap between tip circles of planets, and of other gears in one plane that do not mesh, in
    /// modules; null of a pair.
    pub planet_gap_in_modules: Option<f64>,
    /// Whether the aim of the profile shifts is met; otherwise it is met only as far as the limits allow. Null
    /// of a set without profile shift.
    pub aim_met: Option<bool>,
    /// Angle of each planet about the axis, in rad; empty for a pair.
    pub planet_angles_rad: Vec<f64>,
    /// Whether the planets are equally spaced.
    pub equal_spacing: bool,
    /// Imbalance: distance of the planets' common centre of mass from the axis over the radius of their
    /// centres.
    pub imbalance: f64,
}

/// Gear of an arrangement.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ArrangedGear {
    /// Name of the gear: `sun`, `first_step`.
    pub gear: &'static str,
    /// Letter of the gear in modes and options.
    pub letter: char,
    /// Tooth number.
    pub teeth: u32,
    /// Profile shift coefficient; of a ring positive inwards.
    pub profile_shift: f64,
    /// Tip alteration, in modules; negative for shorter teeth.
    pub tip_alteration: f64,
    /// Tool that cuts the gear; null of a set without profile shift, for which it is open.
    pub tool: Option<CuttingTool>,
    /// Whether the rack undercuts the gear.
    pub undercut: bool,
}

impl Answer for ArrangedSets {
    const NAME: &'static str = "teeth-arranged";
}

/// Finds all sets of an arrangement for a ratio.
///
/// # Errors
/// Those of [`super::answer`]; [`Error::Mode`] for the mode of another kind.
pub(in crate::teeth) fn answer(
    request: &Request,
    bounds: &ArrangementBounds,
    done: impl FnMut(f64) -> ControlFlow<()>,
) -> Result<ArrangedSets, Error> {
    let arrangement = bounds.arrangement;
    let mode = request.arranged_mode(arrangement)?;
    let Listed { ratio, tolerance, found, left_out, sets, tooth_checks, judgement } = listed(
        request,
        &bounds.rack,
        |ratio, tolerance, most| bounds.for_ratio(ratio, mode, tolerance, most, done),
        |one| ArrangedNumbers::of(one, bounds),
        ArrangedNumbers::gearbox,
    )?;
    let [input, output, fixed] = mode.members().map(ArrangementMember::name);
    let shifts = request.shifts.wanted();
    Ok(ArrangedSets {
        ratio,
        arrangement,
        mode: ArrangedMotion { letters: mode.to_string(), input, output, fixed },
        tolerance,
        aim: shifts.as_ref().map(|shifts| shifts.aim),
        least_tip_thickness_in_modules: shifts.map(|shifts| shifts.tip_thickness),
        found,
        left_out,
        shown: sets.len(),
        tooth_numbers: sets,
        tooth_checks,
        judgement,
    })
}

impl ArrangedSets {
    /// Module of each mesh of a listed set, from 1, over that of the first; empty where all are equal.
    pub(super) fn of_meshes(&self, number: usize) -> Vec<f64> {
        let set = number.checked_sub(1).and_then(|place| self.tooth_numbers.get(place));
        let Some(ratio) = set.map(|set| set.module_ratio).filter(|ratio| *ratio != 1.0) else {
            return vec![];
        };
        let gears = self.arrangement.gears();
        let of_mesh = |[gear, _]: &[usize; 2]| if gears[*gear].step == 0 { 1.0 } else { ratio };
        self.arrangement.meshes().iter().map(of_mesh).collect()
    }
}

impl ArrangedNumbers {
    fn of(found: &ArrangedCandidate, bounds: &ArrangementBounds) -> Self {
        let (rack, stated) = (&bounds.rack, &bounds.angles);
        let set = &found.teeth;
        let arrangement = set.arrangement();
        let shifted = found.shifts.as_ref();
        // Every set found has the gears that its shifts leave.
        let involutes = shifted.and_then(|shifts| set.shifted_gears(shifts, rack).ok());
        let gears = arrangement.gears().iter().zip(set.teeth()).enumerate().map(|(place, (gear, &teeth))| {
            let of = involutes.as_ref().map(|gears| &gears[place]);
            ArrangedGear {
                gear: gear.name,
                letter: gear.symbol,
                teeth,
                profile_shift: of.map_or(0.0, |gear| rounded(gear.shift())),
                tip_alteration: of.map_or(0.0, |gear| rounded(gear.tip_alteration())),
                tool: of.map(CuttingTool::of),
                undercut: of.is_none() && set.is_undercut(place, rack),
            }
        });
        let spacing = set.spacing().filter(|_| stated.is_empty());
        let angles = spacing.map_or_else(|| stated.clone(), |spacing| spacing.angles());
        let equal_rad = TAU / angles.len() as f64;
        let is_equal = least_angle_rad(&angles).is_none_or(|least| (least - equal_rad).abs() < ROUNDED);
        let imbalance = if is_equal { 0.0 } else { imbalance(&angles) };
        let over = |ratio: ModuleRatio| f64::from(*ratio.numer()) / f64::from(*ratio.denom());
        Self {
            gears: gears.collect(),
            planets: Some(set.planets()).filter(|_| !arrangement.is_pair()),
            ratio: found.ratio,
            exact_ratio: Fraction::of(found.exact_ratio),
            ratio_error: found.ratio_error,
            module_ratio: over(set.module_ratio()),
            size_in_modules: set.size(),
            common_divisors: set.common_divisors(),
            assembly_positions: Some(set.assembly_positions()).filter(|positions| *positions > 0),
            planet_gap_in_modules: match shifted {
                Some(shifts) => set.shifted_gap_at(shifts, rack, &angles),
                None => set.gap_at(rack, &angles),
            },
            aim_met: shifted.map(|shifts| shifts.is_aim_met),
            planet_angles_rad: angles.into_iter().map(Physical::si).collect(),
            equal_spacing: is_equal,
            imbalance: if imbalance < ROUNDED { 0.0 } else { imbalance },
        }
    }

    /// Set as a gearbox without losses. Its links are named as its gears, and the fixed one is the housing.
    ///
    /// # Errors
    /// No error is known for a set that an answer to this request lists.
    pub fn gearbox(&self, request: &Request) -> Result<Gearbox, Error> {
        let of_kind = request.arrangement().unwrap_or(Arrangement::Stepped);
        let mode = request.arranged_mode(of_kind)?;
        let [input, output, fixed] = mode.members().map(ArrangementMember::name);
        let link = |name: &'static str| if name == fixed { GROUND } else { name };
        let name = format!("Ratio {} ({mode})", request.ratio.get());
        let builder =
            Gearbox::builder(&name).input(input).output(output).gear(gearbox::NAME, [] as [&str; 0]);
        if of_kind.is_pair() {
            let kind = if of_kind == Arrangement::ExternalPair {
                SetKind::ExternalPair
            } else {
                SetKind::InternalPair
            };
            let [first, second] = [self.gears[0], self.gears[1]];
            let members = [first.gear, second.gear, GROUND];
            let set = SetSpec::teeth(gearbox::NAME, kind, members, first.teeth, second.teeth)?;
            return Ok(builder.links([input, output]).set(set).build()?);
        }
        let set = self.compound(request, of_kind, mode);
        let links: Vec<&str> =
            set.centrals.iter().map(|central| central.link.as_str()).chain([link("carrier")]).collect();
        let links: Vec<String> =
            links.into_iter().filter(|link| *link != GROUND).map(str::to_owned).collect();
        Ok(builder.links(links).compound_set(set).build()?)
    }

    /// Compound set with these gears.
    fn compound(&self, request: &Request, arrangement: Arrangement, mode: ArrangementMode) -> CompoundSpec {
        let link = |name: &'static str| if name == mode.fixed.name() { GROUND } else { name };
        let places = arrangement.gears();
        let steps: Vec<usize> =
            (0..places.len()).filter(|gear| places[*gear].role == SimpleGear::Planet).collect();
        let is_one = self.has_one_step(&steps, arrangement);
        let mut set = CompoundSpec::new(gearbox::NAME, link("carrier"));
        // Central gears come first, then those of the planets.
        let mut order: Vec<&ArrangedGear> = vec![];
        for (place, gear) in places.iter().zip(&self.gears) {
            let kind = match place.role {
                SimpleGear::Planet => continue,
                SimpleGear::Ring => CentralKind::Ring,
                _ => CentralKind::Sun,
            };
            set = set.central(kind, link(gear.gear), f64::from(gear.teeth));
            order.push(gear);
        }
        let [first, second] = [&self.gears[steps[0]], &self.gears[steps[1]]];
        order.extend(if is_one { vec![first] } else { vec![first, second] });
        let names = match arrangement {
            Arrangement::Ravigneaux => {
                set = set.planet(first.gear, &[first.teeth]).planet(second.gear, &[second.teeth]);
                [first.gear, second.gear]
            }
            _ if is_one => {
                set = set.planet("planet", &[first.teeth]);
                ["planet"; 2]
            }
            _ => {
                set = set.planet("planet", &[first.teeth, second.teeth]);
                ["planet.1", "planet.2"]
            }
        };
        let name = |gear: usize| match steps.iter().position(|step| *step == gear) {
            Some(step) => names[step],
            None => link(self.gears[gear].gear),
        };
        for [one, other] in arrangement.meshes() {
            set = set.mesh(name(*one), name(*other), MeshEfficiency::IDEAL);
        }
        if order.iter().any(|gear| gear.tool.is_some()) {
            let of = |value: fn(&ArrangedGear) -> f64| order.iter().map(|gear| value(gear)).collect();
            set.tooth_shape.shifts = Some(Shifts {
                profile: of(|gear| gear.profile_shift),
                tips: Some(of(|gear| gear.tip_alteration)),
            });
            let cutting = |gear: &&ArrangedGear| gear.tool.map(|tool| tool.cutting()).unwrap_or_default();
            set.tooth_shape.cutting = order.iter().map(cutting).collect();
        }
        let set = self.planets.map_or(set.clone(), |planets| set.planet_count(planets));
        let stated = || request.angles.iter().map(|angle| angle.0).collect();
        set.spaced(if request.angles.is_empty() {
            Spacing::Placed(request.spacing)
        } else {
            Spacing::At(stated())
        })
    }

    /// Whether the steps of the planet are one gear.
    fn has_one_step(&self, steps: &[usize], arrangement: Arrangement) -> bool {
        let teeth = |step: &usize| self.gears[*step].teeth;
        let all_equal = steps.windows(2).all(|two| teeth(&two[0]) == teeth(&two[1]));
        arrangement.has_steps() && all_equal && self.module_ratio == 1.0
    }
}
