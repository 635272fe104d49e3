//! The command `atlas`: all gearboxes of two and three sets as tables.

use crate::desk::Call;
use crate::failure::Failure;
use epicyclic_tables::atlas::{Table, atlas, classes};
use std::path::PathBuf;

/// All gearboxes of two and three simple planet sets as Parquet tables: structures, gears, and ratios as
/// functions.
///
/// No ratios are asked for: every structure is there, with every set of engaged shift elements that drives
/// the output. Two sets with four and five links, and three sets with five, of class all sparse; three sets
/// with six and seven links of class core.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// Folder for the tables, made if it is not there. Each is written whole, all of them or none.
    #[arg(short, long, value_name = "FOLDER", value_hint = clap::ValueHint::DirPath)]
    output: PathBuf,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let folder = &args.output;
    let made = call.desk.make_folder(folder);
    made.map_err(|source| Failure::Write { file: folder.clone(), source })?;
    let classes = classes().map_err(crate::error::Error::from)?;
    let made = atlas(&classes, env!("CARGO_PKG_VERSION"), &|| call.goes_on())?;
    let tables = [("structures", made.structures), ("functions", made.functions), ("gears", made.gears)];
    let mut told = String::new();
    let mut files = Vec::new();
    for (name, Table { bytes, rows }) in tables {
        let file = folder.join(name).with_extension("parquet");
        told += &format!("{}: {rows} rows, {} bytes\n", file.display(), bytes.len());
        files.push((file, bytes));
    }
    call.write(&files)?;
    call.say(&told)
}
