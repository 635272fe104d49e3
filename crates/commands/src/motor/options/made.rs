//! Manufacturing data of a motor, as options with the keys of its file.

use crate::motor::answer::Groups;
use epicyclic_formats::motor::{GapsGroup, MaterialGroup, OilGroup, PortsGroup};
use epicyclic_formats::{Document, Span};
use serde::de::DeserializeOwned;
use std::str::FromStr;

/// Material, oil, gaps, friction, ports.
#[derive(Debug, Clone, Default, clap::Args)]
#[command(next_help_heading = "As made, each with the keys of a file")]
pub struct Made {
    /// Material of the teeth: youngs_modulus, poissons_ratio, contact_limit, root_limit. Default: steel
    /// without limits.
    #[arg(long, value_name = "KEYS")]
    pub material: Option<Group<MaterialGroup>>,

    /// The fluid: viscosity or dynamic_viscosity, density, bulk_modulus, turbulence. 'viscosity: 46 mm²/s,
    /// density: 870 kg/m³'
    #[arg(long, value_name = "KEYS")]
    pub oil: Option<Group<OilGroup>>,

    /// Gaps at each end face: satellites, rotor, rotor_bore, expansion, temperature_rise. 'satellites: 10 µm'
    #[arg(long, value_name = "KEYS")]
    pub gaps: Option<Group<GapsGroup>>,

    /// Coefficient of friction of the flanks, one or from the least to the greatest.
    #[arg(long, value_name = "FROM..TO", allow_hyphen_values = true)]
    pub friction: Option<Span<f64>>,

    /// Ports as made: part, or high and low; dead_volume, discharge, most_trapped. 'part: 0.95'
    #[arg(long, value_name = "KEYS")]
    pub ports: Option<Group<PortsGroup>>,
}

impl Made {
    /// Options of the group, and whether each is given.
    pub(crate) fn given(&self) -> [(&'static str, bool); 5] {
        [
            ("--material", self.material.is_some()),
            ("--oil", self.oil.is_some()),
            ("--gaps", self.gaps.is_some()),
            ("--friction", self.friction.is_some()),
            ("--ports", self.ports.is_some()),
        ]
    }

    /// Groups of a motor file with the same content.
    pub(crate) fn groups(&self) -> Groups {
        Groups {
            material: self.material.as_ref().map(|group| group.0.clone()),
            oil: self.oil.as_ref().map(|group| group.0.clone()),
            gaps: self.gaps.as_ref().map(|group| group.0.clone()),
            friction: self.friction,
            ports: self.ports.as_ref().map(|group| group.0.clone()),
        }
    }
}

/// A group of keys on one line, with braces or without.
#[derive(Debug, Clone)]
pub struct Group<T>(pub T);

impl<T: DeserializeOwned> FromStr for Group<T> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let braced = if text.starts_with('{') { text.to_owned() } else { format!("{{ {text} }}") };
        let read = Document::parse_one("", braced.as_bytes()).and_then(|document| document.read());
        read.map(Self).map_err(|error| {
            let path = &error.at().path;
            if path.is_root() { error.problem().to_string() } else { format!("{path}: {}", error.problem()) }
        })
    }
}
