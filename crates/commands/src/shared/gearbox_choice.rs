//! Options that choose a gearbox: a file, a scheme or a structure, and what is refused of them.

use crate::analyze::answer::{self as answers, LoadQuantity, inputs::Given};
use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::shared::gearbox::{self, Gearbox};
use crate::shared::named_gearbox::{self as named, Sizes};
use crate::shared::options::efficiency;
use epicyclic_train::{self as train, Analysis};
use epicyclic_units::Quantity;
use std::path::Path;
use uom::si::f64::Ratio;

/// Options that choose a gearbox.
#[derive(Debug, clap::Args)]
pub(crate) struct Choice {
    /// The file, in YAML, or - for standard input; or a scheme of the catalogue (I … III-3) or a structure
    /// (D.T1.B+T2.B.T1) by its name.
    #[arg(value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    gearbox: String,

    #[command(flatten)]
    sizes: Sizes,

    /// One transmission of a list: its name, or a part that no other name has.
    #[arg(long, value_name = "NAME")]
    transmission: Option<String>,

    /// Efficiency with the carrier fixed of each set for which the file states no losses: 0.97 or 97%. Of a
    /// compound set each mesh takes its square root.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    efficiency: Option<Quantity<Ratio>>,
}

impl Choice {
    /// An option that is given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let transmission = self.transmission.as_ref().map(|_| "--transmission");
        transmission.or(self.efficiency.map(|_| "--efficiency")).or(self.sizes.given())
    }

    /// Refuses an efficiency where no losses are shown.
    pub(crate) fn no_efficiency(&self, message: &str) -> Result<(), Failure> {
        match self.efficiency {
            Some(_) => Err(Failure::conflict("--efficiency", message)),
            None => Ok(()),
        }
    }

    /// The file, as it was named.
    pub(crate) fn file(&self) -> &Path {
        Path::new(&self.gearbox)
    }

    /// The document of the gearbox, its text, and whether the sizes in it are known.
    pub(crate) fn document(&self, call: &Call<'_>, any_size_will_do: bool) -> Result<named::Read, Failure> {
        named::document(call, &self.gearbox, self.sizes, self.efficiency, any_size_will_do)
    }

    /// The gearbox; a list of several transmissions is refused without a choice of one.
    pub(crate) fn gearbox(&self, call: &Call<'_>) -> Result<Gearbox, Failure> {
        subject(self, &self.document(call, false)?)
    }

    pub(crate) fn question(&self) -> Result<gearbox::Choice, Failure> {
        let efficiency = self.efficiency.map(efficiency).transpose()?;
        Ok(gearbox::Choice { transmission: self.transmission.clone(), efficiency })
    }
}

/// Names to choose from, each on a line of its own.
pub(crate) fn below_each_other<'n>(names: impl IntoIterator<Item = &'n str>) -> String {
    names.into_iter().map(|name| format!("\n  {name}")).collect()
}

/// Converts an error to a failure with the option that caused it.
pub(crate) fn refuse(error: Error) -> Failure {
    let listed = |names: &[String]| below_each_other(names.iter().map(String::as_str));
    let (option, message) = match &error {
        Error::OneGearbox => ("--transmission", "this is one gearbox; leave the option out".to_owned()),
        Error::SeveralTransmissions { names } => {
            ("--transmission", format!("the file has {}; name one of{}", names.len(), listed(names)))
        }
        Error::NoTransmission { name, names } => {
            ("--transmission", format!("no name in the file has `{name}` in it; there are{}", listed(names)))
        }
        Error::AmbiguousTransmission { name, names } => (
            "--transmission",
            format!("`{name}` is part of several names; write more of one of{}", listed(names)),
        ),
        Error::NoGear { .. } => ("--gear", error.to_string()),
        Error::ProgressionFactor { .. } => ("--progression", error.to_string()),
        Error::Load { quantity: LoadQuantity::Torque, .. } => ("--torque", error.to_string()),
        Error::Load { quantity: LoadQuantity::Power, .. } => ("--power", error.to_string()),
        Error::NoLink { given, .. } | Error::Inputs { given, .. } => {
            let option = match given {
                Given::Speeds => "--speeds",
                Given::Torques => "--torques",
                Given::Map => "--map",
            };
            (option, error.to_string())
        }
        _ => return error.into(),
    };
    Failure::named(error.name(), option, message)
}

/// Reads the gearbox of a document; refuses a list of several transmissions without a choice of one.
pub(crate) fn subject(choice: &Choice, read: &named::Read) -> Result<Gearbox, Failure> {
    let mut gearbox = gearbox::one(&read.document, &choice.question()?).map_err(refuse)?;
    (gearbox.origin, gearbox.is_sized) = (read.origin, read.is_sized);
    Ok(gearbox)
}

/// The analysis of a gear that `--gear` names.
pub(crate) fn analysis<'g>(gearbox: &'g train::Gearbox, gear: &str) -> Result<Analysis<'g>, Failure> {
    answers::analysis(gearbox, gear).map_err(refuse)
}
