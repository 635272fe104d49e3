//! `synthesize` in shards, in a build without Parquet tables: refused.

use crate::desk::Call;
use crate::failure::Failure;
use crate::synthesize::answer::{Kept, Synthesis, Wanted};
use epicyclic_synthesis::work::Share;
use std::path::{Path, PathBuf};

fn refused(option: &'static str) -> Failure {
    Failure::named("not-in-this-build", option, "this build of the program has no tables of searches")
}

/// Refuses.
pub(crate) fn search(_: &Call<'_>, _: &Wanted, _: Share, _: &Path) -> Result<(), Failure> {
    Err(refused("--shard"))
}

/// Refuses.
pub(crate) fn merged(_: &Call<'_>, _: &Wanted, _: &[PathBuf]) -> Result<(Synthesis, Vec<Kept>), Failure> {
    Err(refused("--merge"))
}
