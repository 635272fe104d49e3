//! A gearbox: planet sets, the links that tie them, the shift elements that join links, and its gears.

use crate::drawn_set::DrawnSet;
use crate::error::{Place, Terminal};
use crate::names::nearest;
use crate::tolerance::MOST_FAULTS;
use crate::{Error, LinkId, Named, PlanetSet, Warning};
use epicyclic_gears::simple_set::Fraction;
use std::ops::Range;
use std::sync::Arc;

/// A shift element: a brake, a clutch, or a one-way clutch.
///
/// A brake is one of whose links is the housing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ShiftElement {
    pub(crate) id: String,
    pub(crate) links: [LinkId; 2],
    pub(crate) one_way: bool,
}

impl ShiftElement {
    /// Name of the shift element.
    #[must_use]
    pub fn id(&self) -> &str {
        &self.id
    }

    /// The links it joins when engaged. Its torque acts so on the first and opposite on the second; the
    /// housing, if it is one of them, is the second, unless the element is a one-way clutch.
    #[must_use]
    pub fn links(&self) -> [LinkId; 2] {
        self.links
    }

    /// Whether it holds a link to the housing.
    #[must_use]
    pub fn is_brake(&self) -> bool {
        self.links.contains(&LinkId::GROUND)
    }

    /// Whether it is a one-way clutch: it keeps its first link from turning slower than its second, and lets
    /// it turn faster.
    #[must_use]
    pub fn is_one_way(&self) -> bool {
        self.one_way
    }
}

/// A named set of engaged shift elements, with the links where power enters and leaves.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Gear {
    pub(crate) name: Arc<str>,
    pub(crate) engaged: Arc<[usize]>,
    pub(crate) input: LinkId,
    pub(crate) output: LinkId,
}

impl Gear {
    /// Name of the gear.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Places of the engaged shift elements in [`Gearbox::shift_elements`], ascending.
    #[must_use]
    pub fn engaged(&self) -> &[usize] {
        &self.engaged
    }

    /// Link where power enters.
    #[must_use]
    pub fn input(&self) -> LinkId {
        self.input
    }

    /// Link where power leaves.
    #[must_use]
    pub fn output(&self) -> LinkId {
        self.output
    }
}

/// An equation of a set, as the solver takes it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Equation {
    /// Place of the set.
    pub(crate) set: usize,
    /// Place of the central gear in its set.
    pub(crate) central: usize,
    /// Links of root, central gear and carrier.
    pub(crate) links: [LinkId; 3],
    /// `i_c`.
    pub(crate) ratio: f64,
    pub(crate) rational: Option<Fraction>,
    pub(crate) exact: Option<Fraction>,
}

/// Meshes of a set that carry power in the same direction.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Segment {
    pub(crate) set: usize,
    /// Equations of the gearbox behind it.
    pub(crate) behind: Range<usize>,
    pub(crate) efficiency: f64,
}

/// A planetary gearbox of any structure.
///
/// Built and checked once by [`Gearbox::builder`]; everything else only reads it.
///
/// ```
/// use epicyclic_train::{Gearbox, set::SetSpec};
/// # fn main() -> Result<(), epicyclic_train::Error> {
/// let gearbox = Gearbox::builder("conveyor")
///     .links(["D", "B", "T1"])
///     .set(SetSpec::simple("1", ["D", "T1", "B"], 2.94))
///     .brake("K1", "T1")
///     .clutch("K2", "D", "B")
///     .input("D")
///     .output("B")
///     .gear("slow", ["K1"])
///     .gear("direct", ["K2"])
///     .build()?;
/// let slow = gearbox.analyze("slow")?;
/// assert!((slow.ratio().unwrap() - 3.94).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Gearbox {
    pub(crate) name: String,
    pub(crate) links: Vec<String>,
    pub(crate) sets: Vec<PlanetSet>,
    pub(crate) equations: Vec<Equation>,
    pub(crate) segments: Vec<Segment>,
    pub(crate) drawn: Vec<DrawnSet>,
    pub(crate) shift_elements: Vec<ShiftElement>,
    pub(crate) permanent: Vec<[LinkId; 2]>,
    pub(crate) gears: Vec<Gear>,
    pub(crate) input: LinkId,
    pub(crate) output: LinkId,
    pub(crate) warnings: Vec<Warning>,
}

impl Gearbox {
    /// Name of the gearbox.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The links by [`LinkId::index`], the housing first.
    pub fn link_ids(&self) -> impl Iterator<Item = LinkId> + Clone + use<> {
        (0..self.links.len()).map(LinkId)
    }

    /// Names of the links by [`LinkId::index`]; the first is [`GROUND`](crate::GROUND).
    #[must_use]
    pub fn links(&self) -> &[String] {
        &self.links
    }

    /// Name of a link.
    ///
    /// # Panics
    /// With a link of another, larger gearbox.
    #[must_use]
    pub fn link_name(&self, link: LinkId) -> &str {
        &self.links[link.0]
    }

    /// The link of this name.
    #[must_use]
    pub fn link(&self, name: &str) -> Option<LinkId> {
        self.links.iter().position(|link| link == name).map(LinkId)
    }

    /// The planet sets, and the pairs on fixed axes.
    #[must_use]
    pub fn sets(&self) -> &[PlanetSet] {
        &self.sets
    }

    /// The brakes, clutches and one-way clutches.
    #[must_use]
    pub fn shift_elements(&self) -> &[ShiftElement] {
        &self.shift_elements
    }

    /// Pairs of links that are permanently joined; a permanent ground is a pair with the housing.
    #[must_use]
    pub fn permanent(&self) -> &[[LinkId; 2]] {
        &self.permanent
    }

    /// Sets of the gearbox as drawings show them.
    #[must_use]
    pub fn drawn_sets(&self) -> &[DrawnSet] {
        &self.drawn
    }

    /// The gears.
    #[must_use]
    pub fn gears(&self) -> &[Gear] {
        &self.gears
    }

    /// Link where power enters, unless a gear names another.
    #[must_use]
    pub fn input(&self) -> LinkId {
        self.input
    }

    /// Link where power leaves, unless a gear names another.
    #[must_use]
    pub fn output(&self) -> LinkId {
        self.output
    }

    /// Remarks made when it was built.
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// The gear of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the nearest name.
    pub fn gear(&self, name: &str) -> Result<&Gear, Error> {
        self.gears.iter().find(|gear| gear.name() == name).ok_or_else(|| Error::Unknown {
            what: Named::Gear,
            name: name.into(),
            place: Place::Gearbox(self.name.clone()),
            suggestion: nearest(name, self.gears.iter().map(Gear::name)),
        })
    }

    /// A gear that need not be among the named ones: these shift elements, input and output.
    ///
    /// # Errors
    /// [`Error::Unknown`] for a shift element or link that does not exist, [`Error::GroundedTerminal`]
    /// where power would enter or leave at the housing.
    pub fn gear_of(&self, engaged: &[&str], input: &str, output: &str) -> Result<Gear, Error> {
        let shift_elements = self.engaged(engaged, || Place::UnnamedGear)?;
        let terminal = |name: &str, which| match self.link(name) {
            // The housing is a link of every gearbox, so its name is found; it carries no power in or out.
            Some(LinkId::GROUND) => Err(Error::GroundedTerminal { place: Place::Terminal(which) }),
            Some(link) => Ok(link),
            None => Err(self.unknown_link(name, Place::Terminal(which))),
        };
        Ok(Gear {
            name: engaged.join("+").into(),
            engaged: shift_elements.into(),
            input: terminal(input, Terminal::Input)?,
            output: terminal(output, Terminal::Output)?,
        })
    }

    /// The places of the shift elements that a gear engages, ascending.
    pub(crate) fn engaged(
        &self,
        ids: &[impl AsRef<str>],
        place: impl Fn() -> Place,
    ) -> Result<Vec<usize>, Error> {
        self.engaged_all(ids, place).map_err(|mut faults| faults.swap_remove(0).1)
    }

    /// Places of the engaged shift elements, ascending; or the faults of the list with their indices in it.
    pub(crate) fn engaged_all(
        &self,
        ids: &[impl AsRef<str>],
        place: impl Fn() -> Place,
    ) -> Result<Vec<usize>, Vec<(usize, Error)>> {
        let (mut places, mut faults) = (vec![], vec![]);
        for (index, id) in ids.iter().map(AsRef::as_ref).enumerate() {
            match self.shift_element(id, &place) {
                Ok(engaged) if places.contains(&engaged) => {
                    faults.push((index, Error::EngagedTwice { place: place(), name: id.to_owned() }));
                }
                Ok(engaged) => places.push(engaged),
                Err(error) => faults.push((index, error)),
            }
            if faults.len() == MOST_FAULTS {
                break;
            }
        }
        places.sort_unstable();
        if faults.is_empty() { Ok(places) } else { Err(faults) }
    }

    pub(crate) fn shift_element(&self, id: &str, place: impl Fn() -> Place) -> Result<usize, Error> {
        self.shift_elements.iter().position(|shift_element| shift_element.id == id).ok_or_else(|| {
            Error::Unknown {
                what: Named::ShiftElement,
                name: id.into(),
                place: place(),
                suggestion: nearest(
                    id,
                    self.shift_elements.iter().map(|shift_element| shift_element.id.as_str()),
                ),
            }
        })
    }

    pub(crate) fn known_link(&self, name: &str, place: impl Fn() -> Place) -> Result<LinkId, Error> {
        self.link(name).ok_or_else(|| self.unknown_link(name, place()))
    }

    pub(crate) fn unknown_link(&self, name: &str, place: Place) -> Error {
        Error::Unknown {
            what: Named::Link,
            name: name.into(),
            place,
            suggestion: nearest(name, self.links.iter().map(String::as_str)),
        }
    }

    /// The equations of a set.
    pub(crate) fn equations_of(&self, set: usize) -> Range<usize> {
        // Sets are pushed one by one, so the equations of a set are contiguous and in order.
        let from = self.equations.partition_point(|one| one.set < set);
        from..from + self.equations[from..].partition_point(|one| one.set == set)
    }

    /// Adds a set with its equations and segments.
    pub(crate) fn push_set(&mut self, set: PlanetSet) {
        let (place, from) = (self.sets.len(), self.equations.len());
        let tree = &set.tree;
        for (at, &central) in tree.order.iter().enumerate() {
            self.equations.push(Equation {
                set: place,
                central,
                links: [set.members()[tree.root], set.members()[central], set.carrier()],
                ratio: tree.ratios[at],
                rational: tree.rationals[at],
                exact: tree.exact[at],
            });
        }
        for segment in &tree.segments {
            let behind = from + segment.behind.start..from + segment.behind.end;
            self.segments.push(Segment { set: place, behind, efficiency: segment.efficiency });
        }
        self.sets.push(set);
        for equation in from..self.equations.len() {
            let central = self.equations[equation].central;
            self.drawn.push(DrawnSet::of(&self.sets[place], place, central));
        }
    }

    /// Whether a gear is one of this gearbox, or could be.
    pub(crate) fn check_gear(&self, gear: &Gear) -> Result<(), Error> {
        // A gear holds places, not names: a foreign gear is detected only if a place is out of range.
        let fits = gear.engaged.iter().all(|&shift_element| shift_element < self.shift_elements.len())
            && [gear.input, gear.output].iter().all(|link| link.0 < self.links.len());
        if fits { Ok(()) } else { Err(Error::ForeignGear { gear: gear.name().to_owned() }) }
    }
}
