//! Describing a gearbox by names, and checking that the description is one.

use crate::compound::{CentralKind, CompoundSpec, GearName};
use crate::error::{CompoundFault, MeshFault, Place, Terminal};
use crate::gearbox::{Gear, ShiftElement};
use crate::groups::Groups;
use crate::names::nearest;
use crate::planet_angles;
use crate::planet_set::{
    Central, Description, GearOf, Mesh, MeshKind, Parts, Planet, PlanetSet, parts_of_short,
};
use crate::set::SetSpec;
use crate::set_kind::SetKind;
use crate::tolerance::{
    MOST_ALIKE, MOST_ELEMENTS, MOST_GEARS, MOST_LINKS, MOST_MEMBERS, MOST_PLANETS, MOST_SETS, SPREAD,
};
use crate::{Error, GROUND, Gearbox, LinkId, Named, Warning};
use epicyclic_gears::teeth::ToothCount;

/// A gearbox being described; see [`Gearbox::builder`].
///
/// Nothing is checked before [`build`](Self::build), so the order of the calls is free.
#[derive(Debug, Clone, Default)]
pub struct GearboxBuilder {
    name: String,
    links: Vec<String>,
    sets: Vec<Description>,
    shift_elements: Vec<(String, [String; 2], bool)>,
    permanent: Vec<[String; 2]>,
    gears: Vec<GearSpec>,
    input: Option<String>,
    output: Option<String>,
}

/// Description of a gear by names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GearSpec {
    /// Name of the gear.
    pub name: String,
    /// Engaged shift elements.
    pub engaged: Vec<String>,
    /// Link where power enters, if not the gearbox's input.
    pub input: Option<String>,
    /// Link where power leaves, if not the gearbox's output.
    pub output: Option<String>,
}

impl Gearbox {
    /// A gearbox to be described.
    #[must_use]
    pub fn builder(name: &str) -> GearboxBuilder {
        GearboxBuilder::new(name)
    }

    /// Description of the gearbox as a builder, to be changed and built again. Unchanged, the builder builds
    /// an equal gearbox.
    #[must_use]
    pub fn to_builder(&self) -> GearboxBuilder {
        let name = |link: LinkId| self.link_name(link).to_owned();
        let gear = |gear: &Gear| GearSpec {
            name: gear.name().to_owned(),
            engaged: gear.engaged.iter().map(|&place| self.shift_elements[place].id.clone()).collect(),
            input: Some(name(gear.input)),
            output: Some(name(gear.output)),
        };
        GearboxBuilder {
            name: self.name.clone(),
            links: self.links[1..].to_vec(),
            sets: self.sets.iter().map(|set| set.description().clone()).collect(),
            shift_elements: self
                .shift_elements
                .iter()
                .map(|c| (c.id.clone(), c.links.map(name), c.one_way))
                .collect(),
            permanent: self.permanent.iter().map(|pair| pair.map(name)).collect(),
            gears: self.gears.iter().map(gear).collect(),
            input: Some(name(self.input)),
            output: Some(name(self.output)),
        }
    }
}

impl GearboxBuilder {
    pub(crate) fn new(name: &str) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// Adds links. The housing, [`GROUND`], is there from the start.
    #[must_use]
    pub fn links<S: Into<String>>(mut self, names: impl IntoIterator<Item = S>) -> Self {
        self.links.extend(names.into_iter().map(Into::into));
        self
    }

    /// Adds a set with three members, in short.
    #[must_use]
    pub fn set(mut self, set: SetSpec) -> Self {
        self.sets.push(set.into());
        self
    }

    /// Adds a set of any form, gear by gear.
    #[must_use]
    pub fn compound_set(mut self, set: CompoundSpec) -> Self {
        self.sets.push(set.into());
        self
    }

    /// Adds a shift element that holds a link to the housing.
    #[must_use]
    pub fn brake(self, id: &str, link: &str) -> Self {
        self.clutch(id, link, GROUND)
    }

    /// Adds a shift element that joins two links.
    #[must_use]
    pub fn clutch(mut self, id: &str, first: &str, second: &str) -> Self {
        self.shift_elements.push((id.into(), [first.into(), second.into()], false));
        self
    }

    /// Adds a one-way clutch: it keeps the first link from turning slower than the second, `ω_1 < ω_2`, and
    /// lets it turn faster. A gear that relies on it names it among its engaged shift elements.
    #[must_use]
    pub fn one_way_clutch(mut self, id: &str, first: &str, second: &str) -> Self {
        self.shift_elements.push((id.into(), [first.into(), second.into()], true));
        self
    }

    /// Holds a link to the housing permanently.
    #[must_use]
    pub fn ground(self, link: &str) -> Self {
        self.tie(link, GROUND)
    }

    /// Joins two links permanently.
    #[must_use]
    pub fn tie(mut self, first: &str, second: &str) -> Self {
        self.permanent.push([first.into(), second.into()]);
        self
    }

    /// Names the link where power enters.
    #[must_use]
    pub fn input(mut self, link: &str) -> Self {
        self.input = Some(link.into());
        self
    }

    /// Names the link where power leaves.
    #[must_use]
    pub fn output(mut self, link: &str) -> Self {
        self.output = Some(link.into());
        self
    }

    /// Adds a gear between the gearbox's input and output.
    #[must_use]
    pub fn gear<S: Into<String>>(self, name: &str, engaged: impl IntoIterator<Item = S>) -> Self {
        let engaged = engaged.into_iter().map(Into::into).collect();
        self.gear_spec(GearSpec { name: name.into(), engaged, input: None, output: None })
    }

    /// Adds a gear with its own input or output.
    #[must_use]
    pub fn gear_spec(mut self, gear: GearSpec) -> Self {
        self.gears.push(gear);
        self
    }

    /// Changes the sets described in short so far: other `k`, teeth or losses between the same links.
    ///
    /// ```
    /// use epicyclic_train::{Gearbox, set::{Gearing, SetSpec}};
    /// # fn main() -> Result<(), epicyclic_train::Error> {
    /// let gearbox = Gearbox::builder("I")
    ///     .links(["D", "B", "T1"])
    ///     .set(SetSpec::simple("1", ["D", "T1", "B"], 2.94))
    ///     .brake("K1", "T1")
    ///     .input("D")
    ///     .output("B")
    ///     .gear("slow", ["K1"])
    ///     .build()?;
    /// let other = gearbox
    ///     .to_builder()
    ///     .map_sets(|set| SetSpec { gearing: Gearing::BasicRatio(4.0), ..set })
    ///     .build()?;
    /// assert!((other.analyze("slow")?.ratio().unwrap() - 5.0).abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn map_sets(self, mut change: impl FnMut(SetSpec) -> SetSpec) -> Self {
        self.map_descriptions(|description| match description {
            Description::Short(spec) => Description::Short(change(spec)),
            whole @ Description::Compound(_) => whole,
        })
    }

    /// Changes all sets described so far.
    #[must_use]
    pub fn map_descriptions(mut self, change: impl FnMut(Description) -> Description) -> Self {
        self.sets = self.sets.into_iter().map(change).collect();
        self
    }

    /// Changes the gears described so far, their names for example.
    #[must_use]
    pub fn map_gears(mut self, change: impl FnMut(GearSpec) -> GearSpec) -> Self {
        self.gears = self.gears.into_iter().map(change).collect();
        self
    }

    /// Gives the gearbox this name.
    #[must_use]
    pub fn named(mut self, name: &str) -> Self {
        name.clone_into(&mut self.name);
        self
    }

    /// Checks the description and returns the gearbox.
    ///
    /// # Errors
    /// Every variant of [`Error`] about a description:
    /// - unknown and repeated names, members of a set that are one piece;
    /// - `k ≤ 1` of a simple set, missing steps, meshes that make no tree;
    /// - shift elements that join a link with itself, permanent connections in a loop;
    /// - terminals at the housing, a gearbox above the limits of size.
    ///
    /// [`Gearbox::tooth_checks`] checks whether the teeth fit.
    pub fn build(self) -> Result<Gearbox, Error> {
        for (what, count, limit) in [
            (Named::Set, self.sets.len(), MOST_SETS),
            (Named::Link, self.links.len(), MOST_LINKS),
            (Named::ShiftElement, self.shift_elements.len(), MOST_ELEMENTS),
            (Named::Gear, self.gears.len(), MOST_GEARS),
        ] {
            if count > limit {
                return Err(Error::TooMany { what, count, limit });
            }
        }
        let mut links = vec![GROUND.to_owned()];
        links.extend(self.links.iter().cloned());
        unique(Named::Link, links.iter().map(String::as_str))?;
        unique(Named::Set, self.sets.iter().map(Description::id))?;
        unique(Named::ShiftElement, self.shift_elements.iter().map(|(id, ..)| id.as_str()))?;
        unique(Named::Gear, self.gears.iter().map(|gear| gear.name.as_str()))?;
        if self.sets.is_empty() {
            return Err(Error::NoSets);
        }
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
        gearbox.input = terminal(&gearbox, self.input.as_deref(), Terminal::Input)?;
        gearbox.output = terminal(&gearbox, self.output.as_deref(), Terminal::Output)?;
        let mut groups = Groups::new(gearbox.links.len());
        for (number, [first, second]) in self.permanent.iter().enumerate() {
            let place = || Place::Connection(number);
            let pair = [link(&gearbox, first, place)?, link(&gearbox, second, place)?];
            if !groups.join(pair[0].0, pair[1].0) {
                return Err(Error::CyclicGrounds { number, first: first.clone(), second: second.clone() });
            }
            gearbox.permanent.push(pair);
        }
        for description in self.sets {
            let set = build_set(&gearbox, description, &groups)?;
            gearbox.push_set(set);
        }
        let exponent: f64 = gearbox
            .equations
            .iter()
            .map(|one| libm::log10(1.0 + one.ratio.abs().max(1.0 / one.ratio.abs())))
            .sum();
        if exponent > libm::log10(SPREAD) {
            return Err(Error::Spread { exponent });
        }
        for (id, [first, second], one_way) in self.shift_elements {
            let place = || Place::ShiftElement(id.clone());
            let mut pair = [link(&gearbox, &first, place)?, link(&gearbox, &second, place)?];
            if pair[0] == pair[1] {
                return Err(Error::ShiftElementJoinsItself { shift_element: id, link: first });
            }
            // The order of a one-way clutch is its direction.
            if pair[0] == LinkId::GROUND && !one_way {
                pair.swap(0, 1);
            }
            gearbox.shift_elements.push(ShiftElement { id, links: pair, one_way });
        }
        for spec in self.gears {
            let gear = build_gear(&gearbox, spec)?;
            gearbox.gears.push(gear);
        }
        let terminals = [gearbox.input, gearbox.output];
        let unreachable: Vec<_> =
            terminals.into_iter().filter(|terminal| !touched(&gearbox, *terminal)).collect();
        for terminal in unreachable {
            gearbox.warnings.push(Warning::Unreachable { link: gearbox.link_name(terminal).into() });
        }
        if gearbox.gears.is_empty() {
            gearbox.warnings.push(Warning::NoGears);
        }
        for gear in gearbox.gears.iter().filter(|gear| gear.input == gear.output) {
            gearbox.warnings.push(Warning::SameTerminals {
                gear: gear.name().to_owned(),
                link: gearbox.link_name(gear.input).into(),
            });
        }
        gearbox.warnings.extend(sharing(&gearbox));
        Ok(gearbox)
    }
}

fn unique<'a>(what: Named, names: impl Iterator<Item = &'a str>) -> Result<(), Error> {
    let mut seen = std::collections::BTreeSet::new();
    for name in names {
        if !seen.insert(name) {
            return Err(Error::Duplicate { what, name: name.to_owned() });
        }
    }
    Ok(())
}

fn link(gearbox: &Gearbox, name: &str, place: impl Fn() -> Place) -> Result<LinkId, Error> {
    gearbox.link(name).ok_or_else(|| gearbox.unknown_link(name, place()))
}

fn terminal(gearbox: &Gearbox, name: Option<&str>, which: Terminal) -> Result<LinkId, Error> {
    let name = name.ok_or(Error::NoTerminal { terminal: which })?;
    let found = link(gearbox, name, || Place::Terminal(which))?;
    if found == LinkId::GROUND {
        return Err(Error::GroundedTerminal { place: Place::Terminal(which) });
    }
    Ok(found)
}

fn build_set(gearbox: &Gearbox, description: Description, groups: &Groups) -> Result<PlanetSet, Error> {
    let id = description.id().to_owned();
    let place = || Place::Set(id.clone());
    let (carrier, parts) = match &description {
        Description::Short(spec) => {
            let [a, b, h] = &spec.members;
            let links = [link(gearbox, a, place)?, link(gearbox, b, place)?];
            let carrier = link(gearbox, h, place)?;
            (if spec.kind.is_pair() { LinkId::GROUND } else { carrier }, parts_of_short(spec, links)?)
        }
        Description::Compound(spec) => {
            (link(gearbox, &spec.carrier, place)?, parts_of_compound(gearbox, spec)?)
        }
    };
    let set = PlanetSet::new(description, carrier, parts)?;
    if let Some(given) = set.planet_count().filter(|count| !(1..=MOST_ALIKE).contains(count)) {
        return Err(Error::PlanetCount { set: id, given });
    }
    planet_angles::check(&set)?;
    // Members joined permanently make the set one block whatever is engaged, or lock it if the two are the
    // housing. Joined by a *shift element* they are the ordinary direct drive. Central gears that turn alike
    // anyway lose nothing by being one piece.
    let members = set.members();
    for i in 0..members.len() {
        for j in i + 1..members.len() {
            if groups.root(members[i].0) == groups.root(members[j].0) && !set.turn_alike(i, j) {
                return Err(Error::CoincidentMembers {
                    set: id,
                    first: set.member(i),
                    second: set.member(j),
                    link: gearbox.link_name(members[i]).into(),
                    is_pair: set.is_pair(),
                    is_held: groups.root(members[i].0) == groups.root(LinkId::GROUND.0),
                });
            }
        }
    }
    Ok(set)
}

/// The parts that a compound description names.
fn parts_of_compound(gearbox: &Gearbox, spec: &CompoundSpec) -> Result<Parts, Error> {
    let fault = |fault| Error::Compound { set: spec.id.clone(), fault };
    for (what, count, limit) in [
        (Named::Member, spec.centrals.len(), MOST_MEMBERS),
        (Named::Planet, spec.planets.len(), MOST_PLANETS),
        (Named::Mesh, spec.meshes.len(), MOST_MEMBERS + MOST_PLANETS),
    ] {
        if count > limit {
            return Err(Error::TooMany { what, count, limit });
        }
    }
    if spec.centrals.len() < 2 {
        return Err(fault(CompoundFault::TooFewMembers { given: spec.centrals.len() }));
    }
    let teeth = |gear: &GearName, count: u32| {
        ToothCount::new(count).map_err(|_| fault(CompoundFault::NoTeeth { gear: gear.clone() }))
    };
    let mut gears: Vec<(GearName, GearOf)> = vec![];
    let mut planets = vec![];
    for (place, planet) in spec.planets.iter().enumerate() {
        if planet.teeth.len() > MOST_PLANETS {
            return Err(fault(CompoundFault::PlanetGears {
                planet: planet.name.clone(),
                given: planet.teeth.len(),
                most: MOST_PLANETS,
            }));
        }
        if spec.proportional && !planet.teeth.is_empty() {
            return Err(fault(CompoundFault::PlanetTeeth { planet: planet.name.clone() }));
        }
        let mut counts = vec![];
        if planet.teeth.is_empty() {
            counts.push(None);
            gears.push((GearName::only(&planet.name), GearOf::Planet(place, 0)));
        }
        for (step, &count) in planet.teeth.iter().enumerate() {
            let step_of_several = (planet.teeth.len() > 1).then_some(step + 1);
            let name = GearName { of: planet.name.clone(), step: step_of_several };
            counts.push(Some(teeth(&name, count)?));
            gears.push((name, GearOf::Planet(place, step)));
        }
        planets.push(Planet { name: planet.name.clone(), gears: counts });
    }
    let mut centrals = vec![];
    for (place, central) in spec.centrals.iter().enumerate() {
        let link = link(gearbox, &central.link, || Place::Set(spec.id.clone()))?;
        let (teeth, body) = match (&central.planet, central.kind) {
            (Some(name), CentralKind::PlanetShaft) => {
                let planet = spec.planets.iter().position(|planet| planet.name == *name);
                let unknown = || CompoundFault::UnknownGear {
                    name: name.clone(),
                    suggestion: nearest(name, spec.planets.iter().map(|planet| planet.name.as_str())),
                };
                (None, spec.centrals.len() + planet.ok_or_else(|| fault(unknown()))?)
            }
            _ if spec.proportional => (None, place),
            _ => {
                let (gear, given) = (GearName::only(&central.name), central.teeth);
                let count = (given.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&given))
                    .then_some(given as u32);
                let not_whole = || fault(CompoundFault::NotWhole { gear: gear.clone(), given });
                (Some(teeth(&gear, count.ok_or_else(not_whole)?)?), place)
            }
        };
        if centrals.iter().any(|other: &Central| other.body == body) {
            let planet = central.planet.clone().unwrap_or_default();
            return Err(fault(CompoundFault::TwoShafts { name: central.name.clone(), planet }));
        }
        let proportion = (spec.proportional && central.planet.is_none()).then_some(central.teeth);
        if let Some(given) = proportion.filter(|given| !(*given > 0.0 && given.is_finite())) {
            return Err(fault(CompoundFault::Proportion { gear: GearName::only(&central.name), given }));
        }
        gears.push((GearName::only(&central.name), GearOf::Central(place)));
        centrals.push(Central { link, kind: central.kind, teeth, proportion, body });
    }
    let mut names = std::collections::BTreeSet::new();
    // Names that meshes use: `long.2` may be a step of a planet or a central gear.
    let spelt: Vec<String> = gears.iter().map(|(name, _)| name.to_string()).collect();
    let bodies = spec.planets.iter().map(|planet| &planet.name).filter(|name| !spelt.contains(name));
    let bodies = bodies.map(|name| (name.as_str(), GearName::only(name)));
    let named = spelt.iter().map(String::as_str).zip(gears.iter().map(|(name, _)| name.clone()));
    if let Some((_, name)) = named.chain(bodies).find(|(spelling, _)| !names.insert(*spelling)) {
        return Err(fault(CompoundFault::NameTwice { name }));
    }
    let gear = |name: &str| {
        let known = spelt.iter().position(|spelling| spelling == name);
        known.map(|place| gears[place].1).ok_or_else(|| {
            fault(CompoundFault::UnknownGear {
                name: name.to_owned(),
                suggestion: nearest(name, spelt.iter().map(String::as_str)),
            })
        })
    };
    let mut meshes = vec![];
    for mesh in &spec.meshes {
        let [first, second] = &mesh.between;
        let pair = [gear(first)?, gear(second)?];
        let wrong = |why| fault(CompoundFault::Mesh { first: first.clone(), second: second.clone(), why });
        let kind = match pair {
            [GearOf::Central(_), GearOf::Central(_)] => {
                return Err(wrong(MeshFault::TwoCentrals));
            }
            [GearOf::Planet(one, _), GearOf::Planet(other, _)] if one == other => {
                return Err(wrong(MeshFault::OnePlanet));
            }
            [GearOf::Planet(..), GearOf::Planet(..)] => MeshKind::External,
            [GearOf::Central(central), GearOf::Planet(planet, step)]
            | [GearOf::Planet(planet, step), GearOf::Central(central)] => match centrals[central].kind {
                CentralKind::Sun => MeshKind::External,
                CentralKind::Ring
                    if planets[planet].gears[step]
                        .is_some_and(|teeth| centrals[central].teeth <= Some(teeth)) =>
                {
                    return Err(wrong(MeshFault::SmallRing));
                }
                CentralKind::Ring => MeshKind::Internal,
                CentralKind::BevelLeft => MeshKind::BevelLeft,
                CentralKind::BevelRight => MeshKind::BevelRight,
                CentralKind::PlanetShaft => return Err(wrong(MeshFault::PlanetShaft)),
            },
        };
        meshes.push(Mesh { gears: pair, kind, efficiency: mesh.efficiency });
    }
    let bodies = centrals.len() + planets.len();
    Ok(Parts {
        centrals,
        planets,
        meshes,
        factors: vec![None; bodies],
        exact: vec![None; bodies],
        rational: None,
        loss: None,
    })
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

fn build_gear(gearbox: &Gearbox, spec: GearSpec) -> Result<Gear, Error> {
    let place = || Place::Gear(spec.name.clone());
    let engaged = gearbox.engaged(&spec.engaged, place)?;
    let own = |name: Option<&str>, default: LinkId, which: Terminal| {
        let Some(name) = name else { return Ok(default) };
        let place = || Place::TerminalOf(which, spec.name.clone());
        match link(gearbox, name, place)? {
            LinkId::GROUND => Err(Error::GroundedTerminal { place: place() }),
            link => Ok(link),
        }
    };
    let input = own(spec.input.as_deref(), gearbox.input, Terminal::Input)?;
    let output = own(spec.output.as_deref(), gearbox.output, Terminal::Output)?;
    Ok(Gear { name: spec.name.into(), engaged: engaged.into(), input, output })
}

fn touched(gearbox: &Gearbox, link: LinkId) -> bool {
    gearbox.sets.iter().any(|set| set.members().contains(&link))
        || gearbox.shift_elements.iter().any(|shift_element| shift_element.links.contains(&link))
        || gearbox.permanent.iter().any(|pair| pair.contains(&link))
}
