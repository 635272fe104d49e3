//! Work on many items: on all threads with the feature `parallel`, else on one. Results come in the order of
//! the items.

use std::ops::ControlFlow;

/// The answer to each item.
#[cfg(feature = "parallel")]
pub fn map<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    use rayon::prelude::*;
    items.par_iter().map(work).collect()
}

/// The answer to each item.
#[cfg(not(feature = "parallel"))]
pub fn map<T, R>(items: &[T], work: impl Fn(&T) -> R) -> Vec<R> {
    items.iter().map(work).collect()
}

/// The answer to each item, which the work may change.
#[cfg(feature = "parallel")]
pub fn map_mut<T: Send, R: Send>(items: &mut [T], work: impl Fn(&mut T) -> R + Sync + Send) -> Vec<R> {
    use rayon::prelude::*;
    items.par_iter_mut().map(work).collect()
}

/// The answer to each item, which the work may change.
#[cfg(not(feature = "parallel"))]
pub fn map_mut<T, R>(items: &mut [T], work: impl Fn(&mut T) -> R) -> Vec<R> {
    items.iter_mut().map(work).collect()
}

/// Items between two questions whether to go on.
const AT_A_TIME: usize = 64;

/// The answer to each item; `None` if `goes_on`, which is called now and then, breaks.
pub fn map_while<T: Sync, R: Send>(
    items: &[T],
    goes_on: &dyn Fn() -> ControlFlow<()>,
    work: impl Fn(&T) -> R + Sync + Send,
) -> Option<Vec<R>> {
    let mut all = Vec::with_capacity(items.len());
    for some in items.chunks(AT_A_TIME) {
        if goes_on().is_break() {
            return None;
        }
        all.extend(map(some, &work));
    }
    Some(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_come_in_the_order_of_the_items_with_threads_and_without() {
        let mut items: Vec<u64> = (0..5000).collect();
        let squares: Vec<u64> = items.iter().map(|item| item * item).collect();
        assert_eq!(map(&items, |item| item * item), squares);
        assert_eq!(
            map_while(&items, &|| ControlFlow::Continue(()), |item| item * item),
            Some(squares.clone())
        );
        assert_eq!(map_while(&items, &|| ControlFlow::Break(()), |item| item * item), None);
        let before = map_mut(&mut items, |item| std::mem::replace(item, *item * *item));
        assert_eq!(before, (0..5000).collect::<Vec<u64>>());
        assert_eq!(items, squares);
    }
}
