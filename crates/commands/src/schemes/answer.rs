//! The catalogue of two- and three-speed schemes: all of them, or one with its formulas and numbers.

mod formulas;

use crate::answer::{Answer, Warning};
use crate::error::Error;
pub use crate::refusal::{SizeName, SizeProblem};
use crate::shared::catalogue::{GearName, KRange, Link, SetLinks, SetSpeeds, ShiftElement};
use crate::shared::number::plain;
use crate::shared::records::Motion;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::RingToSunRatio;
use epicyclic_schemes::catalogue::{RingToSunRange, Scheme as CatalogueScheme};
use epicyclic_train::{Analysis, Gearbox};
use epicyclic_units::format::trimmed;
use schemars::JsonSchema;
use serde::Serialize;

/// What says how large the sets of a scheme are.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Sizes {
    /// Ring-to-sun ratio of set 1.
    pub k1: Option<f64>,
    /// Ring-to-sun ratio of set 2.
    pub k2: Option<f64>,
    /// Ratio of gear 1, in place of `k1`.
    pub ratio1: Option<f64>,
    /// Ratio of gear 2, in place of `k2`.
    pub ratio2: Option<f64>,
}

/// A scheme whose sets have sizes.
#[derive(Debug, Clone)]
pub struct Sized {
    /// Ring-to-sun ratios of its sets.
    pub k: Vec<RingToSunRatio>,
    /// The gearbox with gears `1`, `2` (of two sets) and `direct`.
    pub gearbox: Gearbox,
}

/// The scheme with the ring-to-sun ratios or ratios that are given, if any are.
///
/// # Errors
/// [`Error::SchemeSize`].
pub fn sized(scheme: CatalogueScheme, sizes: Sizes, eta0: MeshEfficiency) -> Result<Option<Sized>, Error> {
    let refuse = |size, problem| Err(Error::SchemeSize { size, problem });
    let name = scheme.name();
    let k = |size, k: f64| {
        RingToSunRatio::new(k).map_err(|error| Error::SchemeSize { size, problem: error.into() })
    };
    let of_ratio = |size, found: Result<RingToSunRatio, epicyclic_schemes::Error>| {
        found.map_err(|error| Error::SchemeSize { size, problem: error.into() })
    };
    let first = match (sizes.k1, sizes.ratio1) {
        (Some(k1), _) => k(SizeName::K1, k1)?,
        (None, Some(ratio)) => of_ratio(SizeName::Ratio1, scheme.first_stage().ring_to_sun_ratio(ratio))?,
        (None, None) if sizes.k2.is_some() => return refuse(SizeName::K2, SizeProblem::FirstMissing),
        (None, None) if sizes.ratio2.is_some() => return refuse(SizeName::Ratio2, SizeProblem::FirstMissing),
        (None, None) => return Ok(None),
    };
    let second = match (scheme, sizes.k2, sizes.ratio2) {
        (CatalogueScheme::Two(_), None, None) => None,
        (CatalogueScheme::Two(_), Some(_), _) => {
            return refuse(SizeName::K2, SizeProblem::OneSet { scheme: name });
        }
        (CatalogueScheme::Two(_), ..) => {
            return refuse(SizeName::Ratio2, SizeProblem::OneSet { scheme: name });
        }
        (CatalogueScheme::Three(_), Some(k2), _) => Some(k(SizeName::K2, k2)?),
        (CatalogueScheme::Three(three), None, Some(ratio)) => {
            Some(of_ratio(SizeName::Ratio2, three.second_ring_to_sun_ratio(first, ratio))?)
        }
        (CatalogueScheme::Three(_), None, None) => {
            return refuse(SizeName::K2, SizeProblem::SecondMissing { scheme: name });
        }
    };
    let gearbox = match (scheme, second) {
        (CatalogueScheme::Three(three), Some(second)) => three.gearbox(first, second, eta0)?,
        _ => scheme.first_stage().gearbox(first, eta0)?,
    };
    Ok(Some(Sized { k: [Some(first), second].into_iter().flatten().collect(), gearbox }))
}

/// The catalogue.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Schemes {
    /// Ring-to-sun ratios over which the ranges of ratios are taken.
    pub k: KRange,
    /// The schemes.
    pub schemes: Vec<SchemeFormulas>,
}

/// A scheme of the catalogue.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SchemeFormulas {
    /// Its name.
    pub scheme: &'static str,
    /// Links of the members of its sets.
    pub sets: Vec<SetLinks>,
    /// Ratio of its last braked gear, in k₁ and k₂.
    pub ratio_formula: String,
    /// Efficiency of that gear, in k₁, k₂ and η₀.
    pub efficiency_formula: String,
    /// Least ratio of that gear over the range of k.
    pub least_ratio: f64,
    /// Greatest ratio of that gear over the range of k.
    pub greatest_ratio: f64,
}

impl Answer for Schemes {
    const NAME: &'static str = "schemes";
}

/// All schemes, their ratios over a range of ring-to-sun ratios.
#[must_use]
pub fn list(range: RingToSunRange) -> Schemes {
    let scheme = |scheme: CatalogueScheme| {
        let [least_ratio, greatest_ratio] = scheme.ratio_range(range);
        SchemeFormulas {
            scheme: scheme.name(),
            sets: scheme.sets().into_iter().map(SetLinks::of).collect(),
            ratio_formula: formulas::ratio(scheme),
            efficiency_formula: formulas::efficiency(scheme),
            least_ratio,
            greatest_ratio,
        }
    };
    Schemes {
        k: KRange::of(range.low(), range.high()),
        schemes: CatalogueScheme::all().map(scheme).collect(),
    }
}

/// A scheme: links, formulas, ranges, and its numbers where its sets have sizes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Scheme {
    /// Its name.
    pub scheme: &'static str,
    /// Links of the members of its sets.
    pub sets: Vec<SetLinks>,
    /// How set 2 is connected in gear 2; `null` of a scheme of one set.
    pub connection: Option<Connection>,
    /// Ring-to-sun ratios over which the ranges of ratios are taken.
    pub k: KRange,
    /// Formulas of its gears.
    pub formulas: Vec<GearFormulas>,
    /// Sizes of its sets; `null` where none are given.
    pub parameters: Option<Parameters>,
    /// What its gears do; empty where no sizes are given.
    pub gears: Vec<Gear>,
    /// What speaks against these sizes.
    pub warnings: Vec<Warning>,
}

/// How the second set is connected: in gear 2 it ties T1 to a shaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Connection {
    /// The shaft that it ties T1 to.
    pub shaft: Link,
    /// The members of set 2 on T1 (input), on the shaft (output) and on T2 (fixed).
    pub motion: Motion,
}

/// Formulas of a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearFormulas {
    /// Which gear.
    pub gear: GearName,
    /// The link that is braked in it; `null` of direct drive.
    pub braked: Option<Link>,
    /// Its ratio, in k₁ and k₂.
    pub ratio_formula: String,
    /// Its efficiency, in k₁, k₂ and η₀.
    pub efficiency_formula: String,
    /// Its least ratio over the range of k.
    pub least_ratio: f64,
    /// Its greatest ratio over the range of k.
    pub greatest_ratio: f64,
}

/// Sizes of the sets of a scheme.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Parameters {
    /// Ring-to-sun ratio of set 1.
    pub k1: f64,
    /// Ring-to-sun ratio of set 2; `null` of a scheme of one set.
    pub k2: Option<f64>,
    /// Efficiency of each set with its carrier fixed.
    pub set_efficiency: f64,
}

/// What a gear does; speeds, torques and powers are multiples of the input's.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Gear {
    /// Which gear.
    pub gear: GearName,
    /// Its ratio, input speed over output speed.
    pub ratio: Option<f64>,
    /// Its efficiency; `null` where it is self-locking.
    pub efficiency: Option<f64>,
    /// Its back-driving efficiency; `null` where it is self-locking against back-driving.
    pub back_driving_efficiency: Option<f64>,
    /// Torque on the gearbox at the output, with losses.
    pub output_torque_of_input: Option<f64>,
    /// The shift element engaged.
    pub engaged: ShiftElement,
    /// Its torque on its first link, with losses.
    pub engaged_torque_of_input: Option<f64>,
    /// Circulating power, with losses.
    pub circulating_of_input: Option<f64>,
    /// Speeds in each set.
    pub sets: Vec<SetSpeeds>,
}

impl Answer for Scheme {
    const NAME: &'static str = "scheme";
}

/// One scheme, its ratios over a range of ring-to-sun ratios, and its numbers where sizes are given.
///
/// # Errors
/// [`Error::SchemeSize`], [`Error::Gearbox`].
pub fn one(
    scheme: CatalogueScheme,
    range: RingToSunRange,
    sizes: Sizes,
    eta0: MeshEfficiency,
) -> Result<Scheme, Error> {
    let mut found = Scheme {
        scheme: scheme.name(),
        sets: scheme.sets().into_iter().map(SetLinks::of).collect(),
        connection: match scheme {
            CatalogueScheme::Two(_) => None,
            CatalogueScheme::Three(three) => Some(Connection {
                shaft: Link::of(three.connection().shaft().role()),
                motion: Motion::of(three.connection().mode()),
            }),
        },
        k: KRange::of(range.low(), range.high()),
        formulas: gear_formulas(scheme, range),
        parameters: None,
        gears: vec![],
        warnings: vec![],
    };
    if let Some(sized) = sized(scheme, sizes, eta0)? {
        let (first, second) = (sized.k.first(), sized.k.get(1));
        found.parameters = first.map(|first| Parameters {
            k1: first.get(),
            k2: second.map(|k| k.get()),
            set_efficiency: eta0.get(),
        });
        found.gears = gears(&sized.gearbox)?;
        found.warnings = warnings(&sized.k, &found.gears);
    }
    Ok(found)
}

fn gear_formulas(scheme: CatalogueScheme, range: RingToSunRange) -> Vec<GearFormulas> {
    let of = |gear, braked, scheme: CatalogueScheme| {
        let [least_ratio, greatest_ratio] = scheme.ratio_range(range);
        GearFormulas {
            gear,
            braked: Some(braked),
            ratio_formula: formulas::ratio(scheme),
            efficiency_formula: formulas::efficiency(scheme),
            least_ratio,
            greatest_ratio,
        }
    };
    let mut all = vec![of(GearName::First, Link::T1, CatalogueScheme::Two(scheme.first_stage()))];
    if matches!(scheme, CatalogueScheme::Three(_)) {
        all.push(of(GearName::Second, Link::T2, scheme));
    }
    all.push(GearFormulas {
        gear: GearName::Direct,
        braked: None,
        ratio_formula: "1".to_owned(),
        efficiency_formula: "1".to_owned(),
        least_ratio: 1.0,
        greatest_ratio: 1.0,
    });
    all
}

fn gears(gearbox: &Gearbox) -> Result<Vec<Gear>, Error> {
    let mut found = vec![];
    for gear in gearbox.gears() {
        let Some(name) = GearName::named(gear.name()) else { continue };
        let analysis = gearbox.analyze(gear.name())?;
        let driving = analysis.driving();
        let engaged = name.engaged();
        let place = gearbox.shift_elements().iter().position(|element| element.id() == engaged.name());
        found.push(Gear {
            gear: name,
            ratio: analysis.ratio(),
            efficiency: analysis.efficiency(),
            back_driving_efficiency: analysis.back_driving_efficiency(),
            output_torque_of_input: driving.map(|case| plain(case.output)),
            engaged,
            engaged_torque_of_input: driving
                .zip(place)
                .and_then(|(case, place)| case.shift_elements[place])
                .map(plain),
            circulating_of_input: driving.map(|case| plain(case.power.circulating)),
            sets: set_speeds(&analysis),
        });
    }
    Ok(found)
}

fn set_speeds(analysis: &Analysis<'_>) -> Vec<SetSpeeds> {
    let of_set = |set: &epicyclic_train::speeds::SetMotion| {
        let member = |place: usize| set.members.get(place).copied().flatten();
        SetSpeeds::of([member(0), member(1), member(2)], set.planets.first().copied().flatten())
    };
    analysis.sets().iter().map(of_set).collect()
}

/// What section 3.1 of the source would object to.
fn warnings(k: &[RingToSunRatio], gears: &[Gear]) -> Vec<Warning> {
    let mut all = vec![];
    let recommended = RingToSunRange::RECOMMENDED;
    for (set, k) in (1..).zip(k).filter(|(_, k)| !recommended.contains(**k)) {
        let (low, high) = (recommended.low(), recommended.high());
        let message = format!("k{set} = {} is outside {low} to {high}", trimmed(k.get(), 5));
        all.push(Warning { name: "ring-to-sun-ratio", message });
    }
    let reversed: Vec<&str> = gears
        .iter()
        .filter(|gear| gear.ratio.is_some_and(|ratio| ratio < 0.0))
        .map(|gear| gear.gear.name())
        .collect();
    if !reversed.is_empty() {
        let plural = if reversed.len() > 1 { "s" } else { "" };
        let message =
            format!("the output reverses between direct drive and gear{plural} {}", reversed.join(" and "));
        all.push(Warning { name: "mixed-directions", message });
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scheme_without_sizes_has_formulas_alone() {
        let scheme = "ii-3".parse::<CatalogueScheme>().unwrap();
        let found = one(scheme, RingToSunRange::USED, Sizes::default(), MeshEfficiency::IDEAL).unwrap();
        assert_eq!((found.formulas.len(), found.gears.len(), found.parameters), (3, 0, None));
    }

    #[test]
    fn sizes_that_do_not_fit_are_told_by_name() {
        let refused = |scheme: &str, sizes| {
            let scheme = scheme.parse::<CatalogueScheme>().unwrap();
            match sized(scheme, sizes, MeshEfficiency::IDEAL) {
                Err(Error::SchemeSize { size, problem }) => (size, problem),
                other => panic!("{other:?}"),
            }
        };
        let one = Sizes { k1: Some(2.5), ..Sizes::default() };
        let (size, problem) = refused("II-3", one);
        assert_eq!((size, problem), (SizeName::K2, SizeProblem::SecondMissing { scheme: "II-3" }));
        let (size, problem) = refused("I", Sizes { ratio2: Some(2.0), ..one });
        assert_eq!((size, problem), (SizeName::Ratio2, SizeProblem::OneSet { scheme: "I" }));
        let (size, problem) = refused("I-1", Sizes { ratio2: Some(2.0), ..Sizes::default() });
        assert_eq!((size, problem), (SizeName::Ratio2, SizeProblem::FirstMissing));
        let (size, problem) = refused("I", Sizes { k1: Some(0.5), ..one });
        assert!(size == SizeName::K1 && matches!(problem, SizeProblem::RingToSunRatio(_)));
    }
}
