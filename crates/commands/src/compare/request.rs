//! The command `compare`: gearboxes side by side.

use crate::compare::answer::page::drawn;
use crate::compare::answer::{self as answers, Candidate, Comparison};
use crate::desk::Call;
use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::shared::gearbox::{self, Gearbox};
use crate::shared::named_gearbox::{self as named, Read, Sizes};
use crate::shared::options::efficiency;
use crate::shared::page_options::{self as imprint, PageArgs};
use crate::shared::{gearbox_choice::refuse, load::Load};
use epicyclic_units::Quantity;
use std::path::Path;
use uom::si::f64::Ratio;

/// Gearboxes side by side: ratios, steps, spread, efficiency, torques and slips of shift elements, speeds,
/// circulating power, parts.
///
/// Differences are counted from the first. Gears stand beside each other by their names where these are the
/// same in all gearboxes, with their ratios in the same order; else by their ratios. With a speed and a load
/// of the input they are compared at it, too. Of a list of transmissions those are compared that
/// --transmission names. Schemes and structures by their names take the sizes that are given, all the same.
/// With --output and a name that ends in .html the answer is a page with the schemes.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// Files in YAML, - for standard input, and schemes (I … III-3) or structures (D.T1.B+T2.B.T1) by their
    /// names.
    #[arg(value_name = "GEARBOX", required = true, value_hint = clap::ValueHint::FilePath)]
    gearboxes: Vec<String>,

    #[command(flatten)]
    sizes: Sizes,

    /// A transmission of the lists among the files: its name, or a part that no other name has; again for
    /// each further one.
    #[arg(long = "transmission", value_name = "NAME")]
    transmissions: Vec<String>,

    /// Efficiency with the carrier fixed of each set for which the file states no losses: 0.97 or 97%. Of a
    /// compound set each mesh takes its square root.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    efficiency: Option<Quantity<Ratio>>,

    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    page: PageArgs,

    #[command(flatten)]
    output: OutputArgs,
}

/// Request for a comparison of gearboxes.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Request {
    /// Speed and load of the input, equal for all gearboxes.
    #[command(flatten)]
    pub load: Load,
}

impl Request {
    /// Compares two or more gearboxes; differences are taken from the first.
    ///
    /// # Errors
    /// - [`Failure::Option`] for fewer than two gearboxes, and for an invalid load.
    /// - [`Failure::Answer`] for a gearbox with too many gears.
    pub fn answer(&self, candidates: &[Candidate<'_>]) -> Result<Comparison, Failure> {
        if candidates.len() < 2 {
            let names: Vec<&str> = candidates.iter().map(|candidate| candidate.from.as_str()).collect();
            let message = format!("{}: two gearboxes at least are due to be compared", names.join(" "));
            return Err(Failure::invalid("GEARBOX", message));
        }
        answers::answer(candidates, self.load.input()).map_err(refuse)
    }
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    once(args)?;
    args.page.only_of_a_page(args.output.is_page())?;
    let is_named = |name: &String| !input::exists(call, Path::new(name));
    // Sizes are for those that are named; where none is, the files say why they take none.
    let sizes = |name: &String| {
        if is_named(name) || !args.gearboxes.iter().any(is_named) { args.sizes } else { Sizes::default() }
    };
    let read: Vec<Read> = args
        .gearboxes
        .iter()
        .map(|name| named::document(call, name, sizes(name), args.efficiency, false))
        .collect::<Result<_, _>>()?;
    let eta = args.efficiency.map(efficiency).transpose()?;
    let choice = |transmission| gearbox::Choice { transmission, efficiency: eta };
    let mut subjects: Vec<(Gearbox, &String)> = vec![];
    let mut has_list = false;
    for (Read { document, .. }, name) in read.iter().zip(&args.gearboxes) {
        let is_list = document.value().get("transmissions").is_some();
        has_list |= is_list;
        if is_list && !args.transmissions.is_empty() {
            for transmission in &args.transmissions {
                let choice = choice(Some(transmission.clone()));
                subjects.push((gearbox::one(document, &choice).map_err(refuse)?, name));
            }
            continue;
        }
        subjects.push((gearbox::one(document, &choice(None)).map_err(refuse)?, name));
    }
    if !args.transmissions.is_empty() && !has_list {
        let message = "no file here is a list of transmissions; leave it out".to_owned();
        return Err(Failure::conflict("--transmission", message));
    }
    let candidates: Vec<Candidate<'_>> =
        subjects.iter().map(|(subject, from)| Candidate { subject, from: (*from).clone() }).collect();
    let answer = args.request.answer(&candidates)?;
    if !args.output.is_page() {
        return args.output.deliver(call, &answer);
    }
    let sheet = crate::compare::page::sheet(&answer, &drawn(&candidates), imprint::command(call));
    args.output.deliver_page(call, vec![], &answer, sheet, &args.page.imprint())
}

/// Standard input is read to its end once.
fn once(args: &Args) -> Result<(), Failure> {
    let from_input = args.gearboxes.iter().filter(|name| input::is_standard_input(Path::new(name)));
    if from_input.count() > 1 {
        let message = "standard input is one gearbox; write - once".to_owned();
        return Err(Failure::invalid("GEARBOX", message));
    }
    Ok(())
}
