//! Places of the planets of a set on its carrier, for the phases of their meshes.

use crate::shared::number::short;
use crate::tolerance::{AT_POSITION, EQUAL_SPACING};
use epicyclic_train::PlanetSet;
use epicyclic_units::Physical;
use std::f64::consts::TAU;

/// Places of the planets.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spacing {
    /// Angles from `x` in rad; equally spaced planets begin at 0.
    pub(super) angles_rad: Vec<f64>,
    pub(super) is_equal: bool,
    /// Assembly position of each planet; empty for sets without tooth numbers, and for planets that cannot be
    /// assembled equally spaced.
    pub(super) places: Vec<u64>,
    /// Assembly positions in a turn; 0 without.
    pub(super) positions: u64,
    /// Whether the teeth let planets stand at these angles, as far as it is known.
    pub(super) fits: bool,
}

impl Spacing {
    /// The place of a pair.
    pub(super) fn alone() -> Self {
        Self { angles_rad: vec![0.0], is_equal: false, places: vec![], positions: 0, fits: true }
    }

    /// Places of the planets of a set; `None` if their number is unknown.
    ///
    /// # Errors
    /// Message about a planet that is at no assembly position.
    pub(super) fn of(set: &PlanetSet) -> Option<Result<Self, String>> {
        let angles_rad: Vec<f64> = set.planet_angles()?.into_iter().map(Physical::si).collect();
        if let Some(at) = set.misplaced().first() {
            let [given, nearest] = [at.angle, at.nearest].map(|angle| short(angle.si().to_degrees()));
            let (planet, positions) = (at.planet, at.positions);
            return Some(Err(format!(
                "planet {planet} at {given} deg from the first: its teeth fit at multiples of 360/{positions} deg, the nearest {nearest} deg"
            )));
        }
        let first = angles_rad.first().copied().unwrap_or_default();
        let turns: Vec<f64> =
            angles_rad.iter().map(|angle| ((angle - first) / TAU).rem_euclid(1.0)).collect();
        let place = |turn: &f64, positions: u64| {
            let place = turn * positions as f64;
            ((place - place.round()).abs() < AT_POSITION).then_some(place.round() as u64 % positions)
        };
        let positions = set.assembly_positions().filter(|positions| *positions > 0);
        let places: Vec<u64> = positions
            .and_then(|positions| turns.iter().map(|turn| place(turn, positions)).collect())
            .unwrap_or_default();
        let mut sorted = turns;
        sorted.sort_by(f64::total_cmp);
        let step = 1.0 / sorted.len() as f64;
        let is_equal =
            sorted.iter().enumerate().all(|(n, turn)| (turn - step * n as f64).abs() * TAU < EQUAL_SPACING);
        let fits = positions.is_none() || !places.is_empty();
        Some(Ok(Self { angles_rad, is_equal, places, positions: positions.unwrap_or_default(), fits }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_formats::Document;
    use epicyclic_formats::gearbox::GearboxFile;

    fn spacing(set: &str) -> Result<Spacing, String> {
        let text = format!(
            "gearbox: one\ninput: s\noutput: H\nsets: [{{ id: P, sun: s, ring: ground, carrier: H, {set} }}]\ngears: [{{ name: only }}]\n"
        );
        let file: GearboxFile = Document::parse_one("one.yaml", text.as_bytes()).unwrap().read().unwrap();
        let gearbox = file.gearbox().map_err(|error| error.to_string())?;
        Spacing::of(&gearbox.sets()[0]).unwrap()
    }

    #[test]
    fn planets_stand_where_the_teeth_let_them() {
        // 25 + 83 = 108 positions, 3.333…° apart.
        let with = |keys: &str| spacing(&format!("teeth: [25, 83], planet_teeth: [29], {keys}"));
        let at = |degrees: &str| with(&format!("planet_angles: [{degrees}]"));
        let equal = with("planets: 4").unwrap();
        assert_eq!((equal.places.as_slice(), equal.is_equal), (&[0, 27, 54, 81][..], true));
        let same = at("0 deg, 90 deg, 180 deg, 270 deg").unwrap();
        assert_eq!((same.places, same.is_equal), (equal.places, true));
        let pairs = at("0 deg, 86.67 deg, 180 deg, 266.67 deg").unwrap();
        assert_eq!((pairs.places.as_slice(), pairs.is_equal), (&[0, 26, 54, 80][..], false));
        assert!((pairs.angles_rad[1] - TAU * 26.0 / 108.0).abs() < 1e-12);
        let refused = at("0 deg, 88 deg, 180 deg, 270 deg").unwrap_err();
        assert!(refused.starts_with("planet 2 at 88 deg from the first"), "{refused}");
        let free = spacing("k: 3, planet_angles: [0 deg, 88 deg, 180 deg, 270 deg]").unwrap();
        assert!(free.places.is_empty() && !free.is_equal);
        // Five planets cannot be equally spaced on 108 positions.
        assert!(with("planets: 5").unwrap().places.is_empty());
        assert_eq!(with("planets: 5, spacing: least_unequal").unwrap().places, [0, 21, 43, 64, 86]);
    }
}
