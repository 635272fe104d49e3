//! What the libraries' answers are called in words.

use epicyclic_schemes::catalogue::Reach;
use epicyclic_schemes::standing::Standing;
use epicyclic_schemes::structures::Family;
use epicyclic_selection::drawing::DRAWN_K;
use epicyclic_selection::{Evidence, Mechanism, NotDrawable, Obstacle, Unreachable};

/// Why the source has a structure, or has it not.
pub(super) fn standing(standing: Standing) -> String {
    match standing {
        Standing::Listed(scheme) => format!("scheme {scheme}"),
        Standing::Unlisted { first, second, .. } if standing.is_missed() => {
            format!("missed by the document: gear 1 gives {}, gear 2 {}", reach(first), reach(second))
        }
        Standing::Unlisted { second, .. } => format!("out of reach: gear 2 gives {}", reach(second)),
        Standing::Reversed { of } => format!("equal to {of} with D and B exchanged"),
        Standing::OutsideRule { family: Family::Parallel } => {
            "outside the document's rule: set 2 ties T2, not T1, to D and B, and works alone".to_owned()
        }
        Standing::OutsideRule { .. } => {
            "outside the document's rule: no set has both D and B, the sets work in series".to_owned()
        }
    }
}

/// The values that a ratio takes.
fn reach(reach: Reach) -> String {
    match reach {
        Reach::Between { least, greatest } => format!("{least:.3} to {greatest:.3}"),
        Reach::ThroughZero { least, greatest } => format!("{least:.3} to {greatest:.3}, 0 included"),
        Reach::ThroughInfinity { below, above } => format!("below {below:.3} and above {above:.3}"),
    }
}

/// Where the worst value of a criterion is, or what speaks for or against a yes or no.
pub(super) fn evidence(mechanism: Mechanism, evidence: &Evidence) -> String {
    match evidence {
        Evidence::Gear(gear) => format!("gear {}", gear.name()),
        Evidence::Set(set) => format!("set {}", set + 1),
        Evidence::Link { role, gear } => format!("{role} in gear {}", gear.name()),
        Evidence::Planet { set, gear } => format!("planet {} in gear {}", set + 1, gear.name()),
        Evidence::DirectClutch([one, other]) => format!("{one}–{other}"),
        Evidence::NoDirectClutch => "no direct-drive clutch".to_owned(),
        Evidence::AllForward => "all gears forward".to_owned(),
        Evidence::Backward(gears) => {
            let gears: Vec<&str> = gears.iter().map(|gear| gear.name()).collect();
            format!("gears {} turn against direct drive", gears.join(", "))
        }
        Evidence::Drawable { direct_clutches } => {
            format!("drawn, {direct_clutches} options for the direct-drive clutch")
        }
        Evidence::NotDrawable(why) => not_drawable(mechanism, why),
    }
}

fn not_drawable(mechanism: Mechanism, why: &NotDrawable) -> String {
    match why {
        NotDrawable::Gearbox(error) => error.to_string(),
        NotDrawable::SelfCrossing(witness) => match mechanism.without_direct_clutch(DRAWN_K) {
            Ok(gearbox) => witness.describe(&gearbox),
            Err(error) => error.to_string(),
        },
        NotDrawable::NoDirectClutch => "no direct-drive clutch can be drawn with the rest".to_owned(),
    }
}

/// Why a mechanism cannot give the ratios.
pub(super) fn obstacle(one: &Unreachable) -> String {
    match &one.obstacle {
        Obstacle::Infinite => "a set would need an infinite k".to_owned(),
        Obstacle::TooSmall(sets) => {
            let k = |set: &usize| one.needed.as_ref().and_then(|needed| needed.get(*set)).copied();
            let needed: Vec<String> =
                sets.iter().filter_map(|set| Some(format!("k{} = {:.3}", set + 1, k(set)?))).collect();
            format!("{} needed, and k of a simple set is above 1", needed.join(" and "))
        }
    }
}
