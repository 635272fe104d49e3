//! The gearbox that a file describes, and the paths of its faults.

use super::checks::{NO_LINK, built, refused};
use super::compound::at_set;
use super::place::{LISTS_OF_SETS, of_gear, of_set};
use super::{ClutchEntry, CompoundEntry, DescriptionError, GearEntry, GearboxFile};
use crate::Path;
use crate::faults::{At, Faults};
use epicyclic_train::tolerance::MOST_SETS;
use epicyclic_train::{GROUND, GearSpec, Gearbox, Site};
use std::collections::BTreeSet;

impl GearboxFile {
    /// The gearbox described.
    ///
    /// # Errors
    /// Each [`DescriptionError`] and each error of the solver that does not follow from another one, with its
    /// path. A shift element or gear that names a link which exists nowhere else is
    /// [`epicyclic_train::Error::Unknown`], with the nearest name.
    pub fn gearbox(&self) -> Result<Gearbox, Faults> {
        let short = self.sets.iter().flat_map(|set| [Some(&set.sun), Some(&set.ring), set.carrier.as_ref()]);
        let members = short.flatten().chain(self.compound_sets.iter().flat_map(CompoundEntry::members));
        let clutches =
            self.clutches.iter().flat_map(|clutch| clutch.links.iter().chain(&clutch.one_way).flatten());
        let tied = clutches.chain(self.ties.iter().flatten());
        // A terminal that nothing else names is a slip of the pen, and no link.
        let is_named = |terminal: &&String| {
            members.clone().chain(&self.links).chain(tied.clone()).any(|link| link == *terminal)
        };
        let input = Some(&self.input).filter(is_named);
        let output = Some(&self.output).filter(is_named);
        let mut seen = BTreeSet::from([GROUND]);
        let named = input.into_iter().chain(members.clone()).chain(output).chain(&self.links);
        let links: Vec<&str> = named.map(String::as_str).filter(|link| seen.insert(link)).collect();
        let mut builder =
            Gearbox::builder(&self.gearbox).links(links).input(&self.input).output(&self.output);
        let mut faults = Faults::default();
        let rack = self.rack();
        if let Err(error) = &rack {
            let is_angle = matches!(error, epicyclic_gears::Error::OutOfRange { .. });
            let key = if is_angle { "pressure_angle" } else { "addendum" };
            faults.push(key, DescriptionError::Rack(error.clone()));
        }
        let friction = self.friction.filter(|friction| {
            let is_right = friction.get() > 0.0 && friction.get() <= 1.0;
            if !is_right {
                faults.push("friction", DescriptionError::FrictionRange { given: friction.get() });
            }
            is_right
        });
        self.check_limits(&mut faults);
        for (place, set) in self.sets.iter().enumerate() {
            let spec = faults.below(&of_set(self.sets.len(), place), |faults| {
                let rack = rack.as_ref().ok();
                // Sets beyond the limit are not worth the work.
                (place < MOST_SETS).then(|| set.spec(rack, friction, faults)).flatten()
            });
            builder = builder.set(spec.unwrap_or_else(|| refused(&set.id, set.planets)));
        }
        for (place, set) in (self.sets.len()..).zip(&self.compound_sets) {
            let spec = faults.below(&of_set(self.sets.len(), place), |faults| {
                set.spec(Some, rack.as_ref().ok(), friction, faults)
            });
            builder = builder.compound_set(spec);
        }
        for brake in &self.brakes {
            builder = builder.brake(&brake.id, &brake.link);
        }
        for (place, ClutchEntry { id, links, one_way, .. }) in self.clutches.iter().enumerate() {
            builder = match (links, one_way) {
                (Some([first, second]), None) => builder.clutch(id, first, second),
                (None, Some([first, second])) => builder.one_way_clutch(id, first, second),
                _ => {
                    let clutch = DescriptionError::Clutch { clutch: id.clone() };
                    faults.push(Path::root().key("clutches").index(place), clutch);
                    builder.clutch(id, NO_LINK, NO_LINK)
                }
            };
        }
        for link in &self.grounds {
            builder = builder.ground(link);
        }
        for [first, second] in &self.ties {
            builder = builder.tie(first, second);
        }
        for GearEntry { name, engaged, input, output, .. } in self.gears.iter().cloned() {
            builder = builder.gear_spec(GearSpec { name, engaged, input, output });
        }
        let gearbox = built(faults, builder.build_all(), |site| self.at(site));
        gearbox.map_err(|mut faults| {
            self.curves(&mut faults);
            faults
        })
    }

    /// Path of a part of the description.
    fn at(&self, site: Site) -> At {
        let entry = |list: &str, place| Path::root().key(list).index(place);
        match site {
            Site::Gearbox => LISTS_OF_SETS.into(),
            Site::Terminal(which) => Path::root().key(which.to_string()).into(),
            Site::Link(_) => Path::root().into(),
            Site::Set(set, part) => at_set(self.sets.len(), &self.compound_sets, set, part),
            Site::ShiftElement(element, end) => match element.checked_sub(self.brakes.len()) {
                None if end.is_some() => entry("brakes", element).key("link").into(),
                None => entry("brakes", element).into(),
                Some(clutch) => match (end, self.clutches.get(clutch)) {
                    (Some(end), Some(ClutchEntry { links: Some(_), .. })) => {
                        entry("clutches", clutch).key("links").index(end).into()
                    }
                    (Some(end), _) => entry("clutches", clutch).key("one_way").index(end).into(),
                    (None, _) => entry("clutches", clutch).into(),
                },
            },
            Site::Connection(connection, end) => match connection.checked_sub(self.grounds.len()) {
                None => entry("grounds", connection).into(),
                Some(tie) => entry("ties", tie).indexed(end).into(),
            },
            Site::Gear(gear, part) => of_gear(gear, part).into(),
        }
    }
}
