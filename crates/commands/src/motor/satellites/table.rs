//! The satellites that a hydromotor's stator and rotor admit, as tables.

use crate::motor::satellites::answer::{MotorSatellites, SatelliteMotor, SatellitesWithout};
use crate::motor::table::facts;
use crate::shared::judgement::table as judgement;
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::quantities::words;
use crate::table::report::AsReport;
use crate::table::report::{Part, Records, Report, Row, Text, headline, warned};
use epicyclic_units::Dimension::{Area, Length};

impl AsReport for MotorSatellites {
    fn report(&self) -> Report {
        let title = format!(
            "Satellites of a hydromotor {}×{}: {}/{} teeth of stator, rotor, module {}",
            self.stator_lobes,
            self.rotor_lobes,
            self.stator_teeth,
            self.rotor_teeth,
            words(Length, self.module_m, 6)
        );
        let numbers = vec![
            Row::new("satellites", "satellites, and chambers", "N + n", [Figure::Count(self.satellites)]),
            Row::new("rotor_teeth", "teeth of the rotor", "Z₁", [Figure::Count(self.rotor_teeth)]),
            Row::new(
                "satellite_teeth_below",
                "teeth of a satellite, below",
                "(Z₃ − Z₁)/2",
                [Figure::Number(self.satellite_teeth_below)],
            ),
        ];
        let mut parts = vec![facts("numbers", "Numbers and their conditions", numbers, "")];
        if !self.motors.is_empty() {
            parts.push(Part::Records(motors(self)));
        }
        if !self.without.is_empty() {
            parts.push(Part::Records(without(&self.without)));
        }
        parts.extend(judgement::parts_of_designs(&self.judgement));
        if let Some(teeth) = self.next_satellite_teeth {
            parts.push(Part::Text(Text {
                heading: Some("Next".to_owned()),
                paragraphs: vec![format!(
                    "Give the teeth of a satellite: --zs {teeth} has the greatest displacement of the motors whose teeth keep \
                     their limits. Other motors of a family: --l, --a, --part."
                )],
                ..Text::default()
            }));
        }
        Report { title: Some(headline(title, &self.warnings)), parts, warnings: warned(&self.warnings) }
    }
}

/// Outcome for the teeth, in few words.
fn teeth(motor: &SatelliteMotor) -> String {
    match motor.broken_limits.as_deref() {
        None => "none of this form".to_owned(),
        Some([]) => "keep their limits".to_owned(),
        Some([first, more @ ..]) => {
            let more = if more.is_empty() { String::new() } else { format!(", {} more", more.len()) };
            format!("{}: {}{more}", first.wheel.words(), first.limit.name().replace('-', " "))
        }
    }
}

fn motors(answer: &MotorSatellites) -> Records {
    let of_family = |motor: &SatelliteMotor| {
        let ends = motor.family.first().zip(motor.family.last());
        ends.map_or([None, None], |(first, last)| [Some(first.from_m), last.to_m])
    };
    let note = "Motors close for l from … to. l, a and what follows: the motor in the middle of that family. q/b: \
                   displacement a revolution over width. δ: ripple at the pitch points. Teeth: the first limit that they break.";
    Table::new("motors", answer.motors.iter())
        .number("satellite_teeth", "Z_s", |motor| motor.satellite_teeth)
        .headed("from", "l from", Length, |motor| of_family(motor)[0])
        .quantity("to", "to", Length, |motor| of_family(motor)[1])
        .quantity("l", "l", Length, |motor| motor.l_m)
        .quantity("a", "a", Length, |motor| motor.a_m)
        .quantity("least_chamber", "A_min", Area, |motor| motor.least_chamber_m2)
        .quantity("displacement_per_width", "q/b", Area, |motor| motor.displacement_per_width_m2)
        .share("ripple", "δ", |motor| motor.ripple)
        .words("teeth", "teeth", |motor| teeth(motor))
        .all("Motors, each in the middle of its family")
        .note(note)
        .records()
}

fn without(without: &[SatellitesWithout]) -> Records {
    Table::new("without", without)
        .number("from", "Z_s from", |one| one.from)
        .number("to", "to", |one| one.to)
        .words("reason", "reason", |one| Figure::choice(one.reason, one.reason.words()))
        .all("Satellites without such a motor")
        .records()
}
