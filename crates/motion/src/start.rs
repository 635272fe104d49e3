//! Speeds and twists at the start.

use crate::Error;
use crate::mechanism::Mechanism;
use crate::shaft::Joint;
use crate::tolerance::{PIVOT, RANK, SLIP};
use epicyclic_numerics::linear::{Matrix, Triangles, independent};
use epicyclic_numerics::values::{dot, largest_absolute};
use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularVelocity};

/// Speeds of links from which those of all others follow, and twists of shafts.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Start {
    speeds: Vec<(String, f64)>,
    twists: Vec<(String, f64)>,
    together: Vec<[String; 2]>,
    is_at_rest: bool,
}

impl Start {
    /// Everything at rest.
    #[must_use]
    pub fn at_rest() -> Self {
        Self { is_at_rest: true, ..Self::default() }
    }

    /// Start with these links at these speeds.
    #[must_use]
    pub fn speeds(speeds: &[(&str, AngularVelocity)]) -> Self {
        let speeds = speeds.iter().map(|(link, speed)| ((*link).to_owned(), speed.si())).collect();
        Self { speeds, ..Self::default() }
    }

    /// Returns the start with these shafts twisted; the others are in the middle of their backlash, without
    /// torque.
    #[must_use]
    pub fn twisted(mut self, twists: &[(&str, Angle)]) -> Self {
        self.twists.extend(twists.iter().map(|(shaft, twist)| ((*shaft).to_owned(), twist.si())));
        self
    }

    /// Returns the start with the first link of each pair at the speed of the second.
    #[must_use]
    pub fn together(mut self, pairs: &[[&str; 2]]) -> Self {
        self.together.extend(pairs.iter().map(|pair| pair.map(ToOwned::to_owned)));
        self
    }

    /// Twists of the shafts, in this order.
    pub(crate) fn twists(&self, shafts: &[Joint]) -> Result<Vec<f64>, Error> {
        let mut found = vec![0.0; shafts.len()];
        for (name, twist) in &self.twists {
            let unknown = || Error::Unknown { what: "shaft", name: name.clone() };
            let place = shafts.iter().position(|one| one.name == *name).ok_or_else(unknown)?;
            found[place] = crate::course::finite(&format!("the initial twist of {name} in rad"), *twist)?;
        }
        Ok(found)
    }

    /// Speeds of the coordinates.
    pub(crate) fn coordinates(&self, mechanism: &Mechanism) -> Result<Vec<f64>, Error> {
        let n = mechanism.freedoms();
        if self.is_at_rest {
            return Ok(vec![0.0; n]);
        }
        let mut rows = vec![];
        let mut due: Vec<(&str, f64)> = vec![];
        for (link, speed) in &self.speeds {
            crate::course::finite(&format!("the initial speed of {link} in rad/s"), *speed)?;
            rows.push(mechanism.speed_factors(link)?);
            due.push((link, *speed));
        }
        for [link, other] in &self.together {
            let (one, other) = (mechanism.speed_factors(link)?, mechanism.speed_factors(other)?);
            rows.push(one.iter().zip(&other).map(|(one, other)| one - other).collect());
            due.push((link, 0.0));
        }
        let found = independent(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>(), RANK);
        if found.kept.len() < n {
            // The first coordinate that the rows do not tell.
            let unit = |place: usize| (0..n).map(|one| f64::from(u8::from(one == place))).collect::<Vec<_>>();
            let open = (0..n).find(|&place| {
                let mut more: Vec<&[f64]> = rows.iter().map(Vec::as_slice).collect();
                let unit = unit(place);
                more.push(&unit);
                independent(&more, RANK).kept.len() > found.kept.len()
            });
            let node = mechanism.coordinates[open.unwrap_or(0)];
            return Err(Error::InitialOpen { link: mechanism.node_name(node).to_owned() });
        }
        let mut system = Matrix::zeros(n, n);
        for (place, &row) in found.kept.iter().enumerate() {
            system.row_mut(place).copy_from_slice(&rows[row]);
        }
        let right: Vec<f64> = found.kept.iter().map(|&row| due[row].1).collect();
        let solved =
            Triangles::new(system, PIVOT).map(|triangles| triangles.solution(&right)).unwrap_or_default();
        let scale = largest_absolute(&right);
        for ((link, given), row) in due.iter().zip(&rows) {
            let speed = dot(row, &solved);
            if (speed - given).abs() > SLIP * scale.max(given.abs()) {
                return Err(Error::InitialSpeeds { link: (*link).to_owned(), given: *given, found: speed });
            }
        }
        Ok(solved)
    }
}
