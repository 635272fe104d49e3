//! The part of a calculation that does not depend on the load, and what a load makes of it.

use crate::checks::{positive, within};
use crate::factor::{Document, Factor, Given, Origin, Reference, Side, Symbol};
use crate::life::{self, Line};
use crate::load::{self, Dynamics, LoadFactors, Swinging};
use crate::mesh::{Mesh, Method};
use crate::root::factors;
use crate::root::section::{RootSection, section_of};
use crate::{Error, Quantity, contact};
use epicyclic_gears::geometry::GearKind;
use epicyclic_units::Physical;
use std::f64::consts::PI;
use uom::si::f64::Torque;

const fn part(document: Document, place: &'static str) -> Reference {
    Reference::new(document, place)
}

const fn part1(place: &'static str) -> Reference {
    part(Document::Iso6336Part1, place)
}

const fn part2(place: &'static str) -> Reference {
    part(Document::Iso6336Part2, place)
}

const fn part3(place: &'static str) -> Reference {
    part(Document::Iso6336Part3, place)
}

/// Part of the rating of a mesh that does not depend on the load.
pub(crate) struct Prepared<'a> {
    mesh: &'a Mesh,
    pub(crate) method: &'a Method,
    module_mm: f64,
    face_mm: f64,
    transverse: f64,
    overlap: f64,
    /// Helix angle at the base cylinder, rad.
    base_helix: f64,
    pub(crate) contact_factors: [Factor; 4],
    pub(crate) gears: [PreparedGear; 2],
}

/// A gear, or why its flank or root cannot be rated.
pub(crate) struct PreparedGear {
    pub(crate) contact: Result<PreparedFlank, Error>,
    pub(crate) root: Result<PreparedRoot, Error>,
}

pub(crate) struct PreparedFlank {
    pub(crate) limit: f64,
    pub(crate) single_contact: Factor,
    pub(crate) size: Factor,
    line: Line,
    /// `Z_W` for static strength.
    work_hardening_static: f64,
}

impl PreparedFlank {
    /// `σ_HG` for static strength.
    pub(crate) fn static_limit(&self) -> f64 {
        self.statically() * self.line.at(0.0)
    }

    fn statically(&self) -> f64 {
        self.limit * self.work_hardening_static * self.size.value
    }
}

pub(crate) struct PreparedRoot {
    pub(crate) section: Option<RootSection>,
    pub(crate) stress: [Factor; 5],
    pub(crate) test_gear: Factor,
    pub(crate) notch: Factor,
    pub(crate) surface: Factor,
    pub(crate) size: Factor,
    pub(crate) mean_stress: Factor,
    line: Line,
    /// `σ_Flim·Y_ST·Y_δrelT,stat·Y_M`.
    statically: Result<f64, Error>,
    /// `σ_Flim·Y_ST·Y_δrelT·Y_RrelT·Y_X·Y_M`.
    endurance: f64,
}

impl PreparedRoot {
    /// `σ_FG` over the cycles.
    ///
    /// # Errors
    /// [`Error::MissingFactor`] where the static limit is not known.
    pub(crate) fn limit_line(&self) -> Result<Line, Error> {
        Ok(self.line.times(self.statically.clone()?, self.endurance))
    }

    /// `σ_FG` for static strength.
    ///
    /// # Errors
    /// [`Error::MissingFactor`] where it is not known.
    pub(crate) fn static_limit(&self) -> Result<f64, Error> {
        Ok(self.statically.clone()? * self.line.at(0.0))
    }

    pub(crate) fn limit_at(&self, cycles: f64, given: &Given, side: Side) -> Result<LimitAt, Error> {
        let life = given.or(side, Symbol::LifeRoot, part3("clause 12"), || {
            if cycles >= self.line.reference_cycles() {
                return Ok(self.line.at(cycles));
            }
            Ok(self.limit_line()?.at(cycles) / self.endurance)
        })?;
        Ok(LimitAt { life, stress: life.value * self.endurance })
    }
}

/// A part of a rating: what stops the part alone stays in it, anything else stops the whole.
pub(crate) fn part_of<T>(rated: Result<T, Error>) -> Result<Result<T, Error>, Error> {
    match rated {
        Err(error) if !error.is_of_part() => Err(error),
        part => Ok(part),
    }
}

impl<'a> Prepared<'a> {
    pub(crate) fn new(mesh: &'a Mesh, method: &'a Method) -> Result<Self, Error> {
        let module_mm = positive(Quantity::Module, mesh.module.mm(), "mm")?;
        let face_mm = positive(Quantity::FaceWidth, mesh.face_width.mm(), "mm")?;
        positive(Quantity::Viscosity, mesh.viscosity.mm2_s(), "mm²/s")?;
        within(Quantity::LongLifeFactor, method.long_life_factor, [0.85, 1.0], "")?;
        // Grades of ISO 1328-1:1995; those of 2013 are 1 to 11.
        within(Quantity::AccuracyGrade, f64::from(method.accuracy_grade), [0.0, 12.0], "")?;
        for (gear, kind) in mesh.gears.iter().zip(mesh.pair.gears().map(|gear| gear.kind())) {
            gear.material.check()?;
            positive(Quantity::FlankRoughness, gear.flank_roughness.um(), "µm")?;
            positive(Quantity::RootRoughness, gear.root_roughness.um(), "µm")?;
            let rim = match kind {
                GearKind::External => Quantity::Rim,
                GearKind::Internal => Quantity::RingRim,
            };
            gear.rim.map_or(Ok(0.0), |thickness| positive(rim, thickness.mm(), "mm"))?;
        }
        let transverse =
            within(Quantity::TransverseContactRatio, mesh.pair.transverse_contact_ratio(), [1.0, 2.5], "")?;
        let overlap = mesh.pair.overlap_ratio(face_mm / module_mm);
        let base_helix = mesh.pair.gears()[0].profile().base_helix_rad();
        let given = &method.given;
        let whole = |symbol, reference, value: f64| given.or(Side::First, symbol, reference, || Ok(value));
        let materials = [&mesh.gears[0].material, &mesh.gears[1].material];
        let contact_factors = [
            whole(Symbol::Zone, part2("clause 6.1"), contact::zone_factor(&mesh.pair, base_helix))?,
            whole(Symbol::Elasticity, part2("clause 7"), contact::elasticity_factor(materials))?,
            whole(
                Symbol::ContactRatio,
                part2("clause 8"),
                contact::contact_ratio_factor(transverse, overlap),
            )?,
            whole(
                Symbol::HelixContact,
                part2("clause 9"),
                contact::helix_factor(&mesh.pair, method.edition),
            )?,
        ];
        let singles = contact::single_contact_factors(&mesh.pair, overlap);
        let gear = |side: Side| {
            PreparedGear::new(mesh, method, side, [transverse, overlap], [base_helix, module_mm], &singles)
        };
        let gears = [gear(Side::First)?, gear(Side::Second)?];
        Ok(Self { mesh, method, module_mm, face_mm, transverse, overlap, base_helix, contact_factors, gears })
    }

    fn reference_mm(&self) -> f64 {
        self.mesh.pair.gears()[0].reference_diameter() * self.module_mm
    }

    /// `F_t`, N, of the torque in N·m.
    pub(crate) fn force(&self, torque: f64) -> f64 {
        self.mesh.tangential_force(Torque::from_si(torque)).si()
    }

    /// `v`, m/s, of the first gear's speed in rpm.
    pub(crate) fn speed(&self, speed_rpm: f64) -> f64 {
        PI * self.reference_mm() * speed_rpm / 60_000.0
    }

    /// `N_L` of the first gear's speed in rpm and the hours.
    pub(crate) fn cycles(
        &self,
        side: Side,
        speed_rpm: f64,
        hours: f64,
        contacts: [f64; 2],
    ) -> Result<f64, Error> {
        let contacts = positive(Quantity::Contacts, contacts[side as usize], "")?;
        let [first, second] = self.mesh.pair.gears();
        let ratio = match side {
            Side::First => 1.0,
            Side::Second => first.teeth().as_f64() / second.teeth().as_f64(),
        };
        Ok(60.0 * speed_rpm * ratio * hours * contacts)
    }

    /// `σ_H0`, N/mm².
    pub(crate) fn nominal_contact(&self, force: f64) -> f64 {
        let [first, second] = self.mesh.pair.gears();
        let sign = if self.mesh.pair.is_internal() { -1.0 } else { 1.0 };
        let u = sign * second.teeth().as_f64() / first.teeth().as_f64();
        let factors: f64 = self.contact_factors.iter().map(|factor| factor.value).product();
        factors * (force / (self.reference_mm() * self.face_mm) * (u + 1.0) / u).sqrt()
    }

    /// `σ_F0`, N/mm².
    pub(crate) fn nominal_root(&self, root: &PreparedRoot, force: f64) -> f64 {
        let factors: f64 = root.stress.iter().map(|factor| factor.value).product();
        force / (self.face_mm * self.module_mm) * factors
    }

    fn swinging(&self, speed: f64) -> Swinging<'_> {
        Swinging {
            pair: &self.mesh.pair,
            module_mm: self.module_mm,
            materials: [&self.mesh.gears[0].material, &self.mesh.gears[1].material],
            transverse: self.transverse,
            overlap: self.overlap,
            speed,
            base_helix: self.base_helix,
        }
    }

    /// Load factors of a force, N, and the first gear's speed, rpm.
    pub(crate) fn load_factors(
        &self,
        force: f64,
        speed_rpm: f64,
        given: Given,
        dynamics: Option<&Dynamics>,
    ) -> Result<LoadFactors, Error> {
        let must_be_given = |symbol, because| {
            given.or(Side::First, symbol, part1("clause 5"), || Err(Error::MissingFactor { symbol, because }))
        };
        let application =
            must_be_given(Symbol::Application, "it is a property of the machines that drive and are driven")?;
        let floating = self.method.floating;
        let reference = match self.method.planets {
            Some(1) => part1("the mesh load factor, of one path of power"),
            _ => floating.reference(),
        };
        let sharing =
            given.or(Side::First, Symbol::LoadSharing, reference, || match self.method.planets {
                Some(planets) => load::load_sharing(planets, floating),
                None => Err(Error::MissingFactor {
                    symbol: Symbol::LoadSharing,
                    because: "give it, or the number of planets",
                }),
            })?;
        let swinging = self.swinging(self.speed(speed_rpm));
        let line_load = force * application.value * sharing.value / self.face_mm;
        let needs = |symbol| Error::MissingFactor {
            symbol,
            because: "give it, or the accuracy of the teeth for method B",
        };
        let stiffness =
            dynamics.map(|dynamics| swinging.single_stiffness(dynamics.blank_factor)).transpose()?;
        let dynamics = dynamics.zip(stiffness);
        let dynamic = match (given.of(Side::First, Symbol::Dynamic), dynamics) {
            (None, Some((dynamics, stiffness))) => {
                let found = swinging.dynamic_factor(dynamics, speed_rpm, line_load, stiffness)?;
                Factor {
                    symbol: Symbol::Dynamic,
                    value: found.value,
                    origin: Origin::Formula(found.reference),
                }
            }
            _ => given.or(Side::First, Symbol::Dynamic, part1("clause 6"), || Err(needs(Symbol::Dynamic)))?,
        };
        let face_contact = must_be_given(
            Symbol::FaceContact,
            "it depends on deformations and deviations of shafts and housing",
        )?;
        let heights = self
            .mesh
            .pair
            .gears()
            .map(|gear| (gear.tip_diameter() - gear.root_diameter()).abs() / 2.0 * self.module_mm);
        let face_root = given.or(Side::First, Symbol::FaceRoot, part1("clause 7"), || {
            Ok(libm::pow(face_contact.value, load::face_exponent(heights, self.face_mm)))
        })?;
        let load = line_load * dynamic.value * face_contact.value;
        let transverse = |index: usize, symbol| {
            given.or(Side::First, symbol, part1("formulas (73) to (76)"), || {
                let (dynamics, stiffness) = dynamics.ok_or(needs(symbol))?;
                Ok(swinging.transverse_factors(dynamics, load, self.contact_factors[2].value, stiffness)?
                    [index])
            })
        };
        Ok(LoadFactors {
            application,
            sharing,
            dynamic,
            face_contact,
            transverse_contact: transverse(0, Symbol::TransverseContact)?,
            face_root,
            transverse_root: transverse(1, Symbol::TransverseRoot)?,
        })
    }

    /// `σ_H` of a gear, N/mm².
    pub(crate) fn contact_stress(&self, flank: &PreparedFlank, force: f64, factors: &LoadFactors) -> f64 {
        flank.single_contact.value * self.nominal_contact(force) * factors.contact()
    }

    /// `σ_F` of a gear, N/mm².
    pub(crate) fn root_stress(&self, root: &PreparedRoot, force: f64, factors: &LoadFactors) -> f64 {
        self.nominal_root(root, force) * factors.root()
    }

    /// The limit of a flank at a speed, m/s.
    ///
    /// # Errors
    /// What keeps the flank from being rated.
    pub(crate) fn flank_limit(&self, side: Side, speed: f64) -> Result<FlankLimit<'_>, Error> {
        let given = &self.method.given;
        let flank = self.gears[side as usize].contact.as_ref().map_err(Clone::clone)?;
        let lower = self.mesh.gears.map(|gear| gear.material.contact_limit.mpa());
        let lower = lower[0].min(lower[1]);
        let viscosity = self.mesh.viscosity.mm2_s();
        let roughness = [0, 1].map(|index: usize| self.mesh.gears[index].flank_roughness.um());
        let radius = contact::reduced_radius(&self.mesh.pair) * self.module_mm;
        let film = part2("clause 12");
        let own = side as usize;
        let material = &self.mesh.gears[own].material;
        let mate = &self.mesh.gears[1 - own].material;
        let lubricant =
            given.or(side, Symbol::Lubricant, film, || Ok(contact::lubricant_factor(lower, viscosity)))?;
        let velocity =
            given.or(side, Symbol::Velocity, film, || Ok(contact::velocity_factor(lower, speed)))?;
        let rough = given
            .or(side, Symbol::Roughness, film, || Ok(contact::roughness_factor(lower, roughness, radius)))?;
        let work_hardening = given.or(side, Symbol::WorkHardening, part2("clause 13"), || {
            let roughness = [roughness[own], roughness[1 - own]];
            contact::work_hardening_factor([material, mate], roughness, radius, viscosity, speed)
        })?;
        let endurance = flank.limit
            * lubricant.value
            * velocity.value
            * rough.value
            * work_hardening.value
            * flank.size.value;
        Ok(FlankLimit { flank, lubricant, velocity, roughness: rough, work_hardening, endurance })
    }
}

impl PreparedGear {
    /// # Errors
    /// Faults that are not of one part alone.
    fn new(
        mesh: &Mesh,
        method: &Method,
        side: Side,
        ratios: [f64; 2],
        base_helix_and_module: [f64; 2],
        singles: &Result<[f64; 2], Error>,
    ) -> Result<Self, Error> {
        Ok(Self {
            contact: part_of(PreparedFlank::new(mesh, method, side, singles))?,
            root: part_of(PreparedRoot::new(mesh, method, side, ratios, base_helix_and_module))?,
        })
    }
}

impl PreparedFlank {
    fn new(
        mesh: &Mesh,
        method: &Method,
        side: Side,
        singles: &Result<[f64; 2], Error>,
    ) -> Result<Self, Error> {
        let given = &method.given;
        let material = &mesh.gears[side as usize].material;
        let single_contact = given.or(side, Symbol::SingleContact, part2("clause 6.2"), || {
            singles.clone().map(|factors| factors[side as usize])
        })?;
        Ok(Self {
            limit: material.contact_limit.mpa(),
            single_contact,
            size: given.or(side, Symbol::SizeContact, part2("clause 14"), || Ok(1.0))?,
            line: life::contact_line(material.class, method.pitting_allowed, method.long_life_factor),
            work_hardening_static: given.of(side, Symbol::WorkHardening).unwrap_or(1.0),
        })
    }
}

impl PreparedRoot {
    fn new(
        mesh: &Mesh,
        method: &Method,
        side: Side,
        [transverse, overlap]: [f64; 2],
        [base_helix, module_mm]: [f64; 2],
    ) -> Result<Self, Error> {
        let given = &method.given;
        let own = &mesh.gears[side as usize];
        let gear = &mesh.pair.gears()[side as usize];
        let profile = gear.profile();
        let material = &own.material;
        let class = material.class;
        let take = |symbol, reference, value: &dyn Fn() -> Result<f64, Error>| {
            given.or(side, symbol, reference, value)
        };
        let needs_section = [Symbol::Form, Symbol::StressCorrection, Symbol::NotchSensitivity]
            .iter()
            .any(|symbol| given.of(side, *symbol).is_none());
        let section =
            if needs_section { Some(section_of(gear, transverse, own.shaper, base_helix)?) } else { None };
        let alpha = profile.rack.pressure_angle.si();
        let of_section = |symbol, of: &dyn Fn(&RootSection) -> Result<f64, Error>| match &section {
            Some(section) => of(section),
            None => Err(Error::MissingFactor { symbol, because: "no critical section was calculated" }),
        };
        let form = take(Symbol::Form, part3("clause 6.2"), &|| {
            of_section(Symbol::Form, &|section| Ok(factors::form_factor(section, alpha)))
        })?;
        let correction = take(Symbol::StressCorrection, part3("clause 7.2"), &|| {
            of_section(Symbol::StressCorrection, &factors::stress_correction)
        })?;
        let helix = take(Symbol::HelixRoot, part3("clause 8.2"), &|| {
            Ok(factors::helix_factor(overlap, profile.helix_angle.si()))
        })?;
        let height = (gear.tip_diameter() - gear.root_diameter()).abs() / 2.0;
        let rim = take(Symbol::RimThickness, part3("clause 9.2"), &|| match (own.rim, gear.kind()) {
            (None, _) => Ok(1.0),
            (Some(rim), GearKind::External) => factors::rim_factor_external(rim.mm() / (height * module_mm)),
            (Some(rim), GearKind::Internal) => factors::rim_factor_internal(rim.mm() / module_mm),
        })?;
        let narrowing = libm::cos(base_helix).powi(2);
        let deep = take(Symbol::DeepTooth, part3("clause 10.2"), &|| {
            Ok(factors::deep_tooth_factor(transverse / narrowing, method.accuracy_grade))
        })?;

        let test_gear = take(Symbol::TestGearStress, part3("clause 7.4"), &|| Ok(2.0))?;
        let notch = take(Symbol::NotchSensitivity, part3("clause 13.3"), &|| {
            of_section(Symbol::NotchSensitivity, &|section| {
                factors::notch_sensitivity(material, factors::notch_parameter(section))
            })
        })?;
        let surface = take(Symbol::SurfaceRoot, part3("clause 14.3"), &|| {
            factors::surface_factor(class, own.root_roughness.um())
        })?;
        let size_root =
            take(Symbol::SizeRoot, part3("clause 15"), &|| Ok(factors::size_factor(class, module_mm)))?;
        let mean_stress =
            take(Symbol::MeanStress, part3("annex B"), &|| factors::mean_stress_factor(own.bending))?;
        let static_notch = take(Symbol::StaticNotchSensitivity, part3("clause 13.3"), &|| {
            factors::static_notch_sensitivity(class, correction.value)
        });

        let limit = material.root_limit.mpa() * test_gear.value * mean_stress.value;
        Ok(Self {
            section,
            stress: [form, correction, helix, rim, deep],
            test_gear,
            notch,
            surface,
            size: size_root,
            mean_stress,
            line: life::root_line(class, method.long_life_factor),
            statically: static_notch.map(|factor| limit * factor.value),
            endurance: limit * notch.value * surface.value * size_root.value,
        })
    }
}

/// The limit of a flank at a speed.
pub(crate) struct FlankLimit<'a> {
    pub(crate) flank: &'a PreparedFlank,
    pub(crate) lubricant: Factor,
    pub(crate) velocity: Factor,
    pub(crate) roughness: Factor,
    pub(crate) work_hardening: Factor,
    /// `σ_HG` without `Z_NT`.
    endurance: f64,
}

/// A limit and its life factor.
pub(crate) struct LimitAt {
    pub(crate) life: Factor,
    pub(crate) stress: f64,
}

impl FlankLimit<'_> {
    /// `σ_HG` over the cycles.
    pub(crate) fn line(&self) -> Line {
        self.flank.line.times(self.flank.statically(), self.endurance)
    }

    pub(crate) fn at(&self, cycles: f64, given: &Given, side: Side) -> Result<LimitAt, Error> {
        let life = given.or(side, Symbol::LifeContact, part2("clause 11"), || {
            Ok(self.line().at(cycles) / self.endurance)
        })?;
        Ok(LimitAt { life, stress: life.value * self.endurance })
    }
}
