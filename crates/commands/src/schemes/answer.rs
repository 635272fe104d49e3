//! Catalogue of two- and three-speed schemes: a list of all, or one scheme with its formulas and numbers.

mod formulas;

use crate::answer::{Answer, Warning};
use crate::error::Error;
pub use crate::refusal::{SizeName, SizeProblem};
use crate::shared::catalogue::{KRange, SetLinks, SetSpeeds};
use crate::shared::judgement::answer::Judgement;
use crate::shared::number::plain;
use crate::shared::records::Motion;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::simple_set::RingToSunRatio;
use epicyclic_schemes::catalogue::{RingToSunRange, Scheme as CatalogueScheme};
use epicyclic_schemes::catalogue::{SchemeElement, SchemeGear};
use epicyclic_schemes::structures::Role;
use epicyclic_train::{Analysis, Gearbox};
use epicyclic_units::format::trimmed;
use schemars::JsonSchema;
use serde::Serialize;

/// Data that determine the sets of a scheme.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Sizes {
    /// Ring-to-sun ratio of set 1.
    pub k1: Option<f64>,
    /// Ring-to-sun ratio of set 2.
    pub k2: Option<f64>,
    /// Ratio of gear 1, instead of `k1`.
    pub ratio1: Option<f64>,
    /// Ratio of gear 2, instead of `k2`.
    pub ratio2: Option<f64>,
}

/// Scheme whose ring-to-sun ratios are known.
#[derive(Debug, Clone)]
pub struct Sized {
    /// Ring-to-sun ratios of the sets.
    pub k: Vec<RingToSunRatio>,
    /// The gearbox with gears `1`, `2` (of two sets) and `direct`.
    pub gearbox: Gearbox,
}

/// Determines a scheme from the given ring-to-sun ratios or ratios; `None` if none are given.
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
        // The second set follows from the first one, so it cannot be given alone.
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

/// Catalogue of schemes.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Schemes {
    /// Range of ring-to-sun ratios for the ranges of ratios.
    pub k: KRange,
    /// Schemes with their formulas.
    pub schemes: Vec<SchemeFormulas>,
}

/// Scheme of the catalogue.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SchemeFormulas {
    /// Name of the scheme.
    pub scheme: &'static str,
    /// Links of the members of the sets.
    pub sets: Vec<SetLinks>,
    /// Formula of the ratio of the last braked gear, in k₁ and k₂.
    pub ratio_formula: String,
    /// Formula of the efficiency of that gear, in k₁, k₂ and η₀.
    pub efficiency_formula: String,
    /// Least ratio of that gear over the range of k.
    pub least_ratio: f64,
    /// Greatest ratio of that gear over the range of k.
    pub greatest_ratio: f64,
}

impl Answer for Schemes {
    const NAME: &'static str = "schemes";
}

/// Lists all schemes with their ratios over a range of ring-to-sun ratios.
pub(super) fn list(range: RingToSunRange) -> Schemes {
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

/// Scheme with its links, formulas and ranges, and its numbers if the ring-to-sun ratios are known.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Scheme {
    /// Name of the scheme.
    pub scheme: &'static str,
    /// Links of the members of the sets.
    pub sets: Vec<SetLinks>,
    /// Connection of set 2 in gear 2; null for a scheme of one set.
    pub connection: Option<Connection>,
    /// Range of ring-to-sun ratios for the ranges of ratios.
    pub k: KRange,
    /// Formulas of the gears.
    pub formulas: Vec<GearFormulas>,
    /// Ring-to-sun ratios and efficiency of the sets; null if none are given.
    pub parameters: Option<Parameters>,
    /// Results for the gears; empty if no ring-to-sun ratios are given.
    pub gears: Vec<Gear>,
    /// Judgement of the gearbox by rules of practice; empty without ring-to-sun ratios.
    pub judgement: Judgement,
    /// Warnings about the given values.
    pub warnings: Vec<Warning>,
}

/// Connection of the second set, which in gear 2 ties T1 to a shaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Connection {
    /// Shaft to which the second set ties T1.
    pub shaft: Role,
    /// Members of set 2 on T1 (input), on the shaft (output) and on T2 (fixed).
    pub motion: Motion,
}

/// Formulas of a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearFormulas {
    /// Name of the gear.
    pub gear: SchemeGear,
    /// Link that is braked in the gear; null for direct drive.
    pub braked: Option<Role>,
    /// Formula of the ratio in k₁ and k₂.
    pub ratio_formula: String,
    /// Formula of the efficiency in k₁, k₂ and η₀.
    pub efficiency_formula: String,
    /// Least ratio over the range of k.
    pub least_ratio: f64,
    /// Greatest ratio over the range of k.
    pub greatest_ratio: f64,
}

/// Ring-to-sun ratios and efficiency of the sets of a scheme.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Parameters {
    /// Ring-to-sun ratio of set 1.
    pub k1: f64,
    /// Ring-to-sun ratio of set 2; null for a scheme of one set.
    pub k2: Option<f64>,
    /// Efficiency of each set with its carrier fixed.
    pub set_efficiency: f64,
}

/// Results for a gear. Speeds, torques and powers are relative to those of the input.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Gear {
    /// Name of the gear.
    pub gear: SchemeGear,
    /// Ratio, input speed over output speed; null if none exists.
    pub ratio: Option<f64>,
    /// Efficiency when driven from the input; null if the gear is self-locking.
    pub efficiency: Option<f64>,
    /// Back-driving efficiency; null if the gear is self-locking against back-driving.
    pub back_driving_efficiency: Option<f64>,
    /// Torque on the output with losses, relative to the input torque; null if it cannot be computed.
    pub output_torque_of_input: Option<f64>,
    /// Engaged shift element.
    pub engaged: SchemeElement,
    /// Torque of the shift element on its first link with losses, relative to the input torque; null if it
    /// cannot be computed.
    pub engaged_torque_of_input: Option<f64>,
    /// Circulating power with losses, relative to the input power; null if it cannot be computed.
    pub circulating_of_input: Option<f64>,
    /// Speeds in each set, relative to the input speed.
    pub sets: Vec<SetSpeeds>,
}

impl Answer for Scheme {
    const NAME: &'static str = "scheme";
}

/// Computes one scheme with its ratios over a range of ring-to-sun ratios, and its numbers if values are
/// given.
///
/// # Errors
/// [`Error::SchemeSize`], [`Error::Gearbox`].
pub(super) fn one(
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
                shaft: three.connection().shaft().role(),
                motion: Motion::of(three.connection().mode()),
            }),
        },
        k: KRange::of(range.low(), range.high()),
        formulas: gear_formulas(scheme, range),
        parameters: None,
        gears: vec![],
        judgement: Judgement::default(),
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
        found.judgement = Judgement::of_found(&sized.gearbox, &[], &[]);
        found.warnings = warnings(&sized.k, &found.gears);
        found.judgement.add_to(&mut found.warnings);
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
    // Gear 1 of every scheme is that of its first set alone, with T1 braked.
    let mut all = vec![of(SchemeGear::First, Role::T1, CatalogueScheme::Two(scheme.first_stage()))];
    if matches!(scheme, CatalogueScheme::Three(_)) {
        all.push(of(SchemeGear::Second, Role::T2, scheme));
    }
    all.push(GearFormulas {
        gear: SchemeGear::Direct,
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
        // A gearbox of the catalogue has no other gears; the name only has to become a record.
        let Some(name) = SchemeGear::named(gear.name()) else { continue };
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

/// Objections by section 3.1 of the source.
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
