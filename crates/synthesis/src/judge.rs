//! What a solution is worth: shifts, efficiency by the solver, how near its ratios come.

use crate::gearbox::gearbox;
use crate::motion::Element;
use crate::refine::{Refined, refine};
use crate::run::Found;
use crate::search::Wish;
use crate::tolerance::CONFIRMED;
use epicyclic_gears::efficiency::MeshEfficiency;
#[cfg(feature = "parallel")]
use rayon::iter::{IntoParallelRefIterator as _, ParallelIterator as _};

/// A solution with its best ring-to-sun ratios, judged.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// Best `k`, ranges, greatest deviation.
    pub refined: Refined,
    /// For each gear the elements that it engages, by their places: of the choices with its ratio those with the fewest
    /// exchanges between neighbouring gears.
    pub engaged: Vec<Vec<usize>>,
    /// How many shifts between neighbouring forward gears exchange more than one element.
    pub multiple_shifts: usize,
    /// For each gear the ratio by the solver.
    pub ratios: Vec<f64>,
    /// For each gear the efficiency by the solver; nothing where its losses leave it none.
    pub efficiencies: Vec<Option<f64>>,
}

impl Judged {
    /// The least efficiency of a gear; 0 where a gear has none.
    #[must_use]
    pub fn least_efficiency(&self) -> f64 {
        self.efficiencies.iter().map(|efficiency| efficiency.unwrap_or(0.0)).fold(1.0, f64::min)
    }
}

/// Judges all solutions of a wish, in their order: on all threads of the pool with the feature `parallel`.
///
/// # Errors
/// Those of [`judge`].
///
/// # Panics
/// As [`judge`].
pub fn judge_all(
    found: &[Found],
    wish: &Wish,
    mesh_efficiency: MeshEfficiency,
) -> Result<Vec<Judged>, epicyclic_train::Error> {
    #[cfg(feature = "parallel")]
    let found = found.par_iter();
    #[cfg(not(feature = "parallel"))]
    let found = found.iter();
    found.map(|found| judge(found, wish, mesh_efficiency)).collect()
}

/// Judges a solution of a wish; the solver has to confirm each ratio.
///
/// # Errors
/// Those of the solver. None are known for solutions of a search with `k` above 1.
///
/// # Panics
/// Where the solver's ratio of a gear is another than the formula's: a fault of this library.
pub fn judge(
    found: &Found,
    wish: &Wish,
    mesh_efficiency: MeshEfficiency,
) -> Result<Judged, epicyclic_train::Error> {
    let solution = &found.solution;
    let ratios: Vec<_> = solution.gears.iter().map(|gear| gear.ratio).collect();
    let whole = wish.k.iter().map(|range| [*range.start(), *range.end()]).collect();
    let refined = refine(&ratios, &wish.gears, &whole, &solution.k);
    let (engaged, multiple_shifts) = exchanges(found, wish);
    let elements: Vec<Element> = solution.elements.iter().map(|pairs| pairs[0]).collect();
    let gearbox = gearbox(&found.structure, &refined.k, mesh_efficiency, &elements, &engaged)?;
    let (mut solved, mut efficiencies) = (Vec::new(), Vec::new());
    for (gear, formula) in gearbox.gears().iter().zip(&ratios) {
        let analysis = gearbox.analyze_gear(gear)?;
        let ratio = analysis.ratio().unwrap_or(f64::NAN);
        let value = formula.value(&refined.k);
        assert!(
            (ratio - value).abs() <= CONFIRMED * value.abs(),
            "{}: gear {} is {value} by {formula}, {ratio} by the solver",
            found.structure,
            gear.name()
        );
        solved.push(ratio);
        efficiencies.push(analysis.efficiency());
    }
    Ok(Judged { refined, engaged, multiple_shifts, ratios: solved, efficiencies })
}

/// Elements of each gear with the fewest exchanged between neighbours, and how many shifts exchange several.
///
/// Forward gears stand in falling order of their ratios, and each choice is reached from the best of the gear before; backward
/// gears take what shares most with the first forward gear.
fn exchanges(found: &Found, wish: &Wish) -> (Vec<Vec<usize>>, usize) {
    let gears = &found.solution.gears;
    let mut forward: Vec<usize> = (0..gears.len()).filter(|gear| wish.gears[*gear].least > 0.0).collect();
    forward.sort_by(|one, other| wish.gears[*other].most.total_cmp(&wish.gears[*one].most));
    let exchanged =
        |one: &[usize], other: &[usize]| one.iter().filter(|element| !other.contains(element)).count();
    // For each choice of each gear: exchanges beyond the first of each shift, and the choice before.
    let mut ways: Vec<Vec<(usize, usize)>> = Vec::new();
    for (step, gear) in forward.iter().enumerate() {
        let way = |choice: &Vec<usize>| {
            let Some(before) = step.checked_sub(1).map(|step| &gears[forward[step]].engaged) else {
                return (0, 0);
            };
            let costs = before.iter().enumerate().map(|(place, other)| {
                (ways[step - 1][place].0 + exchanged(choice, other).saturating_sub(1), place)
            });
            costs.min().unwrap_or_default()
        };
        let next = gears[*gear].engaged.iter().map(way).collect();
        ways.push(next);
    }
    let mut engaged: Vec<Vec<usize>> = gears.iter().map(|gear| gear.engaged[0].clone()).collect();
    let mut place =
        ways.last().and_then(|way| (0..way.len()).min_by_key(|place| way[*place].0)).unwrap_or_default();
    for (step, gear) in forward.iter().enumerate().rev() {
        engaged[*gear].clone_from(&gears[*gear].engaged[place]);
        place = ways[step][place].1;
    }
    if let Some(first) = forward.first().map(|gear| engaged[*gear].clone()) {
        for gear in (0..gears.len()).filter(|gear| !forward.contains(gear)) {
            if let Some(least) = gears[gear].engaged.iter().min_by_key(|choice| exchanged(choice, &first)) {
                engaged[gear].clone_from(least);
            }
        }
    }
    let multiple =
        forward.windows(2).filter(|pair| exchanged(&engaged[pair[0]], &engaged[pair[1]]) > 1).count();
    (engaged, multiple)
}
