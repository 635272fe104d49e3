//! Objectives of designs, and whether one is as good as another.

use super::Objective;

/// The objectives as logarithms, each the greater the better; 0 of those that are not asked for.
pub(super) type Value = [f64; Objective::ALL.len()];

/// Values of the designs found.
#[derive(Debug, Clone, Default)]
pub(super) struct Cover {
    values: Vec<Value>,
}

impl Cover {
    pub(super) fn add(&mut self, value: Value) {
        self.values.push(value);
    }

    /// Whether in no objective a value is better than some design's by more than `slack`.
    pub(super) fn is_as_good(&self, value: &Value, slack: f64) -> bool {
        self.values.iter().any(|design| reaches(design, value, slack))
    }

    /// The designs that are as good in some objectives: all that may be so in all.
    pub(super) fn near(&self, value: &Value, slack: f64, objectives: impl Fn(usize) -> bool) -> Self {
        let near =
            |design: &&Value| (0..value.len()).all(|i| !objectives(i) || design[i] + slack >= value[i]);
        Self { values: self.values.iter().filter(near).copied().collect() }
    }
}

fn reaches(design: &Value, value: &Value, slack: f64) -> bool {
    design.iter().zip(value).all(|(design, value)| design + slack >= *value)
}
