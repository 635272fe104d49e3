//! Chebyshev's count of the freedoms of a plane mechanism.

/// Mobility of a plane mechanism from the count of its links and pairs (Chebyshev).
///
/// ```text
/// W = 3·n − 2·P₅ − P₄
/// ```
///
/// | symbol | argument | meaning |
/// |---|---|---|
/// | `n` | `moving_links` | moving links, the housing not counted |
/// | `P₅` | `lower_pairs` | pairs that leave one freedom: bearings |
/// | `P₄` | `higher_pairs` | pairs that leave two: meshes |
///
/// Planets that only share the load are redundant and counted once. Being a count, `W` is blind to
/// special dimensions: the [state](crate::state) of a gear is taken from rank, not from here.
///
/// ```
/// use epicyclic_train::mobility::mobility;
/// assert_eq!(mobility(4, 4, 2), 2); // three-link differential: sun, ring, carrier, planet
/// assert_eq!(mobility(5, 5, 3), 2); // four-link differential
/// assert_eq!(mobility(3, 3, 2), 1); // with one link stopped
/// ```
///
/// # Source
/// multispeed-gearboxes, section 1.3.
#[must_use]
pub fn mobility(moving_links: u32, lower_pairs: u32, higher_pairs: u32) -> i64 {
    3 * i64::from(moving_links) - 2 * i64::from(lower_pairs) - i64::from(higher_pairs)
}

#[cfg(test)]
mod tests {
    use super::mobility;

    #[test]
    fn a_truss_has_less_than_none() {
        assert_eq!(mobility(2, 3, 0), 0);
        assert_eq!(mobility(0, u32::MAX, 0), -2 * i64::from(u32::MAX));
    }
}
