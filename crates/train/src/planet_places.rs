//! Positions of the planets of a set: radii of their centres, and the distances and angles between those in
//! mesh.
//!
//! ```text
//! planet and sun     R = m·(z_c + z_p)/2        planet and ring    R = m·(z_c − z_p)/2
//! planets p, q       a = m·(z_p + z_q)/2        cos ψ = (R_p² + R_q² − a²)/(2·R_p·R_q)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `R` | radius of a planet's centre from the main axis | that of `m` |
//! | `a` | distance between the centres of two planets in mesh | that of `m` |
//! | `ψ` | angle between them about the main axis | rad |
//! | `m` | module of the mesh; meshes of one gear have one module | any |
//!
//! Gears with profile shift have their working centre distances in place of these. A given radius takes
//! precedence over that of module and teeth, and gives the module of meshes for which none is given. If
//! meshes of one planet give different radii, a mesh with a module of its own takes precedence over one with
//! the set's module. Among equals the earlier mesh takes precedence.

use crate::planet_set::{GearOf, MeshKind, PlanetSet};
use crate::set::SetKind;
use crate::tolerance::FLAT;
use epicyclic_gears::ToothCount;
use epicyclic_gears::mesh::{Mesh, coaxial_planet};

/// Given modules, radii and order of the planets.
pub(crate) struct Given {
    /// Module of each mesh.
    pub(crate) modules: Vec<Option<f64>>,
    /// Module of the meshes that have none of their own.
    pub(crate) module: Option<f64>,
    /// Radius of each planet's centre.
    pub(crate) radii: Vec<Option<f64>>,
    /// For each mesh of two planets, whether the one described later is behind the other.
    pub(crate) is_behind: Vec<bool>,
    /// Centre distance of each mesh, in its modules.
    pub(crate) distances: Vec<Option<f64>>,
}

impl Given {
    /// Nothing given.
    pub(crate) fn nothing(set: &PlanetSet) -> Self {
        let (meshes, planets) = (set.meshes().len(), set.planets().len());
        Self {
            modules: vec![None; meshes],
            module: None,
            radii: vec![None; planets],
            is_behind: vec![false; meshes],
            distances: (0..meshes).map(|mesh| plain_distance(set, mesh)).collect(),
        }
    }
}

/// Two planets in mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pair {
    /// Distance of their centres.
    pub(crate) distance: f64,
    /// Pitch radii of their gears, in the order of [`PlanetSet::planets`].
    pub(crate) pitch_radii: [f64; 2],
    /// Angle from the planet described earlier to the other, about the main axis.
    pub(crate) angle_rad: f64,
}

/// Reason why two planets in mesh have no positions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum NoPair {
    /// The mesh is not between two planets.
    OtherMesh,
    /// Radius of the planet.
    Radius(usize),
    /// Module or teeth of the mesh.
    Distance,
    /// No triangle has these sides.
    Triangle { radii: [f64; 2], distance: f64 },
}

/// Positions of the planets.
pub(crate) struct Places {
    /// Module of each mesh.
    pub(crate) modules: Vec<Option<f64>>,
    /// Radius of each planet's centre.
    pub(crate) radii: Vec<Option<f64>>,
    /// Pair of planets of each mesh.
    pub(crate) pairs: Vec<Result<Pair, NoPair>>,
}

/// Teeth of a gear; of the planet of a simple set also those that equal centre distances leave it, whole or
/// not.
pub(crate) fn teeth_of(set: &PlanetSet, gear: GearOf) -> Option<f64> {
    let known = set.teeth(gear).map(ToothCount::as_f64);
    known.or_else(|| {
        let [sun, ring] = [set.centrals().first()?, set.centrals().get(1)?].map(|central| central.teeth);
        (set.kind() == Some(SetKind::Simple) && gear == GearOf::Planet(0, 0))
            .then_some(coaxial_planet(sun?, ring?))
    })
}

/// The planet of a gear, if it is a planet's.
pub(crate) fn planet_of(gear: GearOf) -> Option<usize> {
    match gear {
        GearOf::Central(_) => None,
        GearOf::Planet(planet, _) => Some(planet),
    }
}

/// Central gear and planet gear, in this order, of a mesh between the two on parallel axes; `None` for other
/// meshes.
pub(crate) fn central_mesh(set: &PlanetSet, mesh: usize) -> Option<(usize, GearOf)> {
    let mesh = set.meshes()[mesh];
    match (mesh.gears, mesh.kind) {
        (_, MeshKind::BevelLeft | MeshKind::BevelRight) => None,
        ([GearOf::Central(central), gear @ GearOf::Planet(..)], _)
        | ([gear @ GearOf::Planet(..), GearOf::Central(central)], _) => Some((central, gear)),
        _ => None,
    }
}

/// Gears of a mesh of two planets, in the order of [`PlanetSet::planets`]; `None` for other meshes.
pub(crate) fn planet_mesh(set: &PlanetSet, mesh: usize) -> Option<[GearOf; 2]> {
    let [one, other] = set.meshes()[mesh].gears;
    let (first, second) = (planet_of(one)?, planet_of(other)?);
    Some(if first < second { [one, other] } else { [other, one] })
}

/// The teeth of a mesh between a central gear and a planet, the central gear first; none that leave no centre
/// distance.
fn teeth_in_mesh(set: &PlanetSet, mesh: usize) -> Option<Mesh> {
    let (central, gear) = central_mesh(set, mesh)?;
    let (central, planet) = (teeth_of(set, GearOf::Central(central))?, teeth_of(set, gear)?);
    let mesh = match set.meshes()[mesh].kind {
        MeshKind::Internal => Mesh::internal(central, planet),
        _ => Mesh::external(central, planet),
    };
    (mesh.centre_distance() > 0.0).then_some(mesh)
}

/// Centre distance of a mesh of gears without profile shift, in modules.
fn plain_distance(set: &PlanetSet, mesh: usize) -> Option<f64> {
    centre_distance(set, mesh).or_else(|| {
        let [first, second] = planet_mesh(set, mesh)?.map(|gear| teeth_of(set, gear));
        Some(Mesh::external(first?, second?).centre_distance())
    })
}

/// `R/m` of a mesh between a central gear and a planet: `(z_c ± z_p)/2`.
pub(crate) fn centre_distance(set: &PlanetSet, mesh: usize) -> Option<f64> {
    teeth_in_mesh(set, mesh).map(Mesh::centre_distance)
}

/// `r_c/R` of a mesh between a central gear and a planet.
pub(crate) fn pitch_over_centre_distance(set: &PlanetSet, mesh: usize) -> Option<f64> {
    teeth_in_mesh(set, mesh).map(|mesh| mesh.pitch_radii()[0] / mesh.centre_distance())
}

/// Whether two meshes share a gear, and so their module.
fn share_gear(set: &PlanetSet, one: usize, other: usize) -> bool {
    set.meshes()[one].gears.iter().any(|gear| set.meshes()[other].gears.contains(gear))
}

/// Gives meshes that share a gear one module.
fn spread(set: &PlanetSet, modules: &mut [Option<f64>]) {
    for _ in 0..modules.len() {
        for mesh in 0..modules.len() {
            if modules[mesh].is_none() {
                modules[mesh] = (0..modules.len())
                    .filter(|&other| share_gear(set, mesh, other))
                    .find_map(|other| modules[other]);
            }
        }
    }
}

/// Radii that are not known yet, from the modules that are.
fn find_radii(
    set: &PlanetSet,
    distances: &[Option<f64>],
    modules: &[Option<f64>],
    radii: &mut [Option<f64>],
) {
    for (mesh, module) in modules.iter().enumerate() {
        if let (Some(module), Some((_, GearOf::Planet(planet, _)))) = (module, central_mesh(set, mesh))
            && radii[planet].is_none()
        {
            radii[planet] = distances[mesh].map(|distance| module * distance);
        }
    }
}

/// Modules that are not known yet, from the radii that are.
fn find_modules(
    set: &PlanetSet,
    distances: &[Option<f64>],
    radii: &[Option<f64>],
    modules: &mut [Option<f64>],
) {
    for (mesh, module) in modules.iter_mut().enumerate() {
        if let (None, Some((_, GearOf::Planet(planet, _)))) = (&module, central_mesh(set, mesh)) {
            *module = radii[planet].zip(distances[mesh]).map(|(radius, distance)| radius / distance);
        }
    }
}

/// Gives radii to planets that mesh with other planets alone, where nothing states them: along a chain
/// between two known planets the radius changes in proportion to the distances of the centres, so that no
/// step is larger than its distance unless all are; beyond the last known one it stays. `distances` are those
/// of the meshes. Returns the planets that got one.
pub(crate) fn assume_radii(
    set: &PlanetSet,
    distances: &[Option<f64>],
    radii: &mut [Option<f64>],
) -> Vec<usize> {
    /// A round takes at least a quarter off the error of a chain of five.
    const ROUNDS: usize = 300;
    let pair = |mesh: usize| {
        let [one, other] = planet_mesh(set, mesh)?.map(planet_of);
        Some(([one?, other?], distances[mesh].filter(|distance| *distance > 0.0)?))
    };
    let pairs: Vec<([usize; 2], f64)> = (0..distances.len()).filter_map(pair).collect();
    let open: Vec<usize> = (0..radii.len()).filter(|planet| radii[*planet].is_none()).collect();
    for _ in 0..ROUNDS {
        for &planet in &open {
            let beside = pairs.iter().filter_map(|([one, other], distance)| {
                let mate = if *one == planet { *other } else { *one };
                Some((radii[mate]?, 1.0 / distance)).filter(|_| [*one, *other].contains(&planet))
            });
            let (sum, weight) =
                beside.fold((0.0, 0.0), |(sum, weight), (radius, own)| (sum + own * radius, weight + own));
            if weight > 0.0 {
                radii[planet] = Some(sum / weight);
            }
        }
    }
    open.into_iter().filter(|planet| radii[*planet].is_some()).collect()
}

/// Positions of the planets that follow from the given values.
pub(crate) fn places(set: &PlanetSet, given: &Given) -> Places {
    let mut modules = given.modules.clone();
    spread(set, &mut modules);
    let mut radii = given.radii.clone();
    find_radii(set, &given.distances, &modules, &mut radii);
    for module in &mut modules {
        *module = module.or(given.module);
    }
    // Every round settles a planet or is the last.
    for _ in 0..=radii.len() {
        find_radii(set, &given.distances, &modules, &mut radii);
        find_modules(set, &given.distances, &radii, &mut modules);
        spread(set, &mut modules);
    }
    let pairs = (0..modules.len())
        .map(|mesh| pair(set, mesh, [modules[mesh], given.distances[mesh]], &radii, given.is_behind[mesh]))
        .collect();
    Places { modules, radii, pairs }
}

fn pair(
    set: &PlanetSet,
    mesh: usize,
    [module, distance]: [Option<f64>; 2],
    radii: &[Option<f64>],
    is_behind: bool,
) -> Result<Pair, NoPair> {
    let gears = planet_mesh(set, mesh).ok_or(NoPair::OtherMesh)?;
    let [first, second] = gears.map(|gear| planet_of(gear).unwrap_or_default());
    let r1 = radii[first].ok_or(NoPair::Radius(first))?;
    let r2 = radii[second].ok_or(NoPair::Radius(second))?;
    let [z1, z2] = gears.map(|gear| teeth_of(set, gear));
    let ((module, distance), (z1, z2)) = module.zip(distance).zip(z1.zip(z2)).ok_or(NoPair::Distance)?;
    let plain = Mesh::external(z1, z2);
    let stretch = distance / plain.centre_distance();
    let distance = module * distance;
    let cosine = (r1 * r1 + r2 * r2 - distance * distance) / (2.0 * r1 * r2);
    if cosine.is_nan() || cosine.abs() > 1.0 + FLAT {
        return Err(NoPair::Triangle { radii: [r1, r2], distance });
    }
    let ahead_rad = libm::acos(cosine.clamp(-1.0, 1.0));
    Ok(Pair {
        distance,
        pitch_radii: plain.pitch_radii().map(|radius| module * radius * stretch),
        angle_rad: if is_behind { -ahead_rad } else { ahead_rad },
    })
}

impl Places {
    /// Angles of the planets about the main axis, from the first of those that meshes of planets tie
    /// together; and which is that first.
    pub(crate) fn angles(&self, set: &PlanetSet) -> Vec<(usize, f64)> {
        let mut angles: Vec<(usize, f64)> = (0..self.radii.len()).map(|planet| (planet, 0.0)).collect();
        // Meshes form a tree: each joins two groups of planets.
        for (mesh, pair) in self.pairs.iter().enumerate() {
            let (Ok(pair), Some([Some(first), Some(second)])) =
                (pair, planet_mesh(set, mesh).map(|gears| gears.map(planet_of)))
            else {
                continue;
            };
            let ((group, at), (joined, from)) = (angles[first], angles[second]);
            for angle in angles.iter_mut().filter(|angle| angle.0 == joined) {
                *angle = (group, angle.1 - from + at + pair.angle_rad);
            }
        }
        angles
    }
}
