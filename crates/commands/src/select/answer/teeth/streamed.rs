//! Answer whose designs are computed while they are written.

use super::{BestOfStructure, RequiredSize, Searched, Searches, SelectTeeth};
use crate::answer::Answer;
use crate::finite;
use crate::select::answer::reached::ReachedSpeed;
use crate::select::answer::required::Required;
use crate::shared::judgement::answer::Judgement;
use crate::teeth::answer::shifted::RequiredShifts;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::ser::{Error as _, SerializeSeq as _};
use serde::{Serialize, Serializer};
use std::borrow::Cow;

/// Answer [`SelectTeeth`] whose designs are computed, and checked one by one, while they are written.
#[derive(Serialize)]
pub struct Streamed<'a> {
    pub(super) shown_in_full: Option<u32>,
    pub(super) speeds: Vec<ReachedSpeed>,
    pub(super) judgement: Judgement,
    pub(super) required: Required,
    pub(super) size_limits: RequiredSize,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) profile_shift: Option<RequiredShifts>,
    pub(super) searched: Searched,
    pub(super) shown: usize,
    pub(super) designs: Designs<'a>,
    pub(super) best_of_structures: Vec<BestOfStructure>,
}

pub(super) struct Designs<'a> {
    pub(super) of: &'a Searches<'a>,
    pub(super) told: &'a dyn Fn(f64),
}

impl Serialize for Designs<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let count = self.of.shown();
        let mut list = serializer.serialize_seq(Some(count))?;
        for (place, design) in self.of.designs().enumerate() {
            let design = design.map_err(S::Error::custom)?;
            finite::check(&design).map_err(S::Error::custom)?;
            list.serialize_element(&design)?;
            (self.told)((place + 1) as f64 / count as f64);
        }
        list.end()
    }
}

impl JsonSchema for Streamed<'_> {
    fn schema_name() -> Cow<'static, str> {
        SelectTeeth::schema_name()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        SelectTeeth::json_schema(generator)
    }
}

impl Answer for Streamed<'_> {
    const NAME: &'static str = SelectTeeth::NAME;
}
