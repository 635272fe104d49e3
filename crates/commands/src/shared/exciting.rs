//! Options of what excites the vibration of a gearbox.

use crate::error::Error;
use crate::failure::Failure;
use crate::shared::gearbox_choice::refuse;
use crate::shared::places::Places;
use epicyclic_units::Quantity as Given;
use uom::si::f64::{AngularVelocity, Length, Ratio};

/// Options of the excitation of a vibration and of its speeds. The file may state those that are not given.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Exciting {
    /// Resonances and frequencies over these speeds of the input: 500rpm..3000rpm/11, both ends and how many
    /// places.
    #[arg(long, value_name = "FROM..TO/PLACES", allow_hyphen_values = true)]
    pub speeds: Option<Places<AngularVelocity>>,

    /// How many harmonics of the meshes. Default: 3.
    #[arg(long, value_name = "COUNT")]
    pub harmonics: Option<u32>,

    /// Transmission error of the meshes, harmonics from the first: 3um,1um. Tells the forces that it makes.
    #[arg(long, value_name = "AMPLITUDES", value_delimiter = ',', allow_hyphen_values = true)]
    pub transmission_error: Vec<Given<Length>>,

    /// The same of the ring's meshes, where it is another.
    #[arg(long, value_name = "AMPLITUDES", value_delimiter = ',', allow_hyphen_values = true)]
    pub ring_transmission_error: Vec<Given<Length>>,

    /// Damping ratio of every mode, such as 0.03 or 3%.
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true)]
    pub damping: Option<Given<Ratio>>,

    /// These forces without the gyroscopic effect of the carrier's speed.
    #[arg(long)]
    pub without_gyroscopic: bool,

    /// Modes of the whole gearbox in the plane, with all sets on common links.
    #[arg(long)]
    pub coupled: bool,
}

impl Exciting {
    /// An option that is given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let all = [
            ("--speeds", self.speeds.is_some()),
            ("--harmonics", self.harmonics.is_some()),
            ("--transmission-error", !self.transmission_error.is_empty()),
            ("--ring-transmission-error", !self.ring_transmission_error.is_empty()),
            ("--damping", self.damping.is_some()),
            ("--without-gyroscopic", self.without_gyroscopic),
            ("--coupled", self.coupled),
        ];
        all.into_iter().find(|(_, is_given)| *is_given).map(|(option, _)| option)
    }

    /// Converts an error to a failure with the option that caused it.
    pub(crate) fn refuse(error: Error) -> Failure {
        let option = match &error {
            Error::Harmonics { .. } => "--harmonics",
            Error::DampingRatio { .. } => "--damping",
            Error::TransmissionError { .. } => "--transmission-error",
            Error::ExcitationWithout { given: "harmonics", .. } => "--harmonics",
            Error::ExcitationWithout { given: "damping", .. } => "--damping",
            Error::ExcitationWithout { given: "without-gyroscopic", .. } => "--without-gyroscopic",
            Error::ExcitationWithout { given: "ring-transmission-error", .. } => "--ring-transmission-error",
            Error::ExcitationWithout { .. } => "--transmission-error",
            _ => return refuse(error),
        };
        let message = match &error {
            Error::ExcitationWithout { lacks, .. } => {
                format!("it needs {lacks}, as an option or as a key of `vibration` of the file")
            }
            error => error.to_string(),
        };
        Failure::named(error.name(), option, message)
    }
}
