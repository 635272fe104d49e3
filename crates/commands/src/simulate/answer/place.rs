//! Places of faults that the motion reports: in the scenario, or in the gearbox.

use super::parts::Scenario;
use super::{placed, root};
use crate::error::Error;
use crate::shared::fault::Fault;
use crate::shared::gearbox::Gearbox;
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::part_place;
use epicyclic_formats::scenario::ScenarioFile;
use epicyclic_motion as motion;
use epicyclic_units::Physical;

impl Scenario<'_> {
    /// Path of the first impossible inertia, mass or radius; `None` if all are possible.
    pub(super) fn no_mass(&self) -> Option<Path> {
        let is_none = |value: f64| !(value.is_finite() && value >= 0.0);
        let link = self.file.inertias.iter().find(|(_, inertia)| is_none(inertia.0.si()));
        let of_link = link.map(|(link, _)| root("inertias").key(link));
        let planets = self.file.planets.iter().enumerate().flat_map(|(place, entry)| {
            let of = move |one| root("planets").index(place).key("each").index(one);
            entry.each.iter().enumerate().flat_map(move |(one, planet)| {
                let values = [
                    ("mass", planet.mass.map(|mass| mass.0.si())),
                    ("inertia", Some(planet.inertia.0.si())),
                    ("radius", planet.radius.map(|radius| radius.0.si())),
                ];
                values.into_iter().filter_map(move |(key, value)| Some((of(one).key(key), value?)))
            })
        });
        of_link.or_else(|| planets.into_iter().find(|(_, value)| is_none(*value)).map(|(path, _)| path))
    }

    /// Path of the point out of order in a table of the scenario; for a table in a file, the path of its
    /// name.
    pub(super) fn of_points(&self, path: &Path, why: &motion::Error) -> Path {
        let motion::Error::Order { place, .. } = why else { return path.clone() };
        let key = ["times", "speeds"].into_iter().find(|key| self.has(&path.clone().key(*key)));
        self.point(path, key.unwrap_or_default(), place.saturating_sub(1))
    }

    pub(super) fn point(&self, path: &Path, key: &str, place: usize) -> Path {
        let paths = [path.clone().key(key).index(place), path.clone().key("csv")];
        paths.into_iter().find(|path| self.has(path)).unwrap_or_else(|| path.clone())
    }

    pub(super) fn has(&self, path: &Path) -> bool {
        self.document.value_at(path).is_some()
    }

    /// Error of the run with its place in the scenario or in the file of the gearbox.
    pub(super) fn of_run(&self, why: motion::Error) -> Error {
        use motion::Error as E;
        let here = |keys: &[&str]| {
            let all = [keys, &["gearbox_file", "gearbox"]].concat();
            all.into_iter().map(root).find(|path| self.has(path)).unwrap_or_default()
        };
        let path = match &why {
            E::InitialSpeeds { link, .. } | E::InitialOpen { link } => {
                let speed = root("start").key("speeds").key(link);
                if self.has(&speed) { speed } else { here(&["start"]) }
            }
            E::InitialSlip { .. } | E::Unknown { .. } => here(&["start"]),
            E::InitialDog { element, .. } => self.entry(element).unwrap_or_else(|| here(&["start"])),
            E::NoInertia { .. } => here(&["inertias"]),
            E::NoFreedom => here(&["engaged"]),
            E::TooManyAtRest { .. } => here(&["elements"]),
            E::StepTooShort { .. } | E::TooManySteps { .. } => here(&["duration"]),
            E::NoMotion { parts, .. } | E::Accumulating { parts, .. } => {
                return self.of_parts(parts, why.clone());
            }
            E::OnePiece { element, .. } => return self.of_parts(std::slice::from_ref(element), why.clone()),
            E::OpenSplit { elements, set, .. } => {
                let all: Vec<String> = elements.iter().chain([set]).cloned().collect();
                return self.of_parts(&all, why.clone());
            }
            E::NotUnique { sets, .. } => return self.of_parts(sets, why.clone()),
            E::Overdetermined { set } | E::PlanetSpeed { set, .. } => {
                return self.of_parts(std::slice::from_ref(set), why.clone());
            }
            E::Gearbox(error) => {
                let Gearbox { document, base, .. } = self.subject;
                let at = document.error(base, error.problem());
                return Error::Placed { at: Box::new(at), why: Box::new(why.into()) };
            }
            _ => here(&[]),
        };
        placed(self.document, &path, why)
    }

    /// Path of an element, load, shaft or converter in the scenario.
    fn entry(&self, id: &str) -> Option<Path> {
        let ScenarioFile { elements, torques, shafts, converters, .. } = self.file;
        let lists: [(&str, Option<usize>); 4] = [
            ("elements", elements.iter().position(|one| one.id == id)),
            ("torques", torques.iter().position(|one| one.id == id)),
            ("shafts", shafts.iter().position(|one| one.id == id)),
            ("converters", converters.iter().position(|one| one.id == id)),
        ];
        lists.into_iter().find_map(|(list, place)| Some(root(list).index(place?)))
    }

    /// Error at the first of these parts that the scenario contains, otherwise at the first in the gearbox.
    fn of_parts(&self, parts: &[String], why: motion::Error) -> Error {
        if let Some(path) = parts.iter().find_map(|part| self.entry(part)) {
            return placed(self.document, &path, why);
        }
        let Gearbox { document, base, .. } = self.subject;
        let place = |part: &String| part_place(document, base, part);
        let path = parts.iter().find_map(place).unwrap_or_else(|| base.clone());
        placed(document, &path, why)
    }
}
