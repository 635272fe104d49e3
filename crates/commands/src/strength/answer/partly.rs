//! Results of the rated meshes of a set, and the reasons of the others.

use super::place::Fault;
use super::rated_set::{RatedMesh, RatedSet};
use super::records::NotRated;

/// Results of a set, and the parts of it that are not rated.
pub(crate) struct Partly<T> {
    pub(crate) rated: Vec<T>,
    pub(crate) not_rated: Vec<NotRated>,
}

impl<T> Partly<T> {
    /// Rates the meshes independently: if one cannot be rated, the others are kept.
    ///
    /// # Errors
    /// [`Fault::Refused`], and [`Fault::Row`] if no mesh can be rated for one reason.
    pub(crate) fn of_meshes(
        set: &RatedSet<'_>,
        mut rate: impl FnMut(usize, &RatedMesh) -> Result<(Vec<T>, Vec<NotRated>), Fault>,
    ) -> Result<Self, Fault> {
        let mut all = Self { rated: vec![], not_rated: vec![] };
        for (place, mesh) in set.meshes.iter().enumerate() {
            match rate(place, mesh) {
                Ok((rated, not_rated)) => {
                    all.rated.extend(rated);
                    all.not_rated.extend(not_rated);
                }
                Err(Fault::Row(row)) => all.not_rated.push(row.of_mesh(&mesh.name)),
                Err(fault) => return Err(fault),
            }
        }
        let of_set = |row: &NotRated| NotRated { mesh: None, ..row.clone() };
        let is_one_reason = all.not_rated.iter().all(|row| of_set(row) == of_set(&all.not_rated[0]));
        if all.rated.is_empty() && all.not_rated.len() == set.meshes.len() && is_one_reason {
            return Err(Fault::Row(of_set(&all.not_rated[0]).into()));
        }
        Ok(all)
    }
}
