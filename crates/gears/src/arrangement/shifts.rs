//! Profile shifts of arrangements whose centre distances differ.
//!
//! The carrier radius of a planet is the middle of the least and the greatest centre distance of its meshes
//! without shift ([`ArrangedTeeth::carrier_radius`]). Gears that meshes with central gears join are a
//! [tree of meshes](crate::involute::tree) at these distances, whose shifts and tips an aim picks among those
//! without faults:
//!
//! | arrangement | trees |
//! |---|---|
//! | stepped | `a`–`g`, `f`–`b`, and so for two suns or rings |
//! | Wolfrom | `a`–`g`–`b`, `f`–`e` |
//! | Ravigneaux | `a`–`g`, `c`–`f`–`b`; the mesh of `g` and `f` leaves its distance free |
//! | planet of one gear | all gears |
//!
//! The mesh of two planets is checked with the shifts that its trees have; other shifts are not tried for it.

use super::numbers::{ArrangedTeeth, Shape, least_angle_rad};
use super::{Arrangement, GearPlace, MOST_GEARS};
use crate::gear_kind::GearKind;
use crate::involute::check::{Check, Rule, Severity};
use crate::involute::checks::{Limits, mesh_checks};
use crate::involute::family::Aim;
use crate::involute::fault::ShiftFault;
use crate::involute::shifts::StatedDistance;
use crate::involute::tree::{MeshTree, NoShifts, Place};
use crate::involute::{InvoluteGear, Pair, Profile};
use crate::quantity::SimpleGear;
use crate::rack::BasicRack;
use crate::{Error, ToothCount};
use epicyclic_units::Physical;
use std::collections::HashMap;
use std::fmt;
use uom::si::f64::Angle;

/// Profile shifts and tip alterations of the gears of an arrangement, in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArrangedShifts {
    gears: usize,
    profile: [f64; MOST_GEARS],
    tips: [f64; MOST_GEARS],
    /// Whether the aim is met in full.
    pub is_aim_met: bool,
}

impl ArrangedShifts {
    /// Profile shift of each gear; of a ring positive inwards.
    #[must_use]
    pub fn profile(&self) -> &[f64] {
        &self.profile[..self.gears]
    }

    /// Tip alteration of each gear; negative for shorter teeth.
    #[must_use]
    pub fn tips(&self) -> &[f64] {
        &self.tips[..self.gears]
    }
}

/// Place of a check in an arrangement.
#[derive(Debug, Clone, Copy)]
pub(super) enum Spot {
    Gear(GearPlace),
    Mesh([GearPlace; 2]),
    Tips([GearPlace; 2]),
}

impl fmt::Display for Spot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Gear(gear) => write!(f, "the {gear}"),
            Self::Mesh([one, other]) => write!(f, "the mesh of {one} and {other}"),
            Self::Tips([of, with]) => write!(f, "the tips of the {of}, mesh with the {with},"),
        }
    }
}

/// Gears that meshes join at the carrier radius of one planet.
struct Tree {
    gears: Vec<usize>,
    meshes: Vec<[usize; 2]>,
    /// Centre distance in modules of the gears.
    distance: f64,
}

/// Arrangement, teeth of the gears of a tree, 0 of all others, and the bits of its centre distance.
type TreeKey = (Arrangement, [u32; MOST_GEARS], u64);

/// Teeth of two planets in mesh, and the bits of their shifts and tip alterations.
type PlanetsKey = [[u64; 3]; 2];

/// Shifts with the centre distance of planets in mesh; 0 where there are none.
#[derive(Clone, Copy)]
pub(super) struct Choice {
    pub(super) shifts: ArrangedShifts,
    planet_distance: f64,
}

/// Shifts that an aim picks: each tree and each mesh of planets is calculated once, since it occurs in many
/// sets.
pub(super) struct Choices {
    rack: BasicRack,
    aim: Aim,
    limits: Limits,
    trees: HashMap<TreeKey, Result<ArrangedShifts, Check<Spot>>>,
    planets: HashMap<PlanetsKey, Result<f64, Check<Spot>>>,
}

impl Choices {
    pub(super) fn new(rack: BasicRack, aim: Aim, limits: Limits) -> Self {
        Self { rack, aim, limits, trees: HashMap::new(), planets: HashMap::new() }
    }

    /// Shifts of all gears of a set.
    ///
    /// # Errors
    /// The first check that fails.
    pub(super) fn of(&mut self, set: &ArrangedTeeth) -> Result<Choice, Check<Spot>> {
        let mut all = ArrangedShifts {
            gears: set.teeth().len(),
            profile: [0.0; MOST_GEARS],
            tips: [0.0; MOST_GEARS],
            is_aim_met: true,
        };
        for tree in set.trees() {
            let own = self.of_tree(set, &tree)?;
            for gear in tree.gears {
                (all.profile[gear], all.tips[gear]) = (own.profile[gear], own.tips[gear]);
            }
            all.is_aim_met &= own.is_aim_met;
        }
        if let Some([first, second]) = set.one_planet() {
            (all.profile[second], all.tips[second]) = (all.profile[first], all.tips[first]);
        }
        let planet_distance = match set.arrangement {
            Arrangement::Ravigneaux => self.of_planets(set, &all)?,
            _ => 0.0,
        };
        Ok(Choice { shifts: all, planet_distance })
    }

    fn of_tree(&mut self, set: &ArrangedTeeth, tree: &Tree) -> Result<ArrangedShifts, Check<Spot>> {
        let mut teeth = [0; MOST_GEARS];
        tree.gears.iter().for_each(|gear| teeth[*gear] = set.teeth[*gear]);
        let key = (set.arrangement, teeth, tree.distance.to_bits());
        if let Some(known) = self.trees.get(&key) {
            return *known;
        }
        let chosen = self.chosen(set, tree);
        self.trees.insert(key, chosen);
        chosen
    }

    fn chosen(&self, set: &ArrangedTeeth, tree: &Tree) -> Result<ArrangedShifts, Check<Spot>> {
        let places = set.arrangement.gears();
        let at = |gear: usize| tree.gears.iter().position(|one| *one == gear).unwrap_or_default();
        let spot = |mesh: [usize; 2]| Spot::Mesh(mesh.map(|gear| places[gear]));
        let refused = |error: Error| match error {
            Error::ShiftOutOfRange { teeth, kind, fault: ShiftFault::Pointed { tip_thickness }, .. } => {
                let is_it = |gear: &&usize| set.teeth[**gear] == teeth && set.kind(**gear) == kind;
                let gear = tree.gears.iter().find(is_it).unwrap_or(&tree.gears[0]);
                let (place, limit) = (Spot::Gear(places[*gear]), self.limits.tip_thickness);
                Check { rule: Rule::TipThickness, place, value: tip_thickness, limit }
            }
            // No shift closes a centre distance at which the gears have no line of action.
            _ => {
                let limit = self.limits.contact_ratio;
                Check { rule: Rule::ContactRatio, place: spot(tree.meshes[0]), value: 0.0, limit }
            }
        };
        let gears = tree.gears.iter().map(|gear| set.searched(*gear, &self.rack));
        let gears: Vec<InvoluteGear> = gears.collect::<Result<_, _>>().map_err(refused)?;
        let stated = |mesh: &[usize; 2]| StatedDistance { gears: mesh.map(at), distance: tree.distance };
        let meshes = tree.meshes.iter().map(stated).collect();
        let chosen = MeshTree::new(gears, meshes).map_err(refused)?.choose(self.aim, &self.limits);
        let chosen = chosen.map_err(|why| match why {
            NoShifts::Refused(error) => refused(error),
            NoShifts::Fault(check) => check.at(match check.place {
                Place::Gear(gear) => Spot::Gear(places[tree.gears[gear]]),
                Place::Mesh(mesh) => spot(tree.meshes[mesh]),
                Place::Tips(gear, mesh) => {
                    let own = tree.gears[gear];
                    let mate = tree.meshes[mesh].into_iter().find(|of| *of != own).unwrap_or(own);
                    Spot::Tips([places[own], places[mate]])
                }
            }),
        })?;
        let mut all = ArrangedShifts {
            gears: places.len(),
            profile: [0.0; MOST_GEARS],
            tips: [0.0; MOST_GEARS],
            is_aim_met: chosen.is_aim_met,
        };
        for (gear, own) in tree.gears.iter().zip(&chosen.gears) {
            (all.profile[*gear], all.tips[*gear]) = (own.shift(), own.tip_alteration());
        }
        Ok(all)
    }

    /// Centre distance of the planets of a Ravigneaux set without backlash.
    fn of_planets(&mut self, set: &ArrangedTeeth, shifts: &ArrangedShifts) -> Result<f64, Check<Spot>> {
        let key = PLANETS.map(|gear| {
            [u64::from(set.teeth[gear]), shifts.profile[gear].to_bits(), shifts.tips[gear].to_bits()]
        });
        if let Some(known) = self.planets.get(&key) {
            return *known;
        }
        let found = self.planet_distance(set, shifts);
        self.planets.insert(key, found);
        found
    }

    fn planet_distance(&self, set: &ArrangedTeeth, shifts: &ArrangedShifts) -> Result<f64, Check<Spot>> {
        let places = PLANETS.map(|gear| set.arrangement.gears()[gear]);
        let [short, long] = places;
        let Ok(pair) = set.planet_pair(shifts, &self.rack) else {
            let limit = self.limits.contact_ratio;
            return Err(Check { rule: Rule::ContactRatio, place: Spot::Mesh(places), value: 0.0, limit });
        };
        let mut first = None;
        let mut see = |check: Check<Spot>| {
            if first.is_none() && check.rule.severity() > Severity::Remark && !check.holds() {
                first = Some(check);
            }
        };
        let tips = [Spot::Tips([short, long]), Spot::Tips([long, short])];
        mesh_checks(&Spot::Mesh(places), &tips, &pair, &self.limits, &mut see);
        first.map_or_else(|| Ok(pair.centre_distance()), Err)
    }

    /// Least and most teeth of a short planet that may lie between the small sun and the gears of the long
    /// planet, whatever its own shift; none where the gears of the long planet have no shifts.
    ///
    /// The tip circle of a gear encloses its base circle, and that of the short planet stays outside the base
    /// circle of the small sun:
    ///
    /// ```text
    /// R_g + r_b,g < r_a,b          R_f − R_g < r_a,f + r_a,g        r_a,g² ≤ r_b,g² + (R_g·sin α)²
    /// ```
    pub(super) fn short_planets(&mut self, set: &ArrangedTeeth) -> Option<[u32; 2]> {
        let tree = set.trees().into_iter().find(|tree| tree.gears.contains(&LONG))?;
        let shifts = self.of_tree(set, &tree).ok()?;
        let tip = |gear: usize| set.shifted_tip(gear, &shifts, &self.rack);
        let (sin, cos) = libm::sincos(self.rack.pressure_angle.si());
        let small = f64::from(set.teeth[0]);
        let least = (2.0 * (tree.distance - tip(LONG)) - small * (1.0 + sin)) / (1.0 + sin + cos);
        let most = (2.0 * tip(4) - small) / (1.0 + cos);
        Some([least.max(0.0).floor() as u32, most.max(0.0).ceil() as u32])
    }

    /// Least gap of a set with these shifts, as by [`ArrangedTeeth::gap_at`].
    pub(super) fn gap(&self, set: &ArrangedTeeth, choice: &Choice, neighbours_rad: f64) -> Option<f64> {
        set.gap(&set.shape(choice, &self.rack), neighbours_rad)
    }
}

/// Places of short and long planet in a Ravigneaux set.
const PLANETS: [usize; 2] = [1, LONG];
const LONG: usize = 2;

impl ArrangedTeeth {
    /// The gears with these shifts and tips; rings are cut by the usual shaper with the dedendum of the rack as
    /// its addendum.
    ///
    /// # Errors
    /// Those of [`InvoluteGear::searched`]; [`Error::ShiftOutOfRange`] for shifts of other teeth.
    pub fn shifted_gears(
        &self,
        shifts: &ArrangedShifts,
        rack: &BasicRack,
    ) -> Result<Vec<InvoluteGear>, Error> {
        (0..self.teeth().len()).map(|gear| self.shifted_gear(gear, shifts, rack)).collect()
    }

    /// Least gap as by [`gap_at`](Self::gap_at), of gears with these shifts.
    #[must_use]
    pub fn shifted_gap_at(&self, shifts: &ArrangedShifts, rack: &BasicRack, angles: &[Angle]) -> Option<f64> {
        let planet_distance = match self.arrangement {
            Arrangement::Ravigneaux => self.planet_pair(shifts, rack).ok()?.centre_distance(),
            _ => 0.0,
        };
        let choice = Choice { shifts: *shifts, planet_distance };
        self.gap(&self.shape(&choice, rack), least_angle_rad(angles)?)
    }

    /// Whether gears of one plane may be apart with any shifts: tips are outside base circles.
    pub(super) fn may_clear(&self, rack: &BasicRack, tip_gap: f64, neighbours_rad: f64) -> bool {
        let half_sine = libm::sin(neighbours_rad / 2.0);
        let cos = libm::cos(rack.pressure_angle.si());
        self.planet_gears().all(|planet| {
            let centre_radius = self.carrier_radius(planet) / self.module(planet);
            2.0 * centre_radius * half_sine - f64::from(self.teeth[planet]) * cos > tip_gap
        })
    }

    /// The two steps of a planet that is one gear.
    fn one_planet(&self) -> Option<[usize; 2]> {
        let planets: Vec<usize> = self.planet_gears().collect();
        (self.has_one_step() && planets.len() == 2).then(|| [planets[0], planets[1]])
    }

    /// Trees of meshes, the one that leaves fewest sets first: that of the long planet.
    fn trees(&self) -> Vec<Tree> {
        let one_planet = self.one_planet();
        let own = |gear: usize| match one_planet {
            Some([first, second]) if gear == second => first,
            _ => gear,
        };
        let of_planet = |planet: usize| {
            let is_its = |mesh: &[usize; 2]| {
                mesh.contains(&planet) && mesh.iter().any(|gear| self.role(*gear) != SimpleGear::Planet)
            };
            let meshes: Vec<[usize; 2]> =
                self.arrangement.meshes().iter().map(|mesh| mesh.map(own)).filter(is_its).collect();
            let mut gears: Vec<usize> = meshes.iter().flatten().copied().collect();
            gears.sort_unstable();
            gears.dedup();
            let distance = self.carrier_radius(planet) / self.module(planet);
            Tree { gears, meshes, distance }
        };
        let planets: Vec<usize> = self.planet_gears().filter(|gear| own(*gear) == *gear).collect();
        planets.into_iter().rev().map(of_planet).collect()
    }

    fn role(&self, gear: usize) -> SimpleGear {
        self.arrangement.gears()[gear].role
    }

    fn kind(&self, gear: usize) -> GearKind {
        if self.role(gear) == SimpleGear::Ring { GearKind::Internal } else { GearKind::External }
    }

    fn searched(&self, gear: usize, rack: &BasicRack) -> Result<InvoluteGear, Error> {
        InvoluteGear::searched(self.kind(gear), ToothCount::new(self.teeth[gear])?, Profile::of_rack(*rack))
    }

    fn shifted_gear(
        &self,
        gear: usize,
        shifts: &ArrangedShifts,
        rack: &BasicRack,
    ) -> Result<InvoluteGear, Error> {
        let own = self.searched(gear, rack)?;
        // Both at once: a large shift alone may make teeth pointed.
        own.altered(shifts.profile[gear], shifts.tips[gear]).checked()
    }

    fn planet_pair(&self, shifts: &ArrangedShifts, rack: &BasicRack) -> Result<Pair, Error> {
        let [short, long] = PLANETS.map(|gear| self.shifted_gear(gear, shifts, rack));
        Pair::without_backlash(short?, long?)
    }

    fn shifted_tip(&self, gear: usize, shifts: &ArrangedShifts, rack: &BasicRack) -> f64 {
        let outwards = rack.addendum + shifts.profile[gear] + shifts.tips[gear];
        let radius = f64::from(self.teeth[gear]) / 2.0;
        if self.kind(gear) == GearKind::Internal { radius - outwards } else { radius + outwards }
    }

    fn shape(&self, choice: &Choice, rack: &BasicRack) -> Shape {
        let mut tips = [0.0; MOST_GEARS];
        for (gear, tip) in tips.iter_mut().enumerate().take(self.teeth().len()) {
            *tip = self.shifted_tip(gear, &choice.shifts, rack);
        }
        Shape { tips, planet_distance: choice.planet_distance }
    }
}
