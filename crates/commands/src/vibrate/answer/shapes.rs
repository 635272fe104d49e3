//! Normalized motion of a mode, one for each frequency.
//!
//! Modes of equal frequency have no unique basis. The mode with the largest first moving coordinate is
//! chosen, with a positive sign. The order is `x` of the members, then their rotations, then the motion of
//! the first planet.

use super::Found;
use super::prepared::Prepared;
use super::records::BodyMotion;
use crate::shared::number::plain;
use crate::tolerance::STILL;
use epicyclic_numerics::values::largest_absolute;
use epicyclic_vibration::{BodyId, Group};

/// Motion of all bodies, relative to the largest displacement.
pub(super) fn of(found: &Found, prepared: &Prepared, group: &Group) -> Vec<BodyMotion> {
    let parts = &found.parts;
    let central = || parts.members.iter().copied();
    let members = central().zip(&prepared.members).map(|(body, one)| (body, (&one.name, None)));
    let kinds = parts.planets.chunks(prepared.copies()).zip(&prepared.planet_kinds);
    let planets =
        kinds.flat_map(|(own, kind)| own.iter().zip(1..).map(|(body, n)| (*body, (&kind.name, Some(n)))));
    let bodies: Vec<(BodyId, (&String, Option<u32>))> = members.chain(planets).collect();
    let of = |shape: usize, body: BodyId| group.shapes[shape].of(body).unwrap_or_default();
    let all = || {
        (0..group.shapes.len()).flat_map(|shape| bodies.iter().flat_map(move |(body, _)| of(shape, *body)))
    };
    let size = largest_absolute(all());
    let first = parts.planets.first().copied();
    let leading = central().map(|body| (body, 0)).chain(central().map(|body| (body, 2)));
    let leading = leading.chain(first.into_iter().flat_map(|planet| [2, 0, 1].map(|axis| (planet, axis))));
    let weights = leading
        .map(|(body, axis)| (0..group.shapes.len()).map(|shape| of(shape, body)[axis]).collect::<Vec<f64>>())
        .find(|weights| weights.iter().any(|weight| weight.abs() > STILL * size))
        .unwrap_or_else(|| vec![1.0; group.shapes.len()]);
    let motion = |body: BodyId| {
        let mut sum = [0.0; 3];
        for (shape, weight) in weights.iter().enumerate() {
            sum.iter_mut().zip(of(shape, body)).for_each(|(sum, part)| *sum += weight * part);
        }
        sum
    };
    let largest = bodies
        .iter()
        .map(|(body, _)| motion(*body))
        .fold(0.0_f64, |most, [x, y, u]| most.max(libm::hypot(x, y)).max(u.abs()));
    let shown = |value: f64| if value.abs() < STILL * largest { 0.0 } else { plain(value / largest) };
    bodies
        .iter()
        .map(|(body, (name, planet))| {
            let [x, y, u] = motion(*body).map(shown);
            BodyMotion { body: (*name).clone(), planet: *planet, x, y, u }
        })
        .collect()
}
