//! Whether a gearbox is among what was found.

use epicyclic_synthesis::Structure;
use epicyclic_synthesis::motion::Element;
use epicyclic_synthesis::run::Found;

/// Whether a structure with these elements is among what was found; an automorphism may have given another
/// set of the same solution.
pub(crate) fn holds(found: &[Found], structure: &Structure, wanted: &[Element]) -> bool {
    found.iter().filter(|found| found.structure == *structure).any(|found| {
        structure.automorphisms().iter().any(|order| {
            let names = structure.renaming(order);
            wanted.iter().all(|pair| {
                let mut image = pair.map(|link| names[usize::from(link)]);
                image.sort_unstable();
                found.solution.elements.iter().any(|pairs| pairs.contains(&image))
            })
        })
    })
}
