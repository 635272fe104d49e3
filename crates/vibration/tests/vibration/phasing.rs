//! The rule of planet phasing against the work of the meshes in every mode.

use crate::common::lin_parker;
use epicyclic_vibration::{Error, Group, Kind, Model, SetParts, phasing};

/// Work of unit transmission errors of the meshes with `p` periods a turn in a group of modes: the sum over its modes of `|Σ k·δ·exp(i·p·ψ)|²`,
/// with a phase of its own of the ring's meshes, over the same sum without phases between planets.
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

#[test]
fn two_planets_have_no_rule() {
    let refused = phasing::excited(27, 2).unwrap_err();
    assert_eq!(refused, Error::TooFew { of: "planets", count: 2, least: 3 });
    assert_eq!(phasing::excited(u64::MAX, 3), Ok(Kind::Rotational));
}
