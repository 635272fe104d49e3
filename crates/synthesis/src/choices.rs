//! Choices of elements, numbered.

/// Numbers of choices of elements: `Σ C(place_j, j + 1)` over the places of a choice in rising order.
pub(crate) struct Choices {
    pub(crate) terms: Vec<Vec<usize>>,
}

impl Choices {
    pub(crate) fn new(of: usize, elements: usize) -> Self {
        Self { terms: (1..=of).map(|of| (0..=elements).map(|count| choose(count, of)).collect()).collect() }
    }

    /// Calls `visit` with the number of each choice of some elements, and the choice.
    pub(crate) fn for_each(&self, elements: u64, visit: &mut impl FnMut(usize, u64)) {
        fn go(
            terms: &[Vec<usize>],
            left: u64,
            number: usize,
            chosen: u64,
            visit: &mut impl FnMut(usize, u64),
        ) {
            let Some((term, rest)) = terms.split_first() else { return visit(number, chosen) };
            let mut candidates = left;
            while candidates != 0 {
                let element = candidates.trailing_zeros() as usize;
                candidates &= candidates - 1;
                go(rest, candidates, number + term[element], chosen | 1 << element, visit);
            }
        }
        go(&self.terms, elements, 0, 0, visit);
    }

    /// Calls `visit` with the number of each choice of some elements: without a call a choice where three are engaged, as
    /// in most gearboxes.
    #[inline]
    pub(crate) fn for_each_number(&self, elements: u64, mut visit: impl FnMut(usize)) {
        let [first, second, third] = self.terms.as_slice() else {
            return self.for_each(elements, &mut |number, _| visit(number));
        };
        let mut places = [0; 64];
        let mut count = 0;
        let mut left = elements;
        while left != 0 {
            places[count] = left.trailing_zeros() as usize;
            count += 1;
            left &= left - 1;
        }
        for (top, highest) in places[..count].iter().enumerate() {
            for (middle, next) in places[..top].iter().enumerate() {
                let number = third[*highest] + second[*next];
                for lowest in &places[..middle] {
                    visit(number + first[*lowest]);
                }
            }
        }
    }
}

/// How many choices of so many things there are.
pub(crate) fn choose(count: usize, of: usize) -> usize {
    (0..of).fold(1, |all, place| all * count.saturating_sub(place) / (place + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_are_numbered_without_gaps() {
        let choices = Choices::new(3, 6);
        let mut numbers = Vec::new();
        choices.for_each(0b11_1111, &mut |number, choice| {
            assert_eq!(choice.count_ones(), 3);
            numbers.push(number);
        });
        numbers.sort_unstable();
        assert_eq!(numbers, (0..20).collect::<Vec<_>>());
    }
}
