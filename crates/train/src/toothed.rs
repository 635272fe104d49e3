//! Teeth of the gears of a set beyond their numbers, and the meshes that they make.
//!
//! Every gear has a profile shift, a helix angle and a tool; those in mesh have one module and one helix
//! angle. All meshes of a planet with central gears lie on one carrier radius:
//!
//! ```text
//! R = m_1·a_1 = m_2·a_2 = …        a_j·cos α_wt,j = a_d,j·cos α_t,j
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `R` | radius of the planets' centres | that of `m` |
//! | `m_j` | normal module of mesh `j` | any |
//! | `a_j`, `a_d,j` | centre distance, and that of the reference circles | modules |
//! | `α_wt,j`, `α_t,j` | working and reference transverse pressure angle | rad |
//!
//! The first mesh of a planet with a central gear has no backlash and gives `R`; the others lie at `R` with
//! the backlash that is left. A mesh whose module is not stated has the module that `R` requires. Two planets
//! in mesh have no backlash: the angle between them is free. Tips of rings that are not stated stay out of
//! the fillets of their planets.

use crate::compound::{CentralKind, CompoundSpec};
use crate::planet_bearings::{MeshSize, SetSize};
use crate::planet_places::{Given, NoPair, Places, central_mesh, places, planet_of, teeth_of};
use crate::planet_set::{Description, GearOf, MeshKind, PlanetSet, parts_of_short};
use crate::set::{Gearing, MeshLoss, SetKind, SetSpec};
use crate::tolerance::TOUCH;
pub use crate::tooth_shape::{Shifts, ToothShape};
use crate::{GROUND, Gearbox, LinkId};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::profile::{Cutting, Profiles};
use epicyclic_gears::involute::sliding::mesh_efficiency;
use epicyclic_gears::involute::{InvoluteGear, Pair, PlanetSet as InvoluteSet, Profile};
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::{Error, ToothCount};
use epicyclic_units::Physical;
use std::f64::consts::FRAC_PI_4;
use uom::si::f64::{Angle, Length, Mass};

/// Reason why a set has no teeth in mesh.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Untoothed {
    /// Teeth of a central gear are not known.
    #[error("`teeth` are missing")]
    Teeth,
    /// Teeth of a planet are not known.
    #[error("the teeth of its planets are missing")]
    PlanetTeeth,
    /// The gears share a centre distance with profile shifts alone, and none are given.
    #[error("its centre distances differ, so it needs `profile_shifts`")]
    Shifts,
    /// Bevel gears.
    #[error("its gears are bevel gears")]
    Bevel,
    /// The gears make no set, which the gearbox refuses.
    #[error("its gears make no set")]
    NoSet,
    /// The given values leave no teeth or no mesh.
    #[error(transparent)]
    Refused(#[from] Error),
}

/// Two gears of a set in mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToothedMesh {
    /// The gears, in the order of the pair: a central gear before its planet, a planet before a ring.
    pub gears: [GearOf; 2],
    /// The pair, in modules.
    pub pair: Pair,
    /// Normal module: as stated, in the same unit; over that of the first mesh where none is stated.
    pub module: f64,
}

/// The gears of a set with their teeth, in mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct ToothedSet {
    /// The meshes, in the order of [`PlanetSet::meshes`].
    pub meshes: Vec<ToothedMesh>,
    /// Radius of the centres of each planet, in the unit of the modules.
    pub radii: Vec<Option<f64>>,
}

impl ToothedSet {
    /// A gear as one of its meshes has it.
    #[must_use]
    pub fn gear(&self, gear: GearOf) -> Option<&InvoluteGear> {
        self.meshes.iter().find_map(|mesh| {
            let end = mesh.gears.iter().position(|one| *one == gear)?;
            Some(&mesh.pair.gears()[end])
        })
    }

    /// Sun, planets and ring of a simple set, in mesh; `None` of other meshes than its two.
    fn simple(&self, planet_count: Option<u32>) -> Option<Result<InvoluteSet, Error>> {
        let [of_sun, of_ring] = self.meshes.as_slice() else { return None };
        let ([sun, planet], [_, ring]) = (*of_sun.pair.gears(), *of_ring.pair.gears());
        let planets = planet_count.unwrap_or(1);
        Some(InvoluteSet::new([sun, planet, ring], planets, of_sun.pair.centre_distance()))
    }
}

impl PlanetSet {
    /// Sun, planets and ring of a simple set, in mesh; planets of an unknown number are taken as one. `None`
    /// of other sets.
    #[must_use]
    pub fn simple_involutes(&self, toothed: &ToothedSet) -> Option<InvoluteSet> {
        let spec = self.short().filter(|spec| spec.kind == SetKind::Simple)?;
        toothed.simple(spec.planet_count)?.ok()
    }

    /// The gears of the set. Of a short description from the first central gear over the planets to the
    /// second; of others the central gears as described, then those of the planets.
    #[must_use]
    pub fn gears(&self) -> Vec<GearOf> {
        let is_gear = |central: &usize| self.centrals()[*central].kind != CentralKind::PlanetShaft;
        let mut centrals: Vec<GearOf> =
            (0..self.centrals().len()).filter(is_gear).map(GearOf::Central).collect();
        let planets = self.planets().iter().enumerate();
        let planets = planets
            .flat_map(|(planet, own)| (0..own.gears.len()).map(move |gear| GearOf::Planet(planet, gear)));
        let last = if self.short().is_some() { centrals.pop() } else { None };
        centrals.into_iter().chain(planets).chain(last).collect()
    }

    /// Copy of the set with this number of planets of each kind and this shape of its teeth.
    #[must_use]
    pub fn reshaped(&self, planets: Option<u32>, tooth_shape: ToothShape) -> Self {
        let mut description = self.description().clone();
        let (count, shape) = match &mut description {
            Description::Short(spec) => (&mut spec.planet_count, &mut spec.tooth_shape),
            Description::Compound(spec) => (&mut spec.planet_count, &mut spec.tooth_shape),
        };
        (*count, *shape) = (planets, tooth_shape);
        self.described(description)
    }

    /// Mass of a planet with these teeth, modules in metres: half of the annulus between tip and root circle
    /// is filled. `None` where a face width is missing, or a bore is beyond a root circle.
    #[must_use]
    pub fn mass_of_planet(&self, planet: usize, toothed: &ToothedSet, size: &SetSize) -> Option<Mass> {
        let own = size.planets.get(planet);
        let bore = own.and_then(|own| own.bore).or(size.planet_bore).map_or(0.0, Physical::si);
        let gears = self.planets()[planet].gears.len();
        let mass = |gear: usize| {
            let of_gear = own.and_then(|own| own.face_widths.get(gear).copied().flatten());
            let width = of_gear.or(size.face_width.filter(|_| gears == 1))?;
            let is_own = |mesh: &&ToothedMesh| mesh.gears.contains(&GearOf::Planet(planet, gear));
            let module = toothed.meshes.iter().find(is_own)?.module;
            let teeth = toothed.gear(GearOf::Planet(planet, gear))?;
            let area = teeth.filled_area() * module * module - FRAC_PI_4 * bore * bore;
            (bore < teeth.root_diameter() * module).then_some(size.density.si() * area * width.si())
        };
        (0..gears).map(mass).sum::<Option<f64>>().map(Mass::from_si)
    }

    /// Sizes of the meshes with these teeth, for the planet bearings; `has_modules` where the modules
    /// are lengths in metres.
    #[must_use]
    pub fn mesh_sizes(&self, toothed: &ToothedSet, has_modules: bool) -> Vec<MeshSize> {
        let size = |(place, mesh): (usize, &ToothedMesh)| {
            // Centre distances, and diameters but for addenda, are as with spur teeth of the transverse
            // module.
            let transverse = self.tooth_shape().transverse_module(place, Length::from_si(mesh.module));
            MeshSize {
                module: has_modules.then_some(transverse),
                pressure_angle: Some(Angle::from_si(mesh.pair.working_angle_rad())),
                centre_distance: Some(mesh.pair.centre_distance() * mesh.module / transverse.si()),
                is_behind: false,
            }
        };
        toothed.meshes.iter().enumerate().map(size).collect()
    }

    /// Teeth of its gears beyond their numbers.
    #[must_use]
    pub fn tooth_shape(&self) -> &ToothShape {
        match self.description() {
            Description::Short(spec) => &spec.tooth_shape,
            Description::Compound(spec) => &spec.tooth_shape,
        }
    }

    /// External or internal; `None` of bevel gears and planet shafts.
    #[must_use]
    pub fn gear_kind(&self, gear: GearOf) -> Option<GearKind> {
        match gear {
            GearOf::Planet(..) => Some(GearKind::External),
            GearOf::Central(central) => match self.centrals()[central].kind {
                CentralKind::Sun => Some(GearKind::External),
                CentralKind::Ring => Some(GearKind::Internal),
                _ => None,
            },
        }
    }

    /// The gears with their teeth, in mesh, with the modules that are stated of its meshes, in any unit.
    ///
    /// # Errors
    /// What is missing, or [`Untoothed::Refused`] with the errors of [`InvoluteGear::new`] and
    /// [`Pair::at_centre_distance`].
    pub fn toothed(&self, rack: &BasicRack, modules: &[Option<f64>]) -> Result<ToothedSet, Untoothed> {
        let tooth_shape = self.tooth_shape();
        self.check_hands()?;
        let order = self.gears();
        let mut gears = vec![];
        for (place, gear) in order.iter().enumerate() {
            let kind = self.gear_kind(*gear).ok_or(Untoothed::Bevel)?;
            let missing = if planet_of(*gear).is_some() { Untoothed::PlanetTeeth } else { Untoothed::Teeth };
            let teeth = teeth_of(self, *gear).filter(|teeth| teeth.fract() == 0.0 && *teeth >= 1.0);
            let teeth = ToothCount::new(teeth.ok_or(missing)? as u32)?;
            let mesh = self.meshes().iter().position(|mesh| mesh.gears.contains(gear));
            let helix_angle = mesh.map_or_else(Angle::default, |mesh| tooth_shape.helix_angle(mesh));
            let profile = Profile { helix_angle, ..Profile::of_rack(*rack) };
            let own = InvoluteGear::new(
                kind,
                teeth,
                tooth_shape.cutting(place).of(profile),
                tooth_shape.shift(place),
            )?;
            gears.push(own.with_tip_alteration(tooth_shape.tip(place))?);
        }
        let gear = |gears: &[InvoluteGear], of: GearOf| {
            gears[order.iter().position(|one| *one == of).unwrap_or_default()]
        };
        let ends: Vec<[GearOf; 2]> = (0..self.meshes().len()).map(|mesh| self.gears_of_mesh(mesh)).collect();
        let free: Vec<Pair> = ends
            .iter()
            .map(|[one, other]| Pair::without_backlash(gear(&gears, *one), gear(&gears, *other)))
            .collect::<Result<_, _>>()?;
        let mut given = Given::nothing(self);
        for (mesh, module) in given.modules.iter_mut().enumerate() {
            *module = modules.get(mesh).copied().flatten();
        }
        if let Some(first) = given.modules.first_mut().filter(|_| modules.iter().all(Option::is_none)) {
            *first = Some(1.0);
        }
        given.distances = free.iter().map(|pair| Some(pair.centre_distance())).collect();
        let tied = places(self, &given);
        // A mesh that no centre distance and no gear ties to the others has the module of the first.
        let usual = given.modules.iter().copied().flatten().next().unwrap_or(1.0);
        let given = Given { modules: tied.modules, radii: tied.radii, module: Some(usual), ..given };
        let places = places(self, &given);
        let module = |mesh: usize| places.modules[mesh].unwrap_or(usual);
        let mut pairs = vec![];
        for (mesh, pair) in free.iter().enumerate() {
            pairs.push(match self.distance_of(mesh, &free, &places, module)? {
                Some(distance) => Pair::at_centre_distance(pair.gears()[0], pair.gears()[1], distance)?,
                None => *pair,
            });
        }
        if !tooth_shape.has_tips() {
            for mesh in 0..pairs.len() {
                if !pairs[mesh].is_internal() {
                    continue;
                }
                let ring = pairs[mesh].with_clear_ring_tips()?.gears()[1].tip_alteration();
                for other in (0..pairs.len()).filter(|other| ends[*other][1] == ends[mesh][1]) {
                    let planet = pairs[other].gears()[0].tip_alteration();
                    pairs[other] = pairs[other].with_tip_alterations([planet, ring])?;
                }
            }
        }
        let meshes = ends.into_iter().zip(pairs).enumerate();
        let meshes = meshes.map(|(mesh, (gears, pair))| ToothedMesh { gears, pair, module: module(mesh) });
        Ok(ToothedSet { meshes: meshes.collect(), radii: places.radii })
    }

    /// Refuses helix angles of two signs in meshes that share a gear.
    fn check_hands(&self) -> Result<(), Error> {
        let angle = |mesh: usize| self.tooth_shape().signed_helix_angle(mesh).degrees();
        for mesh in 0..self.meshes().len() {
            let shares = |other: &usize| {
                let gears = self.meshes()[*other].gears;
                gears.iter().any(|gear| self.meshes()[mesh].gears.contains(gear))
            };
            if let Some(other) = (0..mesh).filter(shares).find(|other| angle(*other) * angle(mesh) < 0.0) {
                return Err(Error::HelixAnglesDiffer { first_deg: angle(other), second_deg: angle(mesh) });
            }
        }
        Ok(())
    }

    /// Angle of each planet about the main axis, with the first of those that meshes of planets tie together,
    /// from which it counts; `None` where two planets in mesh do not reach each other. The one described
    /// later is ahead in the positive direction, unless it is behind in this mesh.
    #[must_use]
    pub fn angles_between(&self, toothed: &ToothedSet, is_behind: &[bool]) -> Option<Vec<(usize, Angle)>> {
        let given = Given {
            modules: toothed.meshes.iter().map(|mesh| Some(mesh.module)).collect(),
            radii: toothed.radii.clone(),
            // Meshes that nothing is said of.
            is_behind: is_behind
                .iter()
                .copied()
                .chain(std::iter::repeat(false))
                .take(self.meshes().len())
                .collect(),
            distances: toothed.meshes.iter().map(|mesh| Some(mesh.pair.centre_distance())).collect(),
            module: None,
        };
        let places = places(self, &given);
        let is_placed = |pair: &Result<_, NoPair>| matches!(pair, Ok(_) | Err(NoPair::OtherMesh));
        let angles = || places.angles(self).into_iter().map(|(first, at)| (first, Angle::from_si(at)));
        places.pairs.iter().all(is_placed).then(|| angles().collect())
    }

    /// Centre distance of a mesh in its modules, where another mesh of its planet gives it; `None` of a mesh
    /// that has the one at which its gears have no backlash.
    fn distance_of(
        &self,
        mesh: usize,
        free: &[Pair],
        places: &Places,
        module: impl Fn(usize) -> f64,
    ) -> Result<Option<f64>, Untoothed> {
        let planet_of_central = |mesh: usize| match central_mesh(self, mesh) {
            Some((_, GearOf::Planet(planet, _))) => Some(planet),
            _ => None,
        };
        let Some(planet) = planet_of_central(mesh) else { return Ok(None) };
        let Some(radius) = places.radii[planet] else { return Ok(None) };
        let own = module(mesh) * free[mesh].centre_distance();
        let off = (own - radius).abs() / module(mesh);
        if self.tooth_shape().shifts.is_none() && off > TOUCH {
            return Err(Untoothed::Shifts);
        }
        let gives_radius = |mesh: &usize| {
            planet_of_central(*mesh) == Some(planet)
                && module(*mesh) * free[*mesh].centre_distance() == radius
        };
        let lead = (0..free.len()).find(gives_radius);
        // One module needs no division, which would round.
        Ok(match lead {
            Some(lead) if lead == mesh => None,
            Some(lead) if module(lead) == module(mesh) => Some(free[lead].centre_distance()),
            _ if off <= TOUCH => None,
            _ => Some(radius / module(mesh)),
        })
    }

    /// The gears of a mesh: a central gear before its planet, an internal one last, others as described.
    #[must_use]
    pub fn gears_of_mesh(&self, mesh: usize) -> [GearOf; 2] {
        let mesh = self.meshes()[mesh];
        let [one, other] = mesh.gears;
        let is_ring = |gear| self.gear_kind(gear) == Some(GearKind::Internal);
        let swaps = match mesh.kind {
            MeshKind::Internal => is_ring(one),
            _ => match (planet_of(one), planet_of(other)) {
                (Some(first), Some(second)) => first > second,
                (Some(_), None) => true,
                _ => false,
            },
        };
        if swaps { [other, one] } else { [one, other] }
    }
}

impl CompoundSpec {
    /// As [`PlanetSet::toothed`], of a set that no gearbox has yet.
    ///
    /// # Errors
    /// As [`PlanetSet::toothed`]; [`Untoothed::NoSet`].
    pub fn toothed(&self, rack: &BasicRack, modules: &[Option<f64>]) -> Result<ToothedSet, Untoothed> {
        let links = self.centrals.iter().map(|central| central.link.as_str()).chain([self.carrier.as_str()]);
        let links: Vec<&str> = links.filter(|link| *link != GROUND).collect();
        let [input, output] = [links.first(), links.last()].map(|link| link.copied().unwrap_or_default());
        let alone = Gearbox::builder(&self.id).links(links).input(input).output(output);
        let alone = alone.compound_set(self.clone()).gear("1", [""; 0]).build();
        alone.map_err(|_| Untoothed::NoSet)?.sets()[0].toothed(rack, modules)
    }
}

impl SetSpec {
    /// Returns the set with profile shifts of its gears.
    #[must_use]
    pub fn shifted(mut self, shifts: Shifts) -> Self {
        self.tooth_shape.shifts = Some(shifts);
        self
    }

    /// Returns the set with helical teeth, of one helix angle in all meshes. The module is then the normal
    /// module, as in ISO 21771.
    #[must_use]
    pub fn helical(mut self, helix_angle: Angle) -> Self {
        self.tooth_shape.helix_angles =
            if helix_angle.si() == 0.0 { vec![] } else { vec![helix_angle; self.kind.meshes()] };
        self
    }

    /// Returns the set with this cutting of its gears.
    #[must_use]
    pub fn cut(mut self, cutting: Vec<Cutting>) -> Self {
        self.tooth_shape.cutting = cutting;
        self
    }

    /// Whether any of its teeth are helical.
    #[must_use]
    pub fn is_helical(&self) -> bool {
        self.tooth_shape.is_helical()
    }

    /// The gears of a simple set with profile shifts or helical teeth; `None` of other sets, and where teeth
    /// are not known.
    ///
    /// # Errors
    /// As [`PlanetSet::toothed`].
    #[must_use]
    pub fn involute_set(&self, rack: &BasicRack) -> Option<Result<InvoluteSet, Error>> {
        if self.tooth_shape.has_shape() { self.toothed_set(rack) } else { None }
    }

    /// The gears of a simple set: with their shifts, or without any where equal centre distances need none.
    /// Planets of an unknown number are taken as one.
    ///
    /// `None` of a set that is not simple, whose teeth are not known, or that needs shifts and has none.
    ///
    /// # Errors
    /// As [`PlanetSet::toothed`].
    #[must_use]
    pub fn toothed_set(&self, rack: &BasicRack) -> Option<Result<InvoluteSet, Error>> {
        if self.kind != SetKind::Simple || matches!(self.gearing, Gearing::BasicRatio(_)) {
            return None;
        }
        match self.toothed(rack, &[]) {
            Ok(toothed) => toothed.simple(self.planet_count),
            Err(Untoothed::Refused(error)) => Some(Err(error)),
            Err(_) => None,
        }
    }

    /// As [`PlanetSet::toothed`], of a set that no gearbox has yet.
    ///
    /// # Errors
    /// As [`PlanetSet::toothed`]; [`Untoothed::NoSet`] of a set without a ratio.
    pub fn toothed(&self, rack: &BasicRack, modules: &[Option<f64>]) -> Result<ToothedSet, Untoothed> {
        // Links do not matter to teeth.
        let links = [LinkId(1), LinkId(2)];
        let parts = parts_of_short(self, links).map_err(|_| Untoothed::NoSet)?;
        let set = PlanetSet::new(Description::Short(self.clone()), LinkId::GROUND, parts);
        set.map_err(|_| Untoothed::NoSet)?.toothed(rack, modules)
    }

    /// Losses of the set by the sliding of its teeth, at coefficients of friction of its meshes from the
    /// first central gear to the second.
    ///
    /// ```text
    /// η_j = 1 − H_V,j·μ_m,j
    /// ```
    ///
    /// # Errors
    /// As [`PlanetSet::toothed`] and [`mesh_efficiency`].
    pub fn friction_losses(
        &self,
        rack: &BasicRack,
        modules: &[Option<f64>],
        friction: &[f64],
    ) -> Result<MeshLoss, Untoothed> {
        let toothed = self.toothed(rack, modules)?;
        let meshes = toothed.meshes.iter().zip(friction);
        let all = meshes.map(|(mesh, friction)| mesh_efficiency(&mesh.pair, *friction));
        Ok(match all.collect::<Result<Vec<_>, _>>()?[..] {
            [only] => MeshLoss::Set(only),
            [first, second] => MeshLoss::sun_and_ring(first, second),
            [first, between, second] => MeshLoss::Meshes { first, between, second },
            _ => return Err(Untoothed::Teeth),
        })
    }

    /// Basic racks and tools of sun, planets and ring of a simple set.
    #[must_use]
    pub fn profiles(&self, rack: &BasicRack) -> Profiles {
        let profile = Profile { helix_angle: self.tooth_shape.helix_angle(0), ..Profile::of_rack(*rack) };
        Profiles::cut(profile, [0, 1, 2].map(|gear| self.tooth_shape.cutting(gear)))
    }
}
