//! Which link is shut in by which, where a gearbox crosses itself.

use epicyclic_layout::{Element, Witness};
use epicyclic_train::{Gearbox, LinkId};

/// What cannot reach what.
///
/// The elements of a witness can be drawn together as soon as one is left out. Left out a brake, say, all others are drawn, and in none of
/// these drawings does its link reach the housing: the other links shut it in.
pub(super) fn words(gearbox: &Gearbox, witness: &Witness) -> String {
    let name = |link: LinkId| format!("`{}`", gearbox.link_name(link));
    let shift_element = |place: usize| gearbox.shift_elements().get(place);
    let brakes = |place: &usize| shift_element(*place).is_some_and(epicyclic_train::ShiftElement::is_brake);
    let is_brake = |element: &&Element| matches!(element, Element::ShiftElement(place) if brakes(place));
    let is_shift_element = |element: &&Element| matches!(element, Element::ShiftElement(_));
    let is_shaft =
        |element: &&Element| matches!(element, Element::TakeOff(_) | Element::Input | Element::Output);
    let elements = &witness.elements;
    let missed = elements
        .iter()
        .find(is_brake)
        .or_else(|| elements.iter().find(is_shift_element))
        .or_else(|| elements.iter().find(is_shaft));
    let (inside, what) = match missed {
        Some(&Element::ShiftElement(place)) => match shift_element(place)
            .map(epicyclic_train::ShiftElement::links)
        {
            Some([link, LinkId::GROUND]) => (vec![link], format!("{} cannot reach the housing", name(link))),
            Some([one, other]) => (vec![one, other], format!("{} cannot reach {}", name(one), name(other))),
            None => (vec![], "a lock cannot be reached".into()),
        },
        Some(&Element::TakeOff(link)) => (vec![link], format!("{} cannot reach the housing", name(link))),
        Some(Element::Input) => (vec![gearbox.input()], format!("{} has no way out", name(gearbox.input()))),
        Some(Element::Output) => {
            (vec![gearbox.output()], format!("{} has no way out", name(gearbox.output())))
        }
        _ => (vec![], "its links run through one another".into()),
    };
    let around: Vec<String> = elements
        .iter()
        .filter_map(|element| match element {
            Element::Link(link) if !inside.contains(link) => Some(name(*link)),
            _ => None,
        })
        .collect();
    match (missed, &around[..]) {
        (None, _) | (_, []) => what,
        (_, [one]) => format!("{what}, shut in by {one}"),
        (_, [first @ .., last]) => format!("{what}, shut in by {} and {last}", first.join(", ")),
    }
}
