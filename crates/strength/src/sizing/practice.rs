//! Usual practice in a search: the rules that gears, widths and bearings of a design miss.
//!
//! Designs without warnings come first. For the others mass, or ring, is multiplied by [`PRICE`] for each rule
//! with a warning. Remarks do not count, nor does [`Rule::BearingLeastLoad`], which only chooses among
//! bearings. Errors of gears and widths leave designs out, and so does every
//! value outside a range that is stated in place of a usual one. The rules are those of
//! [`practice`](epicyclic_gears::involute::practice) for gears, meshes, widths, gaps and speeds,
//! [`Rule::LoadSharing`], the rims, and for bearings
//! [`Rule::BallLoad`], [`Rule::BearingStaticSafety`], [`Rule::BearingLeastLoad`], those of speed and
//! acceleration that hold for their rolling elements, and [`Rule::PlainLoad`], [`Rule::OilFilm`].

use super::bearing::Bearing;
use super::pin_loads::PinStep;
use super::rated::rim_of;
use super::task::{Body, Layout, Task};
use crate::bearing::BearingStep;
use crate::factor::{Side, Symbol};
use crate::load::load_sharing;
use crate::material::Class;
use crate::plain_bearing::film_ratio;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::Pair;
use epicyclic_gears::involute::practice::{
    of_face_load, of_gap, of_gear, of_mesh, of_speed, of_total_contact, orbit_acceleration, orbit_rule,
    pin_speed, pin_speed_rule, shift_rule, width_diameters,
};
use epicyclic_gears::life::Rolling;
use epicyclic_judge::{Limits, Rule, Severity, Verdict};
use epicyclic_units::Physical;
use std::f64::consts::TAU;
use uom::si::f64::Length;

/// Factor of the objective for each rule with a warning: what a warning fewer may cost.
const PRICE: f64 = 1.25;

/// Whether any rule of usual practice is missed, 0 or 1, and an objective with the price of the rules: a quarter
/// more for each.
#[must_use]
pub fn priced(rules_missed: u32, objective: f64) -> [f64; 2] {
    let is_unusual = if rules_missed == 0 { 0.0 } else { 1.0 };
    [is_unusual, objective * (0..rules_missed).fold(1.0, |all, _| all * PRICE)]
}

/// Rules that verdicts miss with a warning or an error.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Misses {
    /// A bit for each rule.
    rules: u64,
    /// Whether any miss is an error.
    pub(super) is_error: bool,
    /// Rules with a value outside a range that is stated, which is required whatever the severity: a bit for
    /// each.
    against_stated: u64,
}

const _: () = assert!(Rule::ALL.len() <= u64::BITS as usize, "each rule has a bit");

impl Misses {
    fn of(verdicts: impl IntoIterator<Item = Verdict>) -> Self {
        verdicts.into_iter().fold(Self::default(), |all, one| match one.severity {
            None | Some(Severity::Remark) => all,
            Some(severity) => {
                let bit = 1 << one.rule as u32;
                Self {
                    rules: all.rules | bit,
                    is_error: all.is_error || severity == Severity::Error,
                    against_stated: all.against_stated | if one.is_against_stated { bit } else { 0 },
                }
            }
        })
    }

    /// Misses of gears and meshes, whatever their size and load.
    pub(super) fn of_geometry(task: &Task, layout: &Layout, limits: &Limits) -> Self {
        let meshes = layout.pairs.iter().flat_map(|pair| of_mesh(limits, pair)).map(|(_, verdict)| verdict);
        Self::of(of_gears(task, layout, limits).into_iter().chain(meshes))
    }

    /// Misses of both.
    pub(super) fn with(self, other: Self) -> Self {
        Self {
            rules: self.rules | other.rules,
            is_error: self.is_error || other.is_error,
            against_stated: self.against_stated | other.against_stated,
        }
    }

    /// Misses that both have.
    pub(super) const fn of_both(self, other: Self) -> Self {
        Self {
            rules: self.rules & other.rules,
            is_error: self.is_error && other.is_error,
            against_stated: self.against_stated & other.against_stated,
        }
    }

    /// Whether gears and widths with these misses are left out.
    pub(super) const fn is_refused(self) -> bool {
        self.is_error || self.is_against_stated()
    }

    /// Whether a value is outside a range that is stated.
    pub(super) const fn is_against_stated(self) -> bool {
        self.against_stated != 0
    }

    /// Rules with a value outside a range that is stated.
    pub(super) fn against_stated(self) -> impl Iterator<Item = Rule> {
        Rule::ALL.iter().copied().filter(move |rule| self.against_stated & (1 << *rule as u32) != 0)
    }

    /// Misses of values that are kept though they are outside a stated range.
    pub(super) const fn kept(self) -> Self {
        Self { against_stated: 0, ..self }
    }

    /// Number of rules that count against a design. Too little load on a bearing asks for a smaller
    /// bearing, never for larger gears.
    pub(super) const fn count(self) -> u32 {
        (self.rules & !(1 << Rule::BearingLeastLoad as u32)).count_ones()
    }

    /// Number of rules that count against a bearing.
    pub(super) const fn of_bearing(self) -> u32 {
        self.rules.count_ones()
    }
}

/// A mesh whose face width is judged.
#[derive(Debug, Clone)]
struct Width {
    family: usize,
    /// Reference diameter of the smaller gear, m; `None` where the mesh is judged by another one.
    diameter: Option<f64>,
    /// Face load factor that is given for every width.
    face_load: Option<f64>,
    pair: Pair,
    module: f64,
}

/// A layout under the rules.
#[derive(Debug, Clone)]
pub(super) struct Practice {
    /// Misses at any face width.
    pub(super) of_layout: Misses,
    widths: Vec<Width>,
}

impl Practice {
    pub(super) fn of(task: &Task, layout: &Layout, limits: &Limits) -> Self {
        let ends = task.meshes.iter().zip(layout.pairs.iter()).map(|(mesh, pair)| (mesh.gears, pair));
        let diameters = width_diameters(&ends.collect::<Vec<_>>());
        let widths =
            task.meshes.iter().zip(layout.pairs.iter()).zip(diameters).map(|((mesh, pair), diameter)| {
                let family = task.gears[mesh.gears[0]].family;
                let module = layout.modules[family].si();
                Width {
                    family,
                    diameter: diameter.map(|diameter| diameter * module),
                    face_load: mesh
                        .method
                        .given
                        .of(Side::First, Symbol::FaceContact)
                        .filter(|_| !task.widens_face_load),
                    pair: *pair,
                    module,
                }
            });
        let widths = widths.collect();
        let of_loads = of_planets(task, layout, limits).into_iter().chain(of_speeds(task, layout, limits));
        let of_layout = Misses::of_geometry(task, layout, limits).with(Misses::of(of_loads));
        Self { of_layout, widths }
    }

    /// Misses of face widths, and whether a wider one may have fewer.
    pub(super) fn of_widths(&self, limits: &Limits, widths: &[f64]) -> (Misses, bool) {
        let mut is_narrow = false;
        let mut all = Misses::default();
        for Width { family, diameter, face_load, pair, module } in &self.widths {
            let width = widths[*family];
            let ratio = diameter.map(|diameter| width / diameter);
            let of_ratio = ratio.map(|ratio| limits.judge(Rule::FaceWidth, ratio));
            let of_load = ratio.zip(*face_load).map(|(ratio, given)| of_face_load(limits, ratio, given));
            // More width helps where it or the overlap is too small; it needs more of the face load factor.
            let small = of_ratio.into_iter().chain(of_total_contact(limits, pair, width / module));
            for one in small.chain(of_load) {
                let own = Misses::of([one]);
                is_narrow |= own.count() > 0 && one.rule != Rule::FaceLoad && one.value < one.limit;
                all = all.with(own);
            }
        }
        (all, is_narrow)
    }
}

/// Shifts, case-hardened tips, and rims of rings.
fn of_gears(task: &Task, layout: &Layout, limits: &Limits) -> Vec<Verdict> {
    let is_of_pair = task.planets.is_empty();
    let of = |(place, gear)| {
        let sized = &task.gears[place];
        let own = task.meshes.iter().zip(layout.pairs.iter()).filter(|(mesh, _)| mesh.gears.contains(&place));
        let rule = shift_rule(gear, sized.body != Body::Central, is_of_pair);
        let is_hardened = sized.gear.material.class == Class::CaseHardened;
        let verdicts = of_gear(limits, rule, gear, own.map(|(_, pair)| pair), is_hardened);
        let module = layout.module(task, place);
        let rim = (gear.kind() == GearKind::Internal).then(|| task.ring_rim(place, module).si());
        let rim = rim.map(|rim| limits.judge(Rule::RingRim, rim / module.si()));
        // Rims are asked for, and so are shifts that a file states.
        let rim = rim.map(|verdict| verdict.no_worse_than(Severity::Warning));
        let is_stated = task.has_stated_shifts;
        let stated = move |one: Verdict| if is_stated { one.no_worse_than(Severity::Warning) } else { one };
        verdicts.into_iter().map(stated).chain(rim)
    };
    layout.gears.iter().enumerate().flat_map(of).collect()
}

/// Gaps between planets, and a load sharing factor that is given.
fn of_planets(task: &Task, layout: &Layout, limits: &Limits) -> Vec<Verdict> {
    let planets = layout.planets;
    let mut all = vec![];
    let angle = task.least_planet_angle.map_or(TAU / f64::from(planets), Physical::si);
    for kind in 0..task.planets.len() {
        let radius = layout.radii[kind].si();
        for gear in task.gears_of(kind).filter(|_| planets > 1 && radius > 0.0) {
            let module = layout.module(task, gear).si();
            all.extend(of_gap(limits, &layout.gears[gear], radius / module, angle, Some(module)));
        }
    }
    if let Some(method) = task.meshes.first().map(|mesh| mesh.method).filter(|_| planets > 1)
        && let Some(given) = method.given.of(Side::First, Symbol::LoadSharing)
        && let Ok(usual) = load_sharing(planets, method.floating)
    {
        all.push(limits.judge_least(Rule::LoadSharing, usual, given));
    }
    all
}

/// Pitch-line speeds in the steps that load the set, and in those without a share of the time, which are speeds
/// that come a few times.
fn of_speeds(task: &Task, layout: &Layout, limits: &Limits) -> Vec<Verdict> {
    let loads = &layout.loads;
    let counts = |step: &usize| {
        let own = |mesh: &super::MeshLoads| {
            mesh.steps.get(*step).is_some_and(|of| of.torque.si() != 0.0 || of.share == 0.0)
        };
        loads.iter().any(own)
    };
    let of = |(place, pair): (usize, &Pair)| {
        let steps = loads[place].steps.iter().enumerate().filter(|(step, _)| counts(step));
        let fastest = steps.map(|(_, step)| step.speed.si().abs()).fold(0.0, f64::max);
        let module = layout.module(task, task.meshes[place].gears[0]).si();
        of_speed(limits, pair, fastest * pair.gears()[0].reference_diameter() * module / 2.0)
    };
    layout.pairs.iter().enumerate().map(of).collect()
}

/// Misses of a kind of planets over their bearing, and of their rims over its bore.
pub(super) fn of_pin(
    (task, layout, kind): (&Task, &Layout, usize),
    limits: &Limits,
    (bearing, duty): (Option<&Bearing>, &[PinStep]),
    bore: f64,
) -> Misses {
    let rim = |gear: usize| {
        let rim = rim_of(task, layout, gear, bore) / layout.module(task, gear).si();
        limits.judge(Rule::PlanetRim, rim)
    };
    let rims = task.gears_of(kind).filter(|_| bore > 0.0).map(rim);
    let mut all: Vec<Verdict> = rims.collect();
    let pin = &task.planets[kind].pin;
    let rolling = bearing.map_or(pin.rolling, |bearing| bearing.rolling);
    let fastest = layout.bearing_loads[kind].iter().map(|step| step.carrier_speed.si().abs());
    let acceleration = orbit_acceleration(layout.radii[kind].si(), fastest.fold(0.0, f64::max));
    all.extend(orbit_rule(rolling).map(|rule| limits.judge(rule, acceleration)));
    if let Some(bearing) = bearing {
        // Overloads come without a share of the time, and count for the static safety alone.
        let at_rest = duty.iter().map(|pin| pin.at_rest.si()).fold(0.0, f64::max);
        let rating = bearing.static_load_rating.filter(|_| at_rest > 0.0);
        all.extend(rating.map(|rating| limits.judge(Rule::BearingStaticSafety, rating.si() / at_rest)));
        all.extend(match rolling {
            Rolling::Plain => of_film(task, limits, bearing, duty),
            _ => of_rolling(limits, bearing, duty, pin.mean_diameter),
        });
    }
    Misses::of(all)
}

/// Load and oil film of a plain bearing; of a stated one, whose width is not known here, nothing.
fn of_film(task: &Task, limits: &Limits, bearing: &Bearing, duty: &[PinStep]) -> Vec<Verdict> {
    if bearing.width.si() == 0.0 {
        return vec![];
    }
    let steps: Vec<BearingStep> = duty.iter().map(|pin| pin.step).collect();
    let loads = steps.iter().filter(|step| step.share > 0.0).map(|step| step.load.si());
    let load = limits.judge(Rule::PlainLoad, loads.fold(0.0, f64::max) / bearing.load_rating.si());
    let film = film_ratio([bearing.outside_diameter, bearing.width], &steps, task.bearing_oil());
    film.map(|ratio| limits.judge(Rule::OilFilm, ratio)).into_iter().chain([load]).collect()
}

/// Load and speed of a bearing with rolling elements.
fn of_rolling(
    limits: &Limits,
    bearing: &Bearing,
    duty: &[PinStep],
    stated_diameter: Option<Length>,
) -> Vec<Verdict> {
    let mut all = vec![];
    if bearing.rolling == Rolling::Balls {
        let forces = duty.iter().filter(|pin| pin.step.share > 0.0).map(|pin| pin.force.si());
        all.push(limits.judge(Rule::BallLoad, forces.fold(0.0, f64::max) / 1e3));
    }
    // A bearing at rest needs no load to keep its elements rolling.
    let turning = duty.iter().map(|pin| pin.step);
    let turning = turning.filter(|step| step.share > 0.0 && step.speed.si() != 0.0);
    let turning = turning.map(|step| step.load.si()).filter(|load| *load > 0.0);
    if let Some(least) = turning.reduce(f64::min) {
        all.push(limits.judge(Rule::BearingLeastLoad, least / bearing.load_rating.si()));
    }
    if let Some(diameter) = bearing.mean_diameter().or(stated_diameter) {
        let fastest = duty.iter().map(|pin| pin.step.speed.si().abs()).fold(0.0, f64::max);
        let speed = pin_speed(fastest, diameter.si());
        all.extend(pin_speed_rule(bearing.rolling).map(|rule| limits.judge(rule, speed)));
    }
    all
}
