//! Practical limits for planets on their pins, checked if the input speed and the bearing are known.
//!
//! The limits are those of the file, otherwise those of the rules [`PinSpeed`](Rule::PinSpeed),
//! [`FullPinSpeed`](Rule::FullPinSpeed), [`OrbitAcceleration`](Rule::OrbitAcceleration) and
//! [`NeedleAcceleration`](Rule::NeedleAcceleration): of `n·d_m` and `a·ω_H²`.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `n` | speed of the planet relative to its carrier | rpm |
//! | `d_m` | mean diameter of its bearing | mm |
//! | `a`, `ω_H` | radius of the planets' centres, speed of the carrier | m, rad/s |
//! | `g` | 9.80665 | m/s² |

use super::Worked;
use super::records::planet_name;
use crate::answer::Warning;
use crate::shared::gearbox::Gearbox;
use crate::tolerance::rounded;
use epicyclic_formats::gearbox::{GearboxFile, PlanetData};
use epicyclic_gears::involute::practice::{orbit_acceleration, orbit_rule, pin_speed, pin_speed_rule};
use epicyclic_judge::{Rule, Severity};
use epicyclic_units::Physical;

/// Name of the warning of planets that turn too fast.
pub(crate) const PLANET_SPEED: &str = "planet-speed";

/// Words for what is judged at a speed without load.
pub(crate) const WITHOUT_LOAD: &str = "at the speed without load";

/// The planet bearings that turn faster than is usual in these gears under load, or without: all in one warning,
/// each by its greatest speed in a gear.
pub(crate) fn warning(
    subject: &Gearbox,
    loaded: &[&Worked<'_>],
    without_load: &[&Worked<'_>],
) -> Option<Warning> {
    // A list of transmissions has no diameters of bearings.
    let file: GearboxFile = subject.document.read().ok().filter(|_| subject.published.is_empty())?;
    let mut beyond: Vec<String> = vec![];
    let of_loaded = || loaded.iter().map(|gear| (*gear, None));
    let all = || of_loaded().chain(without_load.iter().map(|gear| (*gear, Some(WITHOUT_LOAD))));
    for bearing in subject.planet_bearings.iter().filter(|bearing| bearing.load_rating.is_some()) {
        let set = &subject.train.sets()[bearing.set];
        let Some(data) = file.set_data(set) else { continue };
        let PlanetData { rolling, bearing_diameter: diameter, .. } = data.planets[bearing.planet];
        let rolling = rolling.into();
        // Greatest value of each rule in each gear.
        let mut greatest: Vec<(&str, Rule, f64, Option<&str>)> = vec![];
        for (Worked { analysis, input, .. }, state) in all() {
            let Some(speed) = input.speed else { continue };
            let planet = analysis.sets()[bearing.set].planets[bearing.planet];
            let turning = planet.map(|planet| (speed * rounded(planet.relative)).abs());
            let carrier = analysis.speed(set.carrier()).map(|of| speed * of);
            let on_pin = turning.zip(diameter).and_then(|(speed, diameter)| {
                Some((pin_speed_rule(rolling)?, pin_speed(speed.si(), diameter.si())))
            });
            let in_orbit = carrier.zip(bearing.radius).and_then(|(carrier, radius)| {
                Some((orbit_rule(rolling)?, orbit_acceleration(radius.si(), carrier.si())))
            });
            for (rule, value) in on_pin.into_iter().chain(in_orbit) {
                let own = (analysis.gear().name(), rule, value, state);
                match greatest.iter_mut().find(|of| (of.0, of.1) == (own.0, rule)) {
                    None => greatest.push(own),
                    Some(known) if known.2 < value => *known = own,
                    Some(_) => {}
                }
            }
        }
        let misses = greatest.into_iter().filter_map(|(gear, rule, value, state)| {
            let verdict = subject.limits.judge(rule, value);
            verdict.severity.filter(|severity| *severity >= Severity::Warning)?;
            let of = format!("set {}, planet {}, gear {gear}", set.id(), planet_name(set, bearing.planet));
            let state = state.map(|state| format!(", {state}")).unwrap_or_default();
            Some(format!("{of}{state}: {}: {}", verdict.miss()?, verdict.remedy()))
        });
        beyond.extend(misses);
    }
    (!beyond.is_empty()).then(|| Warning {
        name: PLANET_SPEED,
        message: format!("planet bearings beyond the limits of practice: {}", beyond.join("; ")),
    })
}

/// Rules whose misses [`warning`] tells.
pub(crate) const OF_PINS: [Rule; 4] =
    [Rule::PinSpeed, Rule::FullPinSpeed, Rule::OrbitAcceleration, Rule::NeedleAcceleration];
