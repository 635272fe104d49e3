//! A set of tooth numbers as a gearbox, to be checked, and to be written as a file that `analyze`, `draw` and
//! `report` read.

use crate::error::Error;
use epicyclic_gears::simple_set::{Member, Mode};
use epicyclic_gears::synthesis::Placement;
use epicyclic_train::set::SetSpec;
use epicyclic_train::spacing::Spacing;
use epicyclic_train::{GROUND, Gearbox};

/// Name of the set, and of the one gear of the gearbox.
pub(super) const NAME: &str = "1";

/// Links of sun, ring and carrier: a link is its member, and the one at rest is the housing.
pub(super) fn members(mode: Mode) -> [&'static str; 3] {
    Member::ALL.map(|member| link(mode, member))
}

fn link(mode: Mode, member: Member) -> &'static str {
    match member {
        of if of == mode.fixed() => GROUND,
        Member::Sun => "sun",
        Member::Ring => "ring",
        Member::Carrier => "carrier",
    }
}

/// A set as a gearbox without losses, named by the ratio that was asked for.
pub(super) fn built(mode: Mode, ratio: f64, placement: Placement, set: SetSpec) -> Result<Gearbox, Error> {
    let [input, output] = [mode.input(), mode.output()].map(|member| link(mode, member));
    let name = format!("Ratio {ratio} ({mode})");
    // Where planets at equal angles assemble, they stand there under either bound.
    let set = set.spaced(Spacing::Placed(placement));
    let gearbox = Gearbox::builder(&name).links([input, output]).set(set).input(input).output(output);
    Ok(gearbox.gear(NAME, [] as [&str; 0]).build()?)
}
