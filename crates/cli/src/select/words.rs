//! What the libraries' answers are called in words.

use epicyclic_schemes::catalogue::Reach;
use epicyclic_schemes::standing::Standing;
use epicyclic_schemes::structures::Family;

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
