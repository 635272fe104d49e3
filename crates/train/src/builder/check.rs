//! Checks of a description: all faults that do not follow from each other, each with its site.

use super::compound_parts::parts_of_compound;
use super::{GearSpec, GearboxBuilder};
use crate::compound::CentralKind;
use crate::error::{Place, Terminal};
use crate::gearbox::{Gear, ShiftElement};
use crate::groups::Groups;
use crate::planet_angles;
use crate::planet_set::{Central, Description, PlanetSet, parts_of_short};
use crate::set_kind::SetKind;
use crate::site::{GearPart, Located, SetFaults, SetPart, Site};
use crate::tolerance::{MOST_ALIKE, MOST_ELEMENTS, MOST_FAULTS, MOST_GEARS, MOST_LINKS, MOST_SETS, SPREAD};
use crate::{Error, GROUND, Gearbox, LinkId, Named, Warning};
use std::collections::BTreeSet;

impl GearboxBuilder {
    /// Checks the description like [`build`](Self::build), and returns all its faults with their sites.
    ///
    /// A fault that only follows from another one is left out: an entry with a fault still counts where
    /// others name it. Of a description above the limits of size nothing else is checked.
    ///
    /// # Errors
    /// The faults, at least one, in the order in which they were found.
    pub fn build_all(self) -> Result<Gearbox, Vec<Located>> {
        let mut faults = self.too_many();
        if !faults.is_empty() {
            return Err(faults);
        }
        faults.extend(self.duplicates());
        if self.sets.is_empty() {
            faults.push(Site::Gearbox.has(Error::NoSets));
        }
        let mut links = vec![GROUND.to_owned()];
        links.extend(self.links);
        let mut gearbox = Gearbox {
            name: self.name,
            links,
            sets: vec![],
            equations: vec![],
            segments: vec![],
            drawn: vec![],
            shift_elements: vec![],
            permanent: vec![],
            gears: vec![],
            input: LinkId::GROUND,
            output: LinkId::GROUND,
            warnings: vec![],
        };
        // What is refused below is replaced by the housing, and nothing is returned but the faults.
        let mut terminal = |name: Option<&str>, which| {
            let found = terminal(&gearbox, name, which);
            found.unwrap_or_else(|error| {
                faults.push(Site::Terminal(which).has(error));
                LinkId::GROUND
            })
        };
        let input = terminal(self.input.as_deref(), Terminal::Input);
        let output = terminal(self.output.as_deref(), Terminal::Output);
        (gearbox.input, gearbox.output) = (input, output);
        let mut groups = Groups::new(gearbox.links.len());
        for (number, [first, second]) in self.permanent.into_iter().enumerate() {
            let site = |end| Site::Connection(number, end);
            let place = || Place::Connection(number);
            let Some(pair) = pair(&gearbox, [&first, &second], place, site, &mut faults) else { continue };
            if !groups.join(pair[0].0, pair[1].0) {
                faults.push(site(None).has(Error::CyclicGrounds { number, first, second }));
            }
            gearbox.permanent.push(pair);
        }
        let mut is_whole = true;
        for (number, description) in self.sets.into_iter().enumerate() {
            match build_set(&gearbox, description, &groups) {
                Ok(set) => gearbox.push_set(set),
                Err(of_set) => {
                    is_whole = false;
                    faults.extend(of_set.into_iter().map(|(part, error)| Site::Set(number, part).has(error)));
                }
            }
        }
        let size = |ratio: f64| libm::log10(1.0 + ratio.abs().max(1.0 / ratio.abs()));
        let exponent: f64 = gearbox.equations.iter().map(|one| size(one.ratio)).sum();
        if is_whole && exponent > libm::log10(SPREAD) {
            faults.push(Site::Gearbox.has(Error::Spread { exponent }));
        }
        for (number, (id, [first, second], one_way)) in self.shift_elements.into_iter().enumerate() {
            let site = |end| Site::ShiftElement(number, end);
            let place = || Place::ShiftElement(id.clone());
            let links = pair(&gearbox, [&first, &second], place, site, &mut faults);
            if links.is_some_and(|links| links[0] == links[1]) {
                let shift_element = id.clone();
                faults.push(site(None).has(Error::ShiftElementJoinsItself { shift_element, link: first }));
            }
            let mut links = links.unwrap_or([LinkId::GROUND; 2]);
            // The order of a one-way clutch is its direction.
            if links[0] == LinkId::GROUND && !one_way {
                links.swap(0, 1);
            }
            gearbox.shift_elements.push(ShiftElement { id, links, one_way });
        }
        for (number, spec) in self.gears.into_iter().enumerate() {
            if faults.len() >= MOST_FAULTS {
                break;
            }
            let gear = build_gear(&gearbox, spec, number, &mut faults);
            gearbox.gears.push(gear);
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        gearbox.warnings = warnings(&gearbox);
        Ok(gearbox)
    }

    fn too_many(&self) -> Vec<Located> {
        let counts = [
            (Named::Set, self.sets.len(), MOST_SETS, Site::Set(MOST_SETS, SetPart::Whole)),
            (Named::Link, self.links.len(), MOST_LINKS, Site::Link(MOST_LINKS)),
            // More connections than links close a loop.
            (Named::Link, self.permanent.len(), MOST_LINKS, Site::Connection(MOST_LINKS, None)),
            (
                Named::ShiftElement,
                self.shift_elements.len(),
                MOST_ELEMENTS,
                Site::ShiftElement(MOST_ELEMENTS, None),
            ),
            (Named::Gear, self.gears.len(), MOST_GEARS, Site::Gear(MOST_GEARS, GearPart::Whole)),
        ];
        let beyond = counts.into_iter().filter(|(_, count, limit, _)| count > limit);
        beyond.map(|(what, count, limit, site)| site.has(Error::TooMany { what, count, limit })).collect()
    }

    fn duplicates(&self) -> Vec<Located> {
        let mut faults = vec![];
        let mut unique = |what, names: &mut dyn Iterator<Item = &str>, site: fn(usize) -> Site| {
            let mut seen = BTreeSet::new();
            for (number, name) in names.enumerate().filter(|(_, name)| !seen.insert(*name)) {
                faults.push(site(number).has(Error::Duplicate { what, name: name.to_owned() }));
            }
        };
        let links = self.links.iter().map(String::as_str);
        unique(Named::Link, &mut [GROUND].into_iter().chain(links), |name| Site::Link(name.max(1) - 1));
        unique(Named::Set, &mut self.sets.iter().map(Description::id), |set| Site::Set(set, SetPart::Whole));
        let elements = &mut self.shift_elements.iter().map(|(id, ..)| id.as_str());
        unique(Named::ShiftElement, elements, |element| Site::ShiftElement(element, None));
        let gears = &mut self.gears.iter().map(|gear| gear.name.as_str());
        unique(Named::Gear, gears, |gear| Site::Gear(gear, GearPart::Whole));
        faults
    }
}

/// Two links by their names; `None` if one is unknown.
fn pair(
    gearbox: &Gearbox,
    names: [&str; 2],
    place: impl Fn() -> Place,
    site: impl Fn(Option<usize>) -> Site,
    faults: &mut Vec<Located>,
) -> Option<[LinkId; 2]> {
    let mut found = |end: usize| {
        let error = match gearbox.known_link(names[end], &place) {
            Ok(link) => return Some(link),
            Err(error) => error,
        };
        faults.push(site(Some(end)).has(error));
        None
    };
    let (first, second) = (found(0), found(1));
    Some([first?, second?])
}

fn terminal(gearbox: &Gearbox, name: Option<&str>, which: Terminal) -> Result<LinkId, Error> {
    let name = name.ok_or(Error::NoTerminal { terminal: which })?;
    turning(gearbox.known_link(name, || Place::Terminal(which))?, || Place::Terminal(which))
}

/// Refuses the housing.
fn turning(link: LinkId, place: impl Fn() -> Place) -> Result<LinkId, Error> {
    if link == LinkId::GROUND { Err(Error::GroundedTerminal { place: place() }) } else { Ok(link) }
}

fn build_set(gearbox: &Gearbox, description: Description, groups: &Groups) -> Result<PlanetSet, SetFaults> {
    let id = description.id().to_owned();
    let given = description.planet_count().filter(|count| !(1..=MOST_ALIKE).contains(count));
    let count = given.map(|given| (SetPart::PlanetCount, Error::PlanetCount { set: id.clone(), given }));
    let mut faults = vec![];
    let mut member = |name: &str, part| {
        gearbox.known_link(name, || Place::Set(id.clone())).unwrap_or_else(|error| {
            faults.push((part, error));
            LinkId::GROUND
        })
    };
    let (carrier, parts) = match &description {
        Description::Short(spec) => {
            let [a, b, h] = &spec.members;
            let links = [member(a, SetPart::Central(0)), member(b, SetPart::Central(1))];
            let carrier = member(h, SetPart::Carrier);
            let parts = parts_of_short(spec, links).map_err(|error| match error {
                Error::RingToSunRatio { .. } => vec![(SetPart::BasicRatio, error)],
                _ => vec![(SetPart::Whole, error)],
            });
            (if spec.kind.is_pair() { LinkId::GROUND } else { carrier }, parts)
        }
        Description::Compound(spec) => {
            (member(&spec.carrier, SetPart::Carrier), parts_of_compound(gearbox, spec))
        }
    };
    let set = parts.and_then(|parts| PlanetSet::new(description, carrier, parts).map_err(|one| vec![one]));
    let set = match set {
        Ok(set) if faults.is_empty() => set,
        refused => {
            faults.extend(refused.err().into_iter().flatten().chain(count));
            return Err(faults);
        }
    };
    match count {
        Some(count) => faults.push(count),
        None => faults.extend(planet_angles::check(&set).err().map(|error| (SetPart::Spacing, error))),
    }
    faults.extend(coincident(gearbox, &set, groups).map(|error| (SetPart::Whole, error)));
    if faults.is_empty() { Ok(set) } else { Err(faults) }
}

/// Members joined permanently make the set one block whatever is engaged, or lock it if the two are the
/// housing. Joined by a *shift element* they are the ordinary direct drive. Central gears that turn alike
/// anyway lose nothing by being one piece.
fn coincident(gearbox: &Gearbox, set: &PlanetSet, groups: &Groups) -> Option<Error> {
    let members = set.members();
    let root = |member: usize| groups.root(members[member].0);
    let mut pairs = (0..members.len()).flat_map(|i| (i + 1..members.len()).map(move |j| (i, j)));
    let (i, j) = pairs.find(|&(i, j)| root(i) == root(j) && !set.turn_alike(i, j))?;
    Some(Error::CoincidentMembers {
        set: set.id().to_owned(),
        first: set.member(i),
        second: set.member(j),
        link: gearbox.link_name(members[i]).into(),
        is_pair: set.is_pair(),
        is_held: root(i) == groups.root(LinkId::GROUND.0),
    })
}

fn build_gear(gearbox: &Gearbox, spec: GearSpec, number: usize, faults: &mut Vec<Located>) -> Gear {
    let mut refuse = |part, error| faults.push(Site::Gear(number, part).has(error));
    let engaged = gearbox.engaged_all(&spec.engaged, || Place::Gear(spec.name.clone()));
    let engaged = engaged.unwrap_or_else(|refused| {
        refused.into_iter().for_each(|(index, error)| refuse(GearPart::Engaged(index), error));
        vec![]
    });
    let mut own = |name: Option<&str>, default: LinkId, which: Terminal| {
        let Some(name) = name else { return default };
        let place = || Place::TerminalOf(which, spec.name.clone());
        gearbox.known_link(name, place).and_then(|link| turning(link, place)).unwrap_or_else(|error| {
            refuse(GearPart::Terminal(which), error);
            default
        })
    };
    let input = own(spec.input.as_deref(), gearbox.input, Terminal::Input);
    let output = own(spec.output.as_deref(), gearbox.output, Terminal::Output);
    Gear { name: spec.name.into(), engaged: engaged.into(), input, output }
}

fn warnings(gearbox: &Gearbox) -> Vec<Warning> {
    let name = |link: LinkId| gearbox.link_name(link).to_owned();
    let terminals = [gearbox.input, gearbox.output].into_iter();
    let unreachable = terminals.filter(|terminal| !touched(gearbox, *terminal));
    let mut warnings: Vec<Warning> =
        unreachable.map(|terminal| Warning::Unreachable { link: name(terminal) }).collect();
    if gearbox.gears.is_empty() {
        warnings.push(Warning::NoGears);
    }
    let blocked = gearbox.gears.iter().filter(|gear| gear.input == gear.output);
    let same = |gear: &Gear| Warning::SameTerminals { gear: gear.name().to_owned(), link: name(gear.input) };
    warnings.extend(blocked.map(same));
    warnings.extend(sharing(gearbox));
    warnings
}

/// Sets that may share planets: one carrier, and a central gear of the same kind and teeth on one link. Where
/// no teeth are known, a simple set and a double-planet set with a ring in common are such: the halves of a
/// Ravigneaux set.
fn sharing(gearbox: &Gearbox) -> Vec<Warning> {
    let mut found = vec![];
    let sets = gearbox.sets();
    let kind = |set: &PlanetSet| set.short().map(|short| short.kind);
    for (place, second) in sets.iter().enumerate() {
        for first in &sets[..place] {
            let kinds = [kind(first), kind(second)];
            let are_halves =
                [SetKind::Simple, SetKind::DoublePlanet].iter().all(|one| kinds.contains(&Some(*one)));
            let same = |one: &Central, other: &Central| {
                one.link == other.link
                    && one.kind == other.kind
                    && one.teeth == other.teeth
                    && (one.teeth.is_some() || are_halves && one.kind == CentralKind::Ring)
            };
            let shared = first.centrals().iter().find(|one| {
                one.link != LinkId::GROUND && second.centrals().iter().any(|other| same(one, other))
            });
            if first.carrier() == second.carrier()
                && first.carrier() != LinkId::GROUND
                && let Some(shared) = shared
            {
                found.push(Warning::SharedPlanets {
                    first: first.id().to_owned(),
                    second: second.id().to_owned(),
                    member: shared.kind,
                });
            }
        }
    }
    found
}

fn touched(gearbox: &Gearbox, link: LinkId) -> bool {
    gearbox.sets.iter().any(|set| set.members().contains(&link))
        || gearbox.shift_elements.iter().any(|shift_element| shift_element.links.contains(&link))
        || gearbox.permanent.iter().any(|pair| pair.contains(&link))
}
