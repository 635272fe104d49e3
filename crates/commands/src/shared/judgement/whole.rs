//! The judgement of a file.

use super::answer::Judgement;
use super::judge::Judge;
use super::{loads, teeth};
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::strength::answer::Strength;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_judge::Rule;

impl Judgement {
    /// Judges a gearbox of a file, or one set of it. The strength is that at an operating point, with its
    /// factors; without one that over the duty of the file.
    ///
    /// # Errors
    /// [`Error::Document`] for invalid data in the file, with the place.
    pub(crate) fn of(
        subject: &Gearbox,
        set: Option<&str>,
        strength: Option<&Strength>,
    ) -> Result<Self, Error> {
        let mut judge = Judge::default();
        let is_wanted = |id: &str| set.is_none_or(|set| set == id);
        judge.take_tooth_checks(&ToothChecks::of(subject.tooth_checks(), is_wanted));
        if subject.document.value().get("transmissions").is_some() {
            return Ok(judge.judgement());
        }
        let file: GearboxFile = subject.document.read()?;
        for set in subject.train.sets().iter().filter(|set| is_wanted(set.id())) {
            if let Some(data) = file.set_data(set) {
                teeth::judge(&mut judge, subject, &file, set, &data)?;
            }
        }
        loads::judge(&mut judge, subject, &file, set, strength)?;
        judge.lacks(
            subject.train.name(),
            &[Rule::Scuffing, Rule::Micropitting],
            vec!["no method here: rate them by ISO/TS 6336-20, -21 and -22".to_owned()],
        );
        Ok(judge.judgement())
    }
}
