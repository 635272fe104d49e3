//! A structure with elements and ring-to-sun ratios as a gearbox of the solver.

use crate::motion::Element;
pub use crate::names::{real_k, solver_name};
use crate::sharing::Sharing;
use crate::structure::{HOUSING, INPUT, Link, OUTPUT, Structure, link_name, link_of_name};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::Gearbox;
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};

/// The name of an element: the links that it joins, a brake by its link alone.
#[must_use]
pub fn element_name(element: Element) -> String {
    match element {
        [HOUSING, link] => link_name(link).to_string(),
        [one, other] => format!("{}-{}", link_name(one), link_name(other)),
    }
}

/// Names of the elements of a gearbox, side by side: its brakes are `B1`, `B2`, …, its clutches `C1`, `C2`,
/// …, each in their order.
#[must_use]
pub fn own_names(elements: &[Element]) -> Vec<String> {
    let [mut brakes, mut clutches] = [0, 0];
    let name = |element: &Element| {
        let (letter, count) = if element[0] == HOUSING { ('B', &mut brakes) } else { ('C', &mut clutches) };
        *count += 1;
        format!("{letter}{count}")
    };
    elements.iter().map(name).collect()
}

/// The element with a name, as [`element_name`] gives it.
#[must_use]
pub fn element_of_name(name: &str) -> Option<Element> {
    let mut links = name.split('-').map(|name| {
        let mut characters = name.chars();
        characters.next().filter(|_| characters.next().is_none()).and_then(link_of_name)
    });
    match (links.next()?, links.next(), links.next()) {
        (Some(link), None, None) => Some([HOUSING, link]),
        (Some(one), Some(Some(other)), None) => Some([one, other]),
        _ => None,
    }
    .filter(|[one, other]| one < other)
}

/// The gearbox with these elements and this efficiency of a simple set's two meshes together, by the gears
/// that each engages some of them (by their places). The three meshes of a double-planet set lose as much
/// each: `η^(3/2)` together. Sets that share planets at these `k` ([`Sharing`]) are one compound set, whose
/// meshes lose as much each, too.
///
/// # Errors
/// Those of the solver: `k` not above 1, a gear that engages no element or one that is not there.
pub fn gearbox(
    structure: &Structure,
    k: &[f64],
    mesh_efficiency: MeshEfficiency,
    elements: &[Element],
    gears: &[Vec<usize>],
) -> Result<Gearbox, epicyclic_train::Error> {
    let links = (1..=structure.links()).filter_map(|link| Some(solver_name(Link::try_from(link).ok()?)));
    let each = MeshEfficiency::new(mesh_efficiency.get().sqrt()).unwrap_or(mesh_efficiency);
    let mut builder = Gearbox::builder(&structure.to_string()).links(links);
    let sharing = Sharing::of(structure, k);
    for (place, one) in k.iter().enumerate() {
        if let Some(compound) = sharing.compound_of(place) {
            if compound.sets[0] == place {
                builder = builder.compound_set(compound.spec(structure, k, each));
            }
            continue;
        }
        let names = structure.members(place).map(solver_name);
        let (kind, loss) = if structure.is_double_planet(place) {
            (SetKind::DoublePlanet, MeshLoss::Meshes { first: each, between: each, second: each })
        } else {
            (SetKind::Simple, MeshLoss::Set(mesh_efficiency))
        };
        let (name, members) = ((place + 1).to_string(), names.each_ref().map(String::as_str));
        builder =
            builder.set(SetSpec::new(&name, kind, members, real_k(structure, place, *one)).with_loss(loss));
    }
    let names = own_names(elements);
    for (element, name) in elements.iter().zip(&names) {
        builder = match *element {
            [HOUSING, link] => builder.brake(name, &solver_name(link)),
            [one, other] => builder.clutch(name, &solver_name(one), &solver_name(other)),
        };
    }
    builder = builder.input(&solver_name(INPUT)).output(&solver_name(OUTPUT));
    for (place, engaged) in gears.iter().enumerate() {
        let engaged = engaged.iter().map(|element| names[*element].clone());
        builder = builder.gear(&(place + 1).to_string(), engaged);
    }
    builder.build()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::elements;

    #[test]
    fn three_meshes_lose_as_much_each_as_two() {
        let structure: Structure = "1-a-2 b-2-1*".parse().unwrap();
        let eta = MeshEfficiency::new(0.97).unwrap();
        let gearbox = gearbox(&structure, &[2.0, 2.0], eta, &[[0, 3], [0, 4]], &[vec![0], vec![1]]).unwrap();
        for (set, meshes) in gearbox.sets().iter().zip([2, 3]) {
            let product: f64 = set.meshes().iter().map(|mesh| mesh.efficiency.get()).product();
            assert_eq!(set.meshes().len(), meshes);
            assert!(
                (product - libm::pow(0.97f64, f64::from(u8::try_from(meshes).unwrap()) / 2.0)).abs() < 1e-15
            );
        }
    }

    #[test]
    fn brakes_and_clutches_are_numbered_apart() {
        assert_eq!(own_names(&[[0, 3], [2, 4], [0, 4], [1, 3]]), ["B1", "C1", "B2", "C2"]);
    }

    #[test]
    fn every_element_is_known_by_its_name() {
        for element in elements(crate::class::MOST_LINKS) {
            assert_eq!(element_of_name(&element_name(element)), Some(element));
        }
        for name in ["", "-", "a-", "a-b-c", "ab", "b-a", "a-a", "A", "0", "1-é"] {
            assert_eq!(element_of_name(name), None, "{name}");
        }
    }
}
