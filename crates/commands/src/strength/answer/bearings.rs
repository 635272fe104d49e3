//! Planet bearings over the duty of a file: basic and modified rating life, static safety.
//!
//! ```text
//! F = √((K_γ·F_t)² + (K_γ·F_r + F_c)²)        1/L = Σ share_i/(a_1·a_ISO,i·L_10,i)        f_s = C_0/F_max
//! ```
//!
//! `F` is the load of the bearings as a unit. Where the file gives the span of their rows, the moment by
//! which axial forces tilt the planet loads the rows unequally, and the equivalent load of
//! [`epicyclic_strength::bearing_rows`] takes the place of `F`; `f_s` is then that of the row with more load.
//! `K_γ` multiplies this moment, too.
//!
//! Plain bearings have no life; their oil film is that of [`epicyclic_strength::plain_bearing`].
//!
//! `F_t` and `F_r` are the mesh forces without losses, `F_c` is the centrifugal force
//! ([`planet_bearings`](epicyclic_train::planet_bearings)). `F_max` also covers the file's overloads; `a_ISO`
//! is that of [`epicyclic_strength::bearing`].

use super::duty::WorkedStep;
use super::materials::{floating, given_sharing};
use super::overload::Peak;
use super::records::{BearingOverDuty, BearingStepFigures, ModifiedLife};
use super::spans::above_0;
use crate::analyze::answer::Worked;
use crate::analyze::answer::records::planet_name;
use crate::error::Error;
use crate::shared::fault::{Named, refused};
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::{lacking, toothed};
use crate::tolerance::{ROUNDED, rounded};
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::{GearboxFile, SetData};
use epicyclic_gears::life::Rolling;
use epicyclic_strength::bearing::{
    BearingStep, Reliability, life_modification, life_over_duty, viscosity_ratio,
};
use epicyclic_strength::bearing_rows::{equivalent_load, row_forces};
use epicyclic_strength::load::{Floating, load_sharing};
use epicyclic_strength::plain_bearing::{self, film_ratio};
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_bearings::{BearingForces, Lack, PlanetBearing};
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::toothed::ToothedSet;
use epicyclic_units::{Physical, Quantity};
use uom::si::f64::{AngularVelocity, Force, KinematicViscosity, Length, Torque};

/// Data of a file for its planet bearings.
struct File<'a> {
    subject: &'a Gearbox,
    file: &'a GearboxFile,
    reliability: Reliability,
}

/// Data of the bearings of a planet besides their load rating: keys of the set for a set with two central
/// gears, keys of the planet for a compound set.
#[derive(Default)]
struct Given {
    /// Path of these keys.
    path: Path,
    static_load_rating: Option<Quantity<Force>>,
    fatigue_limit: Option<Quantity<Force>>,
    bearing_diameter: Option<Quantity<Length>>,
    bearing_span: Option<Quantity<Length>>,
    /// Mesh load factor `K_γ` of a compound set's planet.
    load_sharing: Option<f64>,
}

/// Operating conditions for the modified life.
struct Conditions {
    viscosity: KinematicViscosity,
    contamination: f64,
    fatigue_limit: Force,
    diameter: Length,
}

/// Rows of a planet's bearings.
struct Rows {
    span: Length,
    /// Helical teeth of the set, or those of a set with stepped planets, in metres.
    toothed: Option<ToothedSet>,
    /// Face widths of the gears; empty if no planet is stepped.
    widths: Vec<Length>,
}

/// Load of a bearing in a step.
#[derive(Debug, Clone, Copy, Default)]
struct StepLoad {
    /// Radial force.
    force: Force,
    speed: AngularVelocity,
    /// Load for the life.
    equivalent: Force,
    tilted: Option<Tilted>,
}

/// Load of both rows with the tilting moment.
#[derive(Debug, Clone, Copy, Default)]
struct Tilted {
    axial_n: f64,
    moment_n_m: f64,
    rows: [Force; 2],
}

/// Rates all planet bearings with a load rating.
///
/// # Errors
/// [`Error::Document`] for invalid data in the file, with the place.
pub(super) fn rated(
    subject: &Gearbox,
    file: &GearboxFile,
    duty: &[WorkedStep<'_>],
    peaks: &[Peak<'_>],
) -> Result<Vec<BearingOverDuty>, Error> {
    let of = File { subject, file, reliability: reliability(subject, file)? };
    let rated = subject.planet_bearings.iter().filter_map(|bearing| {
        let (rating, rolling) = bearing.load_rating?;
        Some(of.bearing(bearing, rating, rolling, duty, peaks))
    });
    rated.collect()
}

/// Reliability that a file requires.
fn reliability(subject: &Gearbox, file: &GearboxFile) -> Result<Reliability, Error> {
    let Some(asked) = file.bearing_reliability else { return Ok(Reliability::default()) };
    let is_asked = |one: &Reliability| (one.part() - asked.0.si()).abs() < ROUNDED;
    Reliability::ALL.into_iter().find(is_asked).ok_or_else(|| {
        let why = Named("bearing-reliability", "the reliability of bearings is 90, 95, 96, 97, 98 or 99 %");
        refused(&subject.document, &Path::root(), &["bearing_reliability"], &why)
    })
}

impl File<'_> {
    fn bearing(
        &self,
        bearing: &PlanetBearing,
        rating: Force,
        rolling: Rolling,
        duty: &[WorkedStep<'_>],
        peaks: &[Peak<'_>],
    ) -> Result<BearingOverDuty, Error> {
        let set = &self.subject.train.sets()[bearing.set];
        let entry = self.file.sets.iter().find(|entry| entry.id == set.id());
        let given = self.given(set.id(), &set.planets()[bearing.planet].name);
        let data = self.file.set_data(set);
        let strength = data.as_ref().and_then(|data| data.strength);
        let stated = given.load_sharing.or_else(|| strength.and_then(given_sharing));
        let floating = data.as_ref().and_then(|data| data.floating).map_or(Floating::Assumed, floating);
        let sharing = match stated {
            Some(stated) => Some(stated),
            None => load_sharing(bearing.planets.unwrap_or(1), floating).ok(),
        };
        let (conditions, mut missing) = self.conditions(&given)?;
        let span = given.bearing_span.map(|span| span.0);
        let rows = span.map(|span| self.rows(set, span)).transpose()?;
        let mut row = BearingOverDuty {
            set: set.id().to_owned(),
            planet: planet_name(set, bearing.planet),
            rolling: rolling.name(),
            load_rating_n: rating.si(),
            mean_diameter_m: given.bearing_diameter.map(|diameter| diameter.0.si()),
            load_sharing: sharing,
            load_sharing_is_given: stated.is_some(),
            span_m: span.map(Physical::si),
            greatest_force_n: None,
            greatest_row_force_n: None,
            static_safety: None,
            basic_life_s: None,
            pressure_pa: None,
            film_ratio: None,
            modified: None,
            steps: vec![],
            missing: vec![],
        };
        let Some(sharing) = sharing else {
            let key = if entry.is_some() { "strength.factors.K_gamma" } else { "planet_sizes.load_sharing" };
            row.missing = vec![format!("{key} (its table ends at 7 planets)")];
            return Ok(row);
        };
        let rows = match rows.transpose() {
            Ok(rows) => rows,
            Err(missing) => {
                row.missing = missing;
                return Ok(row);
            }
        };
        let load = |worked: Option<&Worked<'_>>, speed| {
            self.step(bearing, worked, speed, (rolling, sharing, rows.as_ref()))
        };
        let mut steps = vec![];
        let mut all = vec![];
        for WorkedStep(entry, worked) in duty {
            let Some(load) = load(worked.as_ref(), entry.speed.0)? else {
                row.missing = missing_for_forces(bearing);
                return Ok(row);
            };
            let StepLoad { force, speed, equivalent, tilted } = load;
            steps.push(BearingStep { share: entry.share.0.si(), load: equivalent, speed, modification: 1.0 });
            row.steps.push(BearingStepFigures {
                gear: entry.gear.clone(),
                force_n: force.si(),
                axial_force_n: tilted.map(|tilted| tilted.axial_n),
                tilting_moment_n_m: tilted.map(|tilted| tilted.moment_n_m),
                row_forces_n: tilted.map(|tilted| tilted.rows.map(Physical::si)),
                equivalent_load_n: equivalent.si(),
                speed_rad_s: speed.si(),
                viscosity_ratio: None,
                modification: None,
            });
            all.push(load);
        }
        let still = AngularVelocity::from_si(0.0);
        for peak in peaks {
            all.extend(load(Some(&peak.worked), still)?);
        }
        let greatest = all.iter().map(|load| load.force.si()).fold(0.0, f64::max);
        row.greatest_force_n = Some(greatest);
        let of_rows = all.iter().filter_map(|load| load.tilted).flat_map(|tilted| tilted.rows);
        let of_row = of_rows.map(Physical::si).fold(0.0, f64::max);
        row.greatest_row_force_n = span.map(|_| of_row);
        // The static load rating is that of two equal rows.
        let at_rest = span.map_or(greatest, |_| 2.0 * of_row);
        if let Some(rating) = self.of(&given, "static_load_rating", given.static_load_rating)? {
            row.static_safety = (at_rest > 0.0).then(|| rating.si() / at_rest);
        }
        let life = |steps: &[BearingStep], reliability| {
            life_over_duty(rolling, rating, steps, reliability).map(|life| life.map(Physical::si))
        };
        row.basic_life_s = life(&steps, Reliability::Percent90)?;
        if rolling == Rolling::Plain {
            if let Some(size) = data.as_ref().and_then(|data| plain_size(data, bearing.planet)) {
                let loads = steps.iter().filter(|step| step.share > 0.0).map(|step| step.load.si());
                row.pressure_pa = Some(loads.fold(0.0, f64::max) / (size[0] * size[1]).si());
                row.film_ratio = self.film(size, &steps);
            }
        } else if let Some(conditions) = conditions {
            match self.modify(rolling, &conditions, &mut steps, &mut row.steps) {
                Ok(()) => {
                    row.modified = Some(ModifiedLife {
                        reliability: self.reliability.part(),
                        reliability_factor: self.reliability.factor(),
                        life_s: life(&steps, self.reliability)?,
                    });
                }
                Err(why) => missing.push(why),
            }
        }
        row.missing = missing;
        Ok(row)
    }

    /// Oil film of a plain bearing over the least one.
    fn film(&self, size: [Length; 2], steps: &[BearingStep]) -> Option<f64> {
        let oil = self.file.oil.as_ref()?;
        let stated = oil.working_viscosity.map(|stated| stated.0);
        film_ratio(size, steps, plain_bearing::viscosity(oil.viscosity.0, stated))
    }

    /// Data of the bearings of a planet in the file.
    fn given(&self, set: &str, planet: &str) -> Given {
        if let Some((place, entry)) = self.file.sets.iter().enumerate().find(|(_, entry)| entry.id == set) {
            return Given {
                path: Path::root().key("sets").index(place),
                static_load_rating: entry.static_load_rating,
                fatigue_limit: entry.fatigue_limit,
                bearing_diameter: entry.bearing_diameter,
                bearing_span: entry.bearing_span,
                load_sharing: None,
            };
        }
        let compound = self.file.compound_sets.iter().enumerate().find(|(_, entry)| entry.id == set);
        let Some((place, entry)) =
            compound.and_then(|(place, of)| Some((place, of.planet_sizes.get(planet)?)))
        else {
            return Given::default();
        };
        Given {
            path: Path::root().key("compound_sets").index(place).key("planet_sizes").key(planet),
            static_load_rating: entry.static_load_rating,
            fatigue_limit: entry.fatigue_limit,
            bearing_diameter: entry.bearing_diameter,
            bearing_span: entry.bearing_span,
            load_sharing: entry.load_sharing.map(epicyclic_units::Number::get),
        }
    }

    /// Conditions for the modified life, or the missing keys if only some are given.
    fn conditions(&self, given: &Given) -> Result<(Option<Conditions>, Vec<String>), Error> {
        let oil = self.file.oil.as_ref();
        let of_oil = Path::root().key("oil");
        let viscosity = oil.and_then(|oil| oil.working_viscosity).map(|of| of.0);
        let contamination = oil.and_then(|oil| oil.contamination).map(epicyclic_units::Number::get);
        viscosity.map_or(Ok(()), |viscosity| self.above_0(viscosity, &of_oil, "working_viscosity"))?;
        if contamination.is_some_and(|factor| !(0.0..=1.0).contains(&factor)) {
            let why = Named("out-of-range", "a contamination factor is from 0 to 1");
            return Err(refused(&self.subject.document, &of_oil, &["contamination"], &why));
        }
        let fatigue_limit = self.of(given, "fatigue_limit", given.fatigue_limit)?;
        let diameter = self.of(given, "bearing_diameter", given.bearing_diameter)?;
        if let (Some(viscosity), Some(contamination), Some(fatigue_limit), Some(diameter)) =
            (viscosity, contamination, fatigue_limit, diameter)
        {
            let all = Conditions { viscosity, contamination, fatigue_limit, diameter };
            return Ok((Some(all), vec![]));
        }
        let known = [
            ("oil.working_viscosity", viscosity.is_some()),
            ("oil.contamination", contamination.is_some()),
            ("fatigue_limit", fatigue_limit.is_some()),
            ("bearing_diameter", diameter.is_some()),
        ];
        // A file with none of these keys does not ask for a modified life; the diameter is known of any bearing.
        if known.iter().all(|(key, is_known)| !is_known || *key == "bearing_diameter") {
            return Ok((None, vec![]));
        }
        Ok((None, lacking(&known)))
    }

    /// Quantity of a bearing, which must be above 0.
    fn of<T: Physical>(
        &self,
        given: &Given,
        key: &str,
        value: Option<Quantity<T>>,
    ) -> Result<Option<T>, Error> {
        let Some(value) = value.map(|value| value.0) else { return Ok(None) };
        self.above_0(value, &given.path, key)?;
        Ok(Some(value))
    }

    fn above_0(&self, value: impl Physical, path: &Path, key: &str) -> Result<(), Error> {
        above_0(&self.subject.document, value, path, key)
    }

    /// Rows of the bearings of a planet at this distance; the keys missing for the moment on them.
    fn rows(&self, set: &PlanetSet, span: Length) -> Result<Result<Rows, Vec<String>>, Error> {
        let is_stepped = set.has_stepped_planets();
        if !set.tooth_shape().is_helical() && !is_stepped {
            return Ok(Ok(Rows { span, toothed: None, widths: vec![] }));
        }
        let Some(data) = self.file.set_data(set) else { return Ok(Err(vec!["teeth".to_owned()])) };
        let has_module = data.modules.iter().any(Option::is_some);
        Ok(match toothed(self.subject, &data, set)? {
            Ok(toothed) if has_module => {
                let widths = || data.face_widths.iter().copied().collect::<Option<Vec<_>>>();
                let widths = if is_stepped { widths() } else { Some(vec![]) };
                let rows = |widths| Rows { span, toothed: Some(toothed), widths };
                widths.map(rows).ok_or_else(|| vec!["face_width".to_owned()])
            }
            Ok(_) => Err(vec!["module".to_owned()]),
            Err(key) => Err(vec![key.unwrap_or("teeth").to_owned()]),
        })
    }

    /// Load of a bearing and its speed in a step of the duty; `None` if no force can be computed.
    fn step(
        &self,
        bearing: &PlanetBearing,
        worked: Option<&Worked<'_>>,
        speed: AngularVelocity,
        (rolling, sharing, rows): (Rolling, f64, Option<&Rows>),
    ) -> Result<Option<StepLoad>, Error> {
        let Some(worked) = worked else {
            let tilted = rows.map(|_| Tilted::default());
            return Ok(Some(StepLoad { tilted, ..StepLoad::default() }));
        };
        let torques = worked.member_torques(bearing.set);
        let set = &self.subject.train.sets()[bearing.set];
        let carrier = worked.analysis.speed(set.carrier()).map(|of| speed * of);
        let forces = bearing.forces(torques.as_deref(), carrier)?;
        let turning = worked.analysis.sets()[bearing.set].planets[bearing.planet]
            .map(|planet| AngularVelocity::from_si((speed * rounded(planet.relative)).si().abs()));
        let (Some([out, along]), Some(speed), Some(torques)) = (shared(&forces, sharing), turning, torques)
        else {
            return Ok(None);
        };
        let force = Force::from_si(libm::hypot(along.si(), out.si()));
        let Some(rows) = rows else {
            return Ok(Some(StepLoad { force, speed, equivalent: force, tilted: None }));
        };
        let Some(tilted) = self.tilted(bearing, &torques, [out, along], (sharing, rows)) else {
            return Ok(None);
        };
        let equivalent = equivalent_load(rolling, tilted.rows);
        Ok(Some(StepLoad { force, speed, equivalent, tilted: Some(tilted) }))
    }

    /// Rows of a bearing under the tilting moment of these torques, and under a radial force outwards and in
    /// the direction in which the planets push the carrier.
    fn tilted(
        &self,
        bearing: &PlanetBearing,
        torques: &[Torque],
        [out, along]: [Force; 2],
        (sharing, rows): (f64, &Rows),
    ) -> Option<Tilted> {
        let set = &self.subject.train.sets()[bearing.set];
        let (mut axial_n, mut moment) = (0.0, [0.0; 2]);
        if let Some(toothed) = &rows.toothed {
            let teeth = (toothed, self.subject.is_behind(set));
            if set.tooth_shape().is_helical() {
                let own = set.planet_axial_load(bearing.planet, teeth, torques)?;
                let sizes: f64 = own.meshes.iter().map(|(_, force)| force.abs()).sum();
                axial_n = if own.force.abs() <= ROUNDED * sizes { 0.0 } else { sharing * own.force };
                moment = own.moment.map(|part| sharing * part);
            }
            if !rows.widths.is_empty() {
                let couple = set.step_couple(bearing.planet, teeth, torques, &rows.widths)?;
                moment = [0, 1].map(|axis: usize| moment[axis] + sharing * couple[axis]);
            }
        }
        let along = PlanetBearing::push_direction(torques) * along;
        let of_rows = row_forces([out, along], moment.map(Torque::from_si), rows.span);
        Some(Tilted {
            axial_n,
            moment_n_m: libm::hypot(moment[0], moment[1]),
            rows: of_rows.map(|[out, along]| Force::from_si(libm::hypot(out.si(), along.si()))),
        })
    }

    /// Adds `a_ISO` to each step; the error gives the reason why none exists.
    fn modify(
        &self,
        rolling: Rolling,
        conditions: &Conditions,
        steps: &mut [BearingStep],
        figures: &mut [BearingStepFigures],
    ) -> Result<(), String> {
        let Conditions { viscosity, contamination, fatigue_limit, diameter } = *conditions;
        for (step, figures) in steps.iter_mut().zip(figures) {
            if step.load.si() == 0.0 || step.speed.si() == 0.0 {
                continue;
            }
            let why = |error: epicyclic_strength::Error| format!("{error}, in gear {}", figures.gear);
            let kappa = viscosity_ratio(viscosity, step.speed, diameter).map_err(why)?;
            let modification =
                life_modification(rolling, kappa, contamination, fatigue_limit, step.load).map_err(why)?;
            step.modification = modification;
            figures.viscosity_ratio = Some(kappa);
            figures.modification = Some(modification);
        }
        Ok(())
    }
}

/// Diameter and width of a plain bearing, which is as wide as its planet.
fn plain_size(data: &SetData<'_>, planet: usize) -> Option<[Length; 2]> {
    let own = data.of.iter().zip(&data.face_widths);
    let own = own.filter(|(gear, _)| matches!(gear, GearOf::Planet(of, _) if *of == planet));
    let width: Option<Length> = own.map(|(_, width)| *width).sum();
    Some([data.planets[planet].bearing_diameter?, width?])
}

/// Data that are missing for the forces on a bearing.
fn missing_for_forces(bearing: &PlanetBearing) -> Vec<String> {
    let key = |lack: &Lack| match lack {
        Lack::Planets => "planets",
        Lack::Radius => "module with teeth, or carrier_radius",
        Lack::CommonRadius => "a carrier_radius of each planet",
        Lack::Teeth => "teeth",
        Lack::Mass => "planet_mass or face_width",
        Lack::Bevel => "forces on bevel planets are not calculated",
        Lack::OtherRadius { .. } | Lack::Distance { .. } | Lack::Triangle { .. } => {
            "the places of planets in mesh"
        }
    };
    let mut all: Vec<String> = bearing.lacks.iter().map(|lack| key(lack).to_owned()).collect();
    if all.is_empty() {
        all.push("no torques follow".to_owned());
    }
    all
}

/// Force on a bearing outwards and in the direction of the push, with mesh forces increased by the uneven
/// load sharing.
fn shared(forces: &BearingForces, sharing: f64) -> Option<[Force; 2]> {
    let (tangential, radial) = (forces.tangential?, forces.radial?);
    Some([sharing * radial + forces.centrifugal?, sharing * tangential])
}
