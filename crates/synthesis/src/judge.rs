//! Judgement of a solution: shifts, efficiency by the solver, deviations of its ratios.

use crate::error::Error;
use crate::gearbox::gearbox;
use crate::motion::Element;
use crate::refine::Refined;
use crate::run::Found;
use crate::sharing::Sharing;
use crate::shifts::{exchanged, fewest};
use crate::tolerance::{CONFIRMED, WITHIN};
use crate::wish::{Wish, forward};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_numerics::values::largest_absolute;
use epicyclic_train::compound::CentralKind;
use epicyclic_train::planet_set::PlanetSet;
use epicyclic_train::set::SetKind;
use epicyclic_train::{Analysis, Gearbox};
#[cfg(feature = "parallel")]
use rayon::iter::{IntoParallelRefIterator as _, ParallelIterator as _};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// A solution with its best ring-to-sun ratios, judged.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// Best `k`, ranges, greatest deviation.
    pub refined: Refined,
    /// Engaged elements of each gear, by their places: of the choices with its ratio those with the fewest
    /// exchanges between neighbouring gears.
    pub engaged: Vec<Vec<usize>>,
    /// Number of shifts between neighbouring forward gears that exchange more than one element.
    pub multiple_shifts: usize,
    /// Ratio of each gear by the solver.
    pub ratios: Vec<f64>,
    /// Efficiency of each gear by the solver; `None` if its losses leave it none.
    pub efficiencies: Vec<Option<f64>>,
    /// The greatest slip of an open element in a gear, over the input's speed.
    pub slip: f64,
    /// The greatest speed of a link in a gear, over the input's.
    pub link_speed: f64,
    /// Greatest speed of a planet relative to its carrier in a gear, over the input's. For the planets of a
    /// double-planet set it is a lower bound for any teeth ([`planet_speed`]).
    pub planet_speed: f64,
    /// Sets that share planets at the best `k`.
    pub sharing: Sharing,
    /// The gearbox of the solver at the best `k`, its gears named by their numbers in the wish; sets that
    /// share planets are one.
    pub gearbox: Gearbox,
}

impl Judged {
    /// Whether a gear counts as a forward one: its ratio is positive. Where none is, all count.
    #[must_use]
    pub fn is_forward(&self, gear: usize) -> bool {
        self.ratios[gear] > 0.0 || self.ratios.iter().all(|ratio| *ratio <= 0.0)
    }

    /// The least efficiency of a forward gear, 0 where a gear has none.
    #[must_use]
    pub fn forward_efficiency(&self) -> f64 {
        self.least_efficiency(true).unwrap_or(1.0)
    }

    /// Least efficiency of a reverse gear, 0 if a gear has none; `None` without a reverse gear.
    #[must_use]
    pub fn reverse_efficiency(&self) -> Option<f64> {
        self.least_efficiency(false)
    }

    fn least_efficiency(&self, forward: bool) -> Option<f64> {
        let gears = (0..self.ratios.len()).filter(|gear| self.is_forward(*gear) == forward);
        gears.map(|gear| self.efficiencies[gear].unwrap_or(0.0)).reduce(f64::min)
    }

    /// The mean efficiency of the forward gears, weighted by their shares of time, each gear's in the order
    /// of the wish, over their sum.
    ///
    /// ```text
    /// η = Σ s_g·η_g / Σ s_g
    /// ```
    ///
    /// `None` if the shares of all forward gears are 0.
    #[must_use]
    pub fn mean_efficiency(&self, shares: &[f64]) -> Option<f64> {
        let (mut sum, mut all) = (0.0, 0.0);
        for (gear, share) in shares.iter().enumerate().filter(|(gear, _)| self.is_forward(*gear)) {
            sum += share * self.efficiencies[gear].unwrap_or(0.0);
            all += share;
        }
        (all > 0.0).then(|| sum / all)
    }
}

/// Judges all solutions of a wish, in their order; with the feature `parallel` on all threads of the pool.
/// After each solution `judged` is called with the number judged so far. After a break nothing more is
/// judged, and the remaining places are `None`.
///
/// # Errors
/// Those of [`judge`].
pub fn judge_all(
    found: &[Found],
    wish: &Wish,
    mesh_efficiency: MeshEfficiency,
    judged: &(dyn Fn(usize) -> ControlFlow<()> + Sync),
) -> Result<Vec<Option<Judged>>, Error> {
    let (ended, done) = (AtomicBool::new(false), AtomicUsize::new(0));
    let one = |found: &Found| {
        if ended.load(Ordering::Relaxed) {
            return Ok(None);
        }
        let answer = judge(found, wish, mesh_efficiency)?;
        if judged(done.fetch_add(1, Ordering::Relaxed) + 1).is_break() {
            ended.store(true, Ordering::Relaxed);
        }
        Ok(Some(answer))
    };
    #[cfg(feature = "parallel")]
    let found = found.par_iter();
    #[cfg(not(feature = "parallel"))]
    let found = found.iter();
    found.map(one).collect()
}

/// Judges a solution of a wish; the solver has to confirm each ratio.
///
/// # Errors
/// - [`Error::Contradiction`] if a gear's ratio at the solution's `k` is beyond its bounds, or differs by the
///   solver from the formula's;
/// - [`Error::Contradiction`] if shifts that have to be single are not;
/// - errors of the solver: none are known for solutions of a search with `k` above 1.
pub fn judge(found: &Found, wish: &Wish, mesh_efficiency: MeshEfficiency) -> Result<Judged, Error> {
    let solution = &found.solution;
    let contradiction = |why| Error::Contradiction { structure: found.structure.to_string(), why };
    let ratios: Vec<_> = solution.gears.iter().map(|gear| gear.ratio).collect();
    // The solution may come from a changed part of a search, so it is checked against the wish first.
    if ratios.len() != wish.gears.len() || solution.k.len() != wish.k.len() {
        let (gears, sets) = (ratios.len(), solution.k.len());
        return Err(contradiction(format!(
            "{gears} gears of {sets} sets, where {} of {} are wanted",
            wish.gears.len(),
            wish.k.len()
        )));
    }
    for (number, (ratio, bounds)) in (1..).zip(ratios.iter().zip(&wish.gears)) {
        let value = ratio.value(&solution.k);
        if !bounds.widened_by(WITHIN).contain(value) {
            return Err(contradiction(format!(
                "gear {number} is {value} at its ring-to-sun ratios, not within {}..{}",
                bounds.least, bounds.most
            )));
        }
    }
    let refined = wish.refine(&ratios, &solution.k, solution.equal);
    let (engaged, multiple_shifts) = exchanges(found, wish)
        .ok_or_else(|| contradiction("shifts that have to be single exchange several elements".into()))?;
    let elements: Vec<Element> = solution.elements.iter().map(|pairs| pairs[0]).collect();
    let gearbox = gearbox(&found.structure, &refined.k, mesh_efficiency, &elements, &engaged)?;
    let (mut solved, mut efficiencies) = (Vec::new(), Vec::new());
    let (mut slip, mut link_speed, mut planet_speed) = (0.0f64, 0.0f64, 0.0f64);
    for (gear, formula) in gearbox.gears().iter().zip(&ratios) {
        let analysis = gearbox.analyze_gear(gear)?;
        let ratio = analysis.ratio().unwrap_or(f64::NAN);
        let value = formula.value(&refined.k);
        let confirmed = (ratio - value).abs() <= CONFIRMED * value.abs();
        if !confirmed {
            let why = format!("gear {} is {value} by {formula}, {ratio} by the solver", gear.name());
            return Err(contradiction(why));
        }
        solved.push(ratio);
        efficiencies.push(analysis.efficiency());
        let greatest = |speeds: &[Option<f64>]| largest_absolute(speeds.iter().flatten());
        slip = slip.max(greatest(analysis.slips()));
        link_speed = link_speed.max(greatest(analysis.speeds()));
        planet_speed = planet_speed.max(self::planet_speed(&analysis));
    }
    Ok(Judged {
        engaged,
        multiple_shifts,
        ratios: solved,
        efficiencies,
        slip,
        link_speed,
        planet_speed,
        sharing: Sharing::of(&found.structure, &refined.k),
        refined,
        gearbox,
    })
}

/// Greatest speed of a planet relative to its carrier, over the input's. If the teeth of a double-planet set,
/// or of a compound one, are not known, it is a lower bound; for a compound set over each sun and ring with
/// one planet or two between them.
///
/// ```text
/// ∣ω_g − ω_H∣ = ∣ω_s − ω_H∣·z_s/z_g > 2·∣ω_s − ω_H∣/(k − 1)        of both planets of a double-planet set
/// ```
///
/// Both planets of such a set have fewer than `(z_r − z_s)/2` teeth: more would reach into the sun or the
/// ring ([`epicyclic_gears::double_planet`]). So they turn faster than the planets of a simple set of the
/// same `k`.
#[must_use]
pub fn planet_speed(analysis: &Analysis<'_>) -> f64 {
    let mut greatest: f64 = 0.0;
    for (set, motion) in analysis.gearbox().sets().iter().zip(analysis.sets()) {
        let known = motion.planets.iter().flatten().map(|planet| planet.relative.abs());
        greatest = known.fold(greatest, f64::max);
        if !motion.planets.iter().any(Option::is_none) {
            continue;
        }
        let relative =
            |central: usize| Some(analysis.speed(set.members()[central])? - analysis.speed(set.carrier())?);
        for [sun, ring] in suns_and_rings(set) {
            let k = set.ratio_between(sun, ring).abs();
            greatest = greatest.max(relative(sun).map_or(0.0, |speed| 2.0 * speed.abs() / (k - 1.0)));
        }
    }
    greatest
}

/// Suns and rings of a set whose planets' teeth are not known, by their places, with one planet or two
/// between them.
fn suns_and_rings(set: &PlanetSet) -> Vec<[usize; 2]> {
    if set.short().is_some() {
        return if set.kind() == Some(SetKind::DoublePlanet) { vec![[0, 1]] } else { vec![] };
    }
    let of = |kind: CentralKind| {
        (0..set.centrals().len()).filter(move |central| set.centrals()[*central].kind == kind)
    };
    let pairs = of(CentralKind::Sun).flat_map(|sun| of(CentralKind::Ring).map(move |ring| [sun, ring]));
    // Three meshes have two planets between sun and ring; the bound on the speed holds for no more.
    pairs.filter(|[sun, ring]| set.path(*sun, *ring).len() <= 3).collect()
}

/// Elements of each gear with the fewest exchanged between neighbours, and the number of shifts that exchange
/// several.
///
/// Forward gears are in falling order of their ratios, and keep the single shifts of the wish. Backward gears
/// take the choice that shares most with the first forward gear.
fn exchanges(found: &Found, wish: &Wish) -> Option<(Vec<Vec<usize>>, usize)> {
    let gears = &found.solution.gears;
    let forward = forward(&wish.gears);
    let bits = |choice: &Vec<usize>| choice.iter().fold(0, |all, element| all | 1u64 << element);
    let choices: Vec<Vec<u64>> = gears.iter().map(|gear| gear.engaged.iter().map(bits).collect()).collect();
    let of_forward: Vec<&[u64]> = forward.iter().map(|gear| choices[*gear].as_slice()).collect();
    let best = fewest(&of_forward, wish.rules.shifts)?;
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
    Some((engaged.collect(), multiple))
}
