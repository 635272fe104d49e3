//! Meaning of a drive file: defaults filled in, values brought together.

use epicyclic_dynamics::drive::{
    Bore, CarrierSpec, DriveSpec, KnownPart, KnownParts, ShaftSpec, TeethSpec, default_bounds,
};
use epicyclic_gears::bearing::{self, Series};
use epicyclic_gears::carrier::{Arm, Hole, Hub};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::synthesis::{Placement, ToothNumbers};
use epicyclic_gears::{Error as GearError, ToothCount};
use uom::si::f64::{Length, Ratio};

use super::{BoreText, CarrierFile, DriveFile, PartFile, ShaftFile, TeethFile, place};
use crate::faults::Faults;
use crate::{Path, Problem, Span};
use epicyclic_units::{Number, Physical, Quantity};

impl DriveFile {
    /// Specification of the drive, defaults filled in.
    ///
    /// # Errors
    /// Tooth counts of 0, open ranges that their defaults turn around, efficiencies outside 0…1, unknown
    /// bearings, a carrier with both inertia and shape or with half a shape, a missing ratio, and those of
    /// [`DriveSpec::faults`].
    pub fn spec(&self) -> Result<DriveSpec, Faults> {
        let mut faults = Faults::default();
        let gear_set = &self.gear_set;
        let rack = BasicRack::default();
        let rack = BasicRack {
            addendum: gear_set.addendum.map_or(rack.addendum, Number::get),
            clearance: gear_set.clearance.map_or(rack.clearance, Number::get),
            pressure_angle: or(gear_set.pressure_angle, rack.pressure_angle),
        };
        let teeth = teeth(&self.teeth.clone().unwrap_or_default(), rack, &mut faults);
        let own_ratio = teeth.as_ref().and_then(|(_, ratio)| *ratio);
        let ratio = self.ratio.map(Number::get).or(own_ratio);
        // Teeth with a fault might have given it.
        if ratio.is_none() && teeth.is_some() {
            faults.push(Path::root(), Problem::MissingKey { key: "ratio".to_owned() });
        }
        let (power, speed) = (self.power.0, self.speed.0);
        let (module, face_width) = (gear_set.module.0, gear_set.face_width.0);
        let mut spec = DriveSpec::new(power, speed, ratio.unwrap_or(ANY_RATIO), module, face_width);
        spec.ratio_tolerance = self.ratio_tolerance.map_or(spec.ratio_tolerance, |given| given.0.si());
        spec.teeth = teeth.map_or(spec.teeth, |(teeth, _)| teeth);
        if let Some(mesh) = &self.mesh_efficiency {
            let mut eta = |given: Option<Quantity<Ratio>>, usual: &mut MeshEfficiency, key: &str| {
                let path = Path::root().key("mesh_efficiency").key(key);
                let eta = given.and_then(|given| faults.keep(path, MeshEfficiency::new(given.0.si())));
                *usual = eta.unwrap_or(*usual);
            };
            eta(mesh.sun_planet, &mut spec.sun_planet_efficiency, "sun_planet");
            eta(mesh.planet_ring, &mut spec.planet_ring_efficiency, "planet_ring");
            eta(mesh.planet_bearings, &mut spec.planet_bearing_efficiency, "planet_bearings");
        }
        spec.gear_set.rack = rack;
        spec.gear_set.density = or(gear_set.density, spec.gear_set.density);
        let mut bore = |given: Option<BoreText>, usual: &mut Bore, path| match given.map(|given| given.0) {
            Some(Bore::Given(diameter)) if diameter.si() < 0.0 => {
                faults.push(path, refused("negative", "a bore below 0; write 0 mm for a solid gear"));
            }
            given => *usual = given.unwrap_or(*usual),
        };
        bore(gear_set.sun_bore, &mut spec.gear_set.sun_bore, "gear_set.sun_bore");
        bore(gear_set.planet_bore, &mut spec.gear_set.planet_bore, "gear_set.planet_bore");
        if let Some(shafts) = &self.shafts {
            spec.shafts.allowable_stress = or(shafts.allowable_stress, spec.shafts.allowable_stress);
            spec.shafts.bearing_series = shafts.bearing_series.map_or(Series::Medium300, |given| given.0);
            let mut shaft = |given: &Option<ShaftFile>, key: &str| {
                let path = Path::root().key("shafts").key(key);
                given.as_ref().map_or_else(ShaftSpec::default, |given| shaft(given, &path, &mut faults))
            };
            spec.shafts.sun = shaft(&shafts.sun, "sun");
            spec.shafts.planet = shaft(&shafts.planet, "planet");
            spec.shafts.carrier = shaft(&shafts.carrier, "carrier");
        }
        if let Some(given) = &self.carrier {
            spec.carrier = carrier(given, &mut faults).unwrap_or(spec.carrier);
        }
        if let Some(parts) = &self.parts {
            let mut known = |given: &Option<PartFile>, key: &str| {
                let path = Path::root().key("parts").key(key);
                given.as_ref().map_or_else(KnownPart::default, |given| known(given, &path, &mut faults))
            };
            spec.known = KnownParts {
                sun: known(&parts.sun, "sun"),
                planet: known(&parts.planet, "planet"),
                carrier: known(&parts.carrier, "carrier"),
            };
        }
        if let Some(attached) = &self.attached {
            spec.motor_inertia = or(attached.motor, spec.motor_inertia);
            spec.machine_inertia = or(attached.machine, spec.machine_inertia);
        }
        if let Some(start) = &self.start {
            spec.driving_torque = start.driving_torque.map(|given| given.0);
            spec.load = start.load.map(|given| given.0);
        }
        for error in spec.faults() {
            faults.add(place(&error), error);
        }
        faults.or(spec)
    }
}

/// A ratio in place of a missing one, which has its fault already.
const ANY_RATIO: f64 = 5.0;

fn or<T>(given: Option<Quantity<T>>, usual: T) -> T {
    given.map_or(usual, |given| given.0)
}

fn refused(name: &'static str, reason: impl std::fmt::Display) -> Problem {
    Problem::refused(name, reason.to_string())
}

/// The teeth, and the ratio of a set given in full; `None` where that has a fault. A range with a fault
/// counts as not given.
fn teeth(file: &TeethFile, rack: BasicRack, faults: &mut Faults) -> Option<(TeethSpec, Option<f64>)> {
    let single = |span: Option<Span<u32>>| span.and_then(|span| span.single());
    let (sun, planet, ring) = (single(file.sun), single(file.planet), single(file.ring));
    let tip_gap = file.tip_gap.map_or(0.0, Number::get);
    let placement = file.spacing.map_or(Placement::Equal, Placement::from);
    if let (Some(sun), Some(planets)) = (sun, single(file.planets))
        && (planet.is_some() || ring.is_some())
        && (file.planet.is_none() || planet.is_some())
        && (file.ring.is_none() || ring.is_some())
    {
        let mut count = |value, path: &'static str| faults.keep(path, ToothCount::new(value));
        let own = [planet.map(|own| count(own, "teeth.planet")), ring.map(|own| count(own, "teeth.ring"))];
        let sun = count(sun, "teeth.sun")?;
        let (planet, ring) = match own {
            [Some(planet), Some(ring)] => (planet?, ring?),
            [Some(planet), None] => {
                let planet = planet?;
                let ring = planet.get().saturating_mul(2).saturating_add(sun.get());
                (planet, count(ring, "teeth.ring")?)
            }
            [_, ring] => {
                let ring = ring??;
                let twice = ring.get().checked_sub(sun.get()).filter(|twice| twice % 2 == 0);
                let Some(planet) = twice.and_then(|twice| ToothCount::new(twice / 2).ok()) else {
                    let reason = format!(
                        "a ring of {ring} and a sun of {sun} teeth leave no whole number of teeth to the \
                         planet; their difference must be even and above 0"
                    );
                    faults.push("teeth.ring", refused("no-planet-teeth", reason));
                    return None;
                };
                (planet, ring)
            }
        };
        let ratio = 1.0 + ring.as_f64() / sun.as_f64();
        let teeth = ToothNumbers { sun, planet, ring, planets };
        return Some((TeethSpec::Given { teeth, placement, tip_gap }, Some(ratio)));
    }
    let mut bounds = default_bounds(rack);
    for (key, span, usual) in [
        ("teeth.sun", file.sun, &mut bounds.sun),
        ("teeth.planet", file.planet, &mut bounds.planet),
        ("teeth.ring", file.ring, &mut bounds.ring),
        ("teeth.planets", file.planets, &mut bounds.planets),
    ] {
        let range = span.map_or(Ok(usual.clone()), |span| span.closed(usual.clone()));
        match range.map_err(|error| refused("range", error)) {
            Ok(range) if *range.start() == 0 && key != "teeth.planets" => {
                faults.push(key, GearError::NoTeeth);
            }
            Ok(range) => *usual = range,
            Err(problem) => faults.push(key, problem),
        }
    }
    (bounds.tip_gap, bounds.placement) = (tip_gap, placement);
    Some((TeethSpec::Within(bounds), None))
}

fn shaft(given: &ShaftFile, path: &Path, faults: &mut Faults) -> ShaftSpec {
    if given.diameter.is_some_and(|diameter| diameter.0.si() <= 0.0) {
        let reason = "a shaft's diameter must be above 0";
        faults.push(path.clone().key("diameter"), refused("not-positive", reason));
    }
    let bearing = given.bearing.as_ref().and_then(|designation| {
        faults.keep(path.clone().key("bearing"), bearing::by_designation(&designation.0))
    });
    ShaftSpec { diameter: given.diameter.map(|given| given.0), bearing }
}

fn known(given: &PartFile, path: &Path, faults: &mut Faults) -> KnownPart {
    let (mass, inertia) = (given.mass.map(|mass| mass.0), given.inertia.map(|inertia| inertia.0));
    if mass.is_some_and(|mass| mass.si() == 0.0) {
        let reason = "a part of no mass; leave the key out to have the mass of the shape";
        faults.push(path.clone().key("mass"), refused("not-positive", reason));
    }
    for (key, value) in [("mass", mass.map(Physical::si)), ("inertia", inertia.map(Physical::si))] {
        if value.is_some_and(|value| value < 0.0) {
            let reason = format!("a {key} below 0; leave the key out to have that of the shape");
            faults.push(path.clone().key(key), refused("negative", reason));
        }
    }
    KnownPart { mass, inertia }
}

fn carrier(given: &CarrierFile, faults: &mut Faults) -> Option<CarrierSpec> {
    match (&given.inertia, &given.arms, &given.hub) {
        (Some(inertia), None, None) => Some(CarrierSpec::Inertia(inertia.0)),
        (None, Some(arms), Some(hub)) => Some(CarrierSpec::Shape {
            arm: Arm {
                length: arms.length.0,
                width: arms.width.0,
                thickness: arms.thickness.0,
                hole: arms
                    .hole
                    .as_ref()
                    .map(|hole| Hole { radius: hole.radius.0, from_outer_end: hole.from_outer_end.0 }),
            },
            hub: Hub {
                outer_radius: hub.outside_radius.0,
                inner_radius: or(hub.inside_radius, Length::default()),
                width: hub.width.0,
            },
        }),
        (Some(_), _, _) => {
            let reason = "a carrier has its inertia given, or arms and hub, not both";
            faults.push("carrier.inertia", refused("carrier-twice", reason));
            None
        }
        (None, _, _) => {
            let reason = "give the carrier both arms and hub, or its inertia";
            faults.push("carrier", refused("half-a-carrier", reason));
            None
        }
    }
}
