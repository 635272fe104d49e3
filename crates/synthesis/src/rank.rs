//! Rating of a solution: figures by the solver at its best ring-to-sun ratios, the Pareto front, the best by
//! an order.
//!
//! Objectives, with the better direction:
//! - [`Drawable`](Objective::Drawable), 0 is better: 1 if links would cross in the scheme, with all shift
//!   elements ([`epicyclic_layout`]).
//! - [`Shifts`](Objective::Shifts), less: shifts between neighbouring forward gears that exchange more than
//!   one shift element.
//! - [`Efficiency`](Objective::Efficiency), more: the least η of a forward gear, 0 if the losses hold one;
//!   with shares of time their mean η.
//! - [`Drag`](Objective::Drag), less: the mean over the forward gears of `Σ abs(ω_1 − ω_2)/ω_in` over the
//!   open shift elements.
//! - [`Torque`](Objective::Torque), less: the greatest torque of a shift element or a member of a set in any
//!   gear, over the input's, with losses.
//! - [`Speed`](Objective::Speed), less: the greatest speed of a link, or of a planet relative to its carrier,
//!   in any gear, over the input's.
//! - [`Circulation`](Objective::Circulation), less: the greatest circulating power of a gear, over the power
//!   that enters, with losses.
//! - [`Progression`](Objective::Progression), less: the greatest ratio of a step to the previous step; at or
//!   below 1 the steps fall throughout.
//! - [`Deviation`](Objective::Deviation), less: the greatest deviation of a ratio, over half its bounds'
//!   width.
//! - [`Reverse`](Objective::Reverse), more: the least η of a reverse gear, 0 if the losses hold one, 1
//!   without a reverse gear.
//!
//! The drag measure holds no torque of an open shift element, which depends on its size, oil and clearances:
//! it compares gearboxes of the same shift elements. With fewer than two steps between forward gears no
//! progression exists, and all are equal in it.
//!
//! Objectives are not weighed against each other. A solution dominates another if it is nowhere worse and
//! somewhere better; the front holds the non-dominated solutions. Objectives are compared in steps of 10⁻⁵,
//! since the best `k` are found to 10⁻⁴ of the deviation.

use crate::judge::{Judged, planet_speed};
use crate::tolerance::ALIKE;
use epicyclic_layout::is_drawable;
use epicyclic_train::Analysis;
use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

/// Number of objectives.
const COUNT: usize = 10;

/// Objective by which a solution is rated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Objective"))]
pub enum Objective {
    /// Drawability of the scheme without links that cross.
    Drawable,
    /// Number of shifts between neighbouring forward gears that exchange more than one shift element; less is
    /// better.
    Shifts,
    /// Efficiency of the forward gears: the least, or the mean weighted by the parts of the time; more is
    /// better.
    Efficiency,
    /// Mean drag over the forward gears: the sum of the slips of the open shift elements; less is better.
    Drag,
    /// Greatest torque of a shift element or a member of a set; less is better.
    Torque,
    /// Greatest speed of a link, or planet speed relative to its carrier; less is better.
    Speed,
    /// Greatest circulating power; less is better.
    Circulation,
    /// Greatest ratio of a step to the previous step; less is better.
    Progression,
    /// Greatest deviation of a ratio over half the width of its bounds; less is better.
    Deviation,
    /// Least efficiency of a reverse gear; more is better.
    Reverse,
}

/// A name of no objective.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{name}` is no objective: there are {}", Objective::ALL.map(Objective::name).join(", "))]
pub struct UnknownObjective {
    /// The name.
    pub name: String,
}

impl Objective {
    /// Objectives, in the order in which they decide by default.
    pub const ALL: [Self; COUNT] = [
        Self::Drawable,
        Self::Shifts,
        Self::Efficiency,
        Self::Drag,
        Self::Torque,
        Self::Speed,
        Self::Circulation,
        Self::Progression,
        Self::Deviation,
        Self::Reverse,
    ];

    /// Name of the objective.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// Order of all objectives that begins with the given ones.
    #[must_use]
    pub fn order(first: &[Self]) -> Vec<Self> {
        let mut order: Vec<Self> = Vec::new();
        for objective in first.iter().copied().chain(Self::ALL) {
            if !order.contains(&objective) {
                order.push(objective);
            }
        }
        order
    }
}

impl fmt::Display for Objective {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Objective {
    type Err = UnknownObjective;

    fn from_str(name: &str) -> Result<Self, UnknownObjective> {
        let known = Self::ALL.into_iter().find(|objective| objective.name() == name);
        known.ok_or_else(|| UnknownObjective { name: name.into() })
    }
}

/// Figures of a gear at the best ring-to-sun ratios, by the solver.
#[derive(Debug, Clone, PartialEq)]
pub struct GearRating {
    /// The greatest torque of a shift element over the input's, with losses.
    pub shift_element_torque: f64,
    /// The greatest torque of a member of a set over the input's, with losses.
    pub member_torque: f64,
    /// Slip of each shift element over the input's speed, `ω_1 − ω_2`: 0 if it is engaged, `None` if a speed
    /// does not follow.
    pub slips: Vec<Option<f64>>,
    /// The sum of the slips of the open shift elements.
    pub drag: f64,
    /// The greatest speed of a link over the input's.
    pub link_speed: f64,
    /// The greatest speed of a planet relative to its carrier, over the input's, as [`planet_speed`] has it.
    pub planet_speed: f64,
    /// Circulating power over the power that enters, with losses.
    pub circulation: f64,
}

/// Rating of a solution.
#[derive(Debug, Clone, PartialEq)]
pub struct Rating {
    /// The gears in the order of the wish.
    pub gears: Vec<GearRating>,
    /// The objectives in the order of [`Objective::ALL`].
    values: [f64; COUNT],
    /// The greatest ratio of a step to the step before; nothing of fewer than two steps.
    pub progression: Option<f64>,
}

impl Rating {
    /// Rates a solution; with shares of time, one for each gear of the wish, by their mean efficiency
    /// ([`Judged::mean_efficiency`]) in place of the least.
    ///
    /// # Errors
    /// Errors of the solver; none are known for a result of [`judge`](crate::judge::judge).
    pub fn of(judged: &Judged, shares: Option<&[f64]>) -> Result<Self, epicyclic_train::Error> {
        let gearbox = &judged.gearbox;
        let gears: Vec<GearRating> = gearbox
            .gears()
            .iter()
            .map(|gear| gearbox.analyze_gear(gear).map(|analysis| GearRating::of(&analysis)))
            .collect::<Result<_, _>>()?;
        let mut forward: Vec<usize> = (0..gears.len()).filter(|gear| judged.ratios[*gear] > 0.0).collect();
        let drag = forward.iter().map(|gear| gears[*gear].drag).sum::<f64>() / forward.len().max(1) as f64;
        forward.sort_by(|one, other| judged.ratios[*other].total_cmp(&judged.ratios[*one]));
        let steps: Vec<f64> =
            forward.windows(2).map(|pair| judged.ratios[pair[0]] / judged.ratios[pair[1]]).collect();
        let progression = steps.windows(2).map(|pair| pair[1] / pair[0]).reduce(f64::max);
        let greatest = |of: fn(&GearRating) -> f64| gears.iter().map(of).fold(0.0, f64::max);
        let values = Objective::ALL.map(|objective| match objective {
            Objective::Drawable => f64::from(u8::from(!is_drawable(gearbox))),
            Objective::Shifts => judged.multiple_shifts as f64,
            Objective::Efficiency => {
                let mean = shares.and_then(|shares| judged.mean_efficiency(shares));
                mean.unwrap_or_else(|| judged.forward_efficiency())
            }
            Objective::Drag => drag,
            Objective::Torque => greatest(|gear| gear.shift_element_torque.max(gear.member_torque)),
            Objective::Speed => greatest(|gear| gear.link_speed.max(gear.planet_speed)),
            Objective::Circulation => greatest(|gear| gear.circulation),
            Objective::Progression => progression.unwrap_or(0.0),
            Objective::Deviation => judged.refined.deviation,
            Objective::Reverse => judged.reverse_efficiency().unwrap_or(1.0),
        });
        Ok(Self { gears, values, progression })
    }

    /// The value of an objective, as the table of the [module](self) has it.
    #[must_use]
    pub fn value(&self, objective: Objective) -> f64 {
        self.values[objective as usize]
    }

    /// Whether the scheme can be drawn without links that cross.
    #[must_use]
    pub fn is_drawable(&self) -> bool {
        self.value(Objective::Drawable) == 0.0
    }

    /// Value of an objective to be minimised, in steps below which solutions count as equal.
    fn cost(&self, objective: Objective) -> f64 {
        let is_more_better = matches!(objective, Objective::Efficiency | Objective::Reverse);
        let sign = if is_more_better { -1.0 } else { 1.0 };
        (sign * self.value(objective) / ALIKE).round()
    }

    /// Compares two ratings by an order of objectives; the better comes first.
    #[must_use]
    pub fn compare(&self, other: &Self, order: &[Objective]) -> Ordering {
        let decides = self.decides(other, order);
        decides.map_or(Ordering::Equal, |objective| self.cost(objective).total_cmp(&other.cost(objective)))
    }

    /// The first objective of an order in which two differ.
    #[must_use]
    pub fn decides(&self, other: &Self, order: &[Objective]) -> Option<Objective> {
        order.iter().copied().find(|objective| self.cost(*objective) != other.cost(*objective))
    }
}

/// Places of the ratings that no other dominates in these objectives, ascending.
#[must_use]
pub fn front(ratings: &[&Rating], objectives: &[Objective]) -> Vec<usize> {
    let costs: Vec<[f64; COUNT]> = ratings
        .iter()
        .map(|rating| {
            Objective::ALL
                .map(|objective| if objectives.contains(&objective) { rating.cost(objective) } else { 0.0 })
        })
        .collect();
    epicyclic_numerics::front::non_dominated(&costs).into_iter().map(|place| place as usize).collect()
}

impl GearRating {
    fn of(analysis: &Analysis<'_>) -> Self {
        let gearbox = analysis.gearbox();
        let largest = |values: &mut dyn Iterator<Item = f64>| values.map(f64::abs).fold(0.0, f64::max);
        let load = analysis.driving().or_else(|| analysis.ideal());
        let slips = analysis.slips().to_vec();
        let engaged = analysis.gear().engaged();
        let open = (0..slips.len()).filter(|place| !engaged.contains(place));
        Self {
            shift_element_torque: load
                .map_or(0.0, |load| largest(&mut load.shift_elements.iter().flatten().copied())),
            member_torque: load
                .map_or(0.0, |load| largest(&mut load.members.iter().flatten().flatten().copied())),
            drag: open.filter_map(|place| slips[place]).map(f64::abs).sum(),
            link_speed: largest(&mut gearbox.link_ids().filter_map(|link| analysis.speed(link))),
            planet_speed: planet_speed(analysis),
            circulation: load.map_or(0.0, |load| analysis.circulating(load)),
            slips,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gearbox::element_name;
    use crate::judge::judge;
    use crate::parts::Bounds;
    use crate::run::{Found, Share, search};
    use crate::wish::Wish;
    use crate::{Class, Kind};
    use epicyclic_gears::efficiency::MeshEfficiency;
    use std::ops::ControlFlow;

    /// Name of the structure, its elements by the links that they join, and the figures.
    type Named = (String, Vec<String>, Judged, Rating);

    fn rated() -> Vec<Named> {
        let gears = [3.059, 1.625, 1.0, 0.696, -2.294f64]
            .map(|ratio| Bounds { least: ratio - 0.01 * ratio.abs(), most: ratio + 0.01 * ratio.abs() });
        let wish = Wish::new(gears.into(), 5, vec![1.4..=4.5; 2]);
        let class = Class::new(Kind::AllSparse, 2, 5).unwrap();
        let found = search(class, &wish, Share::WHOLE, &|_| ControlFlow::Continue(())).unwrap().found;
        let eta = MeshEfficiency::new(0.97).unwrap();
        let rated = |found: &Found| {
            let judged = judge(found, &wish, eta).unwrap();
            let rating = Rating::of(&judged, None).unwrap();
            let elements = found.solution.elements.iter().map(|choices| element_name(choices[0])).collect();
            (found.structure.to_string(), elements, judged, rating)
        };
        found.iter().map(rated).collect()
    }

    #[test]
    fn figures_of_a_four_speed_are_those_by_hand() {
        // 4L60-E, sets 1-a-2 and b-2-c: in the first gear the brake c and the clutch a-c hold the ring of the
        // first set.
        let all = rated();
        let is_it = |(structure, elements, ..): &&Named| {
            structure == "1-a-2 b-2-c" && *elements == ["b", "c", "1-b", "1-c", "a-c"]
        };
        let (.., judged, rating) = all.iter().find(is_it).unwrap();
        let [k1, k2] = judged.refined.k[..] else { panic!("two sets") };
        let first = &rating.gears[0];
        // ω_out = 1/(1 + k₁); ω_a = ω_c = 0; set 2 (sun b, ring output, carrier c at rest): ω_b = −k₂·ω_out.
        let out = 1.0 / (1.0 + k1);
        let b = -k2 * out;
        let slips = [b.abs(), 0.0, (1.0 - b).abs(), 1.0, 0.0];
        assert!((first.drag - slips.iter().sum::<f64>()).abs() < 1e-9, "{first:?}");
        assert_eq!(first.circulation, 0.0);
        assert!(first.link_speed >= 1.0);
        // Reverse: clutch 1-b, brake c: the sun b of set 2 drives, its ring is the output: T_carrier = 1 + k₂
        // without losses.
        let reverse = &rating.gears[4];
        assert!((reverse.member_torque / (1.0 + k2) - 1.0).abs() < 0.04, "{reverse:?}");
    }

    #[test]
    fn nothing_dominates_the_front_and_the_best_is_on_it() {
        let all = rated();
        let ratings: Vec<&Rating> = all.iter().map(|(.., rating)| rating).collect();
        let front = front(&ratings, &Objective::ALL);
        let better = |one: &Rating, other: &Rating| {
            let costs = |rating: &Rating| Objective::ALL.map(|objective| rating.cost(objective));
            epicyclic_numerics::front::dominates(&costs(one), &costs(other))
        };
        for (place, rating) in ratings.iter().enumerate() {
            assert_eq!(front.contains(&place), !ratings.iter().any(|other| better(other, rating)));
        }
        for first in Objective::ALL {
            let order = Objective::order(&[first]);
            let best = (0..ratings.len()).min_by(|a, b| ratings[*a].compare(ratings[*b], &order)).unwrap();
            assert!(front.contains(&best), "the best by {first}");
        }
    }

    #[test]
    fn an_order_has_each_objective_once() {
        let order = Objective::order(&[Objective::Torque, Objective::Drag, Objective::Torque]);
        assert_eq!(order.len(), COUNT);
        assert_eq!(order[..3], [Objective::Torque, Objective::Drag, Objective::Drawable]);
        assert_eq!("speed".parse(), Ok(Objective::Speed));
        assert!("mass".parse::<Objective>().unwrap_err().to_string().contains("drawable, shifts"));
    }
}
