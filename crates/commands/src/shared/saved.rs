//! Names of gears in the files that are written of designs found.

/// Names of gears with these ratios: forward gears by their places in falling order, `1`, `2` …, reverse `R`,
/// several `R1`, `R2` ….
pub(crate) fn names(ratios: &[f64]) -> Vec<String> {
    let reverse = ratios.iter().filter(|ratio| **ratio < 0.0).count();
    let before = |gear: usize, is_first: &dyn Fn(f64, f64) -> bool| {
        1 + ratios.iter().filter(|other| is_first(**other, ratios[gear])).count()
    };
    (0..ratios.len())
        .map(|gear| match ratios[gear] > 0.0 {
            true => before(gear, &|other, this| other > this).to_string(),
            false if reverse == 1 => "R".to_owned(),
            false => format!("R{}", before(gear, &|other, this| other < this)),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gears_are_numbered_in_falling_order_and_reverse_is_r() {
        assert_eq!(names(&[1.0, 3.0, -2.0, 0.7]), ["2", "1", "R", "3"]);
        assert_eq!(names(&[-2.0, 3.0, -4.0]), ["R2", "1", "R1"]);
    }
}
