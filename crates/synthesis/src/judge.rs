//! What a solution is worth: shifts, efficiency by the solver, how near its ratios come.

use crate::gearbox::gearbox;
use crate::motion::Element;
use crate::refine::Refined;
use crate::run::Found;
use crate::shifts::{exchanged, fewest};
use crate::tolerance::CONFIRMED;
use crate::wish::{Wish, forward};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::Gearbox;
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
    /// The greatest slip of an open element in a gear, over the input's speed.
    pub slip: f64,
    /// The greatest speed of a link in a gear, over the input's.
    pub link_speed: f64,
    /// The greatest speed of a planet relative to its carrier in a gear, over the input's; of planets known by `k`.
    pub planet_speed: f64,
    /// The gearbox of the solver at the best `k`, its gears named by their numbers in the wish.
    pub gearbox: Gearbox,
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
    let refined = wish.refine(&ratios, &solution.k, solution.equal);
    let (engaged, multiple_shifts) = exchanges(found, wish);
    let elements: Vec<Element> = solution.elements.iter().map(|pairs| pairs[0]).collect();
    let gearbox = gearbox(&found.structure, &refined.k, mesh_efficiency, &elements, &engaged)?;
    let (mut solved, mut efficiencies) = (Vec::new(), Vec::new());
    let (mut slip, mut link_speed, mut planet_speed) = (0.0f64, 0.0f64, 0.0f64);
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
        let greatest = |speeds: &[Option<f64>]| {
            speeds.iter().flatten().fold(0.0, |all: f64, speed| all.max(speed.abs()))
        };
        slip = slip.max(greatest(analysis.slips()));
        link_speed = link_speed.max(greatest(analysis.speeds()));
        let planets = analysis.sets().iter().flat_map(|set| set.planets.iter().flatten());
        planet_speed = planets.fold(planet_speed, |all, planet| all.max(planet.relative.abs()));
    }
    Ok(Judged {
        refined,
        engaged,
        multiple_shifts,
        ratios: solved,
        efficiencies,
        slip,
        link_speed,
        planet_speed,
        gearbox,
    })
}

/// Elements of each gear with the fewest exchanged between neighbours, and how many shifts exchange several.
///
/// Forward gears stand in falling order of their ratios, and keep the single shifts of the wish; backward gears take what shares
/// most with the first forward gear.
fn exchanges(found: &Found, wish: &Wish) -> (Vec<Vec<usize>>, usize) {
    let gears = &found.solution.gears;
    let forward = forward(&wish.gears);
    let bits = |choice: &Vec<usize>| choice.iter().fold(0, |all, element| all | 1u64 << element);
    let choices: Vec<Vec<u64>> = gears.iter().map(|gear| gear.engaged.iter().map(bits).collect()).collect();
    let of_forward: Vec<&[u64]> = forward.iter().map(|gear| choices[*gear].as_slice()).collect();
    let best = fewest(&of_forward, wish.rules.shifts);
    let best = best.expect("the search takes functions alone with which the shifts of the wish are single");
    let mut chosen = vec![0; gears.len()];
    for (gear, place) in forward.iter().zip(best) {
        chosen[*gear] = place;
    }
    let engaged = |chosen: &[usize], gear: usize| choices[gear][chosen[gear]];
    if let Some(first) = forward.first().map(|gear| engaged(&chosen, *gear)) {
        for gear in (0..gears.len()).filter(|gear| !forward.contains(gear)) {
            let nearest =
                (0..choices[gear].len()).min_by_key(|place| exchanged(choices[gear][*place], first));
            chosen[gear] = nearest.unwrap_or_default();
        }
    }
    let multiple = forward
        .windows(2)
        .filter(|pair| exchanged(engaged(&chosen, pair[0]), engaged(&chosen, pair[1])) > 1)
        .count();
    let engaged = chosen.iter().zip(gears).map(|(place, gear)| gear.engaged[*place].clone());
    (engaged.collect(), multiple)
}
