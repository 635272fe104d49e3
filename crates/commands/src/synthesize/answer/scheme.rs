//! Scheme of the document that equals a solution.

use epicyclic_schemes::catalogue::{Role, Scheme};
use epicyclic_synthesis::run::Found;
use epicyclic_synthesis::structure::{HOUSING, INPUT, Link, Members, OUTPUT, Structure};

/// Finds the scheme of the catalogue that equals a solution. It has the same structure, a brake on each link
/// except input and output, and besides only one clutch for direct drive.
pub(super) fn of(found: &Found) -> Option<Scheme> {
    let structure = &found.structure;
    let scheme = Scheme::all().find(|scheme| structure_of(*scheme).as_ref() == Some(structure))?;
    let others = Link::try_from(structure.links()).ok()?;
    let is_braked = |link: Link| found.solution.elements.iter().any(|pairs| pairs.contains(&[HOUSING, link]));
    let braked = (OUTPUT + 1..=others).filter(|link| is_braked(*link)).count();
    let rest = found.solution.elements.len() - braked;
    (braked == usize::from(others - OUTPUT) && rest <= 1).then_some(scheme)
}

/// Structure of a scheme: D is the input, B the output, T₁ and T₂ are further links.
pub(super) fn structure_of(scheme: Scheme) -> Option<Structure> {
    let link = |role: Role| match role {
        Role::D => INPUT,
        Role::B => OUTPUT,
        Role::T1 => OUTPUT + 1,
        Role::T2 => OUTPUT + 2,
    };
    let sets: Vec<Members> = scheme.sets().into_iter().map(|set| set.map(link)).collect();
    Structure::new(&sets, sets.len() + 2).ok()
}
