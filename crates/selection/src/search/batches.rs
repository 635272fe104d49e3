//! The pairs of a patch in pieces of work.

use super::patch::Patch;

/// Strips of `k₂` in one piece of work, and pairs, unless a single strip has more.
const PIECE: usize = 128;
const PIECE_PAIRS: u64 = 1 << 18;

/// Pairs tried before their contenders are put together.
const BATCH_PAIRS: u64 = 1 << 21;

/// Strips in pieces, and these in batches.
pub(super) fn batches(strips: &[[u32; 3]]) -> Vec<Vec<&[[u32; 3]]>> {
    let (mut found, mut batch, mut in_batch) = (vec![], vec![], 0);
    let mut rest = strips;
    while !rest.is_empty() {
        let (mut count, mut pairs) = (0, 0);
        while count < rest.len().min(PIECE) {
            let more = Patch::pairs(&rest[count..=count]);
            if count > 0 && pairs + more > PIECE_PAIRS {
                break;
            }
            (count, pairs) = (count + 1, pairs + more);
        }
        let (piece, after) = rest.split_at(count);
        rest = after;
        if !batch.is_empty() && in_batch + pairs > BATCH_PAIRS {
            found.push(std::mem::take(&mut batch));
            in_batch = 0;
        }
        batch.push(piece);
        in_batch += pairs;
    }
    if !batch.is_empty() {
        found.push(batch);
    }
    found
}
