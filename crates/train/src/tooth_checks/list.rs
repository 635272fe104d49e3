//! The checks of the teeth of each set as a list: checks made, checks not possible, checks that fail.

use super::{Checks, NamedGear, ToothWarning};
use crate::Gearbox;
use crate::planet_places::{central_mesh, planet_of, teeth_of};
use crate::planet_set::{GearOf, MeshKind, PlanetSet};
use crate::set::SetKind;
use crate::tolerance::PRINTED_SHIFTS;
use crate::toothed::{ToothedMesh, Untoothed};
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::check::{Check, Place as SimplePlace, Rule, Severity};
use epicyclic_gears::involute::checks::{Limits, gear_checks, mesh_checks};
use epicyclic_gears::involute::{InvoluteGear, Pair, PlanetSet as InvoluteSet, Profile};
use epicyclic_gears::quantity::SimpleGear;
use epicyclic_gears::rack::BasicRack;
use std::fmt;

/// Object of a check in a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Subject {
    /// The set itself.
    Set,
    /// A gear, by name.
    Gear(String),
    /// A mesh, by the names of its gears.
    Mesh(String, String),
    /// The tips of the first gear in the mesh with the second.
    Tips(String, String),
    /// Planets side by side, in this number.
    Planets(u32),
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Set => f.write_str("the set"),
            Self::Gear(gear) => write!(f, "the {gear}"),
            Self::Mesh(one, other) => write!(f, "the mesh of {one} and {other}"),
            Self::Tips(one, other) => write!(f, "the tips of the {one}, mesh with the {other},"),
            Self::Planets(planets) => write!(f, "{planets} planets"),
        }
    }
}

/// A check of a set: its value, its limit, and whether it holds.
#[derive(Debug, Clone, PartialEq)]
pub struct SetCheck {
    /// The set.
    pub set: String,
    /// Object of the check.
    pub subject: Subject,
    /// Name of the rule.
    pub rule: &'static str,
    /// The value.
    pub value: f64,
    /// The limit.
    pub limit: f64,
    /// Unit of both; empty of a plain number.
    pub unit: &'static str,
    /// Severity of a failure.
    pub severity: Severity,
    /// Description of the failure, with its figures; `None` if the check holds.
    pub miss: Option<String>,
    /// Remedy for a failure.
    pub remedy: &'static str,
}

/// A set for which some checks are left out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotChecked {
    /// The set.
    pub set: String,
    /// The keys of the file without which they cannot be made.
    pub missing: Vec<&'static str>,
}

/// The checks of all sets.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SetChecks {
    /// Checks, set by set.
    pub checks: Vec<SetCheck>,
    /// Checks left out for lack of data.
    pub not_checked: Vec<NotChecked>,
}

impl Gearbox {
    /// The checks of the teeth of all sets: those of [`tooth_checks`](Self::tooth_checks), and all that hold.
    ///
    /// `modules` are those that are stated of the meshes of a set, in any unit; with them the steps of
    /// planets are compared.
    #[must_use]
    pub fn set_checks(
        &self,
        rack: &BasicRack,
        modules: impl Fn(&PlanetSet) -> Vec<Option<f64>>,
    ) -> SetChecks {
        let mut all = SetChecks::default();
        for set in &self.sets {
            let checks = Checks::new(set, *rack, &modules(set));
            all.checks.extend(checks.list());
            let missing = checks.missing();
            if !missing.is_empty() {
                all.not_checked.push(NotChecked { set: set.id().to_owned(), missing });
            }
        }
        all
    }
}

impl SetChecks {
    /// Failed checks, without remarks, in words.
    pub fn warnings(&self) -> impl Iterator<Item = String> {
        let missed = self.checks.iter().filter(|check| check.severity > Severity::Remark);
        missed.filter_map(|check| Some(format!("set `{}`: {}", check.set, check.miss.as_ref()?)))
    }
}

impl Checks<'_> {
    /// Toothed gears of a simple set on one centre distance.
    fn simple(&self) -> Option<InvoluteSet> {
        self.set.simple_involutes(self.toothed.as_ref().ok()?)
    }

    /// Every check of the set.
    pub(super) fn list(&self) -> Vec<SetCheck> {
        let mut all: Vec<SetCheck> = vec![];
        let simple = self.simple();
        let is_refused = matches!(self.toothed, Err(Untoothed::Refused(_)))
            && (self.set.tooth_shape().has_shape() || self.is_simple());
        match (&simple, &self.toothed) {
            (Some(set), _) => {
                for check in self.at_angles(set) {
                    let own = set.gears().into_iter().zip(SimpleGear::ALL);
                    let own = own
                        .filter(|(_, gear)| check.place == SimplePlace::Gear(*gear))
                        .map(|(of, _)| of)
                        .next();
                    all.push(self.of_simple(check, own));
                }
                all.extend(self.ring_tips(set.ring_mesh(), &["planet".to_owned(), "ring".to_owned()]));
            }
            (None, Err(Untoothed::Refused(error))) if is_refused => {
                all.push(self.missed(&ToothWarning::ShiftsRefused { error: error.clone() }));
            }
            (None, Ok(set)) => all.extend(self.of_meshes(&set.meshes)),
            (None, Err(_)) if self.needs_shifts() => {}
            (None, Err(_)) => all.extend(self.of_meshes(&self.plain_meshes())),
        }
        all.extend(self.structure(simple.is_some() || is_refused).iter().map(|warning| self.missed(warning)));
        all
    }

    fn is_simple(&self) -> bool {
        self.set.kind() == Some(SetKind::Simple)
    }

    /// Whether it is a simple set whose teeth share a centre distance with profile shifts alone; none are
    /// stated, so nothing is known of its teeth.
    fn needs_shifts(&self) -> bool {
        self.is_simple() && self.set.gears().into_iter().all(|gear| self.set.teeth(gear).is_some())
    }

    /// A check of a simple set by the words of this crate.
    fn of_simple(&self, check: Check, gear: Option<&InvoluteGear>) -> SetCheck {
        let subject = match check.place {
            SimplePlace::Gear(gear) => Subject::Gear(gear.to_string()),
            SimplePlace::Mesh(mesh) => {
                let [one, other] = mesh.gears();
                Subject::Mesh(one.to_string(), other.to_string())
            }
            SimplePlace::Tips(gear, mesh) => {
                let mate = mesh.gears().into_iter().find(|of| *of != gear).unwrap_or(gear);
                Subject::Tips(gear.to_string(), mate.to_string())
            }
            SimplePlace::Planets(planets) => Subject::Planets(planets),
        };
        let check = Check { rule: check.rule, place: subject, value: check.value, limit: check.limit };
        self.made(&check, gear)
    }

    /// A check in words, of a gear with why its tool does not cut it.
    fn made(&self, check: &Check<Subject>, gear: Option<&InvoluteGear>) -> SetCheck {
        let is_rounding = match check.rule {
            Rule::Backlash => check.value >= -PRINTED_SHIFTS,
            // Without shift the nearest whole number counts, as handbooks have it: 17 teeth at 20°.
            Rule::Undercut if check.value == 0.0 => self.is_nearest_whole(&check.place),
            _ => false,
        };
        let most = (check.rule == Rule::PlanetGap).then(|| self.most_that_clear()).flatten();
        let fault = gear.and_then(InvoluteGear::tool_fault).filter(|_| check.rule == Rule::Tool);
        let words = || match (most, fault) {
            (Some(most), _) => format!("{check}; at most {most} clear"),
            (None, Some(fault)) => format!("{check}: {fault}"),
            (None, None) => check.to_string(),
        };
        SetCheck {
            set: self.name(),
            subject: check.place.clone(),
            rule: check.rule.name(),
            value: check.value,
            limit: check.limit,
            unit: check.rule.unit(),
            severity: check.rule.severity(),
            miss: (!check.holds() && !is_rounding).then(words),
            remedy: check.rule.remedy(),
        }
    }

    /// Whether a gear has the least whole number of teeth that counts as not undercut.
    fn is_nearest_whole(&self, subject: &Subject) -> bool {
        let Subject::Gear(name) = subject else { return false };
        let own = self.set.gears().into_iter().find(|gear| self.set.gear_name(*gear) == *name);
        own.and_then(|gear| self.whole_teeth(gear)).is_some_and(|teeth| !self.rack.undercuts(teeth))
    }

    /// Teeth of a gear; of the planet of a simple set those that equal centre distances leave it, where they
    /// are whole.
    fn whole_teeth(&self, gear: GearOf) -> Option<ToothCount> {
        let teeth = teeth_of(self.set, gear).filter(|teeth| teeth.fract() == 0.0 && *teeth >= 1.0)?;
        ToothCount::new(teeth as u32).ok()
    }

    /// The largest number of planets alike that clears.
    fn most_that_clear(&self) -> Option<u32> {
        let planets = self.set.planet_count()?;
        let neighbours = self.neighbours();
        (2..planets).rev().find(|&fewer| self.clears(&neighbours, &super::equal_steps(fewer)))
    }

    /// Check of the shortening of a ring's tips against its basic rack, if the file states no tips.
    fn ring_tips(&self, pair: &Pair, names: &[String; 2]) -> Option<SetCheck> {
        let has_tips = self.set.tooth_shape().shifts.as_ref().is_some_and(|shifts| shifts.tips.is_some());
        if has_tips || !pair.is_internal() {
            return None;
        }
        let [planet, ring] = pair.gears();
        let full = ring.with_tip_alteration(0.0).ok()?;
        let full = Pair::at_centre_distance(*planet, full, pair.centre_distance()).ok()?;
        Some(self.shortened(&full, ring, names))
    }

    /// The check that a ring runs with its full teeth: a remark where their tips reach into fillets alone,
    /// and a warning where they reach below the base circle of the mate.
    fn shortened(&self, full: &Pair, ring: &InvoluteGear, [one, other]: &[String; 2]) -> SetCheck {
        let by = ring.tip_alteration();
        let below_base = full.interference().is_some_and(|free| free.base < 0.0);
        let miss = (by < 0.0).then(|| {
            let reach = if below_base { "reach below the base circle of the" } else { "reach into the fillets of the" };
            format!(
                "the tips of the {other} are taken {:.3} modules shorter than its basic rack has them, since full ones {reach} {one}: cut the blank so",
                -by
            )
        });
        SetCheck {
            set: self.name(),
            subject: Subject::Tips(other.clone(), one.clone()),
            rule: "full-tips",
            value: by,
            limit: 0.0,
            unit: "modules",
            severity: if below_base { Severity::Warning } else { Severity::Remark },
            miss,
            remedy: "state `tip_alterations`, or take other teeth or profile shifts",
        }
    }

    /// Meshes of gears without profile shift, each on its own centre distance, as far as the teeth are known.
    fn plain_meshes(&self) -> Vec<ToothedMesh> {
        // Helical sets of which teeth are missing have no spur teeth.
        if self.set.tooth_shape().is_helical() {
            return vec![];
        }
        let profile = Profile::of_rack(self.rack);
        let toothed = |gear: GearOf| {
            let kind = self.set.gear_kind(gear)?;
            InvoluteGear::new(kind, self.whole_teeth(gear)?, profile, 0.0).ok()
        };
        let plain = |mesh: usize| {
            let gears = self.set.gears_of_mesh(mesh);
            let full = Pair::without_backlash(toothed(gears[0])?, toothed(gears[1])?).ok()?;
            Some(ToothedMesh { gears, pair: full.with_clear_ring_tips().unwrap_or(full), module: 1.0 })
        };
        (0..self.set.meshes().len()).filter_map(plain).collect()
    }

    /// Checks of gears and their meshes.
    fn of_meshes(&self, meshes: &[ToothedMesh]) -> Vec<SetCheck> {
        let mut all = vec![];
        let limits = Limits::default();
        let mut seen: Vec<GearOf> = vec![];
        for ToothedMesh { gears, pair, .. } in meshes {
            let names = gears.map(|gear| self.set.gear_name(gear));
            all.extend(self.ring_tips(pair, &names));
            for ((gear, name), of) in gears.iter().zip(&names).zip(pair.gears()) {
                if !seen.contains(gear) {
                    seen.push(*gear);
                    let subject = Subject::Gear(name.clone());
                    gear_checks(&subject, of, &limits, &mut |check| all.push(self.made(&check, Some(of))));
                }
            }
            let mut see = |check: Check<Subject>| all.push(self.made(&check, None));
            let [one, other] = names;
            let tips = [Subject::Tips(one.clone(), other.clone()), Subject::Tips(other.clone(), one.clone())];
            mesh_checks(&Subject::Mesh(one, other), &tips, pair, &limits, &mut see);
        }
        all
    }

    /// Misfits in the numbers of teeth and planets; `is_toothed` for a simple set whose teeth share a centre
    /// distance, and for a set whose shifts are refused.
    pub(super) fn structure(&self, is_toothed: bool) -> Vec<ToothWarning> {
        let mut found = vec![];
        found.extend(self.small_rings());
        if !is_toothed && !self.set.is_pair() {
            let by_shape = self.by_shape().is_some();
            if !by_shape {
                found.extend(self.half_tooth());
                found.extend(self.centre_distances());
            }
            if by_shape || !self.set.tooth_shape().is_helical() {
                if !by_shape {
                    found.extend(self.steps());
                }
                found.extend(self.across_axis());
                found.extend(self.triangles());
                found.extend(self.overlaps());
            }
        }
        if !self.set.is_pair() {
            found.extend(self.assembly());
        }
        if !is_toothed {
            found.extend(self.planes());
        }
        found
    }

    /// A warning as a check that does not hold.
    fn missed(&self, warning: &ToothWarning) -> SetCheck {
        let (rule, value, limit, unit, remedy) = warning.figures();
        SetCheck {
            set: self.name(),
            subject: Subject::Set,
            rule,
            value,
            limit,
            unit,
            severity: warning.severity(),
            miss: Some(warning.to_string()),
            remedy,
        }
    }

    /// Meshes of a planet with central gears: the mesh, the central gear, the planet's gear, and the centre
    /// distance of gears without profile shift, in modules.
    fn with_centrals(&self, planet: usize) -> Vec<(usize, NamedGear, GearOf, f64)> {
        let of_planet = |mesh: &usize| {
            central_mesh(self.set, *mesh).is_some_and(|(_, gear)| planet_of(gear) == Some(planet))
        };
        let meshes: Vec<usize> = (0..self.set.meshes().len()).filter(of_planet).collect();
        let placed = |mesh: usize| {
            let (central, gear) = central_mesh(self.set, mesh)?;
            let distance = super::centre_distance(self.set, mesh)?;
            Some((mesh, self.named(GearOf::Central(central))?, gear, distance))
        };
        meshes.into_iter().filter_map(placed).collect()
    }

    /// Steps of one planet whose meshes have different centre distances with the modules that are stated.
    fn steps(&self) -> Vec<ToothWarning> {
        let mut found = vec![];
        for planet in 0..self.set.planets().len() {
            let all = self.with_centrals(planet);
            let Some((first, central, gear, distance)) = all.first() else { continue };
            for (mesh, other, step, teeth) in all.iter().skip(1).filter(|(_, _, step, _)| step != gear) {
                let ratio = distance / teeth;
                match (self.stated[*first], self.stated[*mesh]) {
                    (Some(one), Some(two)) if (one * distance - two * teeth).abs() > super::TOUCH * one => {
                        found.push(ToothWarning::StepsApart {
                            centrals: [central.clone(), other.clone()],
                            distances: [one * distance, two * teeth].map(|distance| distance / one),
                        });
                    }
                    (one, None) if (ratio - 1.0).abs() > super::TOUCH => {
                        found.push(ToothWarning::StepModule {
                            step: self.set.gear_name(*step),
                            centrals: [central.clone(), other.clone()],
                            ratio,
                            is_stated: one.is_some(),
                        });
                    }
                    _ => {}
                }
            }
        }
        found
    }

    /// Planets whose gears reach across the axis.
    fn across_axis(&self) -> Vec<ToothWarning> {
        let mut found = vec![];
        for planet in 0..self.set.planets().len() {
            let all = self.with_centrals(planet);
            // About an axis without a sun a single planet may turn as an eccentric does.
            let has_sun = all.iter().any(|(mesh, ..)| self.set.meshes()[*mesh].kind == MeshKind::External);
            for gear in self.gears_of(planet).filter(|_| has_sun) {
                let (Some(radius), Some(tip)) = (self.places.radii[planet], self.tip(gear)) else { continue };
                if tip >= radius {
                    let module = self.module(gear).unwrap_or(1.0);
                    found.push(ToothWarning::AcrossAxis {
                        gear: self.set.gear_name(gear),
                        by: (tip - radius) / module,
                    });
                }
            }
        }
        found
    }

    /// The keys without which checks are left out.
    fn missing(&self) -> Vec<&'static str> {
        let mut missing = vec![];
        let is_pair = self.set.is_pair();
        let has = |gear: GearOf| self.set.teeth(gear).is_some();
        let mut centrals = (0..self.set.centrals().len())
            .filter(|central| self.set.gear_kind(GearOf::Central(*central)).is_some());
        if !centrals.all(|central| has(GearOf::Central(central))) {
            missing.push("teeth");
        }
        let mut planets = (0..self.set.planets().len()).flat_map(|planet| self.gears_of(planet));
        if !is_pair && !planets.all(|gear| self.whole_teeth(gear).is_some()) {
            missing.push(if self.set.short().is_some() { "planet_teeth" } else { "planet_gears" });
        }
        if self.toothed == Err(Untoothed::Shifts) {
            missing.push("profile_shifts");
        }
        if !is_pair && self.set.planet_count().is_none() {
            missing.push("planets");
        }
        missing
    }
}
