//! The error where no design meets every required criterion.

use super::Request;
use crate::failure::Failure;

/// The answer says why; this says it to whoever sees only the end.
pub(super) fn nothing_found(way_out: Option<&String>) -> Failure {
    let way_out = way_out.map(|way| format!("; {way}")).unwrap_or_default();
    Failure::NothingFound(format!("no design meets every required criterion{way_out}"))
}

/// Advice after a search for tooth numbers that found nothing. Without `--teeth` the answer lists the
/// criteria that no design meets.
pub(super) fn with_teeth_more(request: &Request) -> Option<String> {
    let mut more = vec![];
    if !request.speeds.all_structures {
        more.push("--all-structures searches all, not only the source's");
    }
    if request.same_direction {
        more.push("leaving out --same-direction admits outputs that reverse");
    }
    more.push("without --teeth each criterion that stands in the way is told");
    Some(more.join("; "))
}
