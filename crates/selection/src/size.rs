//! Size of a set from its load: the ring's pitch diameter at one load factor K of the sun–planet mesh.
//!
//! ```text
//! K = F_t/(b·d₁)·(u + 1)/u = (F_t/b)·(1/d_a + 1/d_g)      F_t = 2·T_a·K_γ/(N·d_a)      b = ψ·d₁
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `K` | load factor of the mesh: contact stress squared, but for constants of material | Pa |
//! | `F_t`, `b` | tangential force, face width | N, m |
//! | `d₁`, `u` | pitch diameter of the smaller of sun and planet, the larger over it | m, 1 |
//! | `w` | working over reference diameters of sun and planets, `a/a_d` | 1 |
//! | `T_a` | the largest torque on the sun over the braked gears, with losses | N·m |
//! | `N`, `K_γ` | planets; mesh load factor: load of the most loaded mesh over its equal share | 1 |
//! | `ψ` | face-width ratio `b/d₁` | 1 |
//!
//! `w` is 1 but for sets with an offset of the ring. A planet has `d_g = r·d_a` with `r = z_g/z_a`; by equal
//! centre distances without profile shift `r = (k − 1)/2`. The mesh carries its load at the working circles,
//! `w·d_a` and `w·d_g`. `d_b` and `b = ψ·d₁` are by the reference circles, which are `m·z`. With
//! `T_a = τ·T_in` the ring has
//!
//! ```text
//! d_b³ = k³·(1 + 1/r)/(w²·min(1, r))·τ·(K_γ/N) · 2·T_in/(ψ·K)
//! ```
//!
//! The last factor is common to all sets and gearboxes at one input torque. Without it the cube root is the
//! *relative* size, and `∛(2·T_in/(ψ·K))` converts it into metres. The size therefore depends on `k`, `r` and
//! the number of planets, not on the teeth beyond these. In direct drive there is no motion within the sets,
//! and their teeth, loaded but not rolling, do not count.
//!
//! Left out:
//!
//! - the working pressure angle, which `K` does not have, and which lowers the contact stress of meshes with
//!   a large sum of shifts further;
//! - the planet–ring mesh, whose flanks are conformal and carry more;
//! - bending, which decides the module within a diameter;
//! - shafts, bearings and shift elements.

use super::Error;
use crate::quantity::Rated;
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::synthesis::ToothNumbers;
use epicyclic_units::Physical;
use std::ops::RangeInclusive;
use uom::si::f64::{Length, Pressure, Torque};

/// The largest number of planets whose mesh load factor is stated.
pub const MOST_PLANETS: u32 = epicyclic_gears::synthesis::MOST_PLANETS;

/// Data by which sizes are measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Rating {
    /// Input torque and load factor K; without them sizes are relative.
    pub load: Option<(Torque, Pressure)>,
    /// Face-width ratio `ψ = b/d₁`.
    pub face_width_ratio: f64,
    /// Mesh load factor `K_γ` with 2, 3, … 8 planets: 1 where all carry alike.
    pub mesh_load_factors: [f64; (MOST_PLANETS - 1) as usize],
    /// Planets of each set where no teeth say.
    pub planets: u32,
}

impl Default for Rating {
    /// Relative sizes, all planets carrying alike, three of them.
    fn default() -> Self {
        Self { load: None, face_width_ratio: 1.0, mesh_load_factors: [1.0; 7], planets: 3 }
    }
}

impl Rating {
    pub(crate) fn check(&self) -> Result<(), Error> {
        let check = |what, value: f64, unit| {
            if value > 0.0 && value.is_finite() { Ok(()) } else { Err(Error::Rating { what, value, unit }) }
        };
        check(Rated::FaceWidthRatio, self.face_width_ratio, "")?;
        for factor in self.mesh_load_factors {
            check(Rated::MeshLoadFactor, factor, "")?;
        }
        if !PLANETS.contains(&self.planets) {
            return Err(Error::PlanetNumber { planets: self.planets, most: MOST_PLANETS });
        }
        if let Some((torque, load_factor)) = self.load {
            check(Rated::InputTorque, torque.si(), "N·m")?;
            check(Rated::LoadFactor, load_factor.si(), "Pa")?;
        }
        Ok(())
    }

    /// `K_γ/N`: the share of the sun's force that the most loaded planet carries.
    pub(crate) fn share(&self, planets: u32) -> f64 {
        let place = planets.clamp(*PLANETS.start(), *PLANETS.end()) - PLANETS.start();
        self.mesh_load_factors[place as usize] / f64::from(planets)
    }

    /// `∛(2·T_in/(ψ·K))`; `None` where sizes are relative.
    #[must_use]
    pub fn unit(&self) -> Option<Length> {
        let (torque, load_factor) = self.load?;
        Some(Length::from_si(libm::cbrt(2.0 * torque.si() / (self.face_width_ratio * load_factor.si()))))
    }
}

const PLANETS: RangeInclusive<u32> = 2..=MOST_PLANETS;

/// `k³·(1 + 1/r)/(w²·min(1, r))`, what the ratios of ring and planet to the sun do to the cube of the size.
pub(crate) fn cube_of_ratios(k: f64, r: f64, w: f64) -> f64 {
    k * k * k * (1.0 + 1.0 / r) / r.min(1.0) / (w * w)
}

/// Relative ring diameter of a set: [`Rating::unit`] times this is its ring's pitch diameter.
///
/// | symbol | argument | meaning |
/// |---|---|---|
/// | `k` | `k` | ring-to-sun ratio |
/// | `τ` | `sun_torque` | largest torque on the sun over the input torque |
/// | `K_γ/N` | `rating`, `planets` | share of the most loaded planet |
#[must_use]
pub fn relative_ring_diameter(k: f64, sun_torque: f64, planets: u32, rating: &Rating) -> f64 {
    libm::cbrt(cube_of_ratios(k, (k - 1.0) / 2.0, 1.0) * sun_torque.abs() * rating.share(planets))
}

/// Relative ring diameter of a set of teeth; with profile shift its planets need not have `r = (k − 1)/2`.
///
/// # Errors
/// No error for a set that a search with this shift found.
pub fn relative_ring_diameter_of_teeth(
    teeth: &ToothNumbers,
    shift: Option<&ProfileShift>,
    sun_torque: f64,
    rating: &Rating,
) -> Result<f64, Error> {
    let w = working_over_reference(teeth, shift)?;
    let cube = cube_of_ratios(teeth.ring_to_sun_ratio(), teeth.planet_to_sun_ratio(), w);
    Ok(libm::cbrt(cube * sun_torque.abs() * rating.share(teeth.planets)))
}

/// `w` of a set.
pub(crate) fn working_over_reference(
    teeth: &ToothNumbers,
    shift: Option<&ProfileShift>,
) -> Result<f64, Error> {
    Ok(shift.map_or(Ok(1.0), |shift| shift.working_over_reference(teeth))?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_gears::ToothCount;
    use epicyclic_gears::involute::closing::Closing;

    /// Everything anew from F_t, b and u.
    #[test]
    fn the_mesh_carries_the_load_factor_it_was_sized_for() {
        let rating = Rating {
            load: Some((Torque::from_si(1200.0), Pressure::from_si(2.5e6))),
            face_width_ratio: 0.8,
            mesh_load_factors: [1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6],
            planets: 4,
        };
        for k in [1.6, 2.5, 3.0, 4.5] {
            let d_b = relative_ring_diameter(k, -0.7, 4, &rating) * rating.unit().unwrap().value;
            let d_a = d_b / k;
            let d_g = (d_b - d_a) / 2.0;
            let force = 2.0 * 0.7 * 1200.0 * 1.2 / (4.0 * d_a);
            let (small, large) = (d_a.min(d_g), d_a.max(d_g));
            let u = large / small;
            let factor = force / (0.8 * small * small) * (u + 1.0) / u;
            assert!((factor / 2.5e6 - 1.0).abs() < 1e-12, "k = {k}: {factor}");
        }
    }

    /// Sizes at the working circles of planets that are larger and smaller than the room between sun and
    /// ring.
    #[test]
    fn planets_of_sets_with_an_offset_count_with_their_own_teeth() {
        let teeth = |count| ToothCount::new(count).unwrap();
        let rating =
            Rating { load: Some((Torque::from_si(1200.0), Pressure::from_si(2.5e6))), ..Rating::default() };
        let shift = ProfileShift { offsets: -3..=3, closing: Closing::default() };
        for planet in [36, 37, 38, 39] {
            let set = ToothNumbers { sun: teeth(18), planet: teeth(planet), ring: teeth(93), planets: 3 };
            let size = relative_ring_diameter_of_teeth(&set, Some(&shift), 0.7, &rating).unwrap();
            let module = size * rating.unit().unwrap().value / 93.0;
            let a = module * shift.close(&set).unwrap().set.centre_distance();
            let [d_a, d_g] = [18, planet].map(|count| 2.0 * a * f64::from(count) / f64::from(18 + planet));
            let force = 2.0 * 0.7 * 1200.0 / (3.0 * d_a);
            let factor = force / (18.0 * module) * (1.0 / d_a + 1.0 / d_g);
            assert!((factor / 2.5e6 - 1.0).abs() < 1e-12, "{planet}: {factor}");
        }
    }

    #[test]
    fn a_size_without_a_torque_is_relative() {
        assert_eq!(Rating::default().unit(), None);
        let bad = Rating { load: Some((Torque::from_si(0.0), Pressure::from_si(1e6))), ..Rating::default() };
        assert!(matches!(bad.check(), Err(Error::Rating { .. })));
    }
}
