//! Speeds and excitation of a vibration: from options, or otherwise from the keys of the file.

use crate::error::Error;
use crate::shared::exciting::Exciting;
use crate::shared::fault::refused;
use crate::shared::gearbox::Gearbox;
use crate::shared::places::Places;
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::{GearboxFile, VibrationOfGearbox};
use epicyclic_units::{Physical, Quantity};
use uom::si::f64::Length;

/// Maximum number of harmonics, more than the teeth of real gears excite.
const MOST_HARMONICS: u32 = 20;
/// Number of harmonics if neither options nor the file give it.
const HARMONICS: u32 = 3;
/// Number of places in a range of speeds of the file.
const PLACES: u32 = 61;

/// Speeds and excitation from options and file together.
pub(super) struct Settled {
    /// Input speeds in rad/s; empty if none are given.
    pub(super) speeds: Vec<f64>,
    pub(super) harmonics: u32,
    pub(super) excitation: Option<Excitation>,
    pub(super) gyroscopic: bool,
}

/// Excitation by the teeth, and damping of the set.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Excitation {
    /// Amplitudes of the transmission error of a sun mesh, the first harmonic first.
    sun: Vec<Length>,
    /// Amplitudes of the transmission error of a ring mesh, the first harmonic first.
    ring: Vec<Length>,
    /// Damping ratio of every mode.
    pub(super) damping_ratio: f64,
}

impl Settled {
    /// Takes each value from the options, or otherwise from the file.
    ///
    /// # Errors
    /// - [`Error::Harmonics`], [`Error::DampingRatio`], [`Error::TransmissionError`],
    ///   [`Error::ExcitationWithout`] for options.
    /// - [`Error::Document`] for such faults in the file.
    pub(super) fn of(subject: &Gearbox, file: &GearboxFile, options: &Exciting) -> Result<Self, Error> {
        let none = VibrationOfGearbox::default();
        let keys = file.vibration.as_ref().unwrap_or(&none);
        let at = |key: &str, error: &Error| {
            let path = Path::root().key("vibration");
            refused(&subject.document, &path, &[key], error)
        };
        let of_file = keys.speeds.map(|[from, to]| Places::new(from.0, to.0, PLACES)).transpose();
        let of_file = of_file.map_err(|error| at("speeds", &error))?;
        let speeds = options.speeds.as_ref().or(of_file.as_ref());
        let has_speeds = speeds.is_some();
        let mut speeds: Vec<f64> =
            speeds.map_or_else(Vec::new, |all| all.values().map(Physical::si).collect());
        // Resonances are looked for from the least speed up.
        speeds.sort_by(f64::total_cmp);
        let harmonics = options.harmonics.or(keys.harmonics).unwrap_or(HARMONICS);
        if options.harmonics.is_some() && !has_speeds {
            return Err(Error::ExcitationWithout { given: "harmonics", lacks: "speeds of the input" });
        }
        if !(1..=MOST_HARMONICS).contains(&harmonics) {
            let error = Error::Harmonics { harmonics, most: MOST_HARMONICS };
            return Err(if options.harmonics.is_some() { error } else { at("harmonics", &error) });
        }
        let excitation = match Excitation::of(keys, options, has_speeds) {
            Ok(excitation) => excitation,
            Err((error, None)) => return Err(error),
            Err((error, Some(key))) => return Err(at(key, &error)),
        };
        let excitation = excitation.filter(|_| has_speeds);
        if options.without_gyroscopic && excitation.is_none() {
            return Err(Error::ExcitationWithout {
                given: "without-gyroscopic",
                lacks: "a transmission error and speeds of the input",
            });
        }
        Ok(Self { speeds, harmonics, excitation, gyroscopic: !options.without_gyroscopic })
    }

    /// Greatest size of the input speed in rad/s; 0 without speeds.
    pub(super) fn fastest(&self) -> f64 {
        self.speeds.iter().fold(0.0, |fastest, speed| speed.abs().max(fastest))
    }

    /// Least and greatest input speed in rad/s.
    pub(super) fn ends(&self) -> Option<[f64; 2]> {
        Some([*self.speeds.first()?, *self.speeds.last()?])
    }
}

/// Error, with the key of the file if the fault is there.
type Fault = (Error, Option<&'static str>);

impl Excitation {
    /// Allowed damping ratios: a set with less would ring for thousands of periods, and one with more does
    /// not vibrate.
    const DAMPING_RATIOS: [f64; 2] = [1e-4, 1.0];

    /// Combines the values of options and file.
    fn of(keys: &VibrationOfGearbox, options: &Exciting, has_speeds: bool) -> Result<Option<Self>, Fault> {
        let given = |all: &[Quantity<Length>]| -> Vec<Length> { all.iter().map(|one| one.0).collect() };
        let is_of_file = options.transmission_error.is_empty();
        let sun = given(if is_of_file { &keys.transmission_error } else { &options.transmission_error });
        let of_ring = &options.ring_transmission_error;
        let (ring, is_ring_of_file) = match (of_ring.is_empty(), keys.ring_transmission_error.is_empty()) {
            (false, _) => (given(of_ring), false),
            (true, false) if is_of_file => (given(&keys.ring_transmission_error), true),
            _ => (sun.clone(), is_of_file),
        };
        let without = |given, lacks| Error::ExcitationWithout { given, lacks };
        if sun.is_empty() {
            let given = [
                ("ring-transmission-error", !of_ring.is_empty(), None),
                ("damping", options.damping.is_some(), None),
                (
                    "ring_transmission_error",
                    !keys.ring_transmission_error.is_empty(),
                    Some("ring_transmission_error"),
                ),
                ("damping", keys.damping.is_some(), Some("damping")),
            ];
            return match given.into_iter().find(|(_, is_given, _)| *is_given) {
                Some((given, _, key)) => Err((without(given, "a transmission error"), key)),
                None => Ok(None),
            };
        }
        let damping = options.damping.or(keys.damping).map(|damping| damping.0.si());
        let Some(damping_ratio) = damping else {
            let key = is_of_file.then_some("transmission_error");
            return Err((without("transmission-error", "a damping ratio"), key));
        };
        // Values of the file apply only once speeds are given; options require speeds.
        let of_options = [
            ("transmission-error", !is_of_file),
            ("ring-transmission-error", !of_ring.is_empty()),
            ("damping", options.damping.is_some()),
        ];
        if let Some((given, _)) = of_options.into_iter().find(|(_, is_given)| *is_given && !has_speeds) {
            return Err((without(given, "speeds of the input"), None));
        }
        for (all, is_of_file, key) in
            [(&sun, is_of_file, "transmission_error"), (&ring, is_ring_of_file, "ring_transmission_error")]
        {
            let key = is_of_file.then_some(key);
            let harmonics = all.len() as u32;
            if harmonics > MOST_HARMONICS {
                return Err((Error::Harmonics { harmonics, most: MOST_HARMONICS }, key));
            }
            let amplitudes = all.iter().map(|amplitude| amplitude.si());
            if let Some(given_m) = amplitudes.clone().find(|one| !(0.0..f64::INFINITY).contains(one)) {
                return Err((Error::TransmissionError { given_m }, key));
            }
        }
        if sun.iter().chain(&ring).all(|amplitude| amplitude.si() == 0.0) {
            let key = is_of_file.then_some("transmission_error");
            return Err((Error::TransmissionError { given_m: 0.0 }, key));
        }
        let [low, high] = Self::DAMPING_RATIOS;
        if !(low..=high).contains(&damping_ratio) {
            let key = options.damping.is_none().then_some("damping");
            return Err((Error::DampingRatio { given: damping_ratio, low, high }, key));
        }
        Ok(Some(Self { sun, ring, damping_ratio }))
    }

    /// Amplitudes of a harmonic, from 1, of sun and ring.
    pub(super) fn amplitudes(&self, harmonic: u32) -> [Length; 2] {
        let place = harmonic as usize - 1;
        [&self.sun, &self.ring].map(|all| all.get(place).copied().unwrap_or_default())
    }

    /// Number of harmonics that are given.
    pub(super) fn harmonics(&self) -> u32 {
        self.sun.len().max(self.ring.len()) as u32
    }
}
