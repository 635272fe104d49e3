//! States, ratios and efficiencies of the gears of a gearbox for many basic ratios of its sets, as columns.
//!
//! This is an answer for programs that hold arrays: a hundred thousand variants are no text that anybody
//! reads. One variant is what [`analyze`](crate::analyze::answer) says of a gearbox with these `k`.

pub mod points;

use crate::error::Error;
use epicyclic_numerics::threads::map;
use epicyclic_train::sweep::{StateName, Sweep, Swept};
use epicyclic_train::{Gear, Gearbox};
use std::ops::ControlFlow;

/// How many variants are solved between two questions whether to go on.
const PIECE: usize = 4096;

/// Gears and basic ratios to calculate.
#[derive(Debug, Clone, PartialEq)]
pub struct Request<'a> {
    /// Names of the gears; an empty list means all gears.
    pub gears: Vec<String>,
    /// Sets by name, each with its `k = |i₀|` in every variant; of a simple set `k = z_ring/z_sun`.
    pub k: Vec<(String, &'a [f64])>,
}

/// Columns over variants and gears: variant `v` and gear `g` have the index `v·gears + g`.
#[derive(Debug, Clone, PartialEq)]
pub struct Columns {
    /// The gears.
    pub gears: Vec<String>,
    /// How many variants there are.
    pub variants: usize,
    /// The states.
    pub states: Vec<StateName>,
    /// Ratios `i = ω_in/ω_out`; 0 if [`has_ratio`](Self::has_ratio) is false.
    pub ratios: Vec<f64>,
    /// Whether the output's speed follows from the input's.
    pub has_ratio: Vec<bool>,
    /// Efficiencies driven from the input; 0 if [`has_efficiency`](Self::has_efficiency) is false.
    pub efficiencies: Vec<f64>,
    /// Whether losses follow, and a torque moves the gear.
    pub has_efficiency: Vec<bool>,
}

impl Request<'_> {
    /// Solves every variant; `None` where `goes_on` ended it.
    ///
    /// `goes_on` is asked before each piece with 0 and after it with the number of its variants, from any
    /// thread.
    ///
    /// ```
    /// use epicyclic_commands::sweep::Request;
    /// use epicyclic_train::{Gearbox, set::SetSpec};
    /// use std::ops::ControlFlow::Continue;
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let gearbox = Gearbox::builder("scheme I")
    ///     .links(["D", "B", "T1"])
    ///     .set(SetSpec::simple("1", ["D", "T1", "B"], 3.0))
    ///     .brake("K1", "T1")
    ///     .input("D")
    ///     .output("B")
    ///     .gear("1", ["K1"])
    ///     .build()?;
    /// let request = Request { gears: vec![], k: vec![("1".into(), &[2.0, 3.0])] };
    /// let found = request.answer(&gearbox, &|_| Continue(()))?.expect("nothing ends it");
    /// assert_eq!(found.ratios, [3.0, 4.0]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// - [`Error::NoGear`] for a gear that there is not, [`Error::Gearbox`] for a set whose `k` cannot vary.
    /// - [`Error::SweptLength`] unless every set has as many values.
    /// - [`Error::SweptVariant`] with the first variant that has a `k` which its set cannot have.
    pub fn answer(
        &self,
        gearbox: &Gearbox,
        goes_on: &(dyn Fn(usize) -> ControlFlow<()> + Sync),
    ) -> Result<Option<Columns>, Error> {
        let gears = gears(gearbox, &self.gears)?;
        let names: Vec<&str> = self.k.iter().map(|(set, _)| set.as_str()).collect();
        let sweep = Sweep::new(gearbox, &gears, &names)?;
        // Without columns of `k` the gearbox as described is the only variant.
        let variants = self.k.first().map_or(1, |(_, values)| values.len());
        for (set, values) in &self.k {
            if values.len() != variants {
                let (name, given, first) = (set.clone(), values.len(), names[0].to_owned());
                return Err(Error::SweptLength { name, given, first, expected: variants });
            }
        }
        let piece = |place: usize| -> Piece<Swept> {
            if goes_on(0).is_break() {
                return Ok(None);
            }
            // Solving changes the sweep's buffers, so every thread works on its own copy.
            let mut sweep = sweep.clone();
            let range = place * PIECE..variants.min((place + 1) * PIECE);
            let mut all = Vec::with_capacity(range.len() * gears.len());
            let mut k = vec![0.0; self.k.len()];
            let mut found = Vec::with_capacity(gears.len());
            for variant in range.clone() {
                for (k, (_, values)) in k.iter_mut().zip(&self.k) {
                    *k = values[variant];
                }
                sweep.solve(&k, &mut found).map_err(|why| Error::SweptVariant { variant, why })?;
                all.extend_from_slice(&found);
            }
            Ok(goes_on(range.len()).is_continue().then_some(all))
        };
        let pieces = pieces(variants.div_ceil(PIECE), &piece);
        let count = variants * gears.len();
        let mut columns = Columns {
            gears: gears.iter().map(|gear| gear.name().to_owned()).collect(),
            variants,
            states: Vec::with_capacity(count),
            ratios: Vec::with_capacity(count),
            has_ratio: Vec::with_capacity(count),
            efficiencies: Vec::with_capacity(count),
            has_efficiency: Vec::with_capacity(count),
        };
        for piece in pieces {
            let Some(piece) = piece? else { return Ok(None) };
            columns.states.extend(piece.iter().map(|one| one.state));
            columns.ratios.extend(piece.iter().map(|one| one.ratio.unwrap_or(0.0)));
            columns.has_ratio.extend(piece.iter().map(|one| one.ratio.is_some()));
            columns.efficiencies.extend(piece.iter().map(|one| one.efficiency.unwrap_or(0.0)));
            columns.has_efficiency.extend(piece.iter().map(|one| one.efficiency.is_some()));
        }
        Ok(Some(columns))
    }
}

fn gears(gearbox: &Gearbox, names: &[String]) -> Result<Vec<Gear>, Error> {
    if names.is_empty() {
        return Ok(gearbox.gears().to_vec());
    }
    let all = || gearbox.gears().iter().map(|gear| gear.name().to_owned()).collect();
    let find = |name: &String| {
        let found = gearbox.gears().iter().find(|gear| gear.name() == name);
        found.cloned().ok_or_else(|| Error::NoGear { name: name.clone(), gears: all() })
    };
    names.iter().map(find).collect()
}

type Piece<One> = Result<Option<Vec<One>>, Error>;

fn pieces<One: Send>(count: usize, piece: &(dyn Fn(usize) -> Piece<One> + Sync)) -> Vec<Piece<One>> {
    let places: Vec<usize> = (0..count).collect();
    map(&places, |place| piece(*place))
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_train::set::SetSpec;

    fn scheme() -> Gearbox {
        Gearbox::builder("II-3")
            .links(["D", "B", "T1", "T2"])
            .set(SetSpec::simple("1", ["T1", "D", "B"], 2.15))
            .set(SetSpec::simple("2", ["T1", "B", "T2"], 2.354))
            .brake("K1", "T1")
            .brake("K2", "T2")
            .input("D")
            .output("B")
            .gear("1", ["K1"])
            .gear("2", ["K2"])
            .gear("N", [""; 0])
            .build()
            .unwrap()
    }

    #[test]
    fn columns_keep_the_order_of_variants_over_pieces() {
        let count = 2 * PIECE + 3;
        let k1: Vec<f64> = (0..count).map(|place| 1.5 + place as f64 / count as f64).collect();
        let k2: Vec<f64> = k1.iter().rev().copied().collect();
        let k = vec![("1".to_owned(), k1.as_slice()), ("2".to_owned(), k2.as_slice())];
        let found =
            Request { gears: vec![], k }.answer(&scheme(), &|_| ControlFlow::Continue(())).unwrap().unwrap();
        assert_eq!(
            (found.variants, found.gears.as_slice()),
            (count, ["1", "2", "N"].map(String::from).as_slice())
        );
        for (variant, (k1, k2)) in k1.iter().zip(&k2).enumerate() {
            let row = 3 * variant..3 * variant + 3;
            let due = [(1.0 + k1) / k1, (1.0 + k1 + k2) / k1, 0.0];
            for (found, due) in found.ratios[row.clone()].iter().zip(due) {
                assert!((found - due).abs() < 1e-12);
            }
            assert_eq!(found.has_ratio[row.clone()], [true, true, false]);
            assert_eq!(found.has_efficiency[row.clone()], [true, true, false]);
            assert_eq!(found.states[row], [StateName::Driven, StateName::Driven, StateName::Underdetermined]);
        }
    }

    #[test]
    fn gears_are_those_named_in_their_order() {
        let request = Request { gears: vec!["2".into(), "1".into()], k: vec![("2".into(), &[3.0])] };
        let found = request.answer(&scheme(), &|_| ControlFlow::Continue(())).unwrap().unwrap();
        assert_eq!(found.gears, ["2", "1"]);
        assert!((found.ratios[0] - (1.0 + 2.15 + 3.0) / 2.15).abs() < 1e-12);
    }

    #[test]
    fn a_fault_is_told_with_its_variant() {
        let refused = |gears: &[&str], k: Vec<(&str, &[f64])>| {
            let gears = gears.iter().map(|&gear| gear.to_owned()).collect();
            let k = k.into_iter().map(|(set, values)| (set.to_owned(), values)).collect();
            let error = Request { gears, k }.answer(&scheme(), &|_| ControlFlow::Continue(())).unwrap_err();
            (error.name(), error.to_string())
        };
        let (name, text) = refused(&[], vec![("1", &[2.0, 3.0, 0.5])]);
        assert_eq!(name, "ring-to-sun-ratio");
        assert!(text.starts_with("variant 2: k = 0.5 of set `1`"), "{text}");
        let (name, text) = refused(&[], vec![("1", &[2.0, 3.0]), ("2", &[2.0])]);
        assert_eq!(
            (name, text.as_str()),
            ("swept-length", "`2` has 1 values, and `1` has 2: every variant takes one of each")
        );
        assert_eq!(refused(&["9"], vec![("1", &[2.0])]).0, "no-gear");
        assert_eq!(refused(&[], vec![("9", &[2.0])]).0, "unknown");
    }

    #[test]
    fn what_is_not_to_go_on_ends() {
        let k = vec![2.0; 3 * PIECE];
        let request = Request { gears: vec![], k: vec![("1".into(), &k)] };
        assert_eq!(request.answer(&scheme(), &|_| ControlFlow::Break(())).unwrap(), None);
    }
}
