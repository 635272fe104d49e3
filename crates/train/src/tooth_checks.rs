//! Whether the gears of a set fit: equal centre distances, clearance, assembly, undercut.
//!
//! Nothing here keeps a gearbox from being analysed, and much of it is met in service on purpose: profile shift, teeth
//! of other proportions, planets at unequal angles. All is said of gears without profile shift. Lengths are in
//! modules; gears that mesh with one another, and all meshes of one gear, have one module, and nothing more is
//! assumed: the steps of a planet may differ in theirs.
//!
//! ```text
//! centre distance   2·R/m = z_c ± z_p           + sun, − ring; the same for all central gears of one planet gear
//! clearance         e > r_a1 + r_a2             e distance of two centres,  r_a = m·(z/2 + h_a*)
//! undercut          z ≥ 2·h_a*/sin²α            to the nearest whole number, as handbooks have it
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `z_c`, `z_p`, `z` | teeth of a central gear, of a planet, of any gear | 1 |
//! | `R` | radius of a planet's centre | that of `m` |
//! | `h_a*`, `α` | addendum coefficient and pressure angle of the teeth | 1, deg |
//! | `N` | planets of a kind, at equal angles `2π/N` | 1 |
//!
//! Of identical neighbours `e = 2·R·sin(π/N)`. Two planets in mesh stand apart by the angle of
//! [`planet_bearings`](crate::planet_bearings#geometry); each is held against those of the other kind that it does not mesh with. Gears
//! that do not mesh may lie beside each other along the axis, as the short planets and the large sun of a Ravigneaux
//! set do; that they must is only a [note](ToothWarning::is_note).
//!
//! # Assembly
//! Moved from one place to the next a planet, or tree of planets in mesh, finds every central gear turned by `z_c/N`
//! teeth back. It fits where each planet can turn by some angle `x_p` (in revolutions) so that every mesh is whole:
//!
//! ```text
//! s·z_p·x_p ≡ z_c/N (mod 1)       of each mesh with a central gear, s = + sun, − ring
//! z_p·x_p + z_q·x_q ≡ 0 (mod 1)   of each mesh of two planets
//! ```
//!
//! Integer combinations of the lines that lose all `x` leave `v_j/N ≡ 0`, so `N` divides the number of slots
//! `G = gcd(v_j)`. A simple set has `G = z_a + z_b`, a double planet `z_b − z_a`, a stepped one between sun and ring
//! `(z_a·z_f + z_b·z_g)/gcd(z_g, z_f)`: planets are identical, also in the phase of their steps. Exact, in integers.
//! Of sets with a planet shaft it says nothing: how many pins the shaft has is not known.

use crate::Gearbox;
use crate::compound::CentralKind;
use crate::planet_places::{
    Given, NoPair, Places, apart, central_mesh, places, planet_mesh, planet_of, teeth_of,
};
use crate::planet_set::{GearOf, MeshKind, PlanetSet};
use crate::tolerance::{MOST_ALIKE, TOUCH};
use epicyclic_gears::rack::BasicRack;
use std::f64::consts::{PI, TAU};
use std::fmt;

/// A gear with its teeth, by name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedGear {
    /// What it is called: `sun`, `planet long.2`.
    pub name: String,
    /// Its teeth.
    pub teeth: u32,
}

/// Something about the teeth of a set that does not fit without profile shift, or needs a choice.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ToothWarning {
    /// A simple set without planet teeth, whose sun and ring leave its planets none that are whole.
    HalfTooth {
        /// The set.
        set: String,
        /// Teeth of the sun, `z_a`.
        sun: u32,
        /// Teeth of the ring, `z_b`.
        ring: u32,
    },
    /// A ring with no more teeth than the planet in it.
    RingTooSmall {
        /// The set.
        set: String,
        /// The ring.
        ring: NamedGear,
        /// The planet's gear.
        planet: NamedGear,
    },
    /// Two central gears that ask one gear of a planet for different radii.
    UnequalCentreDistances {
        /// The set.
        set: String,
        /// The planet's gear.
        planet: NamedGear,
        /// The central gears.
        centrals: [NamedGear; 2],
        /// Centre distance to each, `R/m`, in modules.
        distances: [f64; 2],
    },
    /// Two planets in mesh that cannot stand at their radii.
    NoTriangle {
        /// The set.
        set: String,
        /// The planets.
        planets: [String; 2],
        /// Radii of their centres, in modules of their mesh.
        radii: [f64; 2],
        /// Distance of their centres, in modules.
        distance: f64,
    },
    /// Planets that overlap their neighbours.
    PlanetsOverlap {
        /// The set.
        set: String,
        /// The gears that overlap: of one kind of planet, or of two.
        gears: [String; 2],
        /// How many of each there are.
        planets: u32,
        /// By how much the tip circles overlap, in modules; 0 where they touch.
        overlap: f64,
        /// The largest number of each that clears; `None` where not even two do.
        most: Option<u32>,
    },
    /// Planets at equal angles that cannot be assembled.
    Assembly {
        /// The set.
        set: String,
        /// How many of each there are.
        planets: u32,
        /// What their number must divide, `G`.
        slots: u64,
        /// The next smaller number that assembles, from 2 on.
        fewer: Option<u32>,
        /// The next larger number that assembles and clears.
        more: Option<u32>,
    },
    /// External gears with so few teeth that a rack undercuts them.
    Undercut {
        /// The set.
        set: String,
        /// The gears.
        gears: Vec<NamedGear>,
        /// The fewest teeth that are not undercut.
        least: u32,
    },
    /// Two gears not in mesh whose tip circles overlap: they cannot lie in one plane.
    DifferentPlanes {
        /// The set.
        set: String,
        /// The gears.
        gears: [String; 2],
    },
}

impl ToothWarning {
    /// The set it is about.
    #[must_use]
    pub fn set(&self) -> &str {
        match self {
            Self::HalfTooth { set, .. }
            | Self::RingTooSmall { set, .. }
            | Self::UnequalCentreDistances { set, .. }
            | Self::NoTriangle { set, .. }
            | Self::PlanetsOverlap { set, .. }
            | Self::Assembly { set, .. }
            | Self::Undercut { set, .. }
            | Self::DifferentPlanes { set, .. } => set,
        }
    }

    /// Whether it only tells how the gears must be arranged: usual in some sets, and no fault.
    #[must_use]
    pub fn is_note(&self) -> bool {
        matches!(self, Self::DifferentPlanes { .. })
    }
}

impl fmt::Display for NamedGear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.name, teeth(self.teeth))
    }
}

fn teeth(count: u32) -> String {
    if count == 1 { "1 tooth".to_owned() } else { format!("{count} teeth") }
}

impl fmt::Display for ToothWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "set `{}`: ", self.set())?;
        match self {
            Self::HalfTooth { sun, ring, .. } => write!(
                f,
                "{sun} and {ring} teeth of sun and ring leave the planets (z_b − z_a)/2 = {} teeth: a whole number \
                 needs shifted profiles",
                (f64::from(*ring) - f64::from(*sun)) / 2.0
            ),
            Self::RingTooSmall { ring, planet, .. } => {
                write!(f, "{ring} is not larger than the {planet} in it")
            }
            Self::UnequalCentreDistances { planet, centrals: [one, other], distances, .. } => write!(
                f,
                "{planet} is {} modules from the axis by the {one} and {} by the {other}: equal centre distances need \
                 shifted profiles",
                distances[0], distances[1]
            ),
            Self::NoTriangle { planets: [one, other], radii, distance, .. } => write!(
                f,
                "{one} and {other} cannot mesh: their centres, {:.4} and {:.4} modules from the axis, cannot stand \
                 {:.4} modules apart",
                radii[0], radii[1], distance
            ),
            Self::PlanetsOverlap { gears: [one, other], planets, overlap, most, .. } => {
                match one == other {
                    true => write!(
                        f,
                        "{planets} planets do not clear each other: tip circles of neighbours ({one})"
                    )?,
                    false => write!(
                        f,
                        "{planets} planets of each kind do not clear: tip circles of {one} and the next {other}"
                    )?,
                }
                if *overlap > 0.0 {
                    write!(f, " overlap by {overlap:.3} modules; ")?;
                } else {
                    f.write_str(" touch; ")?;
                }
                match most {
                    Some(most) => write!(f, "at most {most} clear"),
                    None => f.write_str("not even 2 clear"),
                }
            }
            Self::Assembly { planets, slots, fewer, more, .. } => {
                write!(
                    f,
                    "{planets} planets cannot be assembled at equal angles: their number must divide {slots}"
                )?;
                match (fewer, more) {
                    (Some(fewer), Some(more)) => write!(f, "; {fewer} or {more} would do"),
                    (Some(one), None) | (None, Some(one)) => write!(f, "; {one} would do"),
                    (None, None) => Ok(()),
                }
            }
            Self::Undercut { gears, least, .. } => {
                let gears: Vec<String> = gears.iter().map(NamedGear::to_string).collect();
                write!(f, "undercut without profile shift, below {}: {}", teeth(*least), gears.join(", "))
            }
            Self::DifferentPlanes { gears: [one, other], .. } => {
                write!(f, "{one} and {other} must lie in different planes: their tip circles overlap")
            }
        }
    }
}

impl Gearbox {
    /// What does not fit in the teeth of its sets, set by set.
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
    ///     found[0].to_string(),
    ///     "set `P`: 5 planets cannot be assembled at equal angles: their number must divide 96; 4 would do"
    /// );
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn tooth_checks(&self, rack: &BasicRack) -> Vec<ToothWarning> {
        self.sets.iter().flat_map(|set| Checks::new(set, *rack).all()).collect()
    }
}

/// A set under its checks.
struct Checks<'a> {
    set: &'a PlanetSet,
    rack: BasicRack,
    /// In modules of the first mesh that has any.
    places: Places,
    angles: Vec<(usize, f64)>,
}

/// Two gears of different planets, or a neighbour of the same.
struct Neighbours {
    gears: [GearOf; 2],
    /// Angle from the first to the second of one group.
    angle_rad: f64,
    mesh: bool,
}

impl<'a> Checks<'a> {
    fn new(set: &'a PlanetSet, rack: BasicRack) -> Self {
        let mut given = Given::nothing(set);
        if let Some(first) = given.modules.first_mut() {
            *first = Some(1.0);
        }
        let places = places(set, &given);
        let angles = places.angles(set);
        Self { set, rack, places, angles }
    }

    fn all(&self) -> Vec<ToothWarning> {
        let mut found = vec![];
        if !self.set.is_pair() {
            found.extend(self.half_tooth());
            found.extend(self.small_rings());
            found.extend(self.centre_distances());
            found.extend(self.triangles());
            found.extend(self.overlaps());
            found.extend(self.assembly());
        }
        found.extend(self.undercut());
        found.extend(self.planes());
        found
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
        (planet > 0.0).then_some(ToothWarning::HalfTooth {
            set: self.name(),
            sun: sun?.get(),
            ring: ring?.get(),
        })
    }

    fn small_rings(&self) -> Vec<ToothWarning> {
        let small = |mesh: usize| {
            let (central, gear) = central_mesh(self.set, mesh)?;
            let (ring, planet) = (self.named(GearOf::Central(central))?, self.named(gear)?);
            (self.set.meshes()[mesh].kind == MeshKind::Internal && ring.teeth <= planet.teeth)
                .then_some(ToothWarning::RingTooSmall { set: self.name(), ring, planet })
        };
        (0..self.set.meshes().len()).filter_map(small).collect()
    }

    /// The first central gear of each planet gear against every other.
    fn centre_distances(&self) -> Vec<ToothWarning> {
        let mut first: Vec<(GearOf, NamedGear, f64)> = vec![];
        let mut found = vec![];
        for mesh in 0..self.set.meshes().len() {
            let Some(((central, gear), apart)) = central_mesh(self.set, mesh).zip(apart(self.set, mesh))
            else {
                continue;
            };
            let (Some(planet), Some(central)) = (self.named(gear), self.named(GearOf::Central(central)))
            else {
                continue;
            };
            match first.iter().find(|(one, ..)| *one == gear) {
                None => first.push((gear, central, apart)),
                Some((_, one, of_one)) if *of_one != apart => {
                    found.push(ToothWarning::UnequalCentreDistances {
                        set: self.name(),
                        planet,
                        centrals: [one.clone(), central],
                        distances: [of_one / 2.0, apart / 2.0],
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
                set: self.name(),
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
        let outward = match gear {
            GearOf::Central(central) => match self.set.centrals()[central].kind {
                CentralKind::Sun => 1.0,
                CentralKind::Ring => -1.0,
                _ => return None,
            },
            GearOf::Planet(..) => 1.0,
        };
        Some(self.module(gear)? * (teeth_of(self.set, gear)? / 2.0 + outward * self.rack.addendum))
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

    /// Least gap of the tip circles of two gears over all but the one pair that is one gear or meshes.
    fn gap(&self, one: &Neighbours, planets: u32) -> Option<f64> {
        let [first, second] = one.gears;
        let tips = self.tip(first)? + self.tip(second)?;
        let [r1, r2] = [first, second].map(|gear| self.places.radii[planet_of(gear).unwrap_or_default()]);
        let (r1, r2) = (r1?, r2?);
        let distance = |place: u32| {
            let angle_rad = one.angle_rad + TAU * f64::from(place) / f64::from(planets);
            (r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * angle_rad.cos()).max(0.0).sqrt()
        };
        (1..planets).map(distance).reduce(f64::min).map(|least| least - tips)
    }

    /// Whether this many planets of each kind clear each other, as far as is known.
    fn clears(&self, neighbours: &[Neighbours], planets: u32) -> bool {
        neighbours.iter().all(|one| self.gap(one, planets).is_none_or(|gap| gap > TOUCH))
    }

    fn overlaps(&self) -> Vec<ToothWarning> {
        let Some(planets) = self.set.planet_count() else { return vec![] };
        let mut worst: Vec<(bool, [usize; 2], &Neighbours, f64)> = vec![];
        let all = self.neighbours();
        for one in &all {
            let Some(gap) = self.gap(one, planets).filter(|gap| *gap <= TOUCH) else { continue };
            // Of a stepped planet the step that overlaps most.
            let kinds = one.gears.map(|gear| planet_of(gear).unwrap_or_default());
            match worst.iter_mut().find(|other| (other.0, other.1) == (one.mesh, kinds)) {
                Some(other) if other.3 > gap => (other.2, other.3) = (one, gap),
                Some(_) => {}
                None => worst.push((one.mesh, kinds, one, gap)),
            }
        }
        let most = (2..planets).rev().find(|&fewer| self.clears(&all, fewer));
        let warning = |(_, _, one, gap): (bool, [usize; 2], &Neighbours, f64)| {
            let module = self.module(one.gears[0]).unwrap_or(1.0);
            ToothWarning::PlanetsOverlap {
                set: self.name(),
                gears: one.gears.map(|gear| self.set.gear_name(gear)),
                planets,
                overlap: if gap.abs() <= TOUCH { 0.0 } else { -gap / module },
                most,
            }
        };
        worst.into_iter().map(warning).collect()
    }

    fn assembly(&self) -> Option<ToothWarning> {
        let planets = self.set.planet_count()?;
        let slots = slots(self.set)?;
        let fits = |count: u32| slots.is_multiple_of(u128::from(count));
        if fits(planets) {
            return None;
        }
        let neighbours = self.neighbours();
        let does = |count: &u32| fits(*count) && self.clears(&neighbours, *count);
        Some(ToothWarning::Assembly {
            set: self.name(),
            planets,
            slots: u64::try_from(slots).ok()?,
            fewer: (2..planets).rev().find(does),
            more: (planets + 1..=planets.saturating_mul(2).min(MOST_ALIKE)).find(does),
        })
    }

    fn undercut(&self) -> Option<ToothWarning> {
        let least = self.rack.least_teeth_without_undercut();
        let suns = (0..self.set.centrals().len())
            .filter(|&central| self.set.centrals()[central].kind == CentralKind::Sun)
            .map(GearOf::Central);
        // The virtual teeth of bevel gears depend on angles that nothing gives.
        if self.is_bevel() {
            return None;
        }
        let planets = (0..self.set.planets().len()).flat_map(|planet| self.gears_of(planet));
        let gears: Vec<NamedGear> = suns
            .chain(planets)
            .filter_map(|gear| {
                // Also the planet that equal centre distances leave a simple set.
                let teeth = teeth_of(self.set, gear).filter(|teeth| teeth.fract() == 0.0 && *teeth >= 1.0)?;
                Some(NamedGear { name: self.set.gear_name(gear), teeth: teeth as u32 })
            })
            .filter(|gear| gear.teeth < least)
            .collect();
        (!gears.is_empty()).then(|| ToothWarning::Undercut { set: self.name(), gears, least })
    }

    fn is_bevel(&self) -> bool {
        let bevel = |kind| matches!(kind, MeshKind::BevelLeft | MeshKind::BevelRight);
        self.set.meshes().iter().any(|mesh| bevel(mesh.kind))
    }

    /// Gears that do not mesh and whose tip circles overlap.
    fn planes(&self) -> Vec<ToothWarning> {
        let mut found = vec![];
        let mut note = |gears: [GearOf; 2]| {
            found.push(ToothWarning::DifferentPlanes {
                set: self.name(),
                gears: gears.map(|gear| self.set.gear_name(gear)),
            });
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
                        note([gear, central]);
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
                        let others = self.set.planet_count().and_then(|planets| self.gap(&pair, planets));
                        if own.into_iter().chain(others).any(|gap| gap <= TOUCH) {
                            note([one, two]);
                        }
                    }
                }
            }
        }
        found
    }

    /// Gap of the tip circles of two gears of one group.
    fn gap_at(&self, pair: &Neighbours) -> Option<f64> {
        // Of two groups half a turn apart, the second group turned back.
        self.gap(&Neighbours { gears: pair.gears, angle_rad: pair.angle_rad - PI, mesh: false }, 2)
    }
}

/// `G`, which the number of planets at equal angles must divide; 0 where any number does, `None` where it is not
/// known.
fn slots(set: &PlanetSet) -> Option<u128> {
    if set.centrals().iter().any(|central| central.kind == CentralKind::PlanetShaft) {
        return None;
    }
    // A planet with one gear may be turned to any of its teeth: `z_p·x_p` is as free as `x_p`.
    let coefficient = |gear: GearOf| match gear {
        GearOf::Planet(planet, _) if set.planets()[planet].gears.len() == 1 => Some(1),
        gear => set.teeth(gear).map(|teeth| i128::from(teeth.get())),
    };
    // One line of each mesh: coefficients of the planets, and what stands on the right, times N.
    let mut lines: Vec<(Vec<i128>, i128)> = vec![];
    for mesh in set.meshes() {
        let mut line = (vec![0; set.planets().len()], 0);
        for (gear, sign) in mesh.gears.into_iter().zip([1, -mesh.kind.sign()]) {
            match gear {
                GearOf::Central(_) => line.1 += sign * coefficient(gear)?,
                GearOf::Planet(planet, _) => line.0[planet] += sign * coefficient(gear)?,
            }
        }
        lines.push(line);
    }
    // Euclid's algorithm on the lines, planet by planet; each settles one line.
    for planet in 0..set.planets().len() {
        loop {
            lines.sort_by_key(
                |line| if line.0[planet] == 0 { u128::MAX } else { line.0[planet].unsigned_abs() },
            );
            let ([pivot], rest) = lines.split_first_chunk_mut()?;
            if pivot.0[planet] == 0 {
                break;
            }
            let mut done = true;
            for line in rest.iter_mut().filter(|line| line.0[planet] != 0) {
                let times = line.0[planet] / pivot.0[planet];
                let less = |from: i128, what: i128| from.checked_sub(times.checked_mul(what)?);
                for (of_line, of_pivot) in line.0.iter_mut().zip(&pivot.0) {
                    *of_line = less(*of_line, *of_pivot)?;
                }
                line.1 = less(line.1, pivot.1)?;
                done &= line.0[planet] == 0;
            }
            if done {
                lines.remove(0);
                break;
            }
        }
    }
    Some(lines.iter().fold(0, |slots, line| gcd(slots, line.1.unsigned_abs())))
}

fn gcd(a: u128, b: u128) -> u128 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compound::CompoundSpec;
    use crate::set::{SetKind, SetSpec};
    use crate::units::degrees;
    use crate::{Gearbox, GearboxBuilder};
    use epicyclic_gears::ToothCount;
    use epicyclic_gears::efficiency::MeshEfficiency;

    fn start() -> GearboxBuilder {
        Gearbox::builder("one set").links(["a", "b", "c", "H"]).input("a").output("H")
    }

    fn short(kind: SetKind, sun: u32, ring: u32, planets: &[u32]) -> SetSpec {
        let set = SetSpec::teeth("P", kind, ["a", "b", "H"], sun, ring).unwrap();
        let teeth = |place: usize| planets.get(place).map(|&count| ToothCount::new(count).unwrap());
        match teeth(0) {
            Some(first) => set.planet_teeth(first, teeth(1)),
            None => set,
        }
    }

    fn found(set: SetSpec) -> Vec<String> {
        let gearbox = start().set(set).build().unwrap();
        gearbox.tooth_checks(&BasicRack::default()).iter().map(ToothWarning::to_string).collect()
    }

    fn of(kind: SetKind, sun: u32, ring: u32, planets: &[u32]) -> u128 {
        slots(&start().set(short(kind, sun, ring, planets)).build().unwrap().sets[0]).unwrap()
    }

    #[test]
    fn the_slots_of_the_usual_sets_are_the_known_ones() {
        assert_eq!(of(SetKind::Simple, 20, 61, &[]), 81);
        assert_eq!(of(SetKind::DoublePlanet, 30, 72, &[]), 42);
        assert_eq!(of(SetKind::MeshingSuns, 30, 36, &[18, 20]), 66);
        assert_eq!(of(SetKind::Bevel, 20, 30, &[]), 50);
        // (20·24 + 80·36)/12, (20·24 − 30·36)/12 in size, and likewise of two rings.
        assert_eq!(of(SetKind::SteppedSunRing, 20, 80, &[36, 24]), 280);
        assert_eq!(of(SetKind::SteppedSuns, 20, 30, &[36, 24]), 50);
        assert_eq!(of(SetKind::SteppedRings, 100, 90, &[36, 24]), 70);
    }

    /// Two conditions at once: z_s + z_l of the suns through both planets, z_l + z_r of the long planet.
    #[test]
    fn a_ravigneaux_set_has_the_slots_of_all_its_central_gears() {
        let eta = MeshEfficiency::IDEAL;
        let set = |ring: u32| {
            CompoundSpec::new("R", "H")
                .sun("a", 30)
                .sun("b", 36)
                .ring("c", ring)
                .planet("short", &[18])
                .planet("long", &[18])
                .mesh("a", "short", eta)
                .mesh("short", "long", eta)
                .mesh("b", "long", eta)
                .mesh("long", "c", eta)
                .planet_count(5)
        };
        let gearbox = start().compound_set(set(72)).build().unwrap();
        // 66, 108, 42: gcd 6.
        assert_eq!(slots(&gearbox.sets[0]), Some(6));
        let all = gearbox.tooth_checks(&BasicRack::default());
        let words: Vec<String> = all.iter().map(ToothWarning::to_string).collect();
        assert_eq!(
            words,
            [
                "set `R`: 5 planets of each kind do not clear: tip circles of short and the next long \
                 overlap by 5.986 modules; at most 4 clear",
                "set `R`: 5 planets cannot be assembled at equal angles: their number must divide 6; 3 would do",
                "set `R`: short and sun b must lie in different planes: their tip circles overlap",
            ]
        );
        assert_eq!(all.iter().map(ToothWarning::is_note).collect::<Vec<_>>(), [false, false, true]);
        let gearbox = start().compound_set(set(73)).build().unwrap();
        assert_eq!(
            gearbox.tooth_checks(&BasicRack::default())[0].to_string(),
            "set `R`: long (18 teeth) is 27 modules from the axis by the sun b (36 teeth) and 27.5 by the ring \
             (73 teeth): equal centre distances need shifted profiles"
        );
    }

    #[test]
    fn every_fault_of_a_simple_set_is_told() {
        assert_eq!(
            found(short(SetKind::Simple, 30, 67, &[])),
            [
                "set `P`: 30 and 67 teeth of sun and ring leave the planets (z_b − z_a)/2 = 18.5 teeth: a whole number \
              needs shifted profiles"
            ]
        );
        assert_eq!(
            found(short(SetKind::Simple, 12, 72, &[]).planet_count(8)),
            [
                "set `P`: 8 planets do not clear each other: tip circles of neighbours (planet) overlap by 15.927 \
                 modules; at most 3 clear",
                "set `P`: 8 planets cannot be assembled at equal angles: their number must divide 84; 3 would do",
                "set `P`: undercut without profile shift, below 17 teeth: sun (12 teeth)",
            ]
        );
        assert_eq!(
            found(short(SetKind::Simple, 1, 3, &[1]).planet_count(50)),
            [
                "set `P`: 50 planets do not clear each other: tip circles of neighbours (planet) overlap by 2.874 \
                 modules; not even 2 clear",
                "set `P`: 50 planets cannot be assembled at equal angles: their number must divide 4",
                "set `P`: undercut without profile shift, below 17 teeth: sun (1 tooth), planet (1 tooth)",
            ]
        );
        // (2 + 36)·sin 90° = 36 + 2: two planets around a sun of two teeth touch.
        assert_eq!(
            found(short(SetKind::Simple, 2, 74, &[]).planet_count(2))[0],
            "set `P`: 2 planets do not clear each other: tip circles of neighbours (planet) touch; not even 2 clear"
        );
        assert_eq!(found(short(SetKind::Simple, 24, 72, &[24]).planet_count(4)), [""; 0]);
        assert_eq!(
            found(short(SetKind::SteppedSunRing, 20, 40, &[36, 41])),
            ["set `P`: ring (40 teeth) is not larger than the planet 2 (41 teeth) in it"]
        );
        // A double planet whose ring is too far out for planets so small.
        assert_eq!(
            found(short(SetKind::DoublePlanet, 20, 120, &[20, 20])),
            [
                "set `P`: planet 1 and planet 2 cannot mesh: their centres, 20.0000 and 50.0000 modules from the axis, \
              cannot stand 20.0000 modules apart"
            ]
        );
    }

    #[test]
    fn a_pair_is_only_held_against_undercut() {
        let pair = SetSpec::teeth("F", SetKind::InternalPair, ["a", "b", "ground"], 14, 15).unwrap();
        let gearbox = start().set(pair).set(short(SetKind::Simple, 24, 72, &[])).build().unwrap();
        let form = BasicRack::default();
        let words: Vec<String> = gearbox.tooth_checks(&form).iter().map(ToothWarning::to_string).collect();
        assert_eq!(words, ["set `F`: undercut without profile shift, below 17 teeth: sun (14 teeth)"]);
        // 2/sin²25° = 11.2.
        let steep = BasicRack { pressure_angle: degrees(25.0), ..BasicRack::default() };
        assert_eq!(gearbox.tooth_checks(&steep), []);
    }
}
