//! Links that turn as one piece: a partition under joining.

/// A partition of `0..n`, each part known by its smallest element.
#[derive(Debug, Clone)]
pub struct Groups {
    parent: Vec<usize>,
}

impl Groups {
    /// Every element a part of its own.
    #[must_use]
    pub fn new(count: usize) -> Self {
        Self { parent: (0..count).collect() }
    }

    /// The smallest element of the part that holds `element`.
    #[must_use]
    pub fn root(&self, mut element: usize) -> usize {
        while self.parent[element] != element {
            element = self.parent[element];
        }
        element
    }

    /// Joins two parts; false if they were one already.
    pub fn join(&mut self, first: usize, second: usize) -> bool {
        let (first, second) = (self.root(first), self.root(second));
        self.parent[first.max(second)] = first.min(second);
        first != second
    }
}
