//! What is asked of a vibration: by options, or else by the keys of the file.

use crate::error::Error;
use crate::losses::answer::Places;
use crate::shared::gearbox::Subject;
use crate::strength::answer::place::refused;
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::{GearboxFile, VibrationOfGearbox};
use epicyclic_units::{Physical, Quantity};
use uom::si::f64::{AngularVelocity, Length};

/// What is asked. What is not given here is that of the file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Wanted {
    /// One gear; all without.
    pub gear: Option<String>,
    /// One set; all without.
    pub set: Option<String>,
    /// Speeds of the input, for resonances and frequencies over the speed.
    pub speeds: Option<Places<AngularVelocity>>,
    /// How many harmonics of the meshes are told.
    pub harmonics: Option<u32>,
    /// Amplitudes of the transmission error of the meshes, the first harmonic first, for forces over the
    /// speeds.
    pub transmission_error: Vec<Length>,
    /// The same of the ring's meshes; that of all without.
    pub ring_transmission_error: Vec<Length>,
    /// Damping ratio of every mode, for these forces.
    pub damping: Option<f64>,
    /// Forces without the gyroscopic effect of the carrier's speed.
    pub without_gyroscopic: bool,
    /// The modes of the whole gearbox in the plane, too.
    pub coupled: bool,
}

impl Wanted {
    /// More harmonics than the teeth of real gears have.
    pub const MOST_HARMONICS: u32 = 20;
    /// Harmonics where neither options nor the file say how many.
    const HARMONICS: u32 = 3;
    /// Places in a range of speeds of the file.
    const PLACES: u32 = 61;
}

/// What is asked, with what the file says.
pub(super) struct Settled {
    /// Speeds of the input, rad/s; empty without.
    pub(super) speeds: Vec<f64>,
    pub(super) harmonics: u32,
    pub(super) excitation: Option<Excitation>,
    pub(super) gyroscopic: bool,
}

/// What the teeth do, and how the set is damped.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Excitation {
    /// Amplitudes of the transmission error of a mesh of the sun, the first harmonic first.
    sun: Vec<Length>,
    /// The same of the ring.
    ring: Vec<Length>,
    /// Damping ratio of every mode.
    pub(super) damping_ratio: f64,
}

impl Settled {
    /// What the options say, and else the file.
    ///
    /// # Errors
    /// - [`Error::Harmonics`], [`Error::DampingRatio`], [`Error::TransmissionError`],
    ///   [`Error::ExcitationWithout`] of options.
    /// - [`Error::Document`] for the same in the file.
    pub(super) fn of(subject: &Subject<'_>, file: &GearboxFile, wanted: &Wanted) -> Result<Self, Error> {
        let none = VibrationOfGearbox::default();
        let keys = file.vibration.as_ref().unwrap_or(&none);
        let at = |key: &str, error: &Error| {
            let path = Path::root().key("vibration");
            refused(subject.document, &path, &[key], error)
        };
        let of_file = keys.speeds.map(|[from, to]| Places::new(from.0, to.0, Wanted::PLACES)).transpose()?;
        let speeds = wanted.speeds.as_ref().or(of_file.as_ref());
        let has_speeds = speeds.is_some();
        let speeds = speeds.map_or_else(Vec::new, |all| all.values().into_iter().map(Physical::si).collect());
        let harmonics = wanted.harmonics.or(keys.harmonics).unwrap_or(Wanted::HARMONICS);
        if wanted.harmonics.is_some() && !has_speeds {
            return Err(Error::ExcitationWithout { given: "harmonics", lacks: "speeds of the input" });
        }
        if !(1..=Wanted::MOST_HARMONICS).contains(&harmonics) {
            let error = Error::Harmonics { harmonics, most: Wanted::MOST_HARMONICS };
            return Err(if wanted.harmonics.is_some() { error } else { at("harmonics", &error) });
        }
        let excitation = match Excitation::of(keys, wanted, has_speeds) {
            Ok(excitation) => excitation,
            Err((error, None)) => return Err(error),
            Err((error, Some(key))) => return Err(at(key, &error)),
        };
        let excitation = excitation.filter(|_| has_speeds);
        if wanted.without_gyroscopic && excitation.is_none() {
            return Err(Error::ExcitationWithout {
                given: "without-gyroscopic",
                lacks: "a transmission error and speeds of the input",
            });
        }
        Ok(Self { speeds, harmonics, excitation, gyroscopic: !wanted.without_gyroscopic })
    }

    /// The least and the greatest speed of the input, rad/s.
    pub(super) fn ends(&self) -> Option<[f64; 2]> {
        let [first, last] = [self.speeds.first()?, self.speeds.last()?];
        Some([first.min(*last), first.max(*last)])
    }
}

/// What is wrong, with the key of the file where it stands there.
type Fault = (Error, Option<&'static str>);

impl Excitation {
    /// Damping ratios that are taken: a set with less would ring for thousands of periods, and one with more
    /// does not vibrate.
    const DAMPING_RATIOS: [f64; 2] = [1e-4, 1.0];

    /// What options and file say together.
    fn of(keys: &VibrationOfGearbox, wanted: &Wanted, has_speeds: bool) -> Result<Option<Self>, Fault> {
        let given = |all: &[Quantity<Length>]| -> Vec<Length> { all.iter().map(|one| one.0).collect() };
        let (of_options, of_ring) = (&wanted.transmission_error, &wanted.ring_transmission_error);
        let (sun, is_of_file) = if of_options.is_empty() {
            (given(&keys.transmission_error), true)
        } else {
            (of_options.clone(), false)
        };
        let (ring, is_ring_of_file) = match (of_ring.is_empty(), keys.ring_transmission_error.is_empty()) {
            (false, _) => (of_ring.clone(), false),
            (true, false) if is_of_file => (given(&keys.ring_transmission_error), true),
            _ => (sun.clone(), is_of_file),
        };
        let without = |given, lacks| Error::ExcitationWithout { given, lacks };
        if sun.is_empty() {
            let given = [
                ("ring-transmission-error", !of_ring.is_empty(), None),
                ("damping", wanted.damping.is_some(), None),
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
        let damping = wanted.damping.or(keys.damping.map(|damping| damping.0.si()));
        let Some(damping_ratio) = damping else {
            let key = is_of_file.then_some("transmission_error");
            return Err((without("transmission-error", "a damping ratio"), key));
        };
        // What the file states waits for speeds; what is asked needs them.
        let asked = [
            ("transmission-error", !is_of_file),
            ("ring-transmission-error", !of_ring.is_empty()),
            ("damping", wanted.damping.is_some()),
        ];
        if let Some((given, _)) = asked.into_iter().find(|(_, is_asked)| *is_asked && !has_speeds) {
            return Err((without(given, "speeds of the input"), None));
        }
        let most = Wanted::MOST_HARMONICS;
        for (all, is_of_file, key) in
            [(&sun, is_of_file, "transmission_error"), (&ring, is_ring_of_file, "ring_transmission_error")]
        {
            let key = is_of_file.then_some(key);
            let harmonics = all.len() as u32;
            if harmonics > most {
                return Err((Error::Harmonics { harmonics, most }, key));
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
            let key = wanted.damping.is_none().then_some("damping");
            return Err((Error::DampingRatio { given: damping_ratio, low, high }, key));
        }
        Ok(Some(Self { sun, ring, damping_ratio }))
    }

    /// Amplitudes of a harmonic, from 1: of sun and ring.
    pub(super) fn amplitudes(&self, harmonic: u32) -> [Length; 2] {
        let place = harmonic as usize - 1;
        [&self.sun, &self.ring].map(|all| all.get(place).copied().unwrap_or_default())
    }

    /// Harmonics that are given.
    pub(super) fn harmonics(&self) -> u32 {
        self.sun.len().max(self.ring.len()) as u32
    }
}
