//! Usual values of what a gearbox is for.

use crate::answer::Warning;
use crate::shared::basis::Basis;
use crate::shared::bearing_type::BearingType;
use crate::strength::answer::factors::KEYS;
use crate::table::figure::hours;
use crate::tolerance::SAME;
use epicyclic_formats::yaml::{Mapping, Value};
use epicyclic_judge::Rule;
use epicyclic_strength::factor::Symbol;
use epicyclic_strength::masses::{CAR_DISCS, INDUSTRIAL_DISCS};
use epicyclic_units::{Physical, Quantity};
use std::ops::RangeInclusive;
use uom::si::f64::{Angle, Length, Time};

/// Modules of servo drives in mm, of series I of DIN 780.
const FINE_MODULES_MM: [f64; 9] = [0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.25, 1.5, 2.0];

/// Full load and speed at all times, as [`Application::spectrum`].
pub(crate) const FULL_LOAD: [[f64; 3]; 1] = [[1.0; 3]];

/// Share of the time of a reverse gear of a car, and of its first gear.
const REVERSE: f64 = 0.005;
const FIRST: f64 = 0.02;

/// Helix angle of automatic transmissions in degrees: practice, without a source.
const AUTOMATIC_HELIX_DEG: f64 = 20.0;

/// Face widths of servo drives over the diameter of the smaller gear: wider than of others.
const SERVO_WIDTHS: &str = "0.4..1.4";

/// `Y_M` of roots that are bent both ways alike.
const BENT_BOTH_WAYS: f64 = 0.7;

/// Face widths of servo drives in mm.
const FINE_WIDTHS_MM: RangeInclusive<u32> = 5..=40;

/// Purpose of a gearbox, with usual values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Application {
    /// Belt and scraper conveyors.
    Conveyor,
    /// Travel drives of crawlers and wheels.
    Travel,
    /// Slewing drives of cranes and excavators.
    Slewing,
    /// Winches and hoists.
    Winch,
    /// Mixers and agitators.
    Mixer,
    /// Wind turbines.
    Wind,
    /// Robots and servo drives.
    Robot,
    /// Automatic transmissions of cars.
    Automatic,
}

/// Values that are usual of an application.
struct Usual {
    /// Application factor.
    k_a: f64,
    life_h: u32,
    /// Required safeties of flank and root.
    safeties: [f64; 2],
}

/// Application factors that the sets of a file state.
fn k_a_of(file: &Value) -> Vec<f64> {
    let sets = ["sets", "compound_sets"].into_iter().filter_map(|key| file.get(key)?.as_sequence()).flatten();
    let strengths = sets.chain([file]).filter_map(|set| set.get("strength"));
    let factors =
        strengths.flat_map(|strength| KEYS.into_iter().filter_map(|key| strength.get(key)?.as_mapping()));
    let is_k_a =
        |(name, _): &(&Value, &Value)| name.as_str().and_then(Symbol::named) == Some(Symbol::Application);
    factors.flatten().filter(is_k_a).filter_map(|(_, value)| value.as_f64()).collect()
}

impl Application {
    /// Values of usual practice; none is measured.
    const fn usual(self) -> Usual {
        let (k_a, life_h, safeties) = match self {
            Self::Conveyor => (1.5, 30_000, [1.2, 1.5]),
            Self::Travel => (1.25, 5_000, [1.0, 1.4]),
            Self::Slewing => (1.4, 6_300, [1.1, 1.5]),
            Self::Winch => (1.4, 3_200, [1.1, 1.5]),
            Self::Mixer => (1.5, 20_000, [1.2, 1.5]),
            Self::Wind => (1.25, 175_200, [1.25, 1.56]),
            Self::Robot => (1.1, 20_000, [1.0, 1.4]),
            Self::Automatic => (1.0, 3_000, [1.0, 1.2]),
        };
        Usual { k_a, life_h, safeties }
    }

    /// Steps of the duty in each gear: share of its time, torque and speed over those that are stated. Cars
    /// rarely use all that their engine has.
    pub(crate) const fn spectrum(self) -> &'static [[f64; 3]] {
        match self {
            Self::Automatic => &[[0.95, 0.5, 0.5], [0.05, 1.0, 1.0]],
            _ => &FULL_LOAD,
        }
    }

    /// Shares of the time of gears with these ratios; empty for equal shares. Cars are rarely in reverse and
    /// in their first gear.
    pub(crate) fn shares(self, ratios: &[f64]) -> Vec<f64> {
        let first = ratios.iter().copied().fold(0.0, f64::max);
        let seldom = |ratio: &f64| match *ratio {
            ratio if ratio < 0.0 => Some(REVERSE),
            ratio if ratio == first => Some(FIRST),
            _ => None,
        };
        let others = ratios.iter().filter(|ratio| seldom(ratio).is_none()).count();
        if self != Self::Automatic || others == 0 {
            return vec![];
        }
        let rest = 1.0 - ratios.iter().filter_map(seldom).sum::<f64>();
        ratios.iter().map(|ratio| seldom(ratio).unwrap_or(rest / others as f64)).collect()
    }

    /// Kinds of planet bearings.
    pub(crate) const fn bearings(self) -> &'static [BearingType] {
        use BearingType::{FullComplement, Needles, Plain, Rollers, RollersInBore};
        match self {
            Self::Conveyor | Self::Mixer => &[Rollers],
            Self::Travel | Self::Slewing | Self::Winch => &[Rollers, FullComplement],
            Self::Wind => &[Rollers, RollersInBore, Plain],
            Self::Robot | Self::Automatic => &[Needles],
        }
    }

    /// Numbers of planets.
    pub(crate) const fn planets(self) -> RangeInclusive<u32> {
        match self {
            Self::Conveyor | Self::Slewing => 3..=4,
            Self::Robot => 3..=3,
            Self::Travel | Self::Winch | Self::Mixer | Self::Wind | Self::Automatic => 3..=5,
        }
    }

    /// Whether flanks are corrected along their width, so that wide ones need no greater `K_Hβ`.
    pub(crate) fn corrects_flanks(self) -> bool {
        self == Self::Robot
    }

    /// Helix angle of the teeth; `None` of spur teeth. Those of cars are helical for their noise.
    pub(crate) fn helix_angle(self) -> Option<Quantity<Angle>> {
        (self == Self::Automatic).then(|| Quantity(Angle::from_degrees(AUTOMATIC_HELIX_DEG)))
    }

    /// Modules; `None` for those of other gearboxes.
    pub(crate) fn modules(self) -> Option<Vec<Length>> {
        (self == Self::Robot).then(|| FINE_MODULES_MM.map(Length::from_mm).to_vec())
    }

    /// Face widths; `None` for those of other gearboxes.
    pub(crate) fn face_widths(self) -> Option<Vec<Length>> {
        (self == Self::Robot).then(|| FINE_WIDTHS_MM.map(|mm| Length::from_mm(f64::from(mm))).collect())
    }

    /// Whether the slow shaft is part of the gearbox. A rotor's shaft is clamped in the carrier.
    pub(crate) fn has_slow_shaft(self) -> bool {
        self != Self::Wind
    }

    /// Whether the gearbox has flanges for motor and driven machine, and the bearings of the output between
    /// them, as servo gearboxes.
    pub(crate) fn has_flanges(self) -> bool {
        self == Self::Robot
    }

    /// Static torque of brakes and clutches over their mass, in N·m/kg.
    pub(crate) fn torque_of_discs(of: Option<Self>) -> f64 {
        if of == Some(Self::Automatic) { CAR_DISCS } else { INDUSTRIAL_DISCS }
    }

    /// Teeth of suns in series: those of servo drives are small.
    pub(crate) const fn suns(of: Option<Self>) -> RangeInclusive<u32> {
        match of {
            Some(Self::Robot) => 12..=30,
            _ => 17..=30,
        }
    }

    /// A remark on values of the application that a file states otherwise; `None` without such values.
    pub(crate) fn not_used(self, file: &Value, name: &str) -> Option<Warning> {
        let Usual { k_a, life_h, safeties: [flank, root] } = self.usual();
        let differs = |own: f64, usual: f64| (own - usual).abs() > SAME * usual;
        let mut all = vec![];
        let life =
            file.get("life").and_then(Value::as_str).and_then(|life| life.parse::<Quantity<Time>>().ok());
        if life.is_some_and(|life| differs(hours(life.0.si()), f64::from(life_h))) {
            all.push(format!("life {life_h} h"));
        }
        for (key, usual) in [("flank", flank), ("root", root)] {
            let own = file.get("required").and_then(|required| required.get(key)?.as_f64());
            if own.is_some_and(|own| differs(own, usual)) {
                all.push(format!("required.{key} {usual}"));
            }
        }
        if k_a_of(file).into_iter().any(|own| differs(own, k_a)) {
            all.push(format!("K_A {k_a}"));
        }
        (!all.is_empty()).then(|| Warning {
            name: "application-not-used",
            message: format!(
                "--application: {} not used: {name} states {}; delete there what --application is to decide",
                if all.len() == 1 { format!("{} is", all[0]) } else { format!("{} are", all.join(", ")) },
                if all.len() == 1 { "another value" } else { "other values" },
            ),
        })
    }

    /// Whether the torque reverses often, so that roots of all gears are bent both ways.
    const fn reverses(self) -> bool {
        matches!(self, Self::Travel | Self::Slewing | Self::Robot | Self::Automatic)
    }

    /// The default basis with the values of the application.
    pub(crate) fn basis(self) -> Basis {
        let Usual { k_a, life_h, safeties: [flank, root] } = self.usual();
        let mut factors = vec![("K_A".to_owned(), k_a)];
        factors.extend(self.reverses().then(|| ("Y_M".to_owned(), BENT_BOTH_WAYS)));
        let required = [("flank", flank), ("root", root)];
        let required = required.map(|(key, value)| (Value::from(key), Value::from(value)));
        let basis = Basis::default()
            .with_factors(&factors)
            .with("life", format!("{life_h} h").into())
            .with("required", Value::Mapping(required.into_iter().collect::<Mapping>()));
        if self != Self::Robot {
            return basis;
        }
        let widths = (Value::from(Rule::FaceWidth.name()), Value::from(SERVO_WIDTHS));
        basis.with("limits", Value::Mapping([widths].into_iter().collect::<Mapping>()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use BearingType::{FullComplement, Needles, Plain, Rollers, RollersInBore};

    /// Application, `K_A`, life in h, safeties of flank and root, `Y_M` where roots are bent both ways, planets,
    /// bearings. Usual practice; the safeties of wind turbines are those of IEC 61400-4, their life is 20 years.
    type Row = (Application, f64, u32, [f64; 2], Option<f64>, RangeInclusive<u32>, &'static [BearingType]);

    #[test]
    fn usual_values_of_every_application() {
        use Application::*;
        let rows: [Row; 8] = [
            (Conveyor, 1.5, 30_000, [1.2, 1.5], None, 3..=4, &[Rollers]),
            (Travel, 1.25, 5_000, [1.0, 1.4], Some(0.7), 3..=5, &[Rollers, FullComplement]),
            (Slewing, 1.4, 6_300, [1.1, 1.5], Some(0.7), 3..=4, &[Rollers, FullComplement]),
            (Winch, 1.4, 3_200, [1.1, 1.5], None, 3..=5, &[Rollers, FullComplement]),
            (Mixer, 1.5, 20_000, [1.2, 1.5], None, 3..=5, &[Rollers]),
            (Wind, 1.25, 175_200, [1.25, 1.56], None, 3..=5, &[Rollers, RollersInBore, Plain]),
            (Robot, 1.1, 20_000, [1.0, 1.4], Some(0.7), 3..=3, &[Needles]),
            (Automatic, 1.0, 3_000, [1.0, 1.2], Some(0.7), 3..=5, &[Needles]),
        ];
        for (of, k_a, life_h, [flank, root], mean_stress, planets, bearings) in rows {
            let file = of.basis().file();
            let number = |keys: &[&str]| {
                let at = keys.iter().try_fold(&file, |value, key| value.get(*key));
                at.and_then(Value::as_f64)
            };
            assert_eq!(number(&["strength", "factors", "K_A"]), Some(k_a), "{of:?}");
            assert_eq!(number(&["strength", "factors", "Y_M"]), mean_stress, "{of:?}");
            assert_eq!(number(&["required", "flank"]), Some(flank), "{of:?}");
            assert_eq!(number(&["required", "root"]), Some(root), "{of:?}");
            assert_eq!(file.get("life").and_then(Value::as_str), Some(&*format!("{life_h} h")), "{of:?}");
            let widths = file.get("limits").and_then(|limits| limits.get("face-width")?.as_str());
            assert_eq!(widths, (of == Robot).then_some("0.4..1.4"), "{of:?}");
            assert_eq!((of.planets(), of.bearings()), (planets, bearings), "{of:?}");
            assert_eq!(Application::suns(Some(of)), if of == Robot { 12..=30 } else { 17..=30 }, "{of:?}");
            let helix = of.helix_angle().map(|angle| angle.0.si().to_degrees().round());
            assert_eq!(helix, (of == Automatic).then_some(20.0), "{of:?}");
            let flags = [of.corrects_flanks(), of.has_flanges(), of.has_slow_shaft()];
            assert_eq!(flags, [of == Robot, of == Robot, of != Wind], "{of:?}");
            let steps: &[[f64; 3]] = match of {
                Automatic => &[[0.95, 0.5, 0.5], [0.05, 1.0, 1.0]],
                _ => &[[1.0, 1.0, 1.0]],
            };
            assert_eq!(of.spectrum(), steps, "{of:?}");
            // Reverse and first gear have half a hundredth and two hundredths of the time.
            let shares = of.shares(&[4.0, 2.0, -3.0]);
            let due = if of == Automatic { vec![0.02, 0.975, 0.005] } else { vec![] };
            assert_eq!(shares, due, "{of:?}");
            let of_discs = Application::torque_of_discs(Some(of));
            assert_eq!(of_discs, if of == Automatic { 300.0 } else { 90.0 }, "{of:?}");
        }
        assert_eq!(Application::suns(None), 17..=30);
    }

    /// Modules of DIN 780, and gears from 5 to 40 mm wide.
    #[test]
    fn usual_sizes_of_servo_drives() {
        let mm =
            |all: Vec<Length>| all.iter().map(|one| (1e5 * one.si()).round() / 100.0).collect::<Vec<_>>();
        let modules = mm(Application::Robot.modules().unwrap());
        assert_eq!(modules, [0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.25, 1.5, 2.0]);
        let widths = mm(Application::Robot.face_widths().unwrap());
        assert_eq!((widths.len(), widths[0], widths[35]), (36, 5.0, 40.0));
        assert!(Application::Winch.modules().is_none() && Application::Winch.face_widths().is_none());
    }
}
