//! Drawability of a solution, and the choice among equivalent elements.

use crate::error::Error;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_layout::is_drawable;
use epicyclic_synthesis::gearbox::gearbox;
use epicyclic_synthesis::motion::Element;
use epicyclic_synthesis::rules::Rules;
use epicyclic_synthesis::run::Found;

/// Chooses among the equivalent link pairs of each element one with which the gearbox is drawable and keeps
/// the numbers of brakes and clutches. Returns whether there is such a choice; all choices are tried,
/// beginning with the first of each element.
///
/// Drawability is that of [`epicyclic_layout`]: links nested without one across another, each brake's link
/// reaching the housing. It does not depend on the ring-to-sun ratios or on which elements a gear engages, so
/// nothing is lost by it.
///
/// # Errors
/// Those of the solver.
pub(super) fn choose(found: &mut Found, rules: &Rules) -> Result<bool, Error> {
    let elements = &found.solution.elements;
    let count: usize = elements.iter().map(Vec::len).product();
    for code in 0..count {
        let mut rest = code;
        let places: Vec<usize> = elements
            .iter()
            .map(|pairs| {
                let place = rest % pairs.len();
                rest /= pairs.len();
                place
            })
            .collect();
        let chosen: Vec<Element> = elements.iter().zip(&places).map(|(pairs, place)| pairs[*place]).collect();
        let brakes = chosen.iter().filter(|pair| pair[0] == 0).count();
        if !rules.brakes.contains(&brakes) || !rules.clutches.contains(&(chosen.len() - brakes)) {
            continue;
        }
        let built = gearbox(&found.structure, &found.solution.k, MeshEfficiency::IDEAL, &chosen, &[])?;
        if is_drawable(&built) {
            for (pairs, place) in found.solution.elements.iter_mut().zip(places) {
                pairs[..=place].rotate_right(1);
            }
            return Ok(true);
        }
    }
    Ok(false)
}
