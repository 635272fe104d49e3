//! Keys of a set that shape its teeth: profile shifts, tip alterations, helix angles, tools, face widths.

use super::per_gear::{Gears, PerGear};
use super::{DataSheetEntry, DescriptionError, StrengthEntry, ToolEntry, ToolMisfit};
use crate::Path;
use crate::faults::Faults;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::profile::Cutting;
use epicyclic_gears::involute::shifts::{StatedDistance, Unclosed, closing_shifts};
use epicyclic_gears::involute::{InvoluteGear, Profile};
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::{Error, Quantity as Named, ToothCount};
use epicyclic_train::toothed::{Shifts, ToothShape, Untoothed};
use epicyclic_units::{Number, Physical, Quantity};
use std::collections::BTreeMap;
use uom::si::f64::{Angle, Length};

/// The keys of a set.
pub(super) struct Shape<'e> {
    /// Name of the set.
    pub(super) set: &'e str,
    /// Gears of the set.
    pub(super) gears: &'e Gears,
    pub(super) profile_shifts: Option<&'e PerGear<Number>>,
    pub(super) tip_alterations: Option<&'e PerGear<Number>>,
    pub(super) tools: &'e BTreeMap<String, ToolEntry>,
    /// Widths shape no profile, but their names are checked here, as those of the strength and the data
    /// sheet.
    pub(super) face_widths: Option<&'e PerGear<Quantity<Length>>>,
    /// The shaper of the strength cuts internal gears without a tool of their own.
    pub(super) strength: Option<&'e StrengthEntry>,
    pub(super) data_sheet: Option<&'e DataSheetEntry>,
    /// Helix angle of each mesh, with the path of its key.
    pub(super) helix_angles: Vec<(Angle, Path)>,
    /// Whether the teeth of all gears are known.
    pub(super) is_known: bool,
    /// Teeth of each gear, where `is_known`.
    pub(super) teeth: Vec<u32>,
    /// Meshes with a stated centre distance.
    pub(super) closing: Vec<ClosingMesh<'e>>,
}

/// The largest size of a shift that follows from a centre distance.
const MOST_SHIFT: f64 = 5.0;

/// A mesh with a stated centre distance.
pub(super) struct ClosingMesh<'e> {
    /// Names of the gears.
    pub(super) gears: &'e [String; 2],
    pub(super) distance: Length,
    pub(super) module: Option<Length>,
    pub(super) helix_angle: Angle,
    /// Whether its planets mesh with central gears alone, so that the set has one distance.
    pub(super) is_one: bool,
    /// Path of the key.
    pub(super) at: Path,
}

impl Shape<'_> {
    /// Teeth of the set beyond their numbers; what has a fault is left out. Tools are checked with a rack
    /// alone.
    pub(super) fn tooth_shape(&self, rack: Option<&BasicRack>, faults: &mut Faults) -> ToothShape {
        self.check_names(faults);
        ToothShape {
            shifts: if self.closing.is_empty() { self.shifts(faults) } else { self.closed(rack, faults) },
            helix_angles: self.checked_angles(faults),
            cutting: self.cutting(rack, faults).unwrap_or_default(),
        }
    }

    /// Adds values of gears that the set has not, and lists of another length.
    fn check_names(&self, faults: &mut Faults) {
        let (set, gears) = (self.set, self.gears);
        let at = |keys: &[&'static str]| {
            (keys.iter().fold(Path::root(), |path, key| path.key(*key)), keys[keys.len() - 1])
        };
        if let Some(widths) = self.face_widths {
            gears.check(set, at(&["face_widths"]), widths, faults);
            let path = Path::root().key("face_widths");
            let all: Vec<(Path, &Quantity<Length>)> = match widths {
                PerGear::List(all) => {
                    all.iter().enumerate().map(|(place, width)| (path.clone().index(place), width)).collect()
                }
                PerGear::Named(all) => {
                    all.iter().map(|(gear, width)| (path.clone().key(gear), width)).collect()
                }
            };
            for (path, width) in all.into_iter().filter(|(_, width)| width.0.si() <= 0.0) {
                let error =
                    Error::NotPositive { quantity: Named::FaceWidth, value: width.0.mm(), unit: "mm" };
                faults.push(path, DescriptionError::of_set(set, error));
            }
        }
        if let Some(of) = self.strength {
            gears.check(set, at(&["strength", "materials"]), &of.materials, faults);
            gears.check(set, at(&["strength", "flank_roughness"]), &of.flank_roughness, faults);
            gears.check(set, at(&["strength", "root_roughness"]), &of.root_roughness, faults);
        }
        if let Some(of) = self.strength.and_then(|of| of.accuracy.as_ref()) {
            let lists =
                [("pitch_deviations", &of.pitch_deviations), ("profile_deviations", &of.profile_deviations)];
            for (key, values) in lists {
                let (at, key) = at(&["strength", "accuracy", key]);
                let is_right = gears.check(set, (at.clone(), key), values, faults);
                if let PerGear::Named(values) = values
                    && let Some(gear) =
                        gears.names.iter().find(|gear| is_right && !values.contains_key(*gear))
                {
                    let (set, gear) = (set.to_owned(), gear.clone());
                    faults.push(at, DescriptionError::GearLacks { set, key, gear });
                }
            }
        }
        if let Some(balls) = self.data_sheet.and_then(|of| of.ball_diameters.as_ref()) {
            gears.check(set, at(&["data_sheet", "ball_diameters"]), balls, faults);
        }
        if let Some(allowances) = self.data_sheet.and_then(|of| of.thickness_allowances.as_ref()) {
            gears.check(set, at(&["data_sheet", "thickness_allowances"]), allowances, faults);
        }
    }

    fn shifts(&self, faults: &mut Faults) -> Option<Shifts> {
        if self.profile_shifts.is_none() && self.tip_alterations.is_none() {
            return None;
        }
        if self.profile_shifts.is_none() && self.is_known {
            faults.push("tip_alterations", DescriptionError::TipsAlone { set: self.set.to_owned() });
            return None;
        }
        let Some(profile) = self.profile_shifts.filter(|_| self.is_known) else {
            let shifts = DescriptionError::Shifts { set: self.set.to_owned() };
            faults.push(&["profile_shifts", "tip_alterations"][..], shifts);
            return None;
        };
        let mut of = |key: &'static str, values: &PerGear<Number>| {
            if !self.gears.check(self.set, (Path::root().key(key), key), values, faults) {
                return None;
            }
            let values = values.given(self.set, key, self.gears).ok()?;
            Some(values.into_iter().map(|value| value.map_or(0.0, |value| value.get())).collect::<Vec<_>>())
        };
        let tips = self.tip_alterations.map(|tips| of("tip_alterations", tips));
        let profile = of("profile_shifts", profile);
        // Tips with a fault leave no shifts, as shifts with a fault do.
        let tips = tips.map_or(Some(None), |tips| tips.map(Some));
        Some(Shifts { profile: profile?, tips: tips? })
    }

    /// Shifts by the stated ones and the centre distances.
    fn closed(&self, rack: Option<&BasicRack>, faults: &mut Faults) -> Option<Shifts> {
        let at = self.closing[0].at.clone();
        let set = || self.set.to_owned();
        let (mut is_sound, count) = (true, self.gears.names.len());
        let mut of = |key: &'static str, values: Option<&PerGear<Number>>| {
            let Some(values) = values else { return vec![None; count] };
            is_sound &= self.gears.check(self.set, (Path::root().key(key), key), values, faults);
            values.of_gears(self.gears).into_iter().map(|value| value.map(|value| value.get())).collect()
        };
        let stated: Vec<Option<f64>> = of("profile_shifts", self.profile_shifts);
        let tips: Vec<Option<f64>> = of("tip_alterations", self.tip_alterations);
        let needs = |needs| DescriptionError::CentreDistanceAlone { set: set(), needs };
        let is_above_0 = |mesh: &ClosingMesh<'_>| mesh.distance.si() > 0.0;
        let lacks = [
            (!self.closing.iter().all(is_above_0), "must be above 0"),
            (!self.is_known, "needs the teeth of all gears, and gears that are not bevel"),
            (
                self.closing.iter().any(|mesh| !mesh.is_one),
                "is not one where planets mesh with each other: state it at `meshes` of a set in `compound_sets`",
            ),
            (
                self.closing.iter().any(|mesh| mesh.module.is_none_or(|module| module.si() <= 0.0)),
                "needs the module of each mesh: `module`, of planets with two gears `modules`",
            ),
        ];
        if let Some((_, why)) = lacks.into_iter().find(|one| one.0) {
            faults.push(at, needs(why));
            return None;
        }
        let rack = rack.filter(|_| is_sound)?;
        let place = |name: &String| self.gears.names.iter().position(|own| own == name);
        let is_ring = |gear: usize| self.gears.kinds[gear] == Some(GearKind::Internal);
        let mut helix_angles = vec![Angle::default(); count];
        let mut meshes = vec![];
        for mesh in &self.closing {
            // Names that no gear has are faults of the mesh itself.
            let [first, second] = [place(&mesh.gears[0])?, place(&mesh.gears[1])?];
            let gears = if is_ring(first) { [second, first] } else { [first, second] };
            gears.into_iter().for_each(|gear| helix_angles[gear] = mesh.helix_angle);
            let module = mesh.module.unwrap_or_default();
            meshes.push(StatedDistance { gears, distance: mesh.distance.si() / module.si() });
        }
        let gear = |gear: usize| {
            let profile = Profile { helix_angle: helix_angles[gear], ..Profile::of_rack(*rack) };
            let kind = self.gears.kinds[gear].unwrap_or(GearKind::External);
            InvoluteGear::searched(kind, ToothCount::new(self.teeth[gear])?, profile)
        };
        let gears = (0..count).map(gear).collect::<Result<Vec<_>, _>>();
        let gears = faults.keep(at, gears.map_err(|source| DescriptionError::of_set(self.set, source)))?;
        match closing_shifts(&gears, &stated, &meshes) {
            Ok(profile) => {
                let follows = (0..count).filter(|gear| stated[*gear].is_none() && profile[*gear] != 0.0);
                for gear in follows {
                    let shift = profile[gear];
                    let at = self.closing.iter().zip(&meshes).find(|(_, mesh)| mesh.gears.contains(&gear));
                    if shift.abs() > MOST_SHIFT || gears[gear].with_shift(shift).is_err() {
                        let (set, gear) = (set(), self.gears.names[gear].clone());
                        let fault = DescriptionError::ShiftFollows { set, gear, shift };
                        faults.push(at.map_or(&self.closing[0].at, |(mesh, _)| &mesh.at).clone(), fault);
                        return None;
                    }
                }
                let tips = self.tip_alterations.is_some().then_some(tips);
                let tips = tips.map(|tips| tips.into_iter().map(Option::unwrap_or_default).collect());
                Some(Shifts { profile, tips })
            }
            Err(why) => {
                let (Unclosed::Open { mesh, .. }
                | Unclosed::Fixed { mesh, .. }
                | Unclosed::Refused { mesh, .. }) = why;
                let ClosingMesh { gears, at, module, .. } = &self.closing[mesh];
                let (set, gears) = (set(), <[String; 2]>::clone(gears));
                let fault = match why {
                    Unclosed::Refused {
                        error: Error::NotAbove { quantity: Named::CentreDistance, low, .. },
                        ..
                    } => DescriptionError::TooNear { set, gears, least: low * module.unwrap_or_default() },
                    Unclosed::Refused { error, .. } => DescriptionError::of_set(&set, error),
                    Unclosed::Open { sum, .. } => DescriptionError::ShiftsOpen { set, gears, sum },
                    Unclosed::Fixed { sum, required, .. } => {
                        DescriptionError::ShiftsFixed { set, gears: gears.join(" and "), sum, required }
                    }
                };
                faults.push(at.clone(), fault);
                None
            }
        }
    }

    fn checked_angles(&self, faults: &mut Faults) -> Vec<Angle> {
        let mut seen: Vec<&Path> = vec![];
        let mut is_whole = true;
        for (angle, at) in &self.helix_angles {
            let profile = Profile { helix_angle: angle.abs(), ..Profile::default() };
            if let Err(mut source) = profile.check() {
                if let Error::OutOfRange { value, low, high, .. } = &mut source {
                    // Below 0 the hands are reversed.
                    (*value, *low) = (angle.degrees(), -*high);
                }
                is_whole = false;
                if !seen.contains(&at) {
                    seen.push(at);
                    faults.push(at.clone(), DescriptionError::of_set(self.set, source));
                }
            }
        }
        let is_helical = self.helix_angles.iter().any(|(angle, _)| angle.si() != 0.0);
        if is_whole && is_helical { self.helix_angles.iter().map(|one| one.0).collect() } else { vec![] }
    }

    fn cutting(&self, rack: Option<&BasicRack>, faults: &mut Faults) -> Option<Vec<Cutting>> {
        let shaper = self.strength.and_then(|strength| strength.shaper.as_ref());
        if self.tools.is_empty() && shaper.is_none() {
            return None;
        }
        // Bevel gears have no tools here.
        let is_cut = |name: &String| {
            let gears = self.gears.names.iter().zip(&self.gears.kinds);
            gears.into_iter().any(|(gear, kind)| gear == name && kind.is_some())
        };
        for gear in self.tools.keys().filter(|name| !is_cut(name)) {
            let unknown = self.gears.unknown(self.set, "tools", gear);
            faults.push(Path::root().key("tools").key(gear), unknown);
        }
        let of_shaper = || Path::root().key("strength").key("shaper");
        let mut refuse = |way: Path, source: ToolMisfit| {
            let at = way.first_of(source.keys());
            faults.push(at, DescriptionError::Tools { set: self.set.to_owned(), source });
        };
        let mut all = vec![];
        for (name, kind) in self.gears.names.iter().zip(&self.gears.kinds) {
            let Some(kind) = *kind else { continue };
            let (own, way) = (self.tools.get(name), Path::root().key("tools").key(name));
            let shaper = shaper.filter(|_| kind == GearKind::Internal);
            let made = match (shaper, own) {
                (Some(shaper), None) => shaper
                    .cutting()
                    .map_err(|why| refuse(of_shaper(), why.into()))
                    .map(|own| (own, of_shaper())),
                (_, None) => Ok((Cutting::default(), way)),
                (_, Some(own)) => own.cutting(kind).map_err(|why| refuse(way.clone(), why)).map(|cutting| {
                    // The corners of the shaper are the fillet of the standard's rack, whatever cuts the
                    // teeth.
                    let fillet = shaper.and_then(|shaper| shaper.fillet).map(Number::get);
                    let way = if fillet.is_some() && cutting.fillet.is_none() { of_shaper() } else { way };
                    (Cutting { fillet: fillet.or(cutting.fillet), ..cutting }, way)
                }),
            };
            all.push(made.map(|(cutting, way)| (cutting, way, kind)));
        }
        let all = all.into_iter().collect::<Result<Vec<_>, ()>>().ok()?;
        let angle = self.helix_angles.first().map_or_else(Angle::default, |one| one.0.abs());
        let profile = Profile { helix_angle: angle, ..Profile::of_rack(*rack?) };
        let mut is_whole = true;
        for (cutting, way, kind) in &all {
            let check = cutting.of(profile).check();
            let check = check.and_then(|()| cutting.tool.map_or(Ok(()), |tool| tool.check(*kind)));
            if let Err(source) = check {
                is_whole = false;
                refuse(way.clone(), source.into());
            }
        }
        is_whole.then(|| all.into_iter().map(|one| one.0).collect())
    }
}

/// A mesh with its stated module.
pub(super) struct Stated<'m> {
    /// Names of the gears.
    pub(super) gears: &'m [String; 2],
    pub(super) module: Length,
    /// Path of the key.
    pub(super) at: Path,
}

/// Adds gears whose meshes state different modules, at the later mesh.
pub(super) fn one_module(set: &str, meshes: &[Stated<'_>], faults: &mut Faults) {
    for (place, Stated { gears, module: second, at }) in meshes.iter().enumerate() {
        for Stated { gears: others, module: first, .. } in &meshes[..place] {
            let Some(gear) = gears.iter().find(|gear| others.contains(gear)).filter(|_| first != second)
            else {
                continue;
            };
            let (set, gear, first, second) = (set.to_owned(), gear.clone(), *first, *second);
            faults.push(at.clone(), DescriptionError::TwoModules { set, gear, first, second });
            break;
        }
    }
}

/// Missing data of teeth in mesh, in words; `None` of refused teeth and sets, whose faults are reported
/// themselves.
pub(super) fn missing(why: &Untoothed) -> Option<String> {
    match why {
        Untoothed::Refused(_) | Untoothed::NoSet => None,
        why => Some(why.to_string()),
    }
}
