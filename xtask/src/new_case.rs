//! placeholder
/// a
#[derive(Debug, clap::Args)]
pub struct Arguments {}
/// run
pub fn run(_: &Arguments) -> Result<std::process::ExitCode, String> {
    Err("".into())
}
