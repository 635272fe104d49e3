//! The part of a calculation that does not depend on the load, and what a load makes of it.

use crate::factor::{Document, Factor, Given, Origin, Reference, Side, Symbol};
use crate::life::{self, Line};
use crate::load::{self, Dynamics, LoadFactors, Swinging};
use crate::mesh::{Mesh, Method};
use crate::root::factors;
use crate::root::section::{RootSection, section_of};
use crate::units::{self, mm, mm2_s, mpa, newtons, positive, radians, um, within};
use crate::{Error, Quantity, contact};
use epicyclic_gears::geometry::GearKind;
use std::f64::consts::PI;

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

/// What does not depend on the load.
pub(crate) struct Prepared<'a> {
    mesh: &'a Mesh,
    method: &'a Method,
    module_mm: f64,
    face_mm: f64,
    transverse: f64,
    overlap: f64,
    /// Helix angle at the base cylinder, rad.
    base_helix: f64,
    pub(crate) contact_factors: [Factor; 4],
    pub(crate) gears: [PreparedGear; 2],
}

pub(crate) struct PreparedGear {
    pub(crate) contact_limit: f64,
    pub(crate) single_contact: Factor,
    pub(crate) size_contact: Factor,
    pub(crate) contact_line: Line,
    /// `Z_W` for static strength.
    pub(crate) work_hardening_static: f64,
    pub(crate) section: Option<RootSection>,
    pub(crate) root_stress: [Factor; 5],
    pub(crate) test_gear: Factor,
    pub(crate) notch: Factor,
    pub(crate) surface: Factor,
    pub(crate) size_root: Factor,
    pub(crate) mean_stress: Factor,
    pub(crate) root_line: Line,
    /// `σ_Flim·Y_ST·Y_δrelT,stat·Y_M`.
    pub(crate) static_root: Result<f64, Error>,
    /// `σ_Flim·Y_ST·Y_δrelT·Y_RrelT·Y_X·Y_M`.
    pub(crate) endurance_root: f64,
}

impl<'a> Prepared<'a> {
    pub(crate) fn new(mesh: &'a Mesh, method: &'a Method) -> Result<Self, Error> {
        let module_mm = positive(Quantity::Module, mm(mesh.module), "mm")?;
        let face_mm = positive(Quantity::FaceWidth, mm(mesh.face_width), "mm")?;
        positive(Quantity::Viscosity, mm2_s(mesh.viscosity), "mm²/s")?;
        within(Quantity::LongLifeFactor, method.long_life_factor, [0.85, 1.0], "")?;
        for gear in &mesh.gears {
            gear.material.check()?;
            positive(Quantity::FlankRoughness, um(gear.flank_roughness), "µm")?;
            positive(Quantity::RootRoughness, um(gear.root_roughness), "µm")?;
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
        newtons(self.mesh.tangential_force(units::torque(torque)))
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
    pub(crate) fn nominal_root(&self, side: Side, force: f64) -> f64 {
        let factors: f64 = self.gears[side as usize].root_stress.iter().map(|factor| factor.value).product();
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
        let table = part(Document::AbsRules, "load sharing of planets");
        let sharing = given.or(Side::First, Symbol::LoadSharing, table, || match self.method.planets {
            Some(planets) => load::load_sharing(planets),
            None => Err(Error::MissingFactor {
                symbol: Symbol::LoadSharing,
                because: "give it, or the number of planets for the table",
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

    /// `σ_H` and `σ_F` of a gear, N/mm².
    pub(crate) fn stresses(&self, side: Side, force: f64, factors: &LoadFactors) -> [f64; 2] {
        let contact =
            self.gears[side as usize].single_contact.value * self.nominal_contact(force) * factors.contact();
        [contact, self.nominal_root(side, force) * factors.root()]
    }

    /// Limits of both gears at a speed, m/s.
    pub(crate) fn limits(&self, speed: f64) -> Result<[Limits<'_>; 2], Error> {
        let given = &self.method.given;
        let lower = self.gears[0].contact_limit.min(self.gears[1].contact_limit);
        let viscosity = mm2_s(self.mesh.viscosity);
        let roughness = [0, 1].map(|index: usize| um(self.mesh.gears[index].flank_roughness));
        let radius = contact::reduced_radius(&self.mesh.pair) * self.module_mm;
        let limits = |side: Side| -> Result<Limits<'_>, Error> {
            let film = part2("clause 12");
            let own = side as usize;
            let material = &self.mesh.gears[own].material;
            let mate = &self.mesh.gears[1 - own].material;
            let lubricant = given
                .or(side, Symbol::Lubricant, film, || Ok(contact::lubricant_factor(lower, viscosity)))?;
            let velocity =
                given.or(side, Symbol::Velocity, film, || Ok(contact::velocity_factor(lower, speed)))?;
            let rough = given.or(side, Symbol::Roughness, film, || {
                Ok(contact::roughness_factor(lower, roughness, radius))
            })?;
            let work_hardening = given.or(side, Symbol::WorkHardening, part2("clause 13"), || {
                let roughness = [roughness[own], roughness[1 - own]];
                contact::work_hardening_factor([material, mate], roughness, radius, viscosity, speed)
            })?;
            let gear = &self.gears[own];
            let endurance = gear.contact_limit
                * lubricant.value
                * velocity.value
                * rough.value
                * work_hardening.value
                * gear.size_contact.value;
            Ok(Limits { gear, lubricant, velocity, roughness: rough, work_hardening, endurance })
        };
        Ok([limits(Side::First)?, limits(Side::Second)?])
    }
}

impl PreparedGear {
    fn new(
        mesh: &Mesh,
        method: &Method,
        side: Side,
        [transverse, overlap]: [f64; 2],
        [base_helix, module_mm]: [f64; 2],
        singles: &Result<[f64; 2], Error>,
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

        let single_contact = take(Symbol::SingleContact, part2("clause 6.2"), &|| {
            singles.clone().map(|factors| factors[side as usize])
        })?;
        let size_contact = take(Symbol::SizeContact, part2("clause 14"), &|| Ok(1.0))?;

        let needs_section = [Symbol::Form, Symbol::StressCorrection, Symbol::NotchSensitivity]
            .iter()
            .any(|symbol| given.of(side, *symbol).is_none());
        let section =
            if needs_section { Some(section_of(gear, transverse, own.shaper, base_helix)?) } else { None };
        let alpha = radians(profile.rack.pressure_angle);
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
            Ok(factors::helix_factor(overlap, radians(profile.helix_angle)))
        })?;
        let height = (gear.tip_diameter() - gear.root_diameter()).abs() / 2.0;
        let rim = take(Symbol::RimThickness, part3("clause 9.2"), &|| match (own.rim, gear.kind()) {
            (None, _) => Ok(1.0),
            (Some(rim), GearKind::External) => factors::rim_factor_external(mm(rim) / (height * module_mm)),
            (Some(rim), GearKind::Internal) => factors::rim_factor_internal(mm(rim) / module_mm),
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
            factors::surface_factor(class, um(own.root_roughness))
        })?;
        let size_root =
            take(Symbol::SizeRoot, part3("clause 15"), &|| Ok(factors::size_factor(class, module_mm)))?;
        let mean_stress =
            take(Symbol::MeanStress, part3("annex B"), &|| factors::mean_stress_factor(own.bending))?;
        let static_notch = take(Symbol::StaticNotchSensitivity, part3("clause 13.3"), &|| {
            factors::static_notch_sensitivity(class, correction.value)
        });

        let limit = mpa(material.root_limit) * test_gear.value * mean_stress.value;
        Ok(Self {
            contact_limit: mpa(material.contact_limit),
            single_contact,
            size_contact,
            contact_line: life::contact_line(class, method.pitting_allowed, method.long_life_factor),
            work_hardening_static: given.of(side, Symbol::WorkHardening).unwrap_or(1.0),
            section,
            root_stress: [form, correction, helix, rim, deep],
            test_gear,
            notch,
            surface,
            size_root,
            mean_stress,
            root_line: life::root_line(class, method.long_life_factor),
            static_root: static_notch.map(|factor| limit * factor.value),
            endurance_root: limit * notch.value * surface.value * size_root.value,
        })
    }
}

/// Limits of a gear at a speed.
pub(crate) struct Limits<'a> {
    pub(crate) gear: &'a PreparedGear,
    pub(crate) lubricant: Factor,
    pub(crate) velocity: Factor,
    pub(crate) roughness: Factor,
    pub(crate) work_hardening: Factor,
    /// `σ_HG` without `Z_NT`.
    pub(crate) endurance: f64,
}

/// A limit and its life factor.
pub(crate) struct LimitAt {
    pub(crate) life: Factor,
    pub(crate) stress: f64,
}

impl Limits<'_> {
    /// `σ_HG` over the cycles.
    pub(crate) fn contact_line(&self) -> Line {
        let gear = self.gear;
        let statically = gear.contact_limit * gear.work_hardening_static * gear.size_contact.value;
        gear.contact_line.times(statically, self.endurance)
    }

    /// `σ_FG` over the cycles.
    ///
    /// # Errors
    /// [`Error::MissingFactor`] where the static limit is not known.
    pub(crate) fn root_line(&self) -> Result<Line, Error> {
        Ok(self.gear.root_line.times(self.gear.static_root.clone()?, self.gear.endurance_root))
    }

    pub(crate) fn contact_at(&self, cycles: f64, given: &Given, side: Side) -> Result<LimitAt, Error> {
        let life = given.or(side, Symbol::LifeContact, part2("clause 11"), || {
            Ok(self.contact_line().at(cycles) / self.endurance)
        })?;
        Ok(LimitAt { life, stress: life.value * self.endurance })
    }

    pub(crate) fn root_at(&self, cycles: f64, given: &Given, side: Side) -> Result<LimitAt, Error> {
        let gear = self.gear;
        let life = given.or(side, Symbol::LifeRoot, part3("clause 12"), || {
            if cycles >= gear.root_line.reference_cycles() {
                return Ok(gear.root_line.at(cycles));
            }
            Ok(self.root_line()?.at(cycles) / gear.endurance_root)
        })?;
        Ok(LimitAt { life, stress: life.value * gear.endurance_root })
    }
}
