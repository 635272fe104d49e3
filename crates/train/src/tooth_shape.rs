//! Teeth of the gears of a set beyond their numbers, as a description states them.

use epicyclic_gears::involute::profile::Cutting;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

/// Profile shifts of the gears of a set, in the order of [`PlanetSet::gears`](crate::PlanetSet::gears), with
/// the sign of [`involute`](epicyclic_gears::involute): one above 0 moves the tips of a ring inwards.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shifts {
    /// Profile shift coefficients `x`, modules; 0 of gears at the end that are left out.
    pub profile: Vec<f64>,
    /// Tip alterations `k`, below 0 shorter, modules; where none are given the tips of rings are shortened to
    /// stay out of the fillets of the planets.
    pub tips: Option<Vec<f64>>,
}

/// Teeth of the gears of a set beyond their numbers.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ToothShape {
    /// Profile shifts.
    pub shifts: Option<Shifts>,
    /// Helix angle `β` at the reference cylinders of each mesh, in the order of
    /// [`PlanetSet::meshes`](crate::PlanetSet::meshes), with the sign of its
    /// [hand](crate::axial_forces); 0 of meshes at the end that are left out.
    pub helix_angles: Vec<Angle>,
    /// Cutting of each gear, in the order of [`PlanetSet::gears`](crate::PlanetSet::gears); as usual of gears
    /// at the end that are left out.
    pub cutting: Vec<Cutting>,
}

impl ToothShape {
    /// Whether any mesh is helical.
    #[must_use]
    pub fn is_helical(&self) -> bool {
        self.helix_angles.iter().any(|angle| angle.si() != 0.0)
    }

    /// Whether shifts or helical teeth make gears other than plain spur gears.
    #[must_use]
    pub fn has_shape(&self) -> bool {
        self.shifts.is_some() || self.is_helical()
    }

    /// Size of the helix angle of a mesh.
    #[must_use]
    pub fn helix_angle(&self, mesh: usize) -> Angle {
        self.signed_helix_angle(mesh).abs()
    }

    /// Helix angle of a mesh with the sign of its [hand](crate::axial_forces).
    #[must_use]
    pub fn signed_helix_angle(&self, mesh: usize) -> Angle {
        self.helix_angles.get(mesh).copied().unwrap_or_default()
    }

    /// Transverse module of a mesh, `m_t = m_n/cos β`.
    #[must_use]
    pub fn transverse_module(&self, mesh: usize, normal: Length) -> Length {
        normal / libm::cos(self.helix_angle(mesh).si())
    }

    pub(crate) fn shift(&self, gear: usize) -> f64 {
        self.shifts.as_ref().and_then(|shifts| shifts.profile.get(gear)).copied().unwrap_or_default()
    }

    pub(crate) fn tip(&self, gear: usize) -> f64 {
        let tips = self.shifts.as_ref().and_then(|shifts| shifts.tips.as_ref());
        tips.and_then(|tips| tips.get(gear)).copied().unwrap_or_default()
    }

    pub(crate) fn has_tips(&self) -> bool {
        self.shifts.as_ref().is_some_and(|shifts| shifts.tips.is_some())
    }

    pub(crate) fn cutting(&self, gear: usize) -> Cutting {
        self.cutting.get(gear).copied().unwrap_or_default()
    }
}
