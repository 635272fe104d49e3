//! Reasons why a gearbox cannot be drawn in the half-plane without a link across another.

use epicyclic_layout::{Element as Part, Witness};
use epicyclic_train::{self as train, Gearbox, LinkId};
use schemars::JsonSchema;
use serde::Serialize;

/// Elements of a gearbox that cannot be drawn together; without any one of them the others can.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Conflict {
    /// Elements that cannot be drawn together.
    pub elements: Vec<Element>,
    /// Links that are enclosed; empty if no single link is, but links cross one another.
    pub shut_in: Vec<String>,
    /// Destination that the enclosed links cannot reach; null if no link is enclosed.
    pub cannot_reach: Option<Reach>,
    /// Links that enclose them.
    pub shut_in_by: Vec<String>,
}

/// Element of a drawing.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Element {
    /// Kind of the element.
    pub kind: ElementKind,
    /// Name of the set, shift element or link.
    pub name: String,
}

/// Kinds of elements of a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ElementKind {
    /// Planetary set.
    Set,
    /// A brake.
    Brake,
    /// A clutch.
    Clutch,
    /// A link.
    Link,
    /// Shaft from the input link to the outside.
    Input,
    /// Shaft from the output link to the outside.
    Output,
    /// Connection to the outside of a link where power enters or leaves in some gears only.
    TakeOff,
}

/// Destinations that a link cannot reach.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reach {
    /// Housing of the gearbox.
    Housing,
    /// Outside, on its own side of the gearbox.
    Outside,
    /// Other one of two links.
    EachOther,
}

impl Conflict {
    /// Explains which links cannot reach which destination.
    ///
    /// The elements of a witness can be drawn together as soon as one is left out. Without a brake, for
    /// example, all others can be drawn, but in none of these drawings can its link reach the housing: the
    /// other links enclose it. A direct-drive clutch that the gearbox itself does not have is not named.
    #[must_use]
    pub fn of(gearbox: &Gearbox, witness: &Witness) -> Self {
        let name = |link: LinkId| gearbox.link_name(link).to_owned();
        let (inside, cannot_reach) = shut_in(gearbox, &witness.elements);
        let around = |element: &Part| match element {
            Part::Link(link) if !inside.contains(link) => Some(name(*link)),
            _ => None,
        };
        Self {
            elements: witness.elements.iter().filter_map(|element| Element::of(gearbox, *element)).collect(),
            shut_in_by: if cannot_reach.is_some() {
                witness.elements.iter().filter_map(around).collect()
            } else {
                vec![]
            },
            shut_in: inside.into_iter().map(name).collect(),
            cannot_reach,
        }
    }
}

/// Enclosed links, and the destination that they cannot reach.
fn shut_in(gearbox: &Gearbox, elements: &[Part]) -> (Vec<LinkId>, Option<Reach>) {
    let shift_element = |place: usize| gearbox.shift_elements().get(place);
    let is_brake = |element: &&Part| matches!(element, Part::ShiftElement(place) if shift_element(*place).is_some_and(train::ShiftElement::is_brake));
    let is_shift_element = |element: &&Part| matches!(element, Part::ShiftElement(_));
    let is_shaft = |element: &&Part| matches!(element, Part::TakeOff(_) | Part::Input | Part::Output);
    let find = |is: &dyn Fn(&&Part) -> bool| elements.iter().find(is);
    let missed = find(&is_brake).or_else(|| find(&is_shift_element)).or_else(|| find(&is_shaft));
    match missed {
        Some(&Part::ShiftElement(place)) => match shift_element(place).map(train::ShiftElement::links) {
            Some([link, LinkId::GROUND]) => (vec![link], Some(Reach::Housing)),
            Some(links) => (links.to_vec(), Some(Reach::EachOther)),
            None => (vec![], None),
        },
        Some(&Part::TakeOff(link)) => (vec![link], Some(Reach::Housing)),
        Some(Part::Input) => (vec![gearbox.input()], Some(Reach::Outside)),
        Some(Part::Output) => (vec![gearbox.output()], Some(Reach::Outside)),
        _ => (vec![], None),
    }
}

impl Element {
    fn of(gearbox: &Gearbox, element: Part) -> Option<Self> {
        let link = |link: LinkId| gearbox.link_name(link).to_owned();
        let (kind, name) = match element {
            Part::Set(set) => {
                (ElementKind::Set, gearbox.sets()[gearbox.drawn_sets()[set].set].id().to_owned())
            }
            Part::ShiftElement(place) => {
                let element = gearbox.shift_elements().get(place)?;
                let kind = if element.is_brake() { ElementKind::Brake } else { ElementKind::Clutch };
                (kind, element.id().to_owned())
            }
            Part::Link(id) => (ElementKind::Link, link(id)),
            Part::Input => (ElementKind::Input, link(gearbox.input())),
            Part::Output => (ElementKind::Output, link(gearbox.output())),
            Part::TakeOff(id) => (ElementKind::TakeOff, link(id)),
        };
        Some(Self { kind, name })
    }
}
