//! Real transmissions: members joined to links, shift elements between links, gears with published ratios.

use super::checks::{NO_LINK, built, refused};
use super::compound::{CompoundEntry, ListedPlanetEntry, Note, at_set};
use super::place::{LISTS_OF_SETS, keys_of_part, of_gear, of_set};
use super::{DescriptionError, losses, spaced};
use crate::Path;
use crate::drive::Spacing;
use crate::faults::{At, Faults, Keys};
use epicyclic_gears::teeth::ToothCount;
use epicyclic_train::planet_bearings::{PlanetBearing, SetSize};
use epicyclic_train::set::{SetKind, SetSpec};
use epicyclic_train::{GROUND, GearSpec, Gearbox, PlanetSet, SetPart, Site};
use epicyclic_units::{Number, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use uom::si::f64::{Angle, AngularVelocity, Ratio, Torque};

/// A file of transmissions.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TransmissionsFile {
    /// The transmissions.
    pub transmissions: Vec<Transmission>,
    /// Remark, of any form.
    #[serde(default)]
    pub note: Option<Note>,
}

/// A transmission with what is published of its gears.
///
/// Every node is a link; the node `ground` is the housing.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Transmission {
    /// Name of the transmission.
    pub name: String,
    /// Publication of its data.
    #[serde(default)]
    pub source: Option<String>,
    /// The sets with two central gears, and pairs; their members are gears and carriers.
    #[serde(default)]
    pub sets: Vec<TransmissionSet>,
    /// Sets of any other form, gear by gear; their members too are named in links.
    #[serde(default)]
    pub compound_sets: Vec<CompoundEntry<ListedPlanetEntry>>,
    /// Members that turn as one piece, by node.
    pub links: BTreeMap<String, Vec<String>>,
    /// Node where power enters, unless a gear says otherwise.
    pub input: String,
    /// Node where power leaves, unless a gear says otherwise.
    pub output: String,
    /// Brakes and clutches: the two links that each joins when engaged.
    #[serde(default)]
    pub shift_elements: BTreeMap<String, [String; 2]>,
    /// One-way clutches: each keeps its first node from turning slower than its second.
    #[serde(default)]
    pub one_way: BTreeMap<String, [String; 2]>,
    /// The gears.
    pub gears: Vec<PublishedGear>,
    /// Remark, of any form.
    #[serde(default)]
    pub note: Option<Note>,
}

/// A set of a transmission with two central gears, or a pair.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TransmissionSet {
    /// Name of the set.
    pub id: String,
    /// How its gears are joined.
    pub planet: Planet,
    /// The sun.
    #[serde(default)]
    pub sun: Option<String>,
    /// The ring.
    #[serde(default)]
    pub ring: Option<String>,
    /// The carrier, of a planet set.
    #[serde(default)]
    pub carrier: Option<String>,
    /// Teeth of the sun.
    #[serde(default)]
    pub z_s: Option<u32>,
    /// Teeth of the ring.
    #[serde(default)]
    pub z_r: Option<u32>,
    /// Teeth of a planet; of a double planet that in mesh with the sun.
    #[serde(default)]
    pub z_p: Option<u32>,
    /// Teeth of the planet, or of its step, in mesh with `gear_a` or the sun.
    #[serde(default)]
    pub z_pa: Option<u32>,
    /// Teeth of the planet, or of its step, in mesh with `gear_b` or the ring.
    #[serde(default)]
    pub z_pb: Option<u32>,
    /// Number of planets.
    #[serde(default)]
    pub n_p: Option<u32>,
    /// Spacing of the planets. Default `equal`.
    #[serde(default)]
    pub spacing: Option<Spacing>,
    /// Angle of each planet on the carrier, in place of `spacing`. Only differences of angles matter.
    #[serde(default)]
    pub planet_angles: Option<Vec<Quantity<Angle>>>,
    /// First gear of a pair; of a planet set its first central gear, in place of `sun`.
    #[serde(default)]
    pub gear_a: Option<String>,
    /// Second gear of a pair; of a planet set its second central gear, in place of `ring`.
    #[serde(default)]
    pub gear_b: Option<String>,
    /// Teeth of the first gear, in place of `z_s`.
    #[serde(default)]
    pub z_a: Option<u32>,
    /// Teeth of the second gear, in place of `z_r`.
    #[serde(default)]
    pub z_b: Option<u32>,
    /// Efficiency `η₀` under a carrier at rest, 0.97 or 97 %; 1 unless given.
    #[serde(default)]
    pub efficiency: Option<Quantity<Ratio>>,
    /// Efficiency of each mesh from the first central gear to the second, in place of `efficiency`.
    #[serde(default)]
    pub meshes: Option<Vec<Quantity<Ratio>>>,
    /// Remark, of any form.
    #[serde(default)]
    pub note: Option<Note>,
}

/// How the gears of a set are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Planet {
    /// One planet in mesh with sun and ring.
    Simple,
    /// Two planets in mesh between sun and ring.
    Double,
    /// A stepped planet between a sun and a ring.
    SteppedSunRing,
    /// A stepped planet between two suns.
    SteppedSuns,
    /// A stepped planet between two rings.
    SteppedRings,
    /// Two suns, each with its planet, the planets in mesh.
    MeshingSuns,
    /// Bevel set.
    Bevel,
    /// Two gears outside each other on fixed axes.
    Pair,
    /// A pinion in a ring on fixed axes.
    InternalPair,
}

/// A gear with its published ratio.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PublishedGear {
    /// Name of the gear.
    pub name: String,
    /// Engaged shift elements.
    pub engaged: Vec<String>,
    /// Node where power enters in this gear, if another.
    #[serde(default)]
    pub input: Option<String>,
    /// Node where power leaves in this gear, if another.
    #[serde(default)]
    pub output: Option<String>,
    /// Speeds of links, as many as the gear keeps freedoms: of a power split or summing gear.
    #[serde(default)]
    pub speeds: BTreeMap<String, Quantity<AngularVelocity>>,
    /// Torques at links where power enters or leaves, with `speeds`.
    #[serde(default)]
    pub torques: BTreeMap<String, Quantity<Torque>>,
    /// Input speed over output speed as published, negative in opposite senses.
    pub published_ratio: Number,
    /// Decimals of the published figure, from 0 to 12.
    #[serde(deserialize_with = "few_decimals")]
    #[schemars(range(max = MOST_DECIMALS))]
    pub printed_decimals: u32,
    /// Rounding of the published figure.
    #[serde(default)]
    pub rounding: Rounding,
    /// Whether it is published the other way round, output over input.
    #[serde(default)]
    pub invert: bool,
    /// Whether the figure was not read in the source named.
    #[serde(default)]
    pub unverified: bool,
    /// Remark, of any form.
    #[serde(default)]
    pub note: Option<Note>,
}

/// The most decimals of a published figure.
const MOST_DECIMALS: u32 = 12;

fn few_decimals<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<u32, D::Error> {
    use serde::de::{Error, Unexpected};
    let decimals = u32::deserialize(deserializer)?;
    if decimals > MOST_DECIMALS {
        let due = format!("a whole number from 0 to {MOST_DECIMALS}");
        return Err(D::Error::invalid_value(Unexpected::Unsigned(decimals.into()), &due.as_str()));
    }
    Ok(decimals)
}

/// How a published figure came to its digits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Rounding {
    /// To the nearest.
    #[default]
    Nearest,
    /// Cut off toward zero.
    Truncated,
}

impl PublishedGear {
    /// Whether the published digits stand for this ratio `ω_in/ω_out`.
    ///
    /// Half a unit of the last digit either way, both ends included; a truncated figure stands for the unit
    /// above it in size. The comparison leaves itself 4 ε.
    #[must_use]
    pub fn stands_for(&self, ratio: f64) -> bool {
        let ratio = if self.invert { 1.0 / ratio } else { ratio };
        let published = self.published_ratio.get();
        let unit = 0.1_f64.powi(i32::try_from(self.printed_decimals).unwrap_or(i32::MAX));
        let slack = 4.0 * f64::EPSILON * ratio.abs().max(published.abs());
        match self.rounding {
            Rounding::Nearest => (ratio - published).abs() <= unit / 2.0 + slack,
            Rounding::Truncated => {
                let beyond = (ratio - published) * published.signum();
                beyond >= -slack && beyond < unit - slack
            }
        }
    }
}

impl Transmission {
    /// The transmission as a gearbox.
    ///
    /// # Errors
    /// Each [`DescriptionError`] and each error of the solver that does not follow from another one, with its
    /// path.
    pub fn gearbox(&self) -> Result<Gearbox, Faults> {
        let mut faults = Faults::default();
        let mut link_of: BTreeMap<&str, &str> = BTreeMap::new();
        for (link, members) in &self.links {
            for (place, member) in members.iter().enumerate() {
                let first = *link_of.entry(member).or_insert(link);
                let is_repeated = members[..place].contains(member);
                if first != link || is_repeated {
                    let error = DescriptionError::MemberInTwoLinks {
                        member: member.clone(),
                        first: first.into(),
                        second: link.clone(),
                    };
                    faults.push(Path::root().key("links").key(link).index(place), error);
                }
            }
        }
        let links = self.links.keys().map(String::as_str).filter(|link| *link != GROUND);
        let mut builder = Gearbox::builder(&self.name).links(links).input(&self.input).output(&self.output);
        for (place, set) in self.sets.iter().enumerate() {
            let at = of_set(self.sets.len(), place);
            let spec = faults.below(&at, |faults| set.spec(&link_of, faults));
            builder = builder.set(spec.unwrap_or_else(|| refused(&set.id, set.n_p)));
        }
        for (place, set) in (self.sets.len()..).zip(&self.compound_sets) {
            let node = |member: &str| link_of.get(member).copied();
            let at = of_set(self.sets.len(), place);
            let spec = faults.below(&at, |faults| {
                for (at, key) in set.keys_of_gearboxes() {
                    faults.push(at, DescriptionError::NotListed { set: set.id.clone(), key });
                }
                set.spec(node, None, None, faults)
            });
            builder = builder.compound_set(spec);
        }
        for (id, [first, second]) in &self.shift_elements {
            builder = builder.clutch(id, first, second);
        }
        for (id, [first, second]) in &self.one_way {
            builder = builder.one_way_clutch(id, first, second);
        }
        for gear in &self.gears {
            let PublishedGear { name, engaged, input, output, .. } = gear.clone();
            builder = builder.gear_spec(GearSpec { name, engaged, input, output });
        }
        built(faults, builder.build_all(), |site| self.at(site))
    }

    /// Path of a part of the description.
    fn at(&self, site: Site) -> At {
        match site {
            Site::Gearbox => LISTS_OF_SETS.into(),
            Site::Terminal(which) => Path::root().key(which.to_string()).into(),
            Site::Set(set, part) => at_set(self.sets.len(), &self.compound_sets, set, part),
            Site::ShiftElement(element, end) => {
                let clutches = self.shift_elements.keys().map(|id| ("shift_elements", id));
                let one_way = self.one_way.keys().map(|id| ("one_way", id));
                let path = clutches.chain(one_way).nth(element);
                path.map_or(Path::root(), |(key, id)| Path::root().key(key).key(id).indexed(end)).into()
            }
            Site::Gear(gear, part) => of_gear(gear, part).into(),
            Site::Link(_) | Site::Connection(..) => Path::root().key("links").into(),
        }
    }

    /// The planet bearings of each set that has any. Only compound sets state sizes here.
    ///
    /// # Errors
    /// [`DescriptionError::Set`] for each set with an invalid size.
    pub fn planet_bearings(&self, gearbox: &Gearbox) -> Result<Vec<PlanetBearing>, Faults> {
        let size = |set: &PlanetSet| {
            let entry = self.compound_sets.iter().find(|entry| entry.id == set.id());
            entry.map_or_else(SetSize::default, |entry| entry.size(set, &SetSize::default()))
        };
        super::size::planet_bearings(gearbox, size, |set| of_set(self.sets.len(), set))
    }
}

impl TransmissionSet {
    /// The set; `None` where a fault leaves its ratio or its planets open.
    fn spec(&self, link_of: &BTreeMap<&str, &str>, faults: &mut Faults) -> Option<SetSpec> {
        let missing = |missing| DescriptionError::Missing { set: self.id.clone(), missing };
        let of_set = |source| DescriptionError::of_set(&self.id, source);
        let mut node = |member: Option<&String>, part, what| {
            let Some(member) = member else {
                faults.push(Path::root(), missing(what));
                return NO_LINK;
            };
            let lacks = || DescriptionError::MemberInNoLink { set: self.id.clone(), member: member.clone() };
            let link = link_of.get(member.as_str()).copied().ok_or_else(lacks);
            faults.keep(keys_of_part(part), link).unwrap_or(NO_LINK)
        };
        let kind = match self.planet {
            Planet::Simple => SetKind::Simple,
            Planet::Double => SetKind::DoublePlanet,
            Planet::SteppedSunRing => SetKind::SteppedSunRing,
            Planet::SteppedSuns => SetKind::SteppedSuns,
            Planet::SteppedRings => SetKind::SteppedRings,
            Planet::MeshingSuns => SetKind::MeshingSuns,
            Planet::Bevel => SetKind::Bevel,
            Planet::Pair => SetKind::ExternalPair,
            Planet::InternalPair => SetKind::InternalPair,
        };
        // A planet set names a sun and a ring, or its central gears a and b; a pair its gears.
        let (first, second) = if kind.is_pair() { ("`gear_a`", "`gear_b`") } else { ("`sun`", "`ring`") };
        let one = node(self.sun.as_ref().or(self.gear_a.as_ref()), SetPart::Central(0), first);
        let other = node(self.ring.as_ref().or(self.gear_b.as_ref()), SetPart::Central(1), second);
        let carrier = match kind.is_pair() {
            true => GROUND,
            false => node(self.carrier.as_ref(), SetPart::Carrier, "`carrier`"),
        };
        let (first, second) = if kind.is_pair() { ("`z_a`", "`z_b`") } else { ("`z_s`", "`z_r`") };
        // The first of two keys that is given.
        let mut count = |keys: Keys, given: [Option<u32>; 2]| {
            let teeth = given[0].or(given[1])?;
            Some(faults.keep(keys, ToothCount::new(teeth).map_err(of_set)))
        };
        let teeth =
            [count(&["z_s", "z_a"], [self.z_s, self.z_a]), count(&["z_r", "z_b"], [self.z_r, self.z_b])];
        let planets = [count(&["z_p", "z_pa"], [self.z_p, self.z_pa]), count(&["z_pb"], [self.z_pb, None])];
        for (given, what) in teeth.iter().zip([first, second]) {
            if given.is_none() {
                faults.push(Path::root(), missing(what));
            }
        }
        let loss = losses(&self.id, kind, self.efficiency, self.meshes.as_deref(), faults);
        let spacing = spaced(&self.id, self.spacing, [self.planet_angles.as_deref(), None], faults);
        let members = [one, other, carrier];
        let [first, second] = [teeth[0]??, teeth[1]??];
        let spec = SetSpec::teeth(&self.id, kind, members, first.get(), second.get()).map_err(of_set);
        let mut spec = faults.keep(&["z_r", "z_b"][..], spec)?;
        spec.loss = loss;
        for (planet, given) in [&mut spec.planet, &mut spec.second_planet].into_iter().zip(planets) {
            *planet = match given {
                Some(count) => Some(count?),
                None => None,
            };
        }
        if let Some(count) = self.n_p {
            spec = spec.planet_count(count);
        }
        Some(spec.spaced(spacing))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Document;

    const PAIR: &str = "transmissions:\n- name: pair\n  sets:\n  - {id: P, planet: pair, gear_a: X, gear_b: Y, z_a: 24, z_b: 77}\n  links: {n_x: [X], n_y: [Y]}\n  input: n_x\n  output: n_y\n  gears:\n  - {name: only, engaged: [], published_ratio: -3.20, printed_decimals: 2, rounding: truncated}\n";

    fn read(text: &str) -> Transmission {
        let document = Document::parse_one("t.yaml", text.as_bytes()).unwrap();
        document.read::<TransmissionsFile>().unwrap().transmissions.swap_remove(0)
    }

    #[test]
    fn a_truncated_figure_stands_for_what_was_cut_off() {
        let pair = read(PAIR);
        let ratio = pair.gearbox().unwrap().analyze("only").unwrap().ratio().unwrap();
        assert!(pair.gears[0].stands_for(ratio)); // 77/24 = 3.2083
        let rounded = PublishedGear { rounding: Rounding::Nearest, ..pair.gears[0].clone() };
        assert!(!rounded.stands_for(ratio) && rounded.stands_for(-3.205));
        let inverted = PublishedGear { invert: true, ..rounded };
        assert!(inverted.stands_for(-1.0 / 3.2));
    }

    #[test]
    fn a_published_figure_has_few_decimals() {
        for (decimals, found) in [("13", "13"), ("65536", "65536"), ("4000000000", "4000000000")] {
            let text = PAIR.replace("printed_decimals: 2", &format!("printed_decimals: {decimals}"));
            let document = Document::parse_one("t.yaml", text.as_bytes()).unwrap();
            let error = document.read::<TransmissionsFile>().unwrap_err().to_string();
            let due = format!("the number {found} where a whole number from 0 to 12 is due");
            let place = "t.yaml:9:73: transmissions[0].gears[0].printed_decimals";
            assert_eq!(error, format!("{place}: {due}"));
        }
        assert_eq!(read(&PAIR.replace("decimals: 2", "decimals: 12")).gears[0].printed_decimals, 12);
    }

    #[test]
    fn members_are_in_one_node_each() {
        let twice = read(&PAIR.replace("n_y: [Y]", "n_y: [Y, X]")).gearbox();
        assert_eq!(twice.unwrap_err().name(), "member-in-two-links");
        let nowhere = read(&PAIR.replace("n_y: [Y]", "n_y: [Z]")).gearbox();
        assert_eq!(nowhere.unwrap_err().name(), "member-in-no-link");
        let missing = read(&PAIR.replace(", z_b: 77", "")).gearbox();
        assert_eq!(missing.unwrap_err().to_string(), "set `P`: `z_b` is missing");
    }
}
