//! Limits to relax if no gearbox is found, each with the gearbox that is then found.
//!
//! Every way out is the result of a search with the limit relaxed. The same command with the relaxed limit
//! finds the same gearbox.

use super::front::{front, largest_ring};
use super::records::TeethTaken;
use super::{Design, SizeRequest, Wanted, attempted, attempted_with};
use crate::error::Error;
use crate::select::answer::candidate::Criterion;
use crate::select::answer::reached::{ReachedSpeed, largest_deviation};
use crate::select::answer::teeth::Watch;
use crate::select::answer::{self as select, Relaxation, RelaxedCriterion};
use crate::shared::bearing_type::BearingType;
use epicyclic_selection::Space;
use epicyclic_strength::load::MOST_SHARING;
use epicyclic_units::{Number, Physical, Quantity};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::RangeInclusive;
use uom::si::f64::Length;

/// Limits to relax, with the gearbox that is then found.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct WayOut {
    /// Limits that must be relaxed together.
    pub limits: Vec<RelaxedLimit>,
    /// Scheme: its name in the source, or that of its structure.
    pub scheme: String,
    /// Speeds of the gears, required and reached, the slowest first.
    pub speeds: Vec<ReachedSpeed>,
    /// Tooth numbers and mass of the gearbox.
    pub teeth: TeethTaken,
    /// Mass of the whole in kg.
    pub whole_kg: Option<f64>,
    /// Greatest outside diameter of a ring, in m.
    pub ring_diameter_m: f64,
}

/// Limits, with the stages in series that are found with them.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct WayOutOfStages {
    /// Limits: those that must be relaxed together, or that of a smaller ring.
    pub limits: Vec<RelaxedLimit>,
    /// Tooth numbers of each stage, from the input on: of sun, planet and ring, or of both gears of a pair, the
    /// faster first.
    pub teeth: Vec<Vec<u32>>,
    /// Ratio of the train.
    pub ratio: f64,
    /// Greatest outside diameter of a ring, in m.
    pub ring_diameter_m: f64,
    /// Efficiency of the meshes of all stages; null if their losses hold the train.
    pub efficiency: Option<f64>,
    /// Mass of gears, carriers and housing by a rule, and of the slow shaft, in kg.
    pub whole_kg: Option<f64>,
    /// Rules of usual practice that the stages miss.
    pub rules_missed: u32,
}

/// Limit with a sufficient value.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct RelaxedLimit {
    /// Name of the limit.
    pub limit: Limit,
    /// Sufficient lower limit; null for limits without one.
    pub least: Option<f64>,
    /// Sufficient upper limit; null for limits without one.
    pub greatest: Option<f64>,
}

/// Limits of a design that can be relaxed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    /// Relative deviation of ratios and speeds.
    Tolerance,
    /// Ring-to-sun ratios.
    RingToSunRatio,
    /// Efficiency of a gear.
    Efficiency,
    /// Speed of a link relative to the input speed.
    LinkSpeed,
    /// Planet speed relative to its carrier, relative to the input speed.
    PlanetSpeed,
    /// Slip of the direct-drive clutch relative to the input speed.
    ClutchSlip,
    /// Circulating power relative to the entering power.
    Circulation,
    /// Same direction of the output in all gears; removed.
    SameDirection,
    /// Restriction to drawable schemes; removed.
    Drawable,
    /// Restriction to the schemes of the source; all structures.
    Structures,
    /// Tooth number of the suns.
    SunTeeth,
    /// Tooth number of the planets.
    PlanetTeeth,
    /// Tooth number of the rings.
    RingTeeth,
    /// Ring offset: tooth number of the ring minus that of the sun minus twice that of the planet.
    RingOffset,
    /// Face width over the sun's reference diameter.
    WidthRatio,
    /// Modules; relaxed to the standard series.
    Modules,
    /// Face widths; relaxed to the default ones.
    FaceWidths,
    /// Greatest outside diameter of a ring, in m.
    LargestRing,
    /// Greatest mass of the whole, in kg.
    WholeMass,
    /// Greatest length of the stages along the axis, in m.
    Length,
    /// Number of planets.
    Planets,
    /// Number of stages in series.
    Stages,
    /// Restriction to gears without common divisors; removed.
    HuntingTeeth,
    /// Rolling bearings of the planets: plain bearings.
    PlainBearings,
    /// Bearings of the planets: planets without bearings.
    Bearings,
    /// Shafts in one line; relaxed to either kind of fast stage.
    Axes,
    /// Kinds of stages; all.
    StageKinds,
}

/// Factors on a limit that is just sufficient for exact ratios. Real tooth numbers only come close and may
/// need slightly more.
const MARGINS: [f64; 3] = [1.0, 1.05, 1.15];

/// Largest tolerance that is tried: that of the source.
pub(super) const GREATEST_TOLERANCE: f64 = 0.1;

/// Least tooth number of sun and planet, and largest of rings, that are tried if the given bounds yield
/// nothing.
const TEETH: RangeInclusive<u32> = 12..=200;

/// Ring offsets that are tried if sets without an offset yield nothing.
pub(super) const OFFSETS: RangeInclusive<i32> = -3..=3;

/// Finds the ways out for a design without a gearbox.
pub(super) fn of(
    wanted: &Wanted,
    design: &Design,
    relaxations: &[Relaxation],
    watch: &Watch,
) -> Result<Vec<WayOut>, Error> {
    let search = Search { wanted, watch };
    let mut ways = vec![];
    if let Some(least) = design.limits.lightest_kg {
        let greatest = Some(rounded(least, f64::ceil));
        ways.extend(
            search
                .with(&[RelaxedLimit { greatest, ..RelaxedLimit::lifted(Limit::WholeMass) }])?
                .map(|(way, _)| way),
        );
        return Ok(ways);
    }
    if design.teeth.is_none() {
        for relaxation in relaxations {
            ways.extend(search.of_criteria(&relaxation.limits().collect::<Vec<_>>(), &[])?);
        }
        if wanted.mechanism.is_none() && !matches!(wanted.selection.space, Space::All) {
            ways.extend(search.of_all_structures(ways.is_empty())?);
        }
        ways.extend(search.of_tolerance()?);
    } else {
        ways.extend(search.of_tolerance()?);
        ways.extend(search.of_tooth_bounds()?);
        ways.extend(search.of_sizes(design.sizes.is_some())?);
        if wanted.selection.requirements.limits.same_direction {
            let direction = RelaxedCriterion { criterion: Criterion::SameDirection, limit: None };
            ways.extend(search.of_criteria(&[direction], &[])?);
        }
    }
    Ok(ways)
}

/// The gearbox taken, with the limits under which it was found; `None` without one.
fn way(limits: &[RelaxedLimit], design: &Design) -> Option<WayOut> {
    design.file.as_ref()?;
    Some(WayOut {
        limits: limits.to_vec(),
        scheme: design.scheme.taken.clone()?,
        speeds: design.speeds.clone(),
        teeth: design.teeth.as_ref()?.taken.clone()?,
        whole_kg: design.masses.map(|masses| masses.whole_kg),
        ring_diameter_m: largest_ring(design.sizes.as_ref()),
    })
}

/// The best gearboxes with smaller rings than that of a design, with its kinds of bearings and modules.
pub(super) fn smaller_rings(wanted: &Wanted, design: &Design, watch: &Watch) -> Result<Vec<WayOut>, Error> {
    let mut wanted = Wanted { tooth_design: None, ..wanted.clone() };
    front(largest_ring(design.sizes.as_ref()), |most| {
        let limit = RelaxedLimit::of_rings(most);
        limit.relax(&mut wanted);
        let (design, _) = attempted_with(&wanted, watch)?;
        Ok(way(&[limit], &design).map(|way| (way.clone(), way.ring_diameter_m)))
    })
}

/// Search for a gearbox with relaxed limits.
struct Search<'a> {
    wanted: &'a Wanted,
    watch: &'a Watch<'a>,
}

impl Search<'_> {
    /// Gearbox with these limits; `None` if none exists.
    fn with(&self, limits: &[RelaxedLimit]) -> Result<Option<(WayOut, Design)>, Error> {
        let mut wanted = self.wanted.clone();
        limits.iter().for_each(|limit| limit.relax(&mut wanted));
        let design = attempted(&wanted, self.watch)?.design;
        Ok(way(limits, &design).map(|way| (way, design)))
    }

    /// Search with limits that just suffice for a scheme with exact ratios, or slightly more.
    fn of_criteria(
        &self,
        criteria: &[RelaxedCriterion],
        more: &[RelaxedLimit],
    ) -> Result<Option<WayOut>, Error> {
        let has_value = criteria.iter().any(|one| one.limit.is_some());
        for margin in MARGINS.into_iter().take(if has_value { MARGINS.len() } else { 1 }) {
            let k = &self.wanted.selection.requirements.limits.ring_to_sun;
            let limits = criteria.iter().map(|one| RelaxedLimit::of(*one, margin, k));
            let limits: Vec<RelaxedLimit> = limits.chain(more.iter().copied()).collect();
            if let Some((way, _)) = self.with(&limits)? {
                return Ok(Some(way));
            }
        }
        Ok(None)
    }

    /// Search among all structures; if these have none either, with relaxed criteria too.
    fn of_all_structures(&self, deeper: bool) -> Result<Vec<WayOut>, Error> {
        let structures = RelaxedLimit::lifted(Limit::Structures);
        if let Some((way, _)) = self.with(&[structures])? {
            return Ok(vec![way]);
        }
        let mut ways = vec![];
        if deeper {
            let selection = &self.wanted.selection;
            let all = select::answer(&select::Wanted { space: Space::All, ..selection.clone() })?;
            for relaxation in &all.relaxations {
                ways.extend(self.of_criteria(&relaxation.limits().collect::<Vec<_>>(), &[structures])?);
            }
        }
        Ok(ways)
    }

    /// Search with a wider tolerance. The result uses the tolerance that the gearbox found with the widest
    /// one needs, if a gearbox is found with that, too.
    fn of_tolerance(&self) -> Result<Option<WayOut>, Error> {
        if self.wanted.selection.requirements.tolerance >= GREATEST_TOLERANCE {
            return Ok(None);
        }
        let tolerance =
            |greatest| RelaxedLimit { greatest: Some(greatest), ..RelaxedLimit::lifted(Limit::Tolerance) };
        let Some((widest, design)) = self.with(&[tolerance(GREATEST_TOLERANCE)])? else { return Ok(None) };
        let needed = rounded(largest_deviation(&design.speeds), f64::ceil);
        Ok(Some(self.with(&[tolerance(needed)])?.map_or(widest, |(way, _)| way)))
    }

    /// Search with more tooth numbers: each bound relaxed separately, then offsets of the ring.
    fn of_tooth_bounds(&self) -> Result<Vec<WayOut>, Error> {
        let bounds = &self.wanted.bounds;
        let least =
            |limit| RelaxedLimit { least: Some(f64::from(*TEETH.start())), ..RelaxedLimit::lifted(limit) };
        let greatest =
            |limit| RelaxedLimit { greatest: Some(f64::from(*TEETH.end())), ..RelaxedLimit::lifted(limit) };
        let offsets = RelaxedLimit {
            limit: Limit::RingOffset,
            least: Some(f64::from(*OFFSETS.start())),
            greatest: Some(f64::from(*OFFSETS.end())),
        };
        let all = [
            (least(Limit::SunTeeth), bounds.sun.start() > TEETH.start()),
            (least(Limit::PlanetTeeth), bounds.planet.start() > TEETH.start()),
            (greatest(Limit::RingTeeth), bounds.ring.end() < TEETH.end()),
            (offsets, self.wanted.ring_offsets.is_none()),
        ];
        let mut ways = vec![];
        for (limit, _) in all.into_iter().filter(|(_, is_narrow)| *is_narrow) {
            ways.extend(self.with(&[limit])?.map(|(way, _)| way));
        }
        Ok(ways)
    }

    /// Search with more sizes, if there are tooth numbers.
    fn of_sizes(&self, has_teeth: bool) -> Result<Vec<WayOut>, Error> {
        let own = &self.wanted.size;
        let most = MOST_SHARING;
        let planets =
            RelaxedLimit { greatest: Some(f64::from(most)), ..RelaxedLimit::lifted(Limit::Planets) };
        let all = [
            (RelaxedLimit::lifted(Limit::Modules), own.modules.is_some()),
            (RelaxedLimit::lifted(Limit::FaceWidths), own.face_widths.is_some()),
            (RelaxedLimit::lifted(Limit::LargestRing), own.max_ring.is_some()),
            (planets, *own.planet_counts().end() < most),
            (RelaxedLimit::lifted(Limit::PlainBearings), own.lacks_plain_bearings()),
            (RelaxedLimit::lifted(Limit::Bearings), !own.no_bearings),
        ];
        let mut ways = vec![];
        for (limit, _) in all.into_iter().filter(|(_, is_narrow)| has_teeth && *is_narrow) {
            ways.extend(self.with(&[limit])?.map(|(way, _)| way));
        }
        if own.width_ratio.is_some() && has_teeth {
            let lifted = RelaxedLimit::lifted(Limit::WidthRatio);
            if let Some((way, design)) = self.with(&[lifted])? {
                let sets = design.sizes.iter().flat_map(|sizes| &sizes.sets);
                let families = sets.filter_map(|set| set.found.first()).flat_map(|design| &design.families);
                let needed = families.map(|family| family.face_width_over_diameter).fold(0.0, f64::max);
                let needed = RelaxedLimit { greatest: Some(rounded(needed, f64::ceil)), ..lifted };
                ways.push(self.with(&[needed])?.map_or(way, |(way, _)| way));
            }
        }
        Ok(ways)
    }
}

impl RelaxedLimit {
    /// Limit that is removed, without a value.
    pub(super) const fn lifted(limit: Limit) -> Self {
        Self { limit, least: None, greatest: None }
    }

    /// Limit of the rings, of three digits and not above a diameter in m.
    pub(super) fn of_rings(most: f64) -> Self {
        Self { greatest: Some(rounded(most, f64::floor)), ..Self::lifted(Limit::LargestRing) }
    }

    /// Limit of a criterion, relaxed by a margin and rounded to three digits on the safe side.
    fn of(one: RelaxedCriterion, margin: f64, k: &RangeInclusive<f64>) -> Self {
        let value = one.limit.unwrap_or_default();
        let greatest =
            |limit| Self { greatest: Some(rounded(margin * value, f64::ceil)), ..Self::lifted(limit) };
        match one.criterion {
            Criterion::RatioError => greatest(Limit::Tolerance),
            Criterion::RingToSunRatio => {
                let (least, most) = (*k.start(), *k.end());
                // Ring-to-sun ratios are above 1, so the margin acts on the part above 1.
                let low = rounded(1.0 + (value - 1.0) / margin, f64::floor);
                let high = rounded(margin * value, f64::ceil);
                let [least, most] = if value < least { [low, most] } else { [least, high] };
                Self { limit: Limit::RingToSunRatio, least: Some(least), greatest: Some(most) }
            }
            Criterion::Efficiency => {
                let least = rounded(1.0 - (1.0 - value) * margin, f64::floor);
                Self { least: Some(least), ..Self::lifted(Limit::Efficiency) }
            }
            Criterion::LinkSpeed => greatest(Limit::LinkSpeed),
            Criterion::PlanetSpeed => greatest(Limit::PlanetSpeed),
            Criterion::ClutchSlip => greatest(Limit::ClutchSlip),
            Criterion::Circulation => greatest(Limit::Circulation),
            Criterion::SameDirection => Self::lifted(Limit::SameDirection),
            Criterion::Drawable => Self::lifted(Limit::Drawable),
        }
    }

    fn relax(self, wanted: &mut Wanted) {
        let requirements = &mut wanted.selection.requirements;
        let limits = &mut requirements.limits;
        let greatest = self.greatest.unwrap_or(f64::INFINITY);
        match self.limit {
            Limit::Tolerance => requirements.tolerance = greatest,
            Limit::RingToSunRatio => {
                limits.ring_to_sun = self.least.unwrap_or(1.0)..=greatest;
                wanted.bounds.ring_to_sun_ratio = limits.ring_to_sun.clone();
            }
            Limit::Efficiency => limits.efficiency = self.least.unwrap_or_default(),
            Limit::LinkSpeed => limits.link_speed = greatest,
            Limit::PlanetSpeed => limits.planet_speed = greatest,
            Limit::ClutchSlip => limits.clutch_slip = greatest,
            Limit::Circulation => limits.circulation = greatest,
            Limit::SameDirection => limits.same_direction = false,
            Limit::Drawable => limits.drawable = false,
            Limit::Structures => wanted.selection.space = Space::All,
            Limit::SunTeeth => wanted.bounds.sun = *TEETH.start()..=*wanted.bounds.sun.end(),
            Limit::PlanetTeeth => wanted.bounds.planet = *TEETH.start()..=*wanted.bounds.planet.end(),
            Limit::RingTeeth => wanted.bounds.ring = *wanted.bounds.ring.start()..=*TEETH.end(),
            Limit::RingOffset => wanted.ring_offsets = Some(OFFSETS),
            Limit::Planets => {
                wanted.bounds.planets = *wanted.bounds.planets.start()..=greatest as u32;
                self.relax_size(&mut wanted.size);
            }
            Limit::WidthRatio
            | Limit::Modules
            | Limit::FaceWidths
            | Limit::LargestRing
            | Limit::PlainBearings
            | Limit::Bearings => self.relax_size(&mut wanted.size),
            Limit::WholeMass => wanted.limits.whole_kg = self.greatest,
            // Of stages in series.
            Limit::Length | Limit::Stages | Limit::HuntingTeeth | Limit::Axes | Limit::StageKinds => {}
        }
    }

    /// Relaxes a limit of sizes.
    pub(super) fn relax_size(self, size: &mut SizeRequest) {
        match self.limit {
            Limit::WidthRatio => {
                size.width_ratio = self.greatest.and_then(|greatest| Number::new(greatest).ok());
            }
            Limit::Modules => size.modules = None,
            Limit::FaceWidths => size.face_widths = None,
            Limit::PlainBearings => size.bearing_type = Some(vec![BearingType::Plain]),
            Limit::Bearings => {
                (size.no_bearings, size.bearing_type, size.bearings) = (true, None, None);
            }
            Limit::LargestRing => {
                size.max_ring = self.greatest.map(|greatest| Quantity(Length::from_si(greatest)));
            }
            Limit::Planets => {
                let most = self.greatest.map_or(MOST_SHARING, |greatest| greatest as u32);
                size.planets = Some(*size.planet_counts().start()..=most);
            }
            _ => {}
        }
    }
}

/// Rounds to three significant digits; `round` acts on the last.
pub(crate) fn rounded(value: f64, round: fn(f64) -> f64) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    let digit = libm::log10(value.abs()).floor() - 2.0;
    // A power of ten with a negative exponent is inexact; dividing by a whole one keeps the digits.
    if digit < 0.0 {
        let unit = libm::pow(10.0, -digit);
        round(value * unit) / unit
    } else {
        let unit = libm::pow(10.0, digit);
        round(value / unit) * unit
    }
}
