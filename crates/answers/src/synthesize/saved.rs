//! A solution as a file that `analyze`, `draw` and `report` read.

use super::Kept;
use epicyclic_formats::gearbox::{NotWritable, written};
use epicyclic_synthesis::teeth::Design;
use epicyclic_train::set::SetSpec;
use epicyclic_train::{Error, GearSpec, Gearbox};

/// The gearbox of a solution under this name, its gears named by their places among the wanted forward gears in falling order, `1`,
/// `2` …, reverse `R`, several `R1`, `R2` …; with tooth numbers in place of the ring-to-sun ratios where some are given.
///
/// # Errors
/// Those of the solver for tooth numbers that no set can have; none are known for those of a search.
pub fn gearbox(kept: &Kept, name: &str, teeth: Option<&Design>) -> Result<Gearbox, Error> {
    let mut names = names(&kept.judged.ratios).into_iter();
    let mut sets = teeth.map(|design| design.sets.iter());
    let with_teeth = |set: SetSpec| match sets.as_mut().and_then(Iterator::next) {
        None => set,
        Some(of) => of.put_into(set),
    };
    kept.judged
        .gearbox
        .to_builder()
        .named(name)
        .map_sets(with_teeth)
        .map_gears(|gear| GearSpec {
            name: names.next().unwrap_or_default(),
            input: None,
            output: None,
            ..gear
        })
        .build()
}

/// The file of a solution, below these lines of comment.
///
/// # Errors
/// None are known: every set of a solution has a short form.
pub fn file(gearbox: &Gearbox, comment: &[String]) -> Result<String, NotWritable> {
    written(gearbox, comment)
}

/// Names of gears with these ratios.
fn names(ratios: &[f64]) -> Vec<String> {
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
