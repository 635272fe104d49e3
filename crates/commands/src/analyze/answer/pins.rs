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

/// The planet bearings that turn faster than is usual in these gears: all in one warning.
pub(crate) fn warning(subject: &Gearbox, worked: &[&Worked<'_>]) -> Option<Warning> {
    // A list of transmissions has no diameters of bearings.
    let file: GearboxFile = subject.document.read().ok().filter(|_| subject.published.is_empty())?;
    let mut beyond: Vec<String> = vec![];
    for bearing in subject.planet_bearings.iter().filter(|bearing| bearing.load_rating.is_some()) {
        let set = &subject.train.sets()[bearing.set];
        let Some(data) = file.set_data(set) else { continue };
        let PlanetData { rolling, bearing_diameter: diameter, .. } = data.planets[bearing.planet];
        let rolling = rolling.into();
        for Worked { analysis, input, .. } in worked {
            let Some(speed) = input.speed else { continue };
            let planet = analysis.sets()[bearing.set].planets[bearing.planet];
            let turning = planet.map(|planet| (speed * rounded(planet.relative)).abs());
            let carrier = analysis.speed(set.carrier()).map(|of| speed * of);
            let of = format!(
                "set {}, planet {}, gear {}",
                set.id(),
                planet_name(set, bearing.planet),
                analysis.gear().name()
            );
            let on_pin = turning.zip(diameter).and_then(|(speed, diameter)| {
                Some((pin_speed_rule(rolling)?, pin_speed(speed.si(), diameter.si())))
            });
            let in_orbit = carrier.zip(bearing.radius).and_then(|(carrier, radius)| {
                Some((orbit_rule(rolling)?, orbit_acceleration(radius.si(), carrier.si())))
            });
            let misses = on_pin.into_iter().chain(in_orbit).filter_map(|(rule, value)| {
                let verdict = subject.limits.judge(rule, value);
                verdict.severity.filter(|severity| *severity >= Severity::Warning)?;
                Some(format!("{of}: {}: {}", verdict.miss()?, verdict.remedy()))
            });
            beyond.extend(misses);
        }
    }
    beyond.dedup();
    (!beyond.is_empty()).then(|| Warning {
        name: "planet-speed",
        message: format!("planet bearings beyond the limits of practice: {}", beyond.join("; ")),
    })
}

/// Rules whose misses [`warning`] tells.
pub(crate) const OF_PINS: [Rule; 4] =
    [Rule::PinSpeed, Rule::FullPinSpeed, Rule::OrbitAcceleration, Rule::NeedleAcceleration];
