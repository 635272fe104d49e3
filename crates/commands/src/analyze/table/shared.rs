//! What the tables of gearboxes have in common.

use crate::analyze::answer::records::{Duty, Kind, OneWayClutch, SelfLocking, ShiftElementKind, State};
use crate::shared::records::Fraction;
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::report::Records;

pub(super) fn exact(ratio: Option<Fraction>) -> Figure {
    ratio.map_or(Figure::None, |ratio| Figure::Text(ratio.to_string()))
}

/// A state in a word or two.
pub(super) fn state(state: State) -> Figure {
    let words = match state {
        State::Driven => "driven",
        State::InputBlocked => "input blocked",
        State::OutputAtRest => "output at rest",
        State::OutputFree => "output free",
        State::Underdetermined => "underdetermined",
        State::SpeedsGiven => "given speeds",
        State::TorquesIndeterminate => "torques indeterminate",
        State::SelfLocking => "self-locking",
    };
    Figure::choice(state, words)
}

pub(super) fn self_locking(direction: Option<SelfLocking>) -> Figure {
    direction.map_or(Figure::None, |direction| {
        let words = match direction {
            SelfLocking::No => "no",
            SelfLocking::FromOutput => "from output",
            SelfLocking::FromInput => "from input",
            SelfLocking::BothWays => "both ways",
        };
        Figure::choice(direction, words)
    })
}

/// What a shift element is, in words.
pub(crate) fn kind(kind: ShiftElementKind) -> Figure {
    let words = match kind {
        ShiftElementKind::Brake => "brake",
        ShiftElementKind::Clutch => "clutch",
        ShiftElementKind::OneWayBrake => "one-way brake",
        ShiftElementKind::OneWayClutch => "one-way clutch",
    };
    Figure::choice(kind, words)
}

/// How a set is made, in words.
pub(super) fn kind_in_words(kind: Kind) -> &'static str {
    match kind {
        Kind::Simple => "simple",
        Kind::DoublePlanet => "double planet",
        Kind::SteppedSunRing => "stepped, sun and ring",
        Kind::SteppedSuns => "stepped, two suns",
        Kind::SteppedRings => "stepped, two rings",
        Kind::MeshingSuns => "meshing planets, two suns",
        Kind::Bevel => "bevel",
        Kind::ExternalPair => "external pair",
        Kind::InternalPair => "internal pair",
        Kind::Compound => "compound",
    }
}

/// Whether a shift element is engaged.
pub(super) fn engaged(is_engaged: bool) -> Figure {
    if is_engaged { Figure::answer("true", "engaged") } else { Figure::answer("false", "open") }
}

/// The links that a shift element joins.
pub(super) fn joins(links: &[String; 2]) -> Figure {
    Figure::Text(links.join(" - "))
}

fn duty(duty: Option<Duty>) -> Figure {
    duty.map_or(Figure::None, |duty| {
        let words = match duty {
            Duty::Holds => "holds",
            Duty::Overruns => "overruns",
            Duty::Idles => "idles",
            Duty::WouldOverrun => "would overrun",
            Duty::WouldHold => "would hold",
        };
        Figure::choice(duty, words)
    })
}

/// What the one-way clutches do, in all gears or in one.
pub(super) fn one_way_clutches(clutches: &[OneWayClutch], of_one_gear: bool) -> Records {
    let mut shown = vec!["gear", "clutch", "relied_on", "drive", "coast", "engine_braking"];
    if of_one_gear {
        shown.remove(0);
    }
    Table::new("one_way_clutches", clutches.iter())
        .text("gear", "gear", |one| &one.gear)
        .text("clutch", "clutch", |one| &one.clutch)
        .words("relied_on", "relied on", |one| one.relied_on)
        .words("drive", "on drive", |one| duty(one.drive))
        .words("coast", "on coast", |one| duty(one.coast))
        .words("engine_braking", "engine braking", |one| one.engine_braking)
        .view_of("One-way clutches", &shown)
        .note("Engine braking: of gears that rely on a one-way clutch.")
        .records()
}
