//! A mesh, its load, and how to calculate.

use crate::factor::{Edition, Given};
use crate::load::{Dynamics, Floating};
use crate::material::Material;
use crate::root::factors::Bending;
use crate::root::section::Shaper;
use epicyclic_gears::involute::Pair;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Force, KinematicViscosity, Length, Time, Torque};

/// A gear of the mesh beyond its geometry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gear {
    /// Material of the gear.
    pub material: Material,
    /// Roughness `R_z` of the flank.
    pub flank_roughness: Length,
    /// Roughness `R_z` of the root.
    pub root_roughness: Length,
    /// Thickness `s_R` of the rim under the teeth; `None` of a solid gear.
    pub rim: Option<Length>,
    /// The shaper that cuts an internal gear.
    pub shaper: Option<Shaper>,
    /// Bending of its teeth.
    pub bending: Bending,
}

impl Gear {
    /// A solid external gear whose teeth are bent to one side, with the roughness `R_z` of flank and root.
    #[must_use]
    pub const fn solid(material: Material, flank_roughness: Length, root_roughness: Length) -> Self {
        Self { material, flank_roughness, root_roughness, rim: None, shaper: None, bending: Bending::OneWay }
    }
}

/// A mesh: geometry, width, gears, oil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mesh {
    /// The pair, in modules.
    pub pair: Pair,
    /// Normal module `m_n`.
    pub module: Length,
    /// Common face width `b`.
    pub face_width: Length,
    /// The gears, in the pair's order.
    pub gears: [Gear; 2],
    /// Viscosity of the oil at 40 °C, `ν_40`.
    pub viscosity: KinematicViscosity,
}

impl Mesh {
    /// `F_t = 2·T/d_1` at the reference cylinders, of a torque on the first gear.
    #[must_use]
    pub fn tangential_force(&self, torque: Torque) -> Force {
        Force::from_si(2000.0 * torque.si() / (self.pair.gears()[0].reference_diameter() * self.module.mm()))
    }
}

/// One load of a mesh, for the whole required life.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Torque of one mesh on the first gear.
    pub torque: Torque,
    /// Speed of the first gear relative to the carrier.
    pub speed: AngularVelocity,
    /// Required life.
    pub life: Time,
    /// Contacts of a flank per revolution, of each gear.
    pub contacts: [f64; 2],
}

/// Method of calculation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Method {
    /// Edition of the standard.
    pub edition: Edition,
    /// Factors given instead of calculated; `K_A` and `K_Hβ` must be.
    pub given: Given,
    /// Planets, for `K_γ` by [`load_sharing`](crate::load::load_sharing) where it is not given.
    pub planets: Option<u32>,
    /// Whether a member of their set floats, for `K_γ` too.
    pub floating: Floating,
    /// Deviations and masses, for `K_v`, `K_Hα` and `K_Fα` where they are not given.
    pub dynamics: Option<Dynamics>,
    /// Whether some pitting is allowed.
    pub pitting_allowed: bool,
    /// Life factors at 10¹⁰ cycles, 0.85 to 1.
    pub long_life_factor: f64,
    /// Accuracy grade by ISO 1328-1, for `Y_DT`.
    pub accuracy_grade: u8,
}

impl Default for Method {
    /// The corrected edition; nothing given; no pitting; 0.85; grade 6.
    fn default() -> Self {
        Self {
            edition: Edition::default(),
            given: Given::default(),
            planets: None,
            floating: Floating::Assumed,
            dynamics: None,
            pitting_allowed: false,
            long_life_factor: 0.85,
            accuracy_grade: 6,
        }
    }
}
