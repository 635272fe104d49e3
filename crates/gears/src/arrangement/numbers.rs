//! Tooth numbers of an arrangement and what follows from them.
//!
//! ```text
//! centre distances   2·R = m·(z_c + z_p) of a sun, m·(z_c − z_p) of a ring: equal for all meshes of a planet,
//!                    or closed by profile shift
//! assembly           N divides G
//! neighbours alike   2·R·sin(γ/2) > m·(z_p + 2·h_a* + s)        each step of a planet
//! ```
//!
//! | arrangement | `G` |
//! |---|---|
//! | stepped | `(z_a·z_f + z_b·z_g)/gcd(z_g, z_f)` |
//! | two suns, two rings | `∣z_1·z_f − z_2·z_g∣/gcd(z_g, z_f)` |
//! | Wolfrom | `gcd(z_a + z_b, (z_a·z_f + z_e·z_g)/gcd(z_g, z_f))` |
//! | Ravigneaux | `gcd(z_b − z_a, z_b + z_c)` |
//!
//! All planets are alike, also in the phase of their steps. In a Ravigneaux set the short planet clears the
//! ring and the next long planets, the long one clears the small sun; short planets and large sun lie beside
//! each other along the axis.
//!
//! # Profile shift
//! Where the centre distances of a planet differ, its carrier radius is the middle of the least and the
//! greatest, and its gears are [shifted](crate::arrangement::ArrangedShifts). Gaps are then those of the shifted gears.

use super::{Arrangement, ArrangementMode, MOST_GEARS};
use crate::gear_kind::GearKind;
use crate::involute::{InvoluteGear, Profile};
use crate::mesh::{Gear, TipCircle};
use crate::quantity::SimpleGear;
use crate::rack::BasicRack;
use crate::simple_set::Fraction;
use crate::spacing::PlanetSpacing;
use crate::teeth::gcd;
use crate::tolerance::{AT_ANGLE, AT_POSITION, TOUCH};
use crate::{Error, ToothCount};
use epicyclic_units::Physical;
use num_rational::Ratio;
use std::f64::consts::TAU;
use std::fmt;
use uom::si::f64::Angle;

/// Module of the planet's second step over that of its first.
pub type ModuleRatio = Ratio<u32>;

/// Tooth numbers of an arrangement, with its number of planets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ArrangedTeeth {
    pub(super) arrangement: Arrangement,
    pub(super) teeth: [u32; MOST_GEARS],
    pub(super) module_ratio: ModuleRatio,
    pub(super) planets: u32,
}

/// Tip radii of the gears, each in its module, and the centre distance of planets in mesh.
pub(super) struct Shape {
    pub(super) tips: [f64; MOST_GEARS],
    pub(super) planet_distance: f64,
}

/// Teeth in the order of the gears, and the number of planets: `32/34/100/30/96 ×3`.
impl fmt::Display for ArrangedTeeth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let teeth: Vec<String> = self.teeth().iter().map(u32::to_string).collect();
        f.write_str(&teeth.join("/"))?;
        if self.arrangement.is_pair() { Ok(()) } else { write!(f, " ×{}", self.planets) }
    }
}

impl ArrangedTeeth {
    /// Teeth of an arrangement in the order of its gears; the number of planets is 1 for a pair.
    ///
    /// ```
    /// use epicyclic_gears::arrangement::{ArrangedTeeth, Arrangement};
    /// let set = ArrangedTeeth::new(Arrangement::Stepped, &[18, 66, 33, 117], 1.into(), 3);
    /// assert_eq!(set.unwrap().assembly_positions(), 252);
    /// ```
    ///
    /// # Errors
    /// [`Error::NoTeeth`] unless every gear has teeth and both modules are above 0.
    pub fn new(
        arrangement: Arrangement,
        teeth: &[u32],
        module_ratio: ModuleRatio,
        planets: u32,
    ) -> Result<Self, Error> {
        let gears = arrangement.gears().len();
        if teeth.len() != gears || teeth.contains(&0) || *module_ratio.numer() == 0 || planets == 0 {
            return Err(Error::NoTeeth);
        }
        let mut all = [0; MOST_GEARS];
        all[..gears].copy_from_slice(teeth);
        Ok(Self { arrangement, teeth: all, module_ratio, planets })
    }

    /// Arrangement of the gears.
    #[must_use]
    pub const fn arrangement(&self) -> Arrangement {
        self.arrangement
    }

    /// Teeth in the order of the gears.
    #[must_use]
    pub fn teeth(&self) -> &[u32] {
        &self.teeth[..self.arrangement.gears().len()]
    }

    /// Number of planets, of a Ravigneaux set of pairs of planets; 1 of a pair.
    #[must_use]
    pub const fn planets(&self) -> u32 {
        self.planets
    }

    /// Module of the planet's second step over that of its first.
    #[must_use]
    pub const fn module_ratio(&self) -> ModuleRatio {
        self.module_ratio
    }

    /// Whether both steps of the planet are one gear.
    #[must_use]
    pub fn has_one_step(&self) -> bool {
        let of = |symbol| self.arrangement.gears().iter().position(|gear| gear.symbol == symbol);
        match (of('g'), of('f')) {
            (Some(first), Some(second)) if self.arrangement.has_steps() => {
                self.teeth[first] == self.teeth[second] && self.module_ratio == ModuleRatio::from(1)
            }
            _ => false,
        }
    }

    /// Ratio in a mode, exactly; `None` where the driven member is at rest.
    #[must_use]
    pub fn ratio(&self, mode: ArrangementMode) -> Option<Fraction> {
        let teeth = self.teeth.map(i64::from);
        let [[n_in, d_in], [n_out, d_out], [n_x, d_x]] = mode.members().map(|member| {
            let speed = member.gear().map_or([0, 1], |gear| self.arrangement.speed(gear, &teeth));
            speed.map(i128::from)
        });
        let over = (n_in * d_x - n_x * d_in) * d_out;
        let under = (n_out * d_x - n_x * d_out) * d_in;
        (under != 0).then(|| Fraction::new(over, under))
    }

    /// Module of a gear over that of the first step.
    pub(super) fn module(&self, gear: usize) -> f64 {
        match self.arrangement.gears()[gear].step {
            0 => 1.0,
            _ => f64::from(*self.module_ratio.numer()) / f64::from(*self.module_ratio.denom()),
        }
    }

    /// Whether a mesh is internal.
    fn is_internal(&self, [_, second]: [usize; 2]) -> bool {
        self.arrangement.gears()[second].role == SimpleGear::Ring
    }

    /// Twice the centre distance of a mesh in its module.
    fn doubled_distance(&self, mesh: [usize; 2]) -> i64 {
        let [first, second] = mesh.map(|gear| i64::from(self.teeth[gear]));
        if self.is_internal(mesh) { second - first } else { first + second }
    }

    /// Least and greatest doubled centre distance of the meshes of a planet with central gears, in modules of
    /// the first step over the denominator of the ratio of modules.
    fn doubled_distances(&self, planet: usize) -> [i64; 2] {
        let (over, under) = (i64::from(*self.module_ratio.numer()), i64::from(*self.module_ratio.denom()));
        let gears = self.arrangement.gears();
        let is_of = |gear: usize| {
            gear == planet || self.arrangement.has_steps() && gears[gear].role == SimpleGear::Planet
        };
        let is_central = |gear: &usize| gears[*gear].role != SimpleGear::Planet;
        let own = self.arrangement.meshes().iter();
        let own = own.filter(|mesh| mesh.iter().any(is_central) && mesh.iter().any(|gear| is_of(*gear)));
        let doubled = own.map(|mesh| {
            let factor = if gears[mesh[0]].step == 0 { under } else { over };
            self.doubled_distance(*mesh) * factor
        });
        doubled.fold([i64::MAX, i64::MIN], |[least, greatest], one| [least.min(one), greatest.max(one)])
    }

    /// Radius of the centres of a planet, in modules of its first step.
    #[must_use]
    pub fn carrier_radius(&self, planet: usize) -> f64 {
        let [least, greatest] = self.doubled_distances(planet);
        (least + greatest) as f64 / (4.0 * f64::from(*self.module_ratio.denom()))
    }

    /// Whether every mesh has a centre distance, an internal one the larger gear outside.
    pub(super) fn has_centres(&self) -> bool {
        self.arrangement.meshes().iter().all(|mesh| self.doubled_distance(*mesh) > 0)
    }

    /// Whether every planet has equal centre distances without profile shift.
    #[must_use]
    pub fn is_coaxial(&self) -> bool {
        self.planet_gears().all(|planet| {
            let [least, greatest] = self.doubled_distances(planet);
            least == greatest
        })
    }

    /// Places of the planets' gears.
    pub(super) fn planet_gears(&self) -> impl Iterator<Item = usize> + use<> {
        let gears = self.arrangement.gears();
        (0..gears.len()).filter(|gear| gears[*gear].role == SimpleGear::Planet)
    }

    /// Assembly positions in a turn, `G`; 0 where any angle will do.
    #[must_use]
    pub fn assembly_positions(&self) -> u64 {
        let z = self.teeth.map(u64::from);
        match self.arrangement {
            Arrangement::Stepped => (z[0] * z[2] + z[3] * z[1]) / gcd(z[1], z[2]),
            Arrangement::SteppedSuns | Arrangement::SteppedRings => {
                (z[0] * z[2]).abs_diff(z[3] * z[1]) / gcd(z[1], z[2])
            }
            Arrangement::Wolfrom => gcd(z[0] + z[2], (z[0] * z[3] + z[4] * z[1]) / gcd(z[1], z[3])),
            Arrangement::Ravigneaux => gcd(z[4].abs_diff(z[0]), z[4] + z[3]),
            Arrangement::ExternalPair | Arrangement::InternalPair => 0,
        }
    }

    /// Spacing of the planets as near to equal angles as assembly allows; `None` of a pair, and where there
    /// are more planets than positions.
    #[must_use]
    pub fn spacing(&self) -> Option<PlanetSpacing> {
        let planets = u64::from(self.planets);
        let positions = match self.assembly_positions() {
            0 => planets,
            positions => positions,
        };
        (!self.arrangement.is_pair() && positions >= planets)
            .then(|| PlanetSpacing::of_positions(positions, self.planets))
    }

    /// Shape of the gears without profile shift.
    fn plain_shape(&self, rack: &BasicRack) -> Shape {
        let mut tips = [0.0; MOST_GEARS];
        for ((tip, place), teeth) in tips.iter_mut().zip(self.arrangement.gears()).zip(self.teeth()) {
            let kind = if place.role == SimpleGear::Ring { GearKind::Internal } else { GearKind::External };
            *tip = Gear::new(kind, f64::from(*teeth)).tip_radius(rack);
        }
        Shape { tips, planet_distance: f64::from(self.teeth[1] + self.teeth[2]) / 2.0 }
    }

    /// Least gap between tip circles of planets, and of gears that share a plane and do not mesh, at an angle
    /// of neighbouring planets; in modules of the gears. `None` where planets in mesh do not reach each
    /// other.
    pub(super) fn gap(&self, shape: &Shape, neighbours_rad: f64) -> Option<f64> {
        let half_sine = libm::sin(neighbours_rad / 2.0);
        let circle = |gear: usize| TipCircle {
            centre_radius: self.carrier_radius(gear) / self.module(gear),
            tip_radius: shape.tips[gear],
        };
        let alike = self.planet_gears().map(|gear| circle(gear).gap_to_alike(half_sine));
        let least = alike.fold(f64::INFINITY, f64::min);
        if self.arrangement != Arrangement::Ravigneaux {
            return Some(least);
        }
        let [short, long] = [1, 2].map(circle);
        let (r_g, r_f) = (short.centre_radius, long.centre_radius);
        let distance = shape.planet_distance;
        let cosine = (r_g * r_g + r_f * r_f - distance * distance) / (2.0 * r_g * r_f);
        if cosine.is_nan() || cosine.abs() > 1.0 {
            return None;
        }
        let psi = libm::acos(cosine);
        let next = short.gap(long, neighbours_rad - psi);
        let in_ring = shape.tips[4] - r_g - short.tip_radius;
        let over_sun = r_f - long.tip_radius - shape.tips[0];
        Some(least.min(next).min(in_ring).min(over_sun))
    }

    /// Least gap between tip circles of gears in one plane that do not mesh, without profile shift, in modules
    /// of the gears; `None` of a pair.
    #[must_use]
    pub fn planet_gap(&self, rack: &BasicRack) -> Option<f64> {
        self.gap(&self.plain_shape(rack), self.spacing()?.smallest_gap().si())
    }

    /// Least gap as by [`planet_gap`](Self::planet_gap), of planets at stated angles.
    #[must_use]
    pub fn gap_at(&self, rack: &BasicRack, angles: &[Angle]) -> Option<f64> {
        self.gap(&self.plain_shape(rack), least_angle_rad(angles)?)
    }

    /// Whether planets at stated angles are all at assembly positions, counted from the first.
    #[must_use]
    pub fn assembles_at(&self, angles: &[Angle]) -> bool {
        let positions = self.assembly_positions() as f64;
        angles.iter().all(|angle| {
            let place = (angle.si() - angles[0].si()) / TAU * positions;
            let away = (place - place.round()).abs();
            away <= AT_POSITION && away * TAU <= AT_ANGLE * positions
        })
    }

    /// Whether the planets assemble, equally spaced or not, and gears that do not mesh are apart by more than
    /// `gap` modules without profile shift. A pair always does, an internal one with the larger gear outside.
    #[must_use]
    pub fn fits(&self, rack: &BasicRack, gap: f64) -> bool {
        if !self.has_centres() {
            return false;
        }
        self.arrangement.is_pair() || self.planet_gap(rack).is_some_and(|own| own > gap + TOUCH)
    }

    /// Gears of a mesh without profile shift.
    pub(super) fn gears_of_mesh(
        &self,
        mesh: [usize; 2],
        rack: &BasicRack,
    ) -> [Result<InvoluteGear, Error>; 2] {
        let profile = Profile::of_rack(*rack);
        let second = if self.is_internal(mesh) { GearKind::Internal } else { GearKind::External };
        let gear =
            |kind, gear: usize| InvoluteGear::searched(kind, ToothCount::new(self.teeth[gear])?, profile);
        [gear(GearKind::External, mesh[0]), gear(second, mesh[1])]
    }

    /// Whether the rack undercuts a gear without profile shift.
    #[must_use]
    pub fn is_undercut(&self, gear: usize, rack: &BasicRack) -> bool {
        self.arrangement.gears()[gear].role != SimpleGear::Ring
            && self.teeth[gear] < rack.least_teeth_without_undercut()
    }

    /// Greatest common divisor of the teeth of each mesh: 1 where every tooth meets every other (hunting
    /// tooth).
    #[must_use]
    pub fn common_divisors(&self) -> Vec<u32> {
        let divisor = |[one, other]: &[usize; 2]| {
            gcd(u64::from(self.teeth[*one]), u64::from(self.teeth[*other])) as u32
        };
        self.arrangement.meshes().iter().map(divisor).collect()
    }

    /// Diameter that the reference circles reach to, in modules of the first step: of the greatest central
    /// gear, or over the planets. Of an external pair twice the centre distance.
    #[must_use]
    pub fn size(&self) -> f64 {
        let gears = self.arrangement.gears().iter().enumerate();
        let reach = gears.map(|(gear, place)| {
            let own = f64::from(self.teeth[gear]) * self.module(gear);
            match place.role {
                SimpleGear::Planet => 2.0 * self.carrier_radius(gear) + own,
                _ => own,
            }
        });
        match self.arrangement {
            Arrangement::ExternalPair => f64::from(self.teeth[0] + self.teeth[1]),
            _ => reach.fold(0.0, f64::max),
        }
    }
}

/// Least angle between neighbouring planets, in rad; `None` for fewer than two or angles without a value.
#[must_use]
pub fn least_angle_rad(angles: &[Angle]) -> Option<f64> {
    let mut turns: Vec<f64> = angles.iter().map(|angle| angle.si().rem_euclid(TAU)).collect();
    turns.sort_by(f64::total_cmp);
    let next = turns.iter().skip(1).copied().chain(turns.first().map(|first| first + TAU));
    let least = turns.iter().zip(next).map(|(here, next)| next - here).reduce(f64::min)?;
    (turns.len() > 1 && turns.iter().all(|turn| turn.is_finite())).then_some(least)
}
