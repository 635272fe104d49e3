//! The judgement of a file.

use super::answer::Judgement;
use super::judge::Judge;
use super::{loads, teeth};
use crate::answer::Warning;
use crate::losses::answer::Heat;
use crate::shared::gearbox::Gearbox as Subject;
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::strength::answer::Strength;
use crate::tolerance::rounded;
use epicyclic_formats::gearbox::{GearboxFile, PlanetData, WrittenSize, written_with_sizes};
use epicyclic_judge::Rule;
use epicyclic_train::Gearbox;

/// Temperature of the air, °C.
const AIR_C: f64 = 20.0;

/// Ratio of a gear that a search found, with the one asked for and its tolerance.
pub(crate) struct FoundRatio {
    pub(crate) gear: String,
    pub(crate) wanted: f64,
    pub(crate) tolerance: f64,
    pub(crate) found: f64,
}

impl Judgement {
    /// Judges a gearbox of a file, or one set of it. The strength is that at an operating point, with its
    /// factors; without one that over the duty of the file. With a balance of heat the oil is judged in air of
    /// 20 °C.
    ///
    /// Data of the file that cannot be used leave out the rules that need them, with the fault as the reason.
    #[must_use]
    pub(crate) fn of(
        subject: &Subject,
        set: Option<&str>,
        strength: Option<&Strength>,
        heat: Option<&Heat>,
    ) -> Self {
        Self::collected(subject, set, strength, heat).judgement()
    }

    /// Judges a gearbox, and adds the misses to the warnings of an answer about it.
    #[must_use]
    pub(crate) fn added_to(warnings: &mut Vec<Warning>, subject: &Subject) -> Self {
        let judgement = Self::of(subject, None, None, None);
        judgement.add_to(warnings);
        judgement
    }

    /// Judges a gearbox that a search found by what its file would say, and its ratios by those asked for.
    pub(crate) fn of_found(train: &Gearbox, sizes: &[WrittenSize], ratios: &[FoundRatio]) -> Self {
        let text = written_with_sizes(train, sizes, &[]).map_err(|error| error.to_string());
        Self::of_written(train.name(), text, ratios)
    }

    /// Judges a gearbox by the text of its file, and its ratios by those asked for. Without a text no rule
    /// is judged, and the reason is told.
    pub(crate) fn of_written(name: &str, text: Result<String, String>, ratios: &[FoundRatio]) -> Self {
        let subject = text.and_then(|text| {
            Subject::parse("found.yaml", text.as_bytes()).map_err(|error| error.to_string())
        });
        let mut judge = match subject {
            Ok(subject) => Self::collected(&subject, None, None, None),
            Err(why) => {
                let mut judge = Judge::default();
                judge.lacks(name, &[Rule::CirculatingPower, Rule::StageEfficiency], vec![why]);
                judge
            }
        };
        for one in ratios {
            let name = format!("gear {}", one.gear);
            let deviation = rounded((one.found / one.wanted - 1.0).abs());
            judge.see_most(Rule::RatioDeviation, &[&name], one.tolerance, deviation);
            judge.see(Rule::Direction, &[&name], (one.found * one.wanted).signum());
        }
        judge.judgement()
    }

    /// Collects the verdicts of [`Self::of`], for rules that a command adds.
    pub(crate) fn collected(
        subject: &Subject,
        set: Option<&str>,
        strength: Option<&Strength>,
        heat: Option<&Heat>,
    ) -> Judge {
        let mut judge = Judge::by(subject.limits.clone());
        let is_wanted = |id: &str| set.is_none_or(|set| set == id);
        judge.take_tooth_checks(&ToothChecks::of(subject.tooth_checks(), is_wanted));
        let is_listed = subject.document.value().get("transmissions").is_some();
        let mut has_plain = false;
        if let Ok(file) = subject.document.read::<GearboxFile>()
            && !is_listed
        {
            for set in subject.train.sets().iter().filter(|set| is_wanted(set.id())) {
                if let Some(data) = file.set_data(set) {
                    teeth::judge(&mut judge, subject, &file, set, &data);
                    has_plain |= data.planets.iter().any(PlanetData::is_on_plain_bearings);
                }
            }
            loads::judge(&mut judge, subject, &file, set, strength);
        }
        for gear in heat.iter().flat_map(|heat| &heat.gears) {
            judge.see(Rule::OilTemperature, &[&format!("gear {}", gear.gear)], AIR_C + gear.rise_k);
        }
        let why = "no method here".to_owned();
        judge.lacks(subject.train.name(), &[Rule::Scuffing, Rule::Micropitting], vec![why]);
        if has_plain {
            let why = "left to the maker of the bearings".to_owned();
            judge.lacks(subject.train.name(), &[Rule::PlainHeat], vec![why]);
        }
        judge
    }
}
