//! The judgement of a file.

use super::answer::Judgement;
use super::judge::Judge;
use super::{loads, teeth};
use crate::losses::answer::Heat;
use crate::shared::gearbox::Gearbox;
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::strength::answer::Strength;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_judge::Rule;

/// Temperature of the air, °C.
const AIR_C: f64 = 20.0;

impl Judgement {
    /// Judges a gearbox of a file, or one set of it. The strength is that at an operating point, with its
    /// factors; without one that over the duty of the file. With a balance of heat the oil is judged in air of
    /// 20 °C.
    ///
    /// Data of the file that cannot be used leave out the rules that need them, with the fault as the reason.
    #[must_use]
    pub(crate) fn of(
        subject: &Gearbox,
        set: Option<&str>,
        strength: Option<&Strength>,
        heat: Option<&Heat>,
    ) -> Self {
        let mut judge = Judge::default();
        let is_wanted = |id: &str| set.is_none_or(|set| set == id);
        judge.take_tooth_checks(&ToothChecks::of(subject.tooth_checks(), is_wanted));
        let is_listed = subject.document.value().get("transmissions").is_some();
        if let Ok(file) = subject.document.read::<GearboxFile>()
            && !is_listed
        {
            for set in subject.train.sets().iter().filter(|set| is_wanted(set.id())) {
                if let Some(data) = file.set_data(set) {
                    teeth::judge(&mut judge, subject, &file, set, &data);
                }
            }
            loads::judge(&mut judge, subject, &file, set, strength);
        }
        for gear in heat.iter().flat_map(|heat| &heat.gears) {
            judge.see(Rule::OilTemperature, &[&format!("gear {}", gear.gear)], AIR_C + gear.rise_k);
        }
        let why = "no method here".to_owned();
        judge.lacks(subject.train.name(), &[Rule::Scuffing, Rule::Micropitting], vec![why]);
        judge.judgement()
    }
}
