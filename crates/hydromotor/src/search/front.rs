//! The Pareto front of the objectives, and which of its members covers a point.

use super::objective::Objective;

/// Number of objectives.
const COUNT: usize = Objective::ALL.len();

/// The objectives as logarithms, each the greater the better, in the order of [`Objective::ALL`]; 0 for those
/// not requested.
pub(super) type Value = [f64; COUNT];

/// Indices of the values that no other dominates, ascending; equal values are together.
pub(super) fn front(values: &[Value]) -> Vec<usize> {
    let costs: Vec<Value> = values.iter().map(|value| value.map(|part| -part)).collect();
    epicyclic_numerics::front::non_dominated(&costs).into_iter().map(|place| place as usize).collect()
}

/// Members in falling order of the first objective.
#[derive(Debug, Clone)]
pub(super) struct Cover {
    values: Vec<Value>,
}

impl Cover {
    pub(super) fn new(mut values: Vec<Value>) -> Self {
        values.sort_by(|one, other| other[0].total_cmp(&one[0]));
        Self { values }
    }

    pub(super) fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether some member is nowhere worse than a value by more than `slack`.
    pub(super) fn covers(&self, value: Value, slack: f64) -> bool {
        let end = self.values.partition_point(|member| member[0] >= value[0] - slack);
        self.values[..end].iter().any(|member| excess(value, *member) <= slack)
    }

    /// The member that a value exceeds least, its index in falling order, and the excess in each objective;
    /// `None` if a member is nowhere worse.
    pub(super) fn nearest(&self, value: Value) -> Option<(usize, Value)> {
        if self.covers(value, 0.0) {
            return None;
        }
        let members = self.values.iter().enumerate();
        let of = |(index, member): (usize, &Value)| (index, excess(value, *member));
        let (index, _) = members.map(of).reduce(|best, other| if other.1 < best.1 { other } else { best })?;
        Some((index, std::array::from_fn(|i| (value[i] - self.values[index][i]).max(0.0))))
    }
}

/// Largest amount by which a value exceeds a member in an objective.
fn excess(value: Value, member: Value) -> f64 {
    (0..COUNT).map(|i| value[i] - member[i]).fold(f64::NEG_INFINITY, f64::max)
}

/// Selects members of one set of numbers that differ by more than `resolution` in some objective, by falling
/// first objective. Each one left out is within `resolution` of one kept. The best in every objective are
/// kept.
pub(super) fn apart(values: &[Value], resolution: f64) -> Vec<usize> {
    let best =
        |i: usize| (0..values.len()).reduce(|best, k| if values[k][i] > values[best][i] { k } else { best });
    // An objective in which all are equal has no best.
    let differ = |i: &usize| values.iter().any(|value| value[*i].total_cmp(&values[0][*i]).is_ne());
    let mut kept: Vec<usize> = (0..COUNT).filter(differ).filter_map(best).collect();
    for k in 0..values.len() {
        let near = |other: &usize| (0..COUNT).all(|i| (values[k][i] - values[*other][i]).abs() <= resolution);
        if !kept.iter().any(near) {
            kept.push(k);
        }
    }
    kept.sort_unstable();
    kept.dedup();
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn dominates(one: &Value, other: &Value) -> bool {
        (0..COUNT).all(|i| one[i] >= other[i]) && one != other
    }

    fn values() -> impl Strategy<Value = Vec<Value>> {
        // Few levels, for many ties.
        prop_oneof![
            proptest::collection::vec(
                proptest::array::uniform5(0..5_u8).prop_map(|value| value.map(f64::from)),
                0..120
            ),
            proptest::collection::vec(proptest::array::uniform5(0.0..1.0), 0..120),
            // Three of them asked for.
            proptest::collection::vec(
                [0.0..1.0, 0.0..1.0, 0.0..1.0].prop_map(|[a, b, c]| [a, b, c, 0.0, 0.0]),
                0..120
            ),
        ]
    }

    proptest! {
        #[test]
        fn the_front_is_what_nothing_dominates(values in values()) {
            let naive: Vec<usize> =
                (0..values.len()).filter(|&k| !values.iter().any(|other| dominates(other, &values[k]))).collect();
            prop_assert_eq!(front(&values), naive);
        }

        #[test]
        fn what_is_left_out_lies_near_what_is_kept(values in values(), resolution in 0.0..0.3) {
            let kept = apart(&values, resolution);
            let near = |one: &Value, other: &Value| (0..COUNT).all(|i| (one[i] - other[i]).abs() <= resolution);
            for value in &values {
                prop_assert!(kept.iter().any(|&k| near(value, &values[k])));
            }
            let best = |i: usize, value: &Value| values.iter().all(|other| other[i] <= value[i]);
            for i in 0..COUNT {
                prop_assert!(values.is_empty() || kept.iter().any(|&k| best(i, &values[k])));
            }
            // Beside the best in each objective nothing is near anything.
            let is_asked = |i: &usize| values.iter().any(|value| value[*i] != values[0][*i]);
            let others = |k: &&usize| (0..COUNT).filter(is_asked).all(|i| !best(i, &values[**k]));
            for &one in kept.iter().filter(others) {
                prop_assert!(kept.iter().all(|&other| one == other || !near(&values[one], &values[other])));
            }
        }

        #[test]
        fn the_nearest_member_is_that_of_trial(values in values(), value in proptest::array::uniform5(0.0..4.0)) {
            let cover = Cover::new(values.clone());
            let excess = |member: &Value| (0..COUNT).map(|i| value[i] - member[i]).fold(f64::NEG_INFINITY, f64::max);
            let least = values.iter().map(excess).fold(f64::INFINITY, f64::min);
            match cover.nearest(value) {
                Some((_, found)) => {
                    prop_assert!(least > 0.0 && found.iter().copied().fold(0.0, f64::max) == least);
                    prop_assert!(cover.covers(value, least * (1.0 + 1e-12)) && !cover.covers(value, 0.5 * least));
                }
                None => prop_assert!(values.is_empty() || least <= 0.0),
            }
        }
    }
}
