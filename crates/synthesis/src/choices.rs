//! Choices of elements, numbered without gaps.

use crate::parts::places;

/// Numbers of choices of elements: `Σ C(place_j, j + 1)` over the places of a choice in rising order.
pub(crate) struct Choices {
    terms: Vec<Vec<usize>>,
}

impl Choices {
    /// Numbering of the choices of `of` things among up to `elements` elements.
    pub(crate) fn new(of: usize, elements: usize) -> Self {
        Self { terms: (1..=of).map(|of| (0..=elements).map(|count| choose(count, of)).collect()).collect() }
    }

    /// Amount that each element adds to the number of a choice as its `place`-th in rising order, from 0.
    pub(crate) fn terms(&self, place: usize) -> &[usize] {
        &self.terms[place]
    }

    /// The number of some elements in rising order, as many as are chosen or fewer.
    pub(crate) fn number(&self, elements: &[usize]) -> usize {
        elements.iter().zip(&self.terms).map(|(element, terms)| terms[*element]).sum()
    }

    /// Calls `visit` with each element of a choice, and the number of the others among the choices of one
    /// less.
    pub(crate) fn for_each_without_one(&self, choice: u64, mut visit: impl FnMut(usize, usize)) {
        // Without its last element a choice has the terms that it had; those after one left out move down by
        // a place.
        let mut others: usize =
            places(choice).skip(1).zip(&self.terms).map(|(next, terms)| terms[next]).sum();
        for (place, element) in places(choice).enumerate() {
            visit(element, others);
            if let Some(next) = places(choice & (!0 << element << 1)).next() {
                others = others + self.terms[place][element] - self.terms[place][next];
            }
        }
    }

    /// Calls `visit` with the number of each choice of some elements, and the choice.
    pub(crate) fn for_each(&self, elements: u64, visit: &mut impl FnMut(usize, u64)) {
        go(&self.terms, elements, 0, 0, visit);
    }

    /// Number of choices of one element less among this number of elements.
    pub(crate) fn count_of_one_less(&self, elements: usize) -> usize {
        choose(elements, self.terms.len() - 1)
    }

    /// Calls `visit` with the number of each choice of one less: without a call a choice where three are
    /// engaged.
    pub(crate) fn for_each_of_one_less(&self, elements: u64, visit: &mut impl FnMut(usize)) {
        if let [first, second, _] = self.terms.as_slice() {
            for high in places(elements) {
                for low in places(elements & !(!0 << high)) {
                    visit(first[low] + second[high]);
                }
            }
            return;
        }
        go(&self.terms[..self.terms.len() - 1], elements, 0, 0, &mut |number, _| visit(number));
    }

    /// Calls `visit` with the number of each choice of some elements: without a call a choice where three are
    /// engaged, as in most gearboxes.
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

fn go(terms: &[Vec<usize>], left: u64, number: usize, chosen: u64, visit: &mut impl FnMut(usize, u64)) {
    let Some((term, rest)) = terms.split_first() else { return visit(number, chosen) };
    let mut candidates = left;
    while candidates != 0 {
        let element = candidates.trailing_zeros() as usize;
        candidates &= candidates - 1;
        go(rest, candidates, number + term[element], chosen | 1 << element, visit);
    }
}

/// Number of choices of `of` things among `count`.
pub(crate) fn choose(count: usize, of: usize) -> usize {
    (0..of).fold(1, |all, place| all * count.saturating_sub(place) / (place + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_are_numbered_without_gaps() {
        for of in 1..=4 {
            let choices = Choices::new(of, 7);
            let (mut numbers, mut again) = (Vec::new(), Vec::new());
            choices.for_each(0b111_1111, &mut |number, choice| {
                assert_eq!(choice.count_ones() as usize, of);
                let elements: Vec<usize> = places(choice).collect();
                assert_eq!(choices.number(&elements), number);
                choices.for_each_without_one(choice, |element, others| {
                    let rest: Vec<usize> = places(choice & !(1 << element)).collect();
                    assert_eq!(choices.number(&rest), others, "{elements:?} without {element}");
                });
                numbers.push(number);
            });
            choices.for_each_number(0b111_1111, |number| again.push(number));
            numbers.sort_unstable();
            again.sort_unstable();
            assert_eq!(numbers, (0..choose(7, of)).collect::<Vec<_>>());
            assert_eq!(numbers, again);
            let mut less = Vec::new();
            choices.for_each_of_one_less(0b101_1011, &mut |number| less.push(number));
            assert_eq!(less.len(), choose(5, of - 1));
        }
    }
}
