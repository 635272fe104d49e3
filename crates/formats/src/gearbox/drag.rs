//! Losses that do not depend on the load in a gearbox file: curves of drag torques.

use super::GearboxFile;
use crate::Path;
use crate::faults::Faults;
use epicyclic_train::drag::{Beyond, Drag, DragCurve};
use epicyclic_train::error::DragFault;
use epicyclic_train::tolerance::MOST_DRAGS;
use epicyclic_train::{Error, Gearbox, Named};
use epicyclic_units::Quantity;
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeSet;
use uom::si::f64::{AngularVelocity, Torque};

/// A drag between two links: of a seal, of bearings, of parts that churn oil.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DragEntry {
    /// Name of the drag.
    pub id: String,
    /// The links; `ground` is the housing.
    pub between: [String; 2],
    /// Drag torque over the relative speed of the links.
    pub curve: DragCurveEntry,
}

/// A torque over a relative speed, linear between its points.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DragCurveEntry {
    /// Relative speeds, ascending.
    pub speeds: Vec<Quantity<AngularVelocity>>,
    /// The torque at each, at least 0; it opposes the motion.
    pub torques: Vec<Quantity<Torque>>,
    /// Torque outside these speeds. Default: a speed there is refused.
    #[serde(default)]
    pub beyond: BeyondEntry,
}

/// Torque outside the speeds of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BeyondEntry {
    /// Nothing: such a speed is refused.
    #[default]
    Refused,
    /// The torque of the nearest point.
    Constant,
}

impl DragCurveEntry {
    fn curve(&self) -> Result<DragCurve, DragFault> {
        let (speeds, torques) = (self.speeds.len(), self.torques.len());
        if speeds != torques {
            return Err(DragFault::Lengths { speeds, torques });
        }
        let points: Vec<(AngularVelocity, Torque)> =
            self.speeds.iter().zip(&self.torques).map(|(speed, torque)| (speed.0, torque.0)).collect();
        let beyond = match self.beyond {
            BeyondEntry::Refused => Beyond::Refused,
            BeyondEntry::Constant => Beyond::Constant,
        };
        DragCurve::new(&points, beyond)
    }
}

impl GearboxFile {
    /// The drags of the file: first those of `drags`, then those of brakes and of clutches.
    ///
    /// # Errors
    /// [`epicyclic_train::Error::Drag`] for a curve that is none, [`epicyclic_train::Error::Unknown`] for a
    /// link, and [`epicyclic_train::Error::Duplicate`] for a name that stands twice.
    pub fn drags(&self, gearbox: &Gearbox) -> Result<Vec<Drag>, Faults> {
        let (mut all, mut faults) = (vec![], Faults::default());
        let curves = self.curves(&mut faults);
        for (place, ((id, ..), curve)) in self.drag_entries().zip(curves).enumerate() {
            let Some(DragEntry { between, .. }) = self.drags.get(place) else {
                all.extend(curve.and_then(|curve| gearbox.drag_of_shift_element(id, curve).ok()));
                continue;
            };
            let at = Path::root().key("drags").index(place).key("between");
            match (gearbox.drag_links(id, between.each_ref().map(String::as_str)), curve) {
                (Ok(links), Some(curve)) => {
                    all.push(Drag { name: id.clone(), links, curve, shift_element: None });
                }
                (Ok(_), None) => {}
                (Err(refused), _) => {
                    refused.into_iter().for_each(|(end, error)| faults.push(at.clone().indexed(end), error));
                }
            }
        }
        faults.or(all)
    }

    /// Paths of the curves of the [`drags`](Self::drags), in their order.
    #[must_use]
    pub fn drag_paths(&self) -> Vec<Path> {
        self.drag_entries().map(|(_, path, _)| path).collect()
    }

    /// Names, paths and curves of the drags.
    fn drag_entries(&self) -> impl Iterator<Item = (&String, Path, &DragCurveEntry)> {
        let path = |list: &str, place, key: &str| Path::root().key(list).index(place).key(key);
        let drags = self.drags.iter().enumerate();
        let drags = drags.map(move |(place, one)| (&one.id, path("drags", place, "curve"), &one.curve));
        let brakes = self.brakes.iter().enumerate();
        let brakes = brakes.filter_map(move |(place, one)| {
            Some((&one.id, path("brakes", place, "drag"), one.drag.as_ref()?))
        });
        let clutches = self.clutches.iter().enumerate();
        let clutches = clutches.filter_map(move |(place, one)| {
            Some((&one.id, path("clutches", place, "drag"), one.drag.as_ref()?))
        });
        drags.chain(brakes).chain(clutches)
    }

    /// Curves of the drags; checks names and curves, for which no gearbox is needed.
    pub(super) fn curves(&self, faults: &mut Faults) -> Vec<Option<DragCurve>> {
        let count = self.drags.len();
        if count > MOST_DRAGS {
            let error = Error::TooMany { what: Named::Drag, count, limit: MOST_DRAGS };
            faults.push(Path::root().key("drags").index(MOST_DRAGS), error);
            return vec![];
        }
        // A drag has no other name than that of an open shift element, which has a drag, too.
        let of_elements = self.drag_entries().skip(count).map(|(id, ..)| id);
        let mut seen: BTreeSet<&String> = of_elements.collect();
        for (place, DragEntry { id, .. }) in self.drags.iter().enumerate() {
            if !seen.insert(id) {
                let error = Error::Duplicate { what: Named::Drag, name: id.clone() };
                faults.push(Path::root().key("drags").index(place), error);
            }
        }
        let curve = |(id, path, entry): (&String, Path, &DragCurveEntry)| {
            entry.curve().map_err(|fault| {
                let at = match fault {
                    DragFault::Speed { place, .. } | DragFault::NotAscending { place } => {
                        path.key("speeds").index(place)
                    }
                    DragFault::Torque { place, .. } => path.key("torques").index(place),
                    _ => path,
                };
                faults.push(at, Error::Drag { drag: id.clone(), fault });
            })
        };
        self.drag_entries().map(curve).map(Result::ok).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Document;

    const BOX: &str = "\
gearbox: I
input: D
output: B
sets: [{ id: P, sun: D, ring: T1, carrier: B, k: 3 }]
brakes: [{ id: K1, link: T1, drag: { speeds: [0 rpm, 100 rpm], torques: [1 N·m, 2 N·m] } }]
clutches: [{ id: K2, links: [D, B], drag: { speeds: [0 rpm], torques: [3 N·m], beyond: constant } }]
drags:
  - id: seal
    between: [D, ground]
    curve: { speeds: [0 rpm, 3000 rpm], torques: [1 N·m, 2 N·m] }
gears: [{ name: slow, engaged: [K1] }, { name: fast, engaged: [K2] }]
";

    fn read(text: &str) -> Result<Vec<Drag>, String> {
        let document = Document::parse_one("box.yaml", text.as_bytes()).map_err(|error| error.to_string())?;
        let file: GearboxFile = document.read().map_err(|error| error.to_string())?;
        let drags = file.gearbox().and_then(|gearbox| file.drags(&gearbox));
        drags.map_err(|faults| faults.placed(&document, &Path::root()).to_string())
    }

    #[test]
    fn drags_are_of_the_gearbox_and_of_shift_elements() {
        let drags = read(BOX).unwrap();
        let names: Vec<(&str, Option<usize>)> =
            drags.iter().map(|drag| (drag.name.as_str(), drag.shift_element)).collect();
        assert_eq!(names, [("seal", None), ("K1", Some(0)), ("K2", Some(1))]);
    }

    #[test]
    fn what_is_no_curve_is_told_with_its_place() {
        for (from, to, told) in [
            (
                "[0 rpm, 3000 rpm]",
                "[0 rpm, 0 rpm]",
                "box.yaml:10:30: drags[0].curve.speeds[1]: drag `seal`: speeds ascend",
            ),
            (
                "[0 rpm, 3000 rpm]",
                "[-5 rpm, 3000 rpm]",
                "box.yaml:10:23: drags[0].curve.speeds[0]: drag `seal`: a relative speed is finite and at least 0",
            ),
            (
                "[0 rpm, 3000 rpm]",
                "[0 rpm]",
                "box.yaml:10:12: drags[0].curve: drag `seal`: 1 speeds and 2 torques",
            ),
            (
                "torques: [1 N·m, 2 N·m] }\ngears",
                "torques: [1 N·m, -2 N·m] }\ngears",
                "box.yaml:10:58: drags[0].curve.torques[1]: drag `seal`: a torque is finite and at least 0",
            ),
            (
                "speeds: [0 rpm], torques: [3 N·m]",
                "speeds: [], torques: []",
                "box.yaml:6:43: clutches[0].drag: drag `K2`: a curve has at least one point",
            ),
            (
                "[D, ground]",
                "[E, ground]",
                "box.yaml:9:15: drags[0].between[0]: drag `seal` names the link `E`, which does not exist",
            ),
            (
                "[D, ground]",
                "[D, D]",
                "box.yaml:9:14: drags[0].between: drag `seal`: it stands between two links",
            ),
        ] {
            let refused = read(&BOX.replacen(from, to, 1)).unwrap_err();
            assert!(refused.starts_with(told), "{refused}\nnot\n{told}");
        }
        let twice = BOX.replace(
            "gears:",
            "  - { id: seal, between: [B, ground], curve: { speeds: [0 rpm], torques: [1 N·m] } }\ngears:",
        );
        assert!(read(&twice).unwrap_err().contains("two drags are called `seal`"));
    }
}
