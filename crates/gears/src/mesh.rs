//! Meshes and neighbouring planets from tooth numbers: pitch, tip and root circles, centre distance,
//! clearance.
//!
//! ```text
//! pitch circle        r = z/2
//! tip circle          r_a = r + h_a*             internal: r − h_a*
//! root circle         r_f = r − h_a* − c*        internal: r + h_a* + c*
//! centre distance     a = r_1 + r_2              internal: r_ring − r_planet
//! planets alike       2·a·sin(γ/2) > 2·r_a + s   they clear each other
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `z` | teeth | 1 |
//! | `r`, `r_a`, `r_f`, `a` | radii and centre distance | modules |
//! | `h_a*`, `c*` | [`BasicRack`] | modules |
//! | `γ` | angle between two planets about the main axis | rad |
//! | `s` | required gap between the tip circles of two planets | modules |
//!
//! Gears have no profile shift. The synthesis of tooth numbers, the drive, the gearbox and its tooth checks
//! all use this module, so that a profile shift would be introduced in one place.

use crate::gear_kind::GearKind;
use crate::rack::BasicRack;
use crate::teeth::ToothCount;
use std::f64::consts::PI;

/// Usual gap between the tip circles of neighbouring planets, in modules. It covers errors of pitch, runout
/// and pins.
pub const USUAL_PLANET_GAP: f64 = 0.5;

/// A gear as its meshes see it; lengths in modules.
///
/// Its teeth need not be whole: equal centre distances may leave a planet half a tooth.
///
/// ```
/// use epicyclic_gears::{mesh::Gear, rack::BasicRack};
/// let rack = BasicRack::default();
/// assert_eq!(
///     (Gear::external(20.0).tip_radius(&rack), Gear::internal(100.0).tip_radius(&rack)),
///     (11.0, 49.0),
/// );
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gear {
    kind: GearKind,
    teeth: f64,
}

impl Gear {
    /// Gear with this number of teeth.
    #[must_use]
    pub const fn new(kind: GearKind, teeth: f64) -> Self {
        Self { kind, teeth }
    }

    /// A sun or a planet.
    #[must_use]
    pub const fn external(teeth: f64) -> Self {
        Self::new(GearKind::External, teeth)
    }

    /// A ring.
    #[must_use]
    pub const fn internal(teeth: f64) -> Self {
        Self::new(GearKind::Internal, teeth)
    }

    /// Pitch radius `r = z/2`.
    #[must_use]
    pub fn pitch_radius(self) -> f64 {
        self.teeth / 2.0
    }

    /// Tip radius `r_a`: the largest of an external gear, the smallest of an internal one.
    #[must_use]
    pub fn tip_radius(self, rack: &BasicRack) -> f64 {
        self.outwards(rack.addendum)
    }

    /// Root radius `r_f`: the bottom of the tooth spaces.
    #[must_use]
    pub fn root_radius(self, rack: &BasicRack) -> f64 {
        self.outwards(-(rack.addendum + rack.clearance))
    }

    /// The radius so far from the pitch circle, towards the tips.
    fn outwards(self, height: f64) -> f64 {
        match self.kind {
            GearKind::External => self.pitch_radius() + height,
            GearKind::Internal => self.pitch_radius() - height,
        }
    }
}

/// Two gears in mesh.
///
/// ```
/// use epicyclic_gears::mesh::Mesh;
/// let (sun, ring) = (Mesh::external(20.0, 40.0), Mesh::internal(100.0, 40.0));
/// assert_eq!((sun.centre_distance(), ring.centre_distance()), (30.0, 30.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mesh {
    first: Gear,
    second: Gear,
}

impl Mesh {
    /// External pair with these tooth numbers.
    #[must_use]
    pub const fn external(first: f64, second: f64) -> Self {
        Self { first: Gear::external(first), second: Gear::external(second) }
    }

    /// A ring, and the gear within it.
    #[must_use]
    pub const fn internal(ring: f64, within: f64) -> Self {
        Self { first: Gear::internal(ring), second: Gear::external(within) }
    }

    /// Centre distance `a`, in modules; 0 or less where a ring has no more teeth than the gear within it.
    #[must_use]
    pub fn centre_distance(self) -> f64 {
        match self.first.kind {
            GearKind::External => self.first.pitch_radius() + self.second.pitch_radius(),
            GearKind::Internal => self.first.pitch_radius() - self.second.pitch_radius(),
        }
    }

    /// Pitch radii of the two, in modules, a ring's first.
    #[must_use]
    pub fn pitch_radii(self) -> [f64; 2] {
        [self.first.pitch_radius(), self.second.pitch_radius()]
    }
}

/// Teeth of the ring whose planet centre distance equals that of the sun, `z_b = z_a + 2·z_g`.
#[must_use]
pub const fn coaxial_ring(sun: u32, planet: u32) -> u32 {
    sun + 2 * planet
}

/// Teeth of the planet with equal centre distances to sun and ring, `z_g = (z_b − z_a)/2`. The value need not
/// be whole, and is not above 0 where the ring has no more teeth than the sun.
#[must_use]
pub fn coaxial_planet(sun: ToothCount, ring: ToothCount) -> f64 {
    (ring.as_f64() - sun.as_f64()) / 2.0
}

/// A planet as its neighbours see it: its tip circle, about a centre that circles the main axis.
///
/// Both radii in one unit, of whichever length.
///
/// ```
/// use epicyclic_gears::{ToothCount, mesh::TipCircle, rack::BasicRack};
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// let planet = TipCircle::of_planet(ToothCount::new(24)?, ToothCount::new(20)?, &BasicRack::default());
/// // Six touch: (24 + 20)·sin 30° = 20 + 2.
/// assert_eq!(planet.most(0.0), 5);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TipCircle {
    /// Radius of the centre from the main axis: the centre distance.
    pub centre_radius: f64,
    /// Tip radius `r_a`.
    pub tip_radius: f64,
}

impl TipCircle {
    /// A planet in mesh with a sun, in modules.
    #[must_use]
    pub fn of_planet(sun: ToothCount, planet: ToothCount, rack: &BasicRack) -> Self {
        let (sun, planet) = (sun.as_f64(), planet.as_f64());
        Self {
            centre_radius: Mesh::external(sun, planet).centre_distance(),
            tip_radius: Gear::external(planet).tip_radius(rack),
        }
    }

    /// Gap to the tip circle of another planet, at an angle about the main axis; negative where they overlap.
    ///
    /// ```text
    /// e = √(R_1² + R_2² − 2·R_1·R_2·cos γ) − r_a1 − r_a2
    /// ```
    #[must_use]
    pub fn gap(self, other: Self, angle_rad: f64) -> f64 {
        let (r1, r2) = (self.centre_radius, other.centre_radius);
        let square = r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * libm::cos(angle_rad);
        square.max(0.0).sqrt() - (self.tip_radius + other.tip_radius)
    }

    /// Gap to the next planet of the same kind, from the sine of half the angle between them.
    ///
    /// ```text
    /// 2·a·sin(γ/2) − 2·r_a
    /// ```
    #[must_use]
    pub fn gap_to_alike(self, half_angle_sine: f64) -> f64 {
        2.0 * (self.centre_radius * half_angle_sine - self.tip_radius)
    }

    /// Whether planets of the same kind clear each other by more than `gap`, from the sine of half the angle
    /// between neighbours.
    #[must_use]
    pub fn clears_alike(self, half_angle_sine: f64, gap: f64) -> bool {
        self.centre_radius * half_angle_sine > self.reach(gap)
    }

    /// Half of what neighbours need.
    fn reach(self, gap: f64) -> f64 {
        self.tip_radius + gap / 2.0
    }

    /// Limit of the number of equally spaced planets, `180°/arcsin((r_a + s/2)/a)`: fewer than this clear
    /// each other by more than `gap`. `None` where two already do not.
    ///
    /// # Source
    /// excavator-dynamics, where it is called the condition of neighbourhood.
    #[must_use]
    pub fn number_limit(self, gap: f64) -> Option<f64> {
        let sine = self.reach(gap) / self.centre_radius;
        (sine > 0.0 && sine < 1.0).then(|| PI / libm::asin(sine))
    }

    /// The largest number of equally spaced planets that clear each other by more than `gap`, whether or not
    /// they assemble; 1 where not even two do.
    #[must_use]
    pub fn most(self, gap: f64) -> u32 {
        self.number_limit(gap).map_or(1, |limit| {
            let below = limit.ceil() as u32 - 1;
            // The inequality itself decides where rounding made the limit a whole number.
            let more = below + 1;
            if self.clears_alike(libm::sin(PI / f64::from(more)), gap) { more } else { below.max(1) }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn planet(sun: u32, planet: u32) -> TipCircle {
        let [sun, planet] = [sun, planet].map(|count| ToothCount::new(count).unwrap());
        TipCircle::of_planet(sun, planet, &BasicRack::default())
    }

    #[test]
    fn planets_that_just_touch_do_not_clear_each_other() {
        // Six planets: (z_a + z_g)/2 = z_g + 2 leaves no gap at all.
        assert_eq!((planet(24, 20).most(0.0), planet(25, 20).most(0.0)), (5, 6));
    }

    #[test]
    fn the_excavator_has_its_limit_of_planets() {
        let limit = planet(20, 40).number_limit(0.0).unwrap();
        assert!((limit - 180.0 / 44.427_004).abs() < 1e-6);
        assert_eq!((planet(2, 40).number_limit(0.0), planet(2, 40).most(0.0)), (None, 1));
    }

    #[test]
    fn a_ring_no_larger_than_its_planet_has_no_centre_distance() {
        assert_eq!(Mesh::internal(40.0, 41.0).centre_distance(), -0.5);
        assert_eq!(Mesh::internal(40.0, 40.0).centre_distance(), 0.0);
    }

    proptest! {
        #[test]
        fn most_is_the_last_number_that_clears(sun in 5..120_u32, teeth in 5..120_u32, gap in 0.0..1.5_f64) {
            let clears = |n: u32| {
                f64::from(sun + teeth) * libm::sin(PI / f64::from(n)) > f64::from(teeth) + 2.0 + gap
            };
            let last = (2..200).take_while(|&n| clears(n)).last().unwrap_or(1);
            prop_assert_eq!(planet(sun, teeth).most(gap), last);
        }

        /// The law of cosines against the chord.
        #[test]
        fn the_gap_to_one_alike_is_that_to_any_planet(sun in 5..120_u32, teeth in 5..120_u32, n in 2..30_u32) {
            let planet = planet(sun, teeth);
            let chord = planet.gap_to_alike(libm::sin(PI / f64::from(n)));
            let any = planet.gap(planet, 2.0 * PI / f64::from(n));
            prop_assert!((any - chord).abs() < 1e-11 * planet.centre_radius);
        }
    }
}
