//! Designs in ascending order of the objective, until enough of them hold.

use super::bearing::Bearing;
use super::geometry::{Geometry, check_extent, geometries};
use super::{Design, Found, Governing, LeftOut, Objective, Requirement, SetOverload, Sizing, Space};
use crate::bearing::{BearingStep, Reliability, life_over_duty};
use crate::checks::{not_negative, positive, within};
use crate::factor::{Side, Symbol};
use crate::load::load_sharing;
use crate::mesh::{Gear, Mesh, Method};
use crate::planets::loads;
use crate::rating::overload;
use crate::root::factors::MOST_ROOT_ROUGHNESS;
use crate::spectrum::{GearDuty, Step, Worn, check_shares, rate_duty};
use crate::{Error, Quantity};
use epicyclic_gears::quantity::SimpleGear;
use epicyclic_units::Physical;
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;
use std::ops::ControlFlow;
use uom::si::f64::{AngularVelocity, Force, Length, Mass, Time, Torque};

/// Rim over tooth height below which a rim weakens the root
/// ([`rim_factor_external`](crate::root::factors::rim_factor_external)).
const THICK_RIM: f64 = 1.2;

/// The best `most` designs of the space, unless `goes_on`, which is called now and then, breaks.
///
/// # Errors
/// [`Error::Cancelled`]; [`Error::NothingToSearch`] for a space without modules, face widths, planets or
/// centre distances; [`Error::SpaceTooLarge`]; [`Error::NotPositive`], [`Error::Negative`] and
/// [`Error::OutOfRange`] for a quantity of it; those of
/// [`natural_centre_distance`](epicyclic_gears::involute::family::natural_centre_distance). Also those of
/// [`rate_duty`], except for teeth outside the range of the standard, which are left out and counted.
pub fn size(task: &Sizing, most: usize, goes_on: &dyn Fn() -> ControlFlow<()>) -> Result<Found, Error> {
    check(task)?;
    let modules_mm = sorted(&task.space.modules);
    let widths_mm = sorted(&task.space.face_widths);
    check_extent(task, &modules_mm, widths_mm.len())?;
    let choices: Vec<Option<&Bearing>> = match &task.space.bearings[..] {
        [] => vec![None],
        bearings => bearings.iter().map(Some).collect(),
    };
    let mut left_out = LeftOut::default();
    let others = (widths_mm.len() * choices.len()) as u64;
    let (geometries, space, calculated) = geometries(task, &modules_mm, others, &mut left_out, goes_on)?;
    if space == 0 {
        return Err(Error::NothingToSearch { quantity: Quantity::CentreDistance });
    }
    let mut search = Search {
        task,
        teeth: vec![None; geometries.len() * widths_mm.len()],
        steps: task
            .space
            .planets
            .iter()
            .map(|&planets| Ok((planets, steps(task, planets)?)))
            .collect::<Result<_, Error>>()?,
        geometries,
        widths_mm,
        choices,
        left_out,
        rated: 0,
    };
    let mut heap = search.streams();
    let (mut found, mut nearest): (Vec<Design>, Option<Design>) = (vec![], None);
    while found.len() < most {
        let Some(Reverse(next)) = heap.pop() else { break };
        if goes_on().is_break() {
            return Err(Error::Cancelled);
        }
        if let Some(design) = search.judged(&next)? {
            if design.governing.value >= design.governing.required {
                found.push(design);
            } else {
                match design.governing.requirement {
                    Requirement::Flank => search.left_out.flank += 1,
                    Requirement::Root => search.left_out.root += 1,
                    Requirement::OverloadFlank | Requirement::OverloadRoot => search.left_out.overload += 1,
                    Requirement::BearingLife => search.left_out.bearing_life += 1,
                }
                let ratio = |design: &Design| design.governing.ratio();
                if found.is_empty() && nearest.as_ref().is_none_or(|one| ratio(&design) > ratio(one)) {
                    nearest = Some(design);
                }
            }
        } else {
            search.left_out.not_calculable += 1;
        }
        // A wider design of the same geometry and bearing is heavier: it enters the queue only now, which
        // keeps it short.
        if next.width + 1 < next.end {
            heap.push(Reverse(search.candidate(next.geometry, next.bearing, next.width + 1, next.end)));
        }
    }
    Ok(Found {
        space,
        geometries: calculated,
        rated: search.rated,
        not_reached: space - search.left_out.total() - found.len() as u64,
        left_out: search.left_out,
        nearest_miss: nearest.filter(|_| found.is_empty()),
        found,
    })
}

/// Lengths in mm, ascending and each once.
fn sorted(lengths: &[Length]) -> Vec<f64> {
    let mut all: Vec<f64> = lengths.iter().map(|length| length.mm()).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

impl Space {
    /// Refuses a space of nothing.
    ///
    /// # Errors
    /// [`Error::NothingToSearch`] without modules, face widths or planets; [`Error::NotPositive`] and
    /// [`Error::Negative`] for a quantity.
    pub fn check(&self) -> Result<(), Error> {
        for (quantity, lengths) in
            [(Quantity::Module, &self.modules), (Quantity::FaceWidth, &self.face_widths)]
        {
            if lengths.is_empty() {
                return Err(Error::NothingToSearch { quantity });
            }
            for length in lengths {
                positive(quantity, length.mm(), "mm")?;
            }
        }
        if self.planets.is_empty() {
            return Err(Error::NothingToSearch { quantity: Quantity::Planets });
        }
        positive(Quantity::CentreDistanceStep, self.centre_distance_step.mm(), "mm")?;
        not_negative(Quantity::CentreDistanceReach, self.reach, "modules")?;
        if let Some(ratio) = self.width_ratio {
            positive(Quantity::WidthRatio, ratio, "")?;
        }
        Ok(())
    }
}

/// Refuses what is no space, no duty or no requirement.
fn check(task: &Sizing) -> Result<(), Error> {
    task.space.check()?;
    positive(Quantity::Life, task.life.hours(), "h")?;
    let overloads = task.overloads.iter().flat_map(|one| [one.required_contact, one.required_root]);
    for required in [task.required_contact, task.required_root].into_iter().chain(overloads) {
        positive(Quantity::RequiredSafety, required, "")?;
    }
    for gear in &task.gears {
        within(Quantity::RootRoughness, gear.root_roughness.um(), [0.0, MOST_ROOT_ROUGHNESS], "µm")?;
    }
    not_negative(Quantity::LeastRim, task.planet_rim, "modules")?;
    not_negative(Quantity::RingRimInModules, task.ring_rim, "modules")?;
    for (quantity, length) in [
        (Quantity::LeastRim, task.least_planet_rim),
        (Quantity::RingRimInModules, task.held_ring_rim),
        (Quantity::PlanetBore, task.planet_bore),
    ] {
        if let Some(length) = length {
            positive(quantity, length.mm(), "mm")?;
        }
    }
    task.limits.check()?;
    task.profiles.check()?;
    check_shares(task.duty.iter().map(|step| step.share))
}

/// The steps of the duty in both meshes, how often a flank of each gear is loaded, and the overloads.
#[derive(Debug)]
struct MeshSteps {
    steps: [Vec<Step>; 2],
    overloads: Vec<([Torque; 2], SetOverload)>,
    contacts: [[f64; 2]; 2],
    sharing: f64,
}

fn steps(task: &Sizing, planets: u32) -> Result<MeshSteps, Error> {
    let [sun, planet, _] = task.teeth;
    let mut steps = [vec![], vec![]];
    let mut contacts = [[1.0; 2]; 2];
    for step in &task.duty {
        let both = loads(step.sun_torque, step.sun_speed, planets, [sun, planet], task.life)?;
        for (of_mesh, load) in steps.iter_mut().zip(both) {
            of_mesh.push(Step { share: step.share, torque: load.torque, speed: load.speed });
        }
        contacts = both.map(|load| load.contacts);
    }
    let mut overloads = vec![];
    for one in task.overloads.iter().filter(|one| one.sun_torque.si() != 0.0) {
        let both = loads(one.sun_torque, AngularVelocity::default(), planets, [sun, planet], task.life)?;
        overloads.push((both.map(|load| load.torque), *one));
    }
    let given = task.methods[0].given.of(Side::First, Symbol::LoadSharing);
    let sharing = given.map_or_else(|| load_sharing(planets, task.methods[0].floating), Ok)?;
    Ok(MeshSteps { steps, overloads, contacts, sharing })
}

/// A design before it is judged, in the order of the search.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Candidate {
    objectives: [f64; 2],
    planets: u32,
    module: usize,
    width: usize,
    /// Ascending with the centre distance, of one module and number of planets.
    geometry: usize,
    bearing: usize,
    /// Widths from here on are left out.
    end: usize,
}

impl Eq for Candidate {}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        let [first, second] =
            [0, 1].map(|place: usize| self.objectives[place].total_cmp(&other.objectives[place]));
        let rest = |one: &Self| (one.planets, one.module, one.width, one.geometry, one.bearing);
        first.then(second).then_with(|| rest(self).cmp(&rest(other)))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Teeth that were rated.
#[derive(Debug, Clone, Copy)]
struct Rated {
    meshes: [[GearDuty<Worn>; 2]; 2],
    /// The requirement that is met least over the duty.
    over_duty: Governing,
    /// The overload requirement that is met least.
    overload: Option<Governing>,
}

/// Teeth that were rated; `None` outside what the standard holds for.
type Teeth = Option<Rated>;

/// The requirement that is met least; of equal ones the first.
fn least(all: impl IntoIterator<Item = Governing>) -> Option<Governing> {
    all.into_iter().reduce(|least, one| if one.ratio() < least.ratio() { one } else { least })
}

struct Search<'a> {
    task: &'a Sizing,
    geometries: Vec<Geometry>,
    widths_mm: Vec<f64>,
    choices: Vec<Option<&'a Bearing>>,
    /// Ratings of each geometry and width, with planets whose rim weakens nothing.
    teeth: Vec<Option<Teeth>>,
    steps: Vec<(u32, MeshSteps)>,
    left_out: LeftOut,
    rated: u64,
}

impl Search<'_> {
    /// Outside diameter of a bearing, or the bore of the planets without one; 0 of solid ones.
    fn bore_mm(&self, bearing: usize) -> f64 {
        match self.choices[bearing] {
            Some(bearing) => bearing.outside_diameter.mm(),
            None => self.task.planet_bore.map_or(0.0, Physical::mm),
        }
    }

    fn candidate(&self, geometry: usize, bearing: usize, width: usize, end: usize) -> Candidate {
        let own = &self.geometries[geometry];
        let mass = own.mass(self.bore_mm(bearing), self.widths_mm[width]);
        let objectives = match self.task.objective {
            Objective::Mass => [mass, own.ring_mm],
            Objective::Ring => [own.ring_mm, mass],
        };
        Candidate { objectives, planets: own.planets, module: own.module, width, geometry, bearing, end }
    }

    /// The narrowest design of each geometry with each bearing that fits; mass grows with the width.
    fn streams(&mut self) -> BinaryHeap<Reverse<Candidate>> {
        let mut heap = vec![];
        let all = self.widths_mm.len();
        for geometry in 0..self.geometries.len() {
            let own = &self.geometries[geometry];
            let sun_mm = own.set.gears()[0].reference_diameter() * own.module_mm;
            let widest = self.task.space.width_ratio.map_or(f64::INFINITY, |ratio| ratio * sun_mm);
            let end = self.widths_mm.partition_point(|width| *width <= widest);
            let least = (self.task.planet_rim * own.module_mm)
                .max(self.task.least_planet_rim.map_or(0.0, Physical::mm));
            let root_mm = own.planet_root_mm;
            self.left_out.width_ratio += ((all - end) * self.choices.len()) as u64;
            for bearing in 0..self.choices.len() {
                let bore_mm = self.bore_mm(bearing);
                if bore_mm > 0.0 && (root_mm - bore_mm) / 2.0 < least {
                    self.left_out.rim += end as u64;
                    continue;
                }
                let width_mm = self.choices[bearing].map_or(0.0, |bearing| bearing.width.mm());
                let first = self.widths_mm.partition_point(|width| *width < width_mm).min(end);
                self.left_out.bearing_width += first as u64;
                if first < end {
                    heap.push(Reverse(self.candidate(geometry, bearing, first, end)));
                }
            }
        }
        heap.into()
    }

    /// A design with its safeties and lives; `None` of teeth outside what the standard holds for.
    fn judged(&mut self, one: &Candidate) -> Result<Option<Design>, Error> {
        let bore_mm = self.bore_mm(one.bearing);
        let own = &self.geometries[one.geometry];
        let rim_mm = (bore_mm > 0.0).then(|| (own.planet_root_mm - bore_mm) / 2.0);
        let is_thin = rim_mm.is_some_and(|rim| rim / own.planet_height_mm < THICK_RIM);
        let place = one.geometry * self.widths_mm.len() + one.width;
        // Rating is the slow step. Only a thin rim depends on the bearing, so all other bearings share one
        // rating.
        let teeth = match self.teeth[place] {
            Some(teeth) if !is_thin => teeth,
            _ => {
                self.rated += 1;
                let rim = rim_mm.filter(|_| is_thin);
                let teeth = self.rate(one, rim)?;
                if !is_thin {
                    self.teeth[place] = Some(teeth);
                }
                teeth
            }
        };
        let Some(Rated { meshes, over_duty, overload }) = teeth else { return Ok(None) };
        let own = &self.geometries[one.geometry];
        let face_mm = self.widths_mm[one.width];
        let bearing = self.choices[one.bearing];
        let bearing_life = match bearing {
            Some(bearing) => self.bearing_life(own, bearing, own.planet_mass(bore_mm, face_mm))?,
            None => None,
        };
        let of_bearing = bearing.zip(bearing_life).map(|(bearing, life)| Governing {
            requirement: Requirement::BearingLife,
            mesh: 0,
            gear: SimpleGear::Planet,
            value: libm::pow(life.hours() / self.task.life.hours(), 1.0 / bearing.rolling.exponent()),
            required: 1.0,
        });
        let governing = least([over_duty].into_iter().chain(overload).chain(of_bearing)).unwrap_or(over_duty);
        Ok(Some(Design {
            module: Length::from_mm(own.module_mm),
            face_width: Length::from_mm(face_mm),
            centre_distance: Length::from_mm(own.centre_mm),
            set: own.set,
            limited_by: own.limited_by,
            bearing: bearing.cloned(),
            planet_bore: (bore_mm > 0.0).then(|| Length::from_mm(bore_mm)),
            planet_rim: rim_mm.map(Length::from_mm),
            ring_rim: Length::from_mm(own.ring_rim_mm),
            ring_diameter: Length::from_mm(own.ring_mm),
            mass: Mass::from_si(own.mass(bore_mm, face_mm)),
            meshes,
            overload,
            bearing_life,
            governing,
        }))
    }

    fn steps_of(&self, planets: u32) -> &MeshSteps {
        let own = self.steps.iter().find(|(count, _)| *count == planets);
        &own.expect("every number of planets of the space has its steps").1
    }

    /// Ratings of both meshes over the duty, with `planet_rim_mm` if the rim of the planets weakens their
    /// roots.
    fn rate(&self, one: &Candidate, planet_rim_mm: Option<f64>) -> Result<Teeth, Error> {
        let task = self.task;
        let own = &self.geometries[one.geometry];
        let [sun, planet, ring] = task.gears;
        let planet = Gear { rim: planet_rim_mm.map(Length::from_mm), ..planet };
        let ring = Gear { rim: Some(Length::from_mm(own.ring_rim_mm)), ..ring };
        let steps = self.steps_of(own.planets);
        let rated = |place: usize, gears: [Gear; 2]| {
            let mesh = Mesh {
                pair: own.pairs[place],
                module: Length::from_mm(own.module_mm),
                face_width: Length::from_mm(self.widths_mm[one.width]),
                gears,
                viscosity: task.viscosity,
            };
            let method = Method { planets: Some(own.planets), ..task.methods[place] };
            let over_duty =
                rate_duty(&mesh, &steps.steps[place], task.life, steps.contacts[place], &method)?.whole()?;
            let mut static_safeties = vec![];
            for (torques, against) in &steps.overloads {
                let rating = overload(&mesh, torques[place], &method)?;
                for (side, gear) in rating.gears.into_iter().enumerate() {
                    let of = |requirement, value, required| {
                        Governing::of_teeth(requirement, place, side, value, required)
                    };
                    static_safeties.extend([
                        of(Requirement::OverloadFlank, gear.contact?, against.required_contact),
                        of(Requirement::OverloadRoot, gear.root?, against.required_root),
                    ]);
                }
            }
            Ok((over_duty, least(static_safeties)))
        };
        let both: Result<_, Error> =
            rated(0, [sun, planet]).and_then(|outer| Ok([outer, rated(1, [planet, ring])?]));
        match both {
            Ok(both) => {
                let meshes = both.map(|(over_duty, _)| over_duty);
                let overload = least(both.into_iter().filter_map(|(_, overload)| overload));
                Ok(Some(Rated { over_duty: self.least_over_duty(&meshes), meshes, overload }))
            }
            Err(error) if error.is_beyond_standard() => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// The safety over the duty that is least over what is required of it.
    fn least_over_duty(&self, meshes: &[[GearDuty<Worn>; 2]; 2]) -> Governing {
        let (contact, root) = (self.task.required_contact, self.task.required_root);
        let all = meshes.iter().enumerate().flat_map(|(mesh, rating)| {
            rating.iter().enumerate().flat_map(move |(side, gear)| {
                [
                    Governing::of_teeth(Requirement::Flank, mesh, side, gear.contact.safety, contact),
                    Governing::of_teeth(Requirement::Root, mesh, side, gear.root.safety, root),
                ]
            })
        });
        least(all).expect("two meshes have eight safeties")
    }

    /// `L_10` over the duty.
    fn bearing_life(&self, own: &Geometry, bearing: &Bearing, planet_kg: f64) -> Result<Option<Time>, Error> {
        let [sun, planet, ring] = self.task.teeth.map(epicyclic_gears::ToothCount::as_f64);
        let sharing = self.steps_of(own.planets).sharing;
        let centre_m = own.centre_mm / 1e3;
        let each = f64::from(own.planets) * centre_m * sun;
        let [outer, inner] = own.pairs.map(|pair| libm::tan(pair.working_angle_rad()));
        let duty: Vec<BearingStep> = self
            .task
            .duty
            .iter()
            .map(|step| {
                let torque = step.sun_torque.si().abs() * sharing;
                let [first, second] = [sun + planet, ring - planet].map(|teeth| torque * teeth / each);
                let centrifugal = planet_kg * centre_m * step.carrier_speed.si().powi(2);
                let radial = first * outer - second * inner + centrifugal;
                BearingStep {
                    share: step.share,
                    load: Force::from_si(libm::hypot(first + second, radial)),
                    speed: step.sun_speed.abs() * (sun / planet),
                    modification: 1.0,
                }
            })
            .collect();
        life_over_duty(bearing.rolling, bearing.load_rating, &duty, Reliability::Percent90)
    }
}
