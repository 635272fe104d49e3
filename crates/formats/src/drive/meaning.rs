//! What a drive file means: defaults filled in, values brought together.

use epicyclic_dynamics::drive::{
    Bore, CarrierSpec, DriveSpec, KnownPart, KnownParts, ShaftSpec, TeethSpec, default_bounds,
};
use epicyclic_gears::bearing::{self, Series};
use epicyclic_gears::carrier::{Arm, Hole, Hub};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::synthesis::{Placement, ToothNumbers};
use epicyclic_gears::{Error as GearError, ToothCount};
use std::ops::RangeInclusive;
use uom::si::f64::{Length, Ratio};

use super::{BoreText, CarrierFile, DriveFile, Misfit, PartFile, ShaftFile, TeethFile};
use crate::{Path, Problem, Span};
use epicyclic_units::{Number, Physical, Quantity};

impl DriveFile {
    /// What is meant, defaults filled in.
    ///
    /// # Errors
    /// A [`Misfit`] for a tooth count of 0, an open range that its default turns around, an efficiency
    /// outside 0…1, an unknown bearing, a carrier with both inertia and shape or with half a shape, and a
    /// missing ratio.
    pub fn spec(&self) -> Result<DriveSpec, Misfit> {
        let gear_set = &self.gear_set;
        let rack = BasicRack::default();
        let rack = BasicRack {
            addendum: gear_set.addendum.map_or(rack.addendum, Number::get),
            clearance: gear_set.clearance.map_or(rack.clearance, Number::get),
            pressure_angle: or(gear_set.pressure_angle, rack.pressure_angle),
        };
        let (teeth, own_ratio) = teeth(&self.teeth.clone().unwrap_or_default(), rack)?;
        let ratio = self.ratio.map(Number::get).or(own_ratio).ok_or_else(|| Misfit {
            path: Path::root(),
            problem: Problem::MissingKey { key: "ratio".to_owned() },
        })?;

        let mut spec =
            DriveSpec::new(self.power.0, self.speed.0, ratio, gear_set.module.0, gear_set.face_width.0);
        spec.ratio_tolerance = self.ratio_tolerance.map_or(spec.ratio_tolerance, |given| given.0.si());
        spec.teeth = teeth;
        if let Some(mesh) = &self.mesh_efficiency {
            let eta = |given: Option<Quantity<Ratio>>, usual, path| {
                given.map_or(Ok(usual), |given| {
                    MeshEfficiency::new(given.0.si()).map_err(|error| Misfit::of_gear(path, &error))
                })
            };
            spec.sun_planet_efficiency =
                eta(mesh.sun_planet, spec.sun_planet_efficiency, "mesh_efficiency.sun_planet")?;
            spec.planet_ring_efficiency =
                eta(mesh.planet_ring, spec.planet_ring_efficiency, "mesh_efficiency.planet_ring")?;
            spec.planet_bearing_efficiency =
                eta(mesh.planet_bearings, spec.planet_bearing_efficiency, "mesh_efficiency.planet_bearings")?;
        }
        spec.gear_set.rack = rack;
        spec.gear_set.density = or(gear_set.density, spec.gear_set.density);
        spec.gear_set.sun_bore = bore(gear_set.sun_bore, spec.gear_set.sun_bore, "gear_set.sun_bore")?;
        spec.gear_set.planet_bore =
            bore(gear_set.planet_bore, spec.gear_set.planet_bore, "gear_set.planet_bore")?;
        if let Some(shafts) = &self.shafts {
            spec.shafts.allowable_stress = or(shafts.allowable_stress, spec.shafts.allowable_stress);
            spec.shafts.bearing_series = shafts.bearing_series.map_or(Series::Medium300, |given| given.0);
            spec.shafts.sun = shaft(shafts.sun.as_ref(), "shafts.sun")?;
            spec.shafts.planet = shaft(shafts.planet.as_ref(), "shafts.planet")?;
            spec.shafts.carrier = shaft(shafts.carrier.as_ref(), "shafts.carrier")?;
        }
        if let Some(given) = &self.carrier {
            spec.carrier = carrier(given)?;
        }
        if let Some(parts) = &self.parts {
            spec.known = KnownParts {
                sun: known(parts.sun.as_ref(), "parts.sun")?,
                planet: known(parts.planet.as_ref(), "parts.planet")?,
                carrier: known(parts.carrier.as_ref(), "parts.carrier")?,
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
        Ok(spec)
    }
}

fn or<T>(given: Option<Quantity<T>>, usual: T) -> T {
    given.map_or(usual, |given| given.0)
}

/// The teeth, and the ratio of a set given in full.
fn teeth(file: &TeethFile, rack: BasicRack) -> Result<(TeethSpec, Option<f64>), Misfit> {
    let single = |span: Option<Span<u32>>| span.and_then(|span| span.single());
    let count = |value, path| ToothCount::new(value).map_err(|error| Misfit::of_gear(path, &error));
    let (sun, planet, ring) = (single(file.sun), single(file.planet), single(file.ring));
    let tip_gap = file.tip_gap.map_or(0.0, Number::get);
    let placement = file.spacing.map_or(Placement::Equal, Placement::from);
    if let (Some(sun), Some(planets)) = (sun, single(file.planets))
        && (planet.is_some() || ring.is_some())
        && (file.planet.is_none() || planet.is_some())
        && (file.ring.is_none() || ring.is_some())
    {
        let sun = count(sun, "teeth.sun")?;
        let (planet, ring) = match (planet, ring) {
            (Some(planet), Some(ring)) => (planet, ring),
            (Some(planet), None) => (planet, planet.saturating_mul(2).saturating_add(sun.get())),
            (_, ring) => {
                let ring = ring.unwrap_or(0);
                let twice = ring.checked_sub(sun.get()).filter(|twice| *twice > 0 && twice % 2 == 0);
                let odd = || {
                    Misfit::new(
                        "teeth.ring",
                        "no-planet-teeth",
                        format!(
                            "a ring of {ring} and a sun of {sun} teeth leave no whole number of teeth to the \
                             planet; their difference must be even and above 0"
                        ),
                    )
                };
                (twice.ok_or_else(odd)? / 2, ring)
            }
        };
        let (planet, ring) = (count(planet, "teeth.planet")?, count(ring, "teeth.ring")?);
        let ratio = 1.0 + ring.as_f64() / sun.as_f64();
        let teeth = ToothNumbers { sun, planet, ring, planets };
        return Ok((TeethSpec::Given { teeth, placement, tip_gap }, Some(ratio)));
    }
    let mut bounds = default_bounds(rack);
    let range = |span: Option<Span<u32>>, usual: &RangeInclusive<u32>, path| {
        let range = span.map_or(Ok(usual.clone()), |span| span.closed(usual.clone()));
        let range = range.map_err(|error| Misfit::new(path, "range", error))?;
        if *range.start() == 0 { Err(Misfit::of_gear(path, &GearError::NoTeeth)) } else { Ok(range) }
    };
    bounds.sun = range(file.sun, &bounds.sun, "teeth.sun")?;
    bounds.planet = range(file.planet, &bounds.planet, "teeth.planet")?;
    bounds.ring = range(file.ring, &bounds.ring, "teeth.ring")?;
    if let Some(planets) = file.planets {
        let range = planets.closed(bounds.planets.clone());
        bounds.planets = range.map_err(|error| Misfit::new("teeth.planets", "range", error))?;
    }
    (bounds.tip_gap, bounds.placement) = (tip_gap, placement);
    Ok((TeethSpec::Within(bounds), None))
}

fn bore(given: Option<BoreText>, usual: Bore, path: &str) -> Result<Bore, Misfit> {
    match given.map(|given| given.0) {
        Some(Bore::Given(diameter)) if diameter.si() < 0.0 => {
            Err(Misfit::new(path, "negative", "a bore below 0; write 0 mm for a solid gear"))
        }
        given => Ok(given.unwrap_or(usual)),
    }
}

fn shaft(given: Option<&ShaftFile>, path: &str) -> Result<ShaftSpec, Misfit> {
    let Some(given) = given else { return Ok(ShaftSpec::default()) };
    if given.diameter.is_some_and(|diameter| diameter.0.si() <= 0.0) {
        return Err(Misfit::new(
            &format!("{path}.diameter"),
            "not-positive",
            "a shaft's diameter must be above 0",
        ));
    }
    let bearing = given.bearing.as_ref().map(|designation| {
        bearing::by_designation(&designation.0)
            .map_err(|error| Misfit::of_gear(&format!("{path}.bearing"), &error))
    });
    Ok(ShaftSpec { diameter: given.diameter.map(|given| given.0), bearing: bearing.transpose()? })
}

fn known(given: Option<&PartFile>, path: &str) -> Result<KnownPart, Misfit> {
    let Some(given) = given else { return Ok(KnownPart::default()) };
    let is_massless = given.mass.is_some_and(|mass| mass.0.si() == 0.0);
    if is_massless {
        let reason = "a part of no mass; leave the key out to have the mass of the shape";
        return Err(Misfit::new(&format!("{path}.mass"), "not-positive", reason));
    }
    let negative = |key: &str, is_negative: bool| match is_negative {
        true => Err(Misfit::new(
            &format!("{path}.{key}"),
            "negative",
            format!("a {key} below 0; leave the key out to have that of the shape"),
        )),
        false => Ok(()),
    };
    negative("mass", given.mass.is_some_and(|mass| mass.0.si() < 0.0))?;
    negative("inertia", given.inertia.is_some_and(|inertia| inertia.0.si() < 0.0))?;
    Ok(KnownPart { mass: given.mass.map(|given| given.0), inertia: given.inertia.map(|given| given.0) })
}

fn carrier(given: &CarrierFile) -> Result<CarrierSpec, Misfit> {
    match (&given.inertia, &given.arms, &given.hub) {
        (Some(inertia), None, None) => Ok(CarrierSpec::Inertia(inertia.0)),
        (None, Some(arms), Some(hub)) => Ok(CarrierSpec::Shape {
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
        (Some(_), _, _) => Err(Misfit::new(
            "carrier.inertia",
            "carrier-twice",
            "a carrier has its inertia given, or arms and hub, not both",
        )),
        (None, _, _) => Err(Misfit::new(
            "carrier",
            "half-a-carrier",
            "give the carrier both arms and hub, or its inertia",
        )),
    }
}
