//! The gears of a set seen along its axis, every one in mesh.
//!
//! Helical gears are seen in their transverse section. Seen from gear `A` with centre `O_A`, a meshing gear
//! `B` lies in direction `φ`. A tooth of one gear lies in the middle of a space of the other if
//!
//! ```text
//! external   z_A·(φ − t_A) + z_B·(φ + π − t_B) = π
//! internal   z_B·(φ − t_B) − z_A·(φ − t_A) = π
//! ```
//!
//! up to turns of 2π. `t` is the angle of the centre line of a tooth. In an internal mesh `B` is the ring,
//! and `φ` is the direction from its centre to that of `A`. Profile shifts do not change the rule: they make
//! both flanks of a tooth thicker alike. Backlash is therefore the same at both flanks, and flanks that press
//! into each other overlap as much at both.
//!
//! The first central gear has a tooth along the first axis; every other gear follows from one with which it
//! meshes. A gear of a stepped planet that meshes with no placed gear is turned like the planet's first.
//!
//! Planets whose spacing is not stated are at the assembly positions nearest to equal angles. Planets of an
//! unknown number are as many as asked for, or as have room.
//!
//! The radius of a planet that meshes with no central gear does not follow from the meshes. If none is stated,
//! one between the radii of its neighbours is assumed ([`InMesh::assumed`]).

use crate::PlanetSet;
use crate::planet_places::{assume_radii, planet_of};
use crate::planet_set::GearOf;
use crate::spacing::Spacing;
use crate::toothed::{ToothedSet, Untoothed};
use epicyclic_gears::Error;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::Pair;
use epicyclic_gears::involute::curve::ToothCurve;
use epicyclic_gears::spacing::PlanetSpacing;
use epicyclic_units::Physical;
use std::f64::consts::{PI, TAU};

/// Rim of a ring beyond its root circle as it is drawn, modules.
const RIM: f64 = 3.0;

/// Reason why the gears of a set have no places in mesh.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Unplaced {
    /// The set has no teeth in mesh.
    #[error(transparent)]
    Untoothed(#[from] Untoothed),
    /// A gear that its tool does not cut.
    #[error(transparent)]
    Uncut(#[from] Error),
    /// A planet that no mesh ties to a central gear.
    #[error("no mesh ties planet {planet} to a central gear, so its radius is not known")]
    Free {
        /// Name of the planet.
        planet: String,
    },
    /// Two planets in mesh whose centres are at other distances than their gears require.
    #[error("two planets in mesh do not reach each other at the radii that their other meshes give")]
    Apart,
}

/// A gear with the outline of its teeth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearInMesh {
    /// The gear.
    pub of: GearOf,
    /// Tooth as the tool leaves it, in modules.
    pub curve: ToothCurve,
    /// Normal module, in the unit of [`ToothedSet`].
    pub module: f64,
    /// Radius of its working circle in its first mesh, in the unit of the modules.
    pub working_radius: f64,
}

impl GearInMesh {
    /// Whether it is internal.
    #[must_use]
    pub fn is_ring(&self) -> bool {
        self.curve.gear().kind() == GearKind::Internal
    }

    /// Tip radius in the unit of the modules.
    #[must_use]
    pub fn tip_radius(&self) -> f64 {
        self.module * self.curve.tip_radius()
    }

    /// Outer radius in the unit of the modules: of a ring that of the rim with which it is drawn.
    #[must_use]
    pub fn outer_radius(&self) -> f64 {
        if self.is_ring() { self.module * (self.curve.root_radius() + RIM) } else { self.tip_radius() }
    }
}

/// A mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mesh {
    /// Indices of the gears in [`InMesh::gears`]; a ring is the second.
    pub gears: [usize; 2],
    /// The pair, in modules.
    pub pair: Pair,
    /// Normal module, in the unit of [`ToothedSet`].
    pub module: f64,
}

/// A gear at its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placed {
    /// Index of the gear in [`InMesh::gears`].
    pub gear: usize,
    /// Centre of the gear, in the unit of the modules.
    pub centre: [f64; 2],
    /// Angle of the centre line of one of its teeth, rad.
    pub turn_rad: f64,
}

/// A planet at its place.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedPlanet {
    /// Distance of its centre from the main axis, in the unit of the modules.
    pub centre_distance: f64,
    /// Angle of its centre about the main axis, rad.
    pub angle_rad: f64,
    /// Gears of the planet.
    pub gears: Vec<Placed>,
}

/// The gears of a set in mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct InMesh {
    /// The gears: central gears, then those of the planets.
    pub gears: Vec<GearInMesh>,
    /// The central gears at their places: about the main axis, or those of a pair about a point between them.
    pub centrals: Vec<Placed>,
    /// The planets, those of one tree of meshes together.
    pub planets: Vec<PlacedPlanet>,
    /// The meshes, in the order of [`PlanetSet::meshes`].
    pub meshes: Vec<Mesh>,
    /// Planets whose radius is assumed, by their index, with the radius in the unit of the modules.
    pub assumed: Vec<(usize, f64)>,
}

impl InMesh {
    /// Every gear at every place.
    pub fn placed(&self) -> impl Iterator<Item = &Placed> {
        self.centrals.iter().chain(self.planets.iter().flat_map(|planet| &planet.gears))
    }

    /// Groups of gears that mesh with each other: those of one plane.
    #[must_use]
    pub fn planes(&self) -> Vec<Vec<usize>> {
        let gears: Vec<[usize; 2]> = self.meshes.iter().map(|mesh| mesh.gears).collect();
        let plane = |meshes: Vec<usize>| {
            let mut plane: Vec<usize> = meshes.into_iter().flat_map(|mesh| gears[mesh]).collect();
            plane.sort_unstable();
            plane.dedup();
            plane
        };
        let mut planes: Vec<Vec<usize>> = sharing(&gears).into_iter().map(plane).collect();
        planes.sort_unstable();
        planes
    }
}

/// Meshes that share gears, together, by their two gears.
#[must_use]
pub fn sharing<G: PartialEq>(meshes: &[[G; 2]]) -> Vec<Vec<usize>> {
    let mut all: Vec<Vec<usize>> = vec![];
    for mesh in 0..meshes.len() {
        let shares = |group: &Vec<usize>| {
            group.iter().flat_map(|other| &meshes[*other]).any(|gear| meshes[mesh].contains(gear))
        };
        let (sharing, others): (Vec<_>, Vec<_>) = all.into_iter().partition(shares);
        let mut group = sharing.concat();
        group.push(mesh);
        group.sort_unstable();
        all = others;
        all.push(group);
    }
    all.sort_unstable();
    all
}

impl PlanetSet {
    /// The gears in mesh, seen along the axis; `most` planets of a kind where their number is not known, or
    /// as many as have room. `is_behind` as in [`angles_between`](Self::angles_between).
    ///
    /// # Errors
    /// [`Unplaced`].
    pub fn in_mesh(&self, toothed: &ToothedSet, is_behind: &[bool], most: u32) -> Result<InMesh, Unplaced> {
        let placing = Placing::new(self, toothed, is_behind)?;
        let count = self.planet_count().unwrap_or_else(|| {
            (1..=most).rev().find(|count| placing.have_room(&self.shown_angles(*count))).unwrap_or(1)
        });
        Ok(placing.in_mesh(&self.shown_angles(count)))
    }

    /// Angles of so many planets of a kind about the main axis, as they are drawn, rad.
    #[must_use]
    pub fn shown_angles(&self, count: u32) -> Vec<f64> {
        let positions = self.assembly_positions().filter(|positions| *positions >= u64::from(count));
        let angles = match positions {
            Some(positions) if positions > 0 && *self.spacing() == Spacing::default() => {
                Some(PlanetSpacing::of_positions(positions, count).angles())
            }
            _ => self.planet_angles(),
        };
        match angles {
            Some(angles) => angles.into_iter().map(Physical::si).collect(),
            None => (0..count).map(|copy| TAU * f64::from(copy) / f64::from(count)).collect(),
        }
    }
}

/// Gears of a set, and the radius and angle of each planet from the first.
struct Placing<'s> {
    set: &'s PlanetSet,
    gears: Vec<GearInMesh>,
    meshes: Vec<Mesh>,
    planets: Vec<[f64; 2]>,
    assumed: Vec<(usize, f64)>,
}

impl<'s> Placing<'s> {
    fn new(set: &'s PlanetSet, toothed: &ToothedSet, is_behind: &[bool]) -> Result<Self, Unplaced> {
        let (centrals, planets): (Vec<GearOf>, Vec<GearOf>) =
            set.gears().into_iter().partition(|gear| planet_of(*gear).is_none());
        let mut gears = vec![];
        for of in centrals.into_iter().chain(planets) {
            let Some(mesh) = toothed.meshes.iter().find(|mesh| mesh.gears.contains(&of)) else { continue };
            let end = usize::from(mesh.gears[1] == of);
            gears.push(GearInMesh {
                of,
                curve: ToothCurve::new(mesh.pair.gears()[end])?,
                module: mesh.module,
                working_radius: 0.5 * mesh.module * mesh.pair.working_diameters()[end],
            });
        }
        let index = |of: GearOf| gears.iter().position(|gear| gear.of == of).unwrap_or_default();
        let meshes = toothed.meshes.iter();
        let meshes =
            meshes.map(|mesh| Mesh { gears: mesh.gears.map(index), pair: mesh.pair, module: mesh.module });
        let meshes = meshes.collect();
        let mut toothed = toothed.clone();
        let distances = toothed.meshes.iter().map(|mesh| Some(mesh.module * mesh.pair.centre_distance()));
        let assumed = assume_radii(set, &distances.collect::<Vec<_>>(), &mut toothed.radii);
        let free = |planet| Unplaced::Free { planet: set.gear_name(GearOf::Planet(planet, 0)) };
        let radii: Result<Vec<f64>, Unplaced> = toothed
            .radii
            .iter()
            .enumerate()
            .map(|(planet, radius)| radius.ok_or_else(|| free(planet)))
            .collect();
        let radii = radii?;
        let angles = set.angles_between(&toothed, is_behind).ok_or(Unplaced::Apart)?;
        let planets = radii.iter().zip(angles).map(|(radius, (_, angle))| [*radius, angle.si()]).collect();
        let assumed = assumed.into_iter().map(|planet| (planet, radii[planet])).collect();
        Ok(Self { set, gears, meshes, planets, assumed })
    }

    /// Whether planets at these angles do not overlap; those of one angle may mesh.
    fn have_room(&self, angles: &[f64]) -> bool {
        let tip = |planet: usize| {
            let own = self.gears.iter().filter(|gear| planet_of(gear.of) == Some(planet));
            own.map(GearInMesh::tip_radius).fold(0.0, f64::max)
        };
        let tips: Vec<f64> = (0..self.planets.len()).map(tip).collect();
        let clears = |between: f64| {
            self.planets.iter().zip(&tips).all(|([r1, a1], one)| {
                self.planets.iter().zip(&tips).all(|([r2, a2], other)| {
                    let square = r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * libm::cos(a2 - a1 + between);
                    square.sqrt() > one + other
                })
            })
        };
        angles
            .iter()
            .enumerate()
            .all(|(place, one)| angles.iter().skip(place + 1).all(|other| clears(other - one)))
    }

    /// Centres of the two gears of a pair; their tips are equally far from the origin, which is the centre of
    /// a ring.
    fn pair_centres(&self) -> Option<Vec<[f64; 2]>> {
        let [first, second] = [self.gears.first()?, self.gears.get(1)?];
        let distance = if second.is_ring() {
            second.working_radius - first.working_radius
        } else {
            first.working_radius + second.working_radius
        };
        let middle = 0.5 * (distance + second.tip_radius() - first.tip_radius());
        let shift = if second.is_ring() { distance } else { -middle };
        let other = if second.is_ring() { -distance } else { distance };
        self.set.is_pair().then(|| vec![[shift, 0.0], [shift + other, 0.0]])
    }

    /// Every gear turned so that it meshes; the planets at each of the angles.
    fn in_mesh(self, angles: &[f64]) -> InMesh {
        let Self { set, gears, meshes, planets: places, .. } = &self;
        let of_pair = self.pair_centres();
        let is_central = |gear: usize| planet_of(gears[gear].of).is_none();
        let teeth = |gear: usize| gears[gear].curve.gear().teeth().as_f64();
        let mut central_turns: Vec<Option<f64>> = vec![None; gears.len()];
        if let Some(first) = central_turns.first_mut() {
            *first = Some(0.0);
        }
        let central = |gear: usize| of_pair.as_ref().map_or([0.0; 2], |of_pair| of_pair[gear]);
        let mut planets = vec![];
        // The gears of a pair have no planets between them.
        let angles = if places.is_empty() { &[0.0] } else { angles };
        for start in angles {
            let centre = |gear: usize| match planet_of(gears[gear].of) {
                None => central(gear),
                Some(planet) => {
                    let (sin, cos) = libm::sincos(start + places[planet][1]);
                    [places[planet][0] * cos, places[planet][0] * sin]
                }
            };
            let mut turns = central_turns.clone();
            while turns.contains(&None) {
                let mut is_new = false;
                for &Mesh { gears: [one, other], .. } in meshes {
                    let (from, to, turn) = match (turns[one], turns[other]) {
                        (Some(turn), None) => (one, other, turn),
                        (None, Some(turn)) => (other, one, turn),
                        _ => continue,
                    };
                    let [z_from, z_to] = [from, to].map(teeth);
                    let towards = |one: usize, other: usize| {
                        let ([x1, y1], [x2, y2]) = (centre(one), centre(other));
                        libm::atan2(y2 - y1, x2 - x1)
                    };
                    turns[to] = Some(if gears[other].is_ring() {
                        let direction = towards(other, one);
                        direction - (z_from * (direction - turn) + PI) / z_to
                    } else {
                        let direction = towards(from, to);
                        direction + PI - (PI - z_from * (direction - turn)) / z_to
                    });
                    is_new = true;
                }
                if is_new {
                    continue;
                }
                // The angle of a planet is passed on to its other gears; a gear that nothing ties to the
                // others is at 0.
                let like = |gear: usize| {
                    let on_body = |other: &usize| set.body(gears[*other].of) == set.body(gears[gear].of);
                    let turn = (0..gears.len()).filter(on_body).find_map(|other| turns[other]);
                    turn.map(|turn| (gear, turn))
                };
                let mut unplaced = (0..gears.len()).filter(|gear| turns[*gear].is_none());
                let first = unplaced.clone().next().map(|gear| (gear, 0.0));
                if let Some((gear, turn)) = unplaced.find_map(like).or(first) {
                    turns[gear] = Some(turn);
                }
            }
            let placed = |gear: usize| Placed {
                gear,
                centre: centre(gear),
                turn_rad: turns[gear].unwrap_or_default(),
            };
            for (planet, [radius, angle]) in places.iter().enumerate() {
                let own = (0..gears.len()).filter(|gear| planet_of(gears[*gear].of) == Some(planet));
                planets.push(PlacedPlanet {
                    centre_distance: *radius,
                    angle_rad: start + angle,
                    gears: own.map(placed).collect(),
                });
            }
            for (gear, turn) in turns.into_iter().enumerate().filter(|(gear, _)| is_central(*gear)) {
                central_turns[gear] = turn;
            }
        }
        let centrals = (0..gears.len()).filter(|gear| is_central(*gear)).map(|gear| Placed {
            gear,
            centre: central(gear),
            turn_rad: central_turns[gear].unwrap_or_default(),
        });
        let centrals = centrals.collect();
        InMesh { centrals, planets, gears: self.gears, meshes: self.meshes, assumed: self.assumed }
    }
}
