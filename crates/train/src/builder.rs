//! Describing a gearbox by names, and checking that the description is one.

use crate::compound::CompoundSpec;
use crate::gearbox::Gear;
use crate::planet_set::Description;
use crate::set::SetSpec;
use crate::{Error, GROUND, Gearbox, LinkId};

mod check;
mod compound_parts;

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
    /// Of several faults the first is returned; [`build_all`](Self::build_all) returns all.
    ///
    /// [`Gearbox::tooth_checks`] checks whether the teeth fit.
    pub fn build(self) -> Result<Gearbox, Error> {
        self.build_all().map_err(|mut faults| faults.swap_remove(0).error)
    }
}
