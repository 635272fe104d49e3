//! The rule of planet phasing against the work of the meshes in every mode.

use crate::common::{lin_parker, n_m};
use epicyclic_vibration::train::{Link, Placed, torsional};
use epicyclic_vibration::{Error, Group, Kind, Model, SetParts, phasing};
use uom::si::f64::{MomentOfInertia, Torque};

/// Work of unit transmission errors of the meshes with `p` periods a turn in a group of modes: the sum over
/// its modes of `|Σ k·δ·exp(i·p·ψ)|²`, with a phase of its own of the ring's meshes, over the same sum
/// without phases between planets.
fn work(model: &Model, parts: &SetParts, group: &Group, periods: u64) -> f64 {
    let count = parts.planets.len();
    let mut sums = [0.0; 2];
    for shape in &group.shapes {
        let (mut re, mut im) = (0.0, 0.0);
        for n in 0..count {
            let phase = periods as f64 * std::f64::consts::TAU * n as f64 / count as f64;
            for (meshes, own) in [(&parts.sun_meshes, 0.0), (&parts.ring_meshes, 0.7)] {
                let part = model.elongation(meshes[n], shape).unwrap();
                re += part * libm::cos(phase + own);
                im += part * libm::sin(phase + own);
                sums[1] += part.abs();
            }
        }
        sums[0] += libm::hypot(re, im);
    }
    sums[0] / sums[1]
}

#[test]
fn meshes_work_in_the_modes_of_the_rule_and_in_no_others() {
    for planets in 3..=7_u32 {
        let (model, parts) = lin_parker(planets as usize).planar().unwrap();
        let groups = model.groups(&parts.central()).unwrap();
        for periods in 0..=u64::from(3 * planets) {
            let rule = phasing::excited(periods, planets).unwrap();
            for group in groups.iter().filter(|group| !group.is_zero()) {
                let work = work(&model, &parts, group, periods);
                if group.kind == rule {
                    assert!(work > 1e-6, "{planets} planets, {periods} periods, {rule:?}: {work}");
                } else {
                    assert!(work < 1e-9, "{planets} planets, {periods} periods, {:?}: {work}", group.kind);
                }
            }
        }
    }
}

/// The work of a set's meshes in the torsional modes of two sets on common links: the rule of each set,
/// beside the other.
#[test]
fn meshes_of_each_of_several_sets_work_in_the_torsional_modes_of_the_rule() {
    for [one, other] in [[2_u32, 3], [3, 4], [4, 5], [5, 2]] {
        let mut second = lin_parker(other as usize);
        for planet in &mut second.planets {
            planet.sun_mesh = n_m(3e8);
        }
        let sets = [lin_parker(one as usize), second];
        let link = |index: usize| Link {
            name: format!("link {index}"),
            inertia: MomentOfInertia::default(),
            support: Torque::default(),
            held: index == 3,
        };
        let links: Vec<Link> = (0..4).map(link).collect();
        let placed = [("1", &sets[0], [0, 1, 2]), ("2", &sets[1], [0, 3, 1])];
        let placed = placed.map(|(name, set, links)| Placed {
            name: name.to_owned(),
            set: set.gear_set(),
            links: links.to_vec(),
        });
        let (model, parts) = torsional(&links, &placed, &[]).unwrap();
        let groups = model.groups(&parts.links).unwrap();
        for (set, planets) in [one, other].into_iter().enumerate() {
            for periods in 0..=u64::from(3 * planets) {
                let rule = phasing::torsional(periods, planets).unwrap();
                for group in groups.iter().filter(|group| !group.is_zero()) {
                    let (of_sun, of_ring) = parts.sets[set].meshes.split_at(planets as usize);
                    let meshes = [of_sun, of_ring];
                    let energy = model.modal_energy(group).unwrap();
                    let own =
                        energy.strain.iter().filter(|one| meshes.iter().any(|all| all.contains(&one.spring)));
                    let share: f64 = own.map(|one| one.share).sum();
                    let mut work = 0.0;
                    for shape in &group.shapes {
                        let [mut re, mut im] = [0.0, 0.0];
                        for (own, meshes) in [0.0, 0.7].into_iter().zip(meshes) {
                            for (n, mesh) in meshes.iter().enumerate() {
                                let phase = periods as f64 * std::f64::consts::TAU * n as f64
                                    / f64::from(planets)
                                    + own;
                                let bent = model.elongation(*mesh, shape).unwrap();
                                re += bent * libm::cos(phase);
                                im += bent * libm::sin(phase);
                            }
                        }
                        work += libm::hypot(re, im);
                    }
                    let driven = group.kind == rule && share > 1e-9;
                    assert_eq!(work > 1e-9, driven, "{planets} {periods} {:?} {share} {work}", group.kind);
                }
            }
        }
    }
    assert_eq!(phasing::torsional(1, 0).unwrap_err().name(), "too-few");
}

#[test]
fn two_planets_have_no_rule() {
    let refused = phasing::excited(27, 2).unwrap_err();
    assert_eq!(refused, Error::TooFew { of: "planets", count: 2, least: 3 });
    assert_eq!(phasing::excited(u64::MAX, 3), Ok(Kind::Rotational));
}
