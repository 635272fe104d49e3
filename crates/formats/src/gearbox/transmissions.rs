//! Real transmissions: members joined by nodes, elements between nodes, gears with published ratios.

use super::DescriptionError;
use crate::Number;
use epicyclic_gears::teeth::ToothCount;
use epicyclic_schemes::row::{RowKind, RowSpec};
use epicyclic_schemes::{GROUND, GearSpec, Gearbox};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;

/// A file of transmissions.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TransmissionsFile {
    /// The transmissions.
    pub transmissions: Vec<Transmission>,
}

/// A transmission with what is published of its gears.
///
/// Every node is a link; the node `ground` is the housing.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Transmission {
    /// Its name.
    pub name: String,
    /// Where its data stand.
    #[serde(default)]
    pub source: Option<String>,
    /// The rows, whose members are wheels and carriers.
    pub rows: Vec<TransmissionRow>,
    /// Which members turn as one piece: by node.
    pub nodes: BTreeMap<String, Vec<String>>,
    /// Node where power enters, unless a gear says otherwise.
    pub input: String,
    /// Node where power leaves, unless a gear says otherwise.
    pub output: String,
    /// Brakes and clutches: the two nodes that each joins when engaged.
    #[serde(default)]
    pub elements: BTreeMap<String, [String; 2]>,
    /// The gears.
    pub gears: Vec<PublishedGear>,
}

/// A row of a transmission.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TransmissionRow {
    /// Its name.
    pub id: String,
    /// How its wheels are joined.
    pub planet: Planet,
    /// The sun, of a planetary row.
    #[serde(default)]
    pub sun: Option<String>,
    /// The ring, of a planetary row.
    #[serde(default)]
    pub ring: Option<String>,
    /// The carrier, of a planetary row.
    #[serde(default)]
    pub carrier: Option<String>,
    /// Teeth of the sun.
    #[serde(default)]
    pub z_s: Option<u32>,
    /// Teeth of the ring.
    #[serde(default)]
    pub z_r: Option<u32>,
    /// Teeth of a planet.
    #[serde(default)]
    pub z_p: Option<u32>,
    /// Number of planets.
    #[serde(default)]
    pub n_p: Option<u32>,
    /// First wheel of a pair.
    #[serde(default)]
    pub gear_a: Option<String>,
    /// Second wheel of a pair.
    #[serde(default)]
    pub gear_b: Option<String>,
    /// Teeth of the first wheel of a pair.
    #[serde(default)]
    pub z_a: Option<u32>,
    /// Teeth of the second wheel of a pair.
    #[serde(default)]
    pub z_b: Option<u32>,
    /// Remark.
    #[serde(default)]
    pub note: Option<String>,
}

/// How the wheels of a row are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Planet {
    /// One planet in mesh with sun and ring.
    Simple,
    /// Two planets in mesh between sun and ring.
    Double,
    /// Two wheels outside each other on fixed axes.
    Pair,
}

/// A gear with its published ratio.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PublishedGear {
    /// Its name.
    pub name: String,
    /// Engaged elements.
    pub engaged: Vec<String>,
    /// Node where power enters in this gear, if another.
    #[serde(default)]
    pub input: Option<String>,
    /// Node where power leaves in this gear, if another.
    #[serde(default)]
    pub output: Option<String>,
    /// Input speed over output speed as published, negative in opposite senses.
    pub published_ratio: Number,
    /// Decimals of the published figure, from 0 to 12.
    #[serde(deserialize_with = "few_decimals")]
    #[schemars(range(max = MOST_DECIMALS))]
    pub printed_decimals: u32,
    /// How it came to its digits.
    #[serde(default)]
    pub rounding: Rounding,
    /// Whether it is published the other way round, output over input.
    #[serde(default)]
    pub invert: bool,
    /// Whether the figure was not read in the source named.
    #[serde(default)]
    pub unverified: bool,
    /// Remark.
    #[serde(default)]
    pub note: Option<String>,
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
    /// Half a unit of the last digit either way, both ends included; a truncated figure stands for the unit above it
    /// in size. The comparison leaves itself 4 ε.
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
    /// The transmission as a gearbox, its nodes as links, without losses.
    ///
    /// # Errors
    /// [`DescriptionError`].
    pub fn gearbox(&self) -> Result<Gearbox, DescriptionError> {
        let mut node_of: BTreeMap<&str, &str> = BTreeMap::new();
        for (node, members) in &self.nodes {
            for member in members {
                if let Some(first) = node_of.insert(member, node) {
                    return Err(DescriptionError::MemberInTwoNodes {
                        member: member.clone(),
                        first: first.into(),
                        second: node.clone(),
                    });
                }
            }
        }
        let nodes = self.nodes.keys().map(String::as_str).filter(|node| *node != GROUND);
        let mut builder = Gearbox::builder(&self.name).links(nodes).input(&self.input).output(&self.output);
        for row in &self.rows {
            builder = builder.row(row.spec(&node_of)?);
        }
        for (id, [first, second]) in &self.elements {
            builder = builder.clutch(id, first, second);
        }
        for gear in &self.gears {
            let PublishedGear { name, engaged, input, output, .. } = gear.clone();
            builder = builder.gear_spec(GearSpec { name, engaged, input, output });
        }
        Ok(builder.build()?)
    }
}

impl TransmissionRow {
    fn spec(&self, node_of: &BTreeMap<&str, &str>) -> Result<RowSpec, DescriptionError> {
        let missing = |missing| DescriptionError::Missing { row: self.id.clone(), missing };
        let gears = |source| DescriptionError::Row { row: self.id.clone(), source };
        let node = |member: &Option<String>, what| {
            let member = member.as_deref().ok_or_else(|| missing(what))?;
            node_of.get(member).copied().ok_or_else(|| DescriptionError::MemberInNoNode {
                row: self.id.clone(),
                member: member.into(),
            })
        };
        let kind = match self.planet {
            Planet::Pair => {
                let wheels = [node(&self.gear_a, "`gear_a`")?, node(&self.gear_b, "`gear_b`")?];
                let (a, b) = (self.z_a.ok_or(missing("`z_a`"))?, self.z_b.ok_or(missing("`z_b`"))?);
                return RowSpec::pair(&self.id, wheels, a, b).map_err(gears);
            }
            Planet::Simple => RowKind::Simple,
            Planet::Double => RowKind::DoublePlanet,
        };
        let members =
            [node(&self.sun, "`sun`")?, node(&self.ring, "`ring`")?, node(&self.carrier, "`carrier`")?];
        let (sun, ring) = (self.z_s.ok_or(missing("`z_s`"))?, self.z_r.ok_or(missing("`z_r`"))?);
        let mut spec = RowSpec::teeth(&self.id, kind, members, sun, ring).map_err(gears)?;
        if let Some(planet) = self.z_p {
            spec = spec.planet_teeth(ToothCount::new(planet).map_err(gears)?, None);
        }
        Ok(match self.n_p {
            Some(count) => spec.planet_count(count),
            None => spec,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Document;

    const PAIR: &str = "transmissions:\n- name: pair\n  rows:\n  - {id: P, planet: pair, gear_a: X, gear_b: Y, z_a: 24, z_b: 77}\n  nodes: {n_x: [X], n_y: [Y]}\n  input: n_x\n  output: n_y\n  gears:\n  - {name: only, engaged: [], published_ratio: -3.20, printed_decimals: 2, rounding: truncated}\n";

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
        assert!(matches!(twice, Err(DescriptionError::MemberInTwoNodes { .. })));
        let nowhere = read(&PAIR.replace("n_y: [Y]", "n_y: [Z]")).gearbox();
        assert!(matches!(nowhere, Err(DescriptionError::MemberInNoNode { .. })));
        let missing = read(&PAIR.replace(", z_b: 77", "")).gearbox();
        assert_eq!(missing.unwrap_err().to_string(), "row `P`: `z_b` is missing");
    }
}
