//! Set of tooth numbers as a gearbox, for its checks and for a file that `analyze`, `draw` and `report` read.

use crate::error::Error;
use crate::teeth::options::Request;
use epicyclic_gears::simple_set::{Member, Mode};
use epicyclic_train::set::SetSpec;
use epicyclic_train::spacing::Spacing;
use epicyclic_train::{GROUND, Gearbox};

/// Name of the set, and of the one gear of the gearbox.
pub(super) const NAME: &str = "1";

/// Links of sun, ring and carrier: a link has the name of its member, and the fixed one is the housing.
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

/// Set as a gearbox without losses, named by the required ratio.
pub(super) fn built(request: &Request, set: SetSpec) -> Result<Gearbox, Error> {
    let (mode, ratio) = (request.simple_mode()?, request.ratio.get());
    let [input, output] = [mode.input(), mode.output()].map(|member| link(mode, member));
    let name = format!("Ratio {ratio} ({mode})");
    // Planets that can be assembled equally spaced are placed so under either bound.
    let set = set.spaced(Spacing::Placed(request.spacing));
    let gearbox = Gearbox::builder(&name).links([input, output]).set(set).input(input).output(output);
    Ok(gearbox.gear(NAME, [] as [&str; 0]).build()?)
}
