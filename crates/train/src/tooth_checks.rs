//! Checks whether the gears of a set fit: equal centre distances, clearance, assembly, undercut,
//! interference.
//!
//! Sets with [shifts](crate::set::Shifts) or helical teeth are checked [in mesh](crate::toothed): limits,
//! interference and clearance follow [`involute::set`](epicyclic_gears::involute::set). Flanks may then
//! overlap by the rounding of printed shifts.
//!
//! No check keeps a gearbox from being analysed. Many a failed check is intended in service: profile shift,
//! teeth of other proportions, planets at unequal angles. Gears without shifts have none. Lengths are in
//! modules. Gears that mesh with one another, and all meshes of one gear, have one
//! module. Nothing more is assumed: the steps of a planet may differ in theirs.
//!
//! ```text
//! centre distance   2·R/m = z_c ± z_p           + sun, − ring; the same for all central gears
//!                                               of one planet gear
//! clearance         e > r_a1 + r_a2             e distance of two centres,  r_a = m·(z/2 + h_a*)
//! undercut          z ≥ 2·h_a*/sin²α            to the nearest whole number, as handbooks have it
//! interference      planet and ring: the tips miss each other outside the mesh,
//!                   as in gears::involute::interference
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `z_c`, `z_p`, `z` | teeth of a central gear, of a planet, of any gear | 1 |
//! | `R` | radius of a planet's centre | that of `m` |
//! | `h_a*`, `α` | addendum coefficient and pressure angle of the teeth | 1, deg |
//! | `N` | planets of a kind, at equal angles `2π/N` unless [given otherwise](crate::planet_angles) | 1 |
//!
//! For identical neighbours `e = 2·R·sin(γ/2)`, with `γ = 2π/N` or the least angle between planets at [given
//! angles](crate::planet_angles). Two planets in mesh are apart by the angle of
//! [`planet_bearings`](crate::planet_bearings#geometry); each is checked against those of the other kind that
//! it does not mesh with. Gears that do not mesh may be side by side along the axis, as the short planets and
//! the large sun of a Ravigneaux set are; if they must be, the check is a remark.
//!
//! # Assembly
//! Let a planet, or a tree of planets in mesh, move from one position to the next. It then finds every
//! central gear turned by `z_c/N` teeth back. It fits if each planet can turn by some angle `x_p` (in
//! revolutions) so that every mesh is whole:
//!
//! ```text
//! s·z_p·x_p ≡ z_c/N (mod 1)       of each mesh with a central gear, s = + sun, − ring
//! z_p·x_p + z_q·x_q ≡ 0 (mod 1)   of each mesh of two planets
//! ```
//!
//! Integer combinations of the lines that lose all `x` leave `v_j/N ≡ 0`, so `N` divides the number of
//! assembly positions `G = gcd(v_j)`. For planets at given angles the same holds with `θ/2π` in place of
//! `1/N`: each is a multiple of `2π/G` from the first.
//!
//! A simple set has `G = z_a + z_b`, a double planet `z_b − z_a`. A stepped planet between sun and ring has
//! `(z_a·z_f + z_b·z_g)/gcd(z_g, z_f)`: planets are identical, also in the phase of their steps. The result
//! is exact, in integers. Sets with a planet shaft are not checked: the number of pins of the shaft is not
//! known.

mod list;
mod warning;

pub use list::{NotChecked, SetCheck, SetChecks, Subject};
use warning::{NamedGear, ToothWarning};

use crate::Gearbox;
use crate::compound::CentralKind;
use crate::planet_places::{
    Given, NoPair, Places, central_mesh, centre_distance, places, planet_mesh, planet_of, teeth_of,
};
use crate::planet_set::{GearOf, MeshKind, PlanetSet};
use crate::spacing::Spacing;
use crate::tolerance::{MOST_ALIKE, TOUCH};
use crate::toothed::{ToothedSet, Untoothed};
use epicyclic_gears::involute::PlanetSet as InvoluteSet;
use epicyclic_gears::involute::check::{Check, Rule};
use epicyclic_gears::involute::set::Limits;
use epicyclic_gears::mesh::{Gear, TipCircle};
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::synthesis::Placement;
use epicyclic_units::Physical;
use std::f64::consts::TAU;

impl Gearbox {
    /// Lists what does not fit in the teeth of the sets, set by set: the failed [checks](Self::set_checks),
    /// without remarks, in words.
    ///
    /// ```
    /// use epicyclic_train::{Gearbox, set::{SetKind, SetSpec}};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let gearbox = Gearbox::builder("tight")
    ///     .links(["sun", "arm"])
    ///     .set(SetSpec::teeth("P", SetKind::Simple, ["sun", "ground", "arm"], 24, 72)?.planet_count(5))
    ///     .input("sun")
    ///     .output("arm")
    ///     .gear("only", [""; 0])
    ///     .build()?;
    /// let found = gearbox.tooth_checks(&Default::default());
    /// assert_eq!(
    ///     found[0],
    ///     "set `P`: 5 planets cannot be assembled at equal angles: their number must divide 96; 4 would do"
    /// );
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn tooth_checks(&self, rack: &BasicRack) -> Vec<String> {
        self.set_checks(rack, |_| vec![]).warnings().collect()
    }
}

/// Whether the planets of a set can be put in and clear each other; `None` where their number, teeth or
/// places are not known.
///
/// Of gears without profile shift, or of a simple set with its shifts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PlanetFit {
    /// Whether this number of planets of each kind can be assembled at their angles.
    pub assembles: Option<bool>,
    /// Whether tip circles of planets alike, and of those in mesh with each other's neighbours, clear.
    pub clears: Option<bool>,
}

impl PlanetSet {
    /// Teeth of a gear; of the planet of a simple set without planet teeth those that equal centre distances
    /// leave it, whole or not.
    #[must_use]
    pub fn teeth_or_coaxial(&self, gear: GearOf) -> Option<f64> {
        teeth_of(self, gear)
    }

    /// Whether its planets clear each other, with the modules of its meshes in any unit; `None` where their
    /// number, teeth or places are not known.
    #[must_use]
    pub fn planets_clear(&self, rack: &BasicRack, modules: &[Option<f64>]) -> Option<bool> {
        Checks::new(self, *rack, modules).do_clear()
    }

    /// Whether its planets can be put in and clear each other.
    ///
    /// ```
    /// use epicyclic_train::{Gearbox, set::{SetKind, SetSpec}, tooth_checks::PlanetFit};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let gearbox = Gearbox::builder("five of 96")
    ///     .links(["sun", "arm"])
    ///     .set(SetSpec::teeth("P", SetKind::Simple, ["sun", "ground", "arm"], 24, 72)?.planet_count(5))
    ///     .input("sun")
    ///     .output("arm")
    ///     .gear("only", [""; 0])
    ///     .build()?;
    /// let fit = gearbox.sets()[0].planet_fit(&Default::default());
    /// assert_eq!(fit, PlanetFit { assembles: Some(false), clears: Some(true) });
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn planet_fit(&self, rack: &BasicRack) -> PlanetFit {
        let Some(planets) = self.planet_count().filter(|_| !self.is_pair()) else {
            return PlanetFit { assembles: None, clears: None };
        };
        let checks = Checks::new(self, *rack, &[]);
        let clears = match (&checks.toothed, self.short().and_then(|spec| spec.involute_set(rack))) {
            (_, Some(Ok(set))) => Some(
                !checks.at_angles(&set).iter().any(|check| check.rule == Rule::PlanetGap && !check.holds()),
            ),
            (Err(Untoothed::Refused(_)), _) => None,
            (Err(_), _) if self.tooth_shape().is_helical() => None,
            _ => checks.do_clear(),
        };
        let assembles = self.assembly_positions().map(|positions| match self.spacing() {
            Spacing::Placed(Placement::Equal) => positions.is_multiple_of(planets.into()),
            _ => self.misplaced().is_empty(),
        });
        PlanetFit { assembles, clears }
    }
}

/// A set under its checks.
struct Checks<'a> {
    set: &'a PlanetSet,
    rack: BasicRack,
    /// Modules that are stated of each mesh, in any unit.
    stated: Vec<Option<f64>>,
    /// Positions of the planets, in the unit of the modules, or in modules of the first mesh if none is
    /// stated.
    places: Places,
    angles: Vec<(usize, f64)>,
    /// Angles from each group of planets to every other; `None` of an unknown number of groups.
    steps: Option<Vec<f64>>,
    toothed: Result<ToothedSet, Untoothed>,
}

/// Angles from each to every other planet at these angles, rad.
fn steps_between(angles_rad: &[f64]) -> Vec<f64> {
    let from = |(one, at): (usize, &f64)| {
        let to = |(other, there): (usize, &f64)| (other != one).then_some(there - at);
        angles_rad.iter().enumerate().filter_map(to).collect::<Vec<_>>()
    };
    let mut steps: Vec<f64> = angles_rad.iter().enumerate().flat_map(from).collect();
    steps.sort_by(f64::total_cmp);
    steps.dedup();
    steps
}

/// Angles between a planet and the others, for planets at equal angles, rad.
fn equal_steps(planets: u32) -> Vec<f64> {
    (1..planets).map(|place| TAU * f64::from(place) / f64::from(planets)).collect()
}

/// Two gears of different planets, or a neighbour of the same.
struct Neighbours {
    gears: [GearOf; 2],
    /// Angle from the first to the second of one group.
    angle_rad: f64,
    mesh: bool,
}

impl<'a> Checks<'a> {
    fn new(set: &'a PlanetSet, rack: BasicRack, stated: &[Option<f64>]) -> Self {
        let mut given = Given::nothing(set);
        let stated: Vec<Option<f64>> =
            (0..given.modules.len()).map(|mesh| stated.get(mesh).copied().flatten()).collect();
        given.modules.clone_from(&stated);
        if let Some(first) = given.modules.first_mut().filter(|_| stated.iter().all(Option::is_none)) {
            *first = Some(1.0);
        }
        let toothed = set.toothed(&rack, &stated);
        if set.tooth_shape().has_shape() {
            for (mesh, own) in toothed.iter().flat_map(|set| &set.meshes).enumerate() {
                given.distances[mesh] = Some(own.pair.centre_distance());
            }
        }
        let places = places(set, &given);
        let angles = places.angles(set);
        let steps = match (set.spacing(), set.planet_count()) {
            (Spacing::Placed(Placement::Equal), Some(planets)) => Some(equal_steps(planets)),
            _ => set.planet_angles().map(|angles| {
                let angles_rad: Vec<f64> = angles.iter().map(|angle| angle.si()).collect();
                steps_between(&angles_rad)
            }),
        };
        Self { set, rack, stated, places, angles, steps, toothed }
    }

    /// Checks of toothed gears, with the planets at their actual angles.
    fn at_angles(&self, set: &InvoluteSet) -> Vec<Check> {
        let mut checks = set.checks(&Limits::default());
        if let Spacing::At(_) = self.set.spacing() {
            // The set itself knows planets as near to equal angles as they assemble.
            let planet = set.planet_circle();
            let gaps = self.steps.iter().flatten().map(|step| planet.gap(planet, *step));
            let gap = gaps.fold(f64::INFINITY, f64::min);
            for check in checks.iter_mut().filter(|check| check.rule == Rule::PlanetGap) {
                check.value = gap;
            }
        }
        checks
    }

    fn name(&self) -> String {
        self.set.id().to_owned()
    }

    fn named(&self, gear: GearOf) -> Option<NamedGear> {
        Some(NamedGear { name: self.set.gear_name(gear), teeth: self.set.teeth(gear)?.get() })
    }

    fn half_tooth(&self) -> Option<ToothWarning> {
        let planet = teeth_of(self.set, GearOf::Planet(0, 0)).filter(|teeth| teeth.fract() != 0.0)?;
        let [sun, ring] = [0, 1].map(|central: usize| self.set.centrals()[central].teeth);
        // Only equal centre distances leave half a tooth.
        (planet > 0.0).then_some(ToothWarning::HalfTooth { sun: sun?.get(), ring: ring?.get() })
    }

    fn small_rings(&self) -> Vec<ToothWarning> {
        let small = |mesh: usize| {
            let (central, gear) = central_mesh(self.set, mesh)?;
            let (ring, planet) = (self.named(GearOf::Central(central))?, self.named(gear)?);
            (self.set.meshes()[mesh].kind == MeshKind::Internal && ring.teeth <= planet.teeth)
                .then_some(ToothWarning::RingTooSmall { ring, planet })
        };
        (0..self.set.meshes().len()).filter_map(small).collect()
    }

    /// The first central gear of each planet gear against every other.
    fn centre_distances(&self) -> Vec<ToothWarning> {
        let mut first: Vec<(GearOf, NamedGear, f64)> = vec![];
        let mut found = vec![];
        for mesh in 0..self.set.meshes().len() {
            let Some(((central, gear), distance)) =
                central_mesh(self.set, mesh).zip(centre_distance(self.set, mesh))
            else {
                continue;
            };
            let (Some(planet), Some(central)) = (self.named(gear), self.named(GearOf::Central(central)))
            else {
                continue;
            };
            match first.iter().find(|(one, ..)| *one == gear) {
                None => first.push((gear, central, distance)),
                Some((_, one, of_one)) if *of_one != distance => {
                    found.push(ToothWarning::UnequalCentreDistances {
                        planet,
                        centrals: [one.clone(), central],
                        distances: [*of_one, distance],
                    });
                }
                Some(_) => {}
            }
        }
        found
    }

    fn triangles(&self) -> Vec<ToothWarning> {
        let none = |mesh: usize| {
            let Err(NoPair::Triangle { radii, distance }) = self.places.pairs[mesh] else { return None };
            let gears = planet_mesh(self.set, mesh)?;
            let module = self.places.modules[mesh]?;
            Some(ToothWarning::NoTriangle {
                planets: gears.map(|gear| self.set.planet_name(planet_of(gear).unwrap_or_default())),
                radii: radii.map(|radius| radius / module),
                distance: distance / module,
            })
        };
        (0..self.set.meshes().len()).filter_map(none).collect()
    }

    /// Module of a gear, as a multiple of the first mesh's.
    fn module(&self, gear: GearOf) -> Option<f64> {
        let has = |mesh: &usize| self.set.meshes()[*mesh].gears.contains(&gear);
        (0..self.set.meshes().len()).filter(has).find_map(|mesh| self.places.modules[mesh])
    }

    /// Tip radius: of an external gear the largest, of a ring the smallest.
    fn tip(&self, gear: GearOf) -> Option<f64> {
        let module = self.module(gear)?;
        if let Some(own) = self.by_shape().and_then(|toothed| toothed.gear(gear)) {
            return Some(module * own.tip_diameter() / 2.0);
        }
        let kind = self.set.gear_kind(gear)?;
        Some(module * Gear::new(kind, teeth_of(self.set, gear)?).tip_radius(&self.rack))
    }

    /// The toothed gears, where shifts or helical teeth make them other than plain spur gears.
    fn by_shape(&self) -> Option<&ToothedSet> {
        self.toothed.as_ref().ok().filter(|_| self.set.tooth_shape().has_shape())
    }

    fn gears_of(&self, planet: usize) -> impl Iterator<Item = GearOf> + use<> {
        (0..self.set.planets()[planet].gears.len()).map(move |gear| GearOf::Planet(planet, gear))
    }

    fn do_mesh(&self, one: GearOf, other: GearOf) -> bool {
        self.set.meshes().iter().any(|mesh| mesh.gears.contains(&one) && mesh.gears.contains(&other))
    }

    /// Gears of planets that turn in one plane for certain: of one kind of planet, and those in mesh.
    fn neighbours(&self) -> Vec<Neighbours> {
        let alike = (0..self.set.planets().len())
            .flat_map(|planet| self.gears_of(planet))
            .map(|gear| Neighbours { gears: [gear; 2], angle_rad: 0.0, mesh: false });
        let meshing = (0..self.set.meshes().len()).filter_map(|mesh| {
            let pair = self.places.pairs[mesh].ok()?;
            let gears = planet_mesh(self.set, mesh)?;
            Some(Neighbours { gears, angle_rad: pair.angle_rad, mesh: true })
        });
        alike.chain(meshing).collect()
    }

    /// Least gap of the tip circles of two gears over all but the one pair that is one gear or meshes, their
    /// groups being these angles apart.
    fn gap(&self, one: &Neighbours, steps: &[f64]) -> Option<f64> {
        let circle = |gear: GearOf| {
            let centre_radius = self.places.radii[planet_of(gear).unwrap_or_default()]?;
            Some(TipCircle { centre_radius, tip_radius: self.tip(gear)? })
        };
        let [first, second] = one.gears.map(circle);
        let (first, second) = (first?, second?);
        steps.iter().map(|step| first.gap(second, one.angle_rad + step)).reduce(f64::min)
    }

    /// Whether planets of each kind, their groups being these angles apart, clear each other, as far as is
    /// known.
    fn clears(&self, neighbours: &[Neighbours], steps: &[f64]) -> bool {
        neighbours.iter().all(|one| self.gap(one, steps).is_none_or(|gap| gap > TOUCH))
    }

    /// Whether the planets of the set clear each other at their own angles; `None` if the place or size of
    /// any planet is not known.
    fn do_clear(&self) -> Option<bool> {
        let steps = self.steps.as_ref()?;
        let all = self.neighbours();
        if !steps.is_empty() && !self.clears(&all, steps) {
            return Some(false);
        }
        let is_placed =
            |mesh: usize| planet_mesh(self.set, mesh).is_none() || self.places.pairs[mesh].is_ok();
        let is_sized = |one: &Neighbours| steps.is_empty() || self.gap(one, steps).is_some();
        let is_known = (0..self.set.meshes().len()).all(is_placed) && all.iter().all(is_sized);
        (is_known && !self.is_bevel()).then_some(true)
    }

    fn overlaps(&self) -> Vec<ToothWarning> {
        let (Some(planets), Some(steps)) = (self.set.planet_count(), &self.steps) else { return vec![] };
        let mut worst: Vec<(bool, [usize; 2], &Neighbours, f64)> = vec![];
        let all = self.neighbours();
        for one in &all {
            let Some(gap) = self.gap(one, steps).filter(|gap| *gap <= TOUCH) else { continue };
            // Of a stepped planet the step that overlaps most.
            let kinds = one.gears.map(|gear| planet_of(gear).unwrap_or_default());
            match worst.iter_mut().find(|other| (other.0, other.1) == (one.mesh, kinds)) {
                Some(other) if other.3 > gap => (other.2, other.3) = (one, gap),
                Some(_) => {}
                None => worst.push((one.mesh, kinds, one, gap)),
            }
        }
        let is_equal = *self.set.spacing() == Spacing::default();
        let fits = |fewer: &u32| self.clears(&all, &equal_steps(*fewer));
        let most = (2..planets).rev().filter(|_| is_equal).find(fits);
        let warning = |(_, _, one, gap): (bool, [usize; 2], &Neighbours, f64)| {
            let module = self.module(one.gears[0]).unwrap_or(1.0);
            ToothWarning::PlanetsOverlap {
                gears: one.gears.map(|gear| self.set.gear_name(gear)),
                planets,
                overlap: if gap.abs() <= TOUCH { 0.0 } else { -gap / module },
                most,
                is_equal,
            }
        };
        worst.into_iter().map(warning).collect()
    }

    fn assembly(&self) -> Vec<ToothWarning> {
        if *self.set.spacing() != Spacing::default() {
            let misplaced = |at| ToothWarning::Misplaced { at };
            return self.set.misplaced().into_iter().map(misplaced).collect();
        }
        self.equal_angles().into_iter().collect()
    }

    /// Planets at equal angles that do not assemble.
    fn equal_angles(&self) -> Option<ToothWarning> {
        let planets = self.set.planet_count()?;
        let positions = self.set.assembly_positions()?;
        let fits = |count: u32| positions.is_multiple_of(u64::from(count));
        if fits(planets) {
            return None;
        }
        let neighbours = self.neighbours();
        let does = |count: &u32| fits(*count) && self.clears(&neighbours, &equal_steps(*count));
        Some(ToothWarning::Assembly {
            planets,
            slots: positions,
            fewer: (2..planets).rev().find(does),
            more: (planets + 1..=planets.saturating_mul(2).min(MOST_ALIKE)).find(does),
        })
    }

    fn is_bevel(&self) -> bool {
        let bevel = |kind| matches!(kind, MeshKind::BevelLeft | MeshKind::BevelRight);
        self.set.meshes().iter().any(|mesh| bevel(mesh.kind))
    }

    /// Gears that do not mesh and whose tip circles overlap.
    fn planes(&self) -> Vec<ToothWarning> {
        let mut found = vec![];
        let mut note = |gears: [GearOf; 2], gap: f64| {
            let gap = if gap.abs() <= TOUCH { 0.0 } else { gap / self.module(gears[0]).unwrap_or(1.0) };
            let gears = gears.map(|gear| self.set.gear_name(gear));
            found.push(ToothWarning::DifferentPlanes { gears, gap });
        };
        for planet in 0..self.set.planets().len() {
            let Some(radius) = self.places.radii[planet] else { continue };
            for central in (0..self.set.centrals().len()).map(GearOf::Central) {
                // One step in mesh with it, the others of the planet lie in other planes anyway.
                if self.gears_of(planet).any(|gear| self.do_mesh(gear, central)) {
                    continue;
                }
                for gear in self.gears_of(planet) {
                    let (Some(tip), Some(of_central)) = (self.tip(gear), self.tip(central)) else { continue };
                    let is_ring = matches!(central, GearOf::Central(place) if self.set.centrals()[place].kind == CentralKind::Ring);
                    let gap = if is_ring { of_central - radius - tip } else { radius - tip - of_central };
                    if gap <= TOUCH {
                        note([gear, central], gap);
                    }
                }
            }
            for other in planet + 1..self.set.planets().len() {
                let ((group, at), (other_group, other_at)) = (self.angles[planet], self.angles[other]);
                if group != other_group {
                    continue;
                }
                for one in self.gears_of(planet) {
                    for two in self.gears_of(other).filter(|&two| !self.do_mesh(one, two)) {
                        let pair = Neighbours { gears: [one, two], angle_rad: other_at - at, mesh: false };
                        let own = self.gap_at(&pair);
                        let others = self.steps.as_ref().and_then(|steps| self.gap(&pair, steps));
                        let least = own.into_iter().chain(others).min_by(f64::total_cmp);
                        if let Some(gap) = least.filter(|gap| *gap <= TOUCH) {
                            note([one, two], gap);
                        }
                    }
                }
            }
        }
        found
    }

    /// Gap of the tip circles of two gears of one group.
    fn gap_at(&self, pair: &Neighbours) -> Option<f64> {
        self.gap(pair, &[0.0])
    }
}

#[cfg(test)]
mod tests;
