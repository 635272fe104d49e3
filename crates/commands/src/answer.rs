//! Common parts of all answers: name, version, JSON and its schema.

use crate::error::Error;
use crate::finite;
use schemars::{JsonSchema, Schema, schema_for};
use serde::Serialize;
use serde_json::Value;
use serde_json::ser::{Formatter, PrettyFormatter};
use std::io::{self, Write};

/// Version of the records: raised when a key is removed, or changes its meaning or unit.
pub const SCHEMA_VERSION: u32 = 1;

/// An answer of the program.
pub trait Answer: Serialize + JsonSchema {
    /// Name of the answer in JSON, under `answer`.
    const NAME: &'static str;
}

/// Warning for the reader of an answer.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Warning {
    /// Kind of the warning: a name that does not depend on the message.
    pub name: &'static str,
    /// Message for people.
    pub message: String,
}

/// Answer with its version and name.
#[derive(Serialize, JsonSchema)]
struct Whole<'a, A> {
    /// Version of the records: raised when a key is removed, or changes its meaning or unit.
    schema_version: u32,
    /// Name of the answer.
    answer: &'static str,
    #[serde(flatten)]
    content: &'a A,
}

/// Writes an answer as JSON with a final line break; negative zero becomes `0.0`.
///
/// # Errors
/// [`Error::NotFinite`] with the key of a number that is infinite or NaN.
pub fn to_json<A: Answer>(answer: &A) -> Result<String, Error> {
    finite::check(answer)?;
    let mut bytes = vec![];
    write_json(answer, &mut bytes).map_err(|error| Error::Json(error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| Error::Json(error.to_string()))
}

/// Writes an answer as JSON without buffering it. The caller checks with [`finite::check`] that all numbers
/// are finite.
///
/// # Errors
/// Errors of the writer, and those of records that compute their entries while they are written.
pub fn write_json<A: Answer>(answer: &A, mut out: impl Write) -> io::Result<()> {
    let whole = Whole { schema_version: SCHEMA_VERSION, answer: A::NAME, content: answer };
    let mut serializer = serde_json::Serializer::with_formatter(&mut out, Plain(PrettyFormatter::new()));
    whole.serialize(&mut serializer)?;
    out.write_all(b"\n")
}

/// JSON formatter for several lines, without negative zeros.
struct Plain<'a>(PrettyFormatter<'a>);

impl Formatter for Plain<'_> {
    fn write_f64<W: ?Sized + Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        // -0.0 + 0.0 is 0.0.
        self.0.write_f64(writer, value + 0.0)
    }

    fn begin_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.begin_array(writer)
    }

    fn end_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.end_array(writer)
    }

    fn begin_array_value<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.0.begin_array_value(writer, first)
    }

    fn end_array_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.end_array_value(writer)
    }

    fn begin_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.begin_object(writer)
    }

    fn end_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.end_object(writer)
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.0.begin_object_key(writer, first)
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.begin_object_value(writer)
    }

    fn end_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.end_object_value(writer)
    }
}

/// JSON Schema of an answer, restricted to its own name and version.
#[must_use]
pub fn schema<A: Answer>() -> Schema {
    let mut schema = schema_for!(Whole<'_, A>);
    let described = schema_for!(A).get("description").cloned();
    schema
        .insert("$id".to_owned(), format!("urn:epicyclic:schema:{SCHEMA_VERSION}:answer:{}", A::NAME).into());
    schema.insert("title".to_owned(), format!("Answer of epicyclic: {}", A::NAME).into());
    schema.insert("description".to_owned(), described.unwrap_or_default());
    for (key, only) in [("schema_version", SCHEMA_VERSION.into()), ("answer", Value::from(A::NAME))] {
        if let Some(Value::Object(key)) = schema.pointer_mut(&format!("/properties/{key}")) {
            key.insert("const".to_owned(), only);
        }
    }
    schema
}

/// JSON Schema of an input file with this name.
#[must_use]
pub fn schema_of_file<F: JsonSchema>(name: &str) -> Schema {
    let mut schema = schema_for!(F);
    schema.insert("$id".to_owned(), format!("urn:epicyclic:schema:{SCHEMA_VERSION}:file:{name}").into());
    schema.insert("title".to_owned(), format!("File of epicyclic: {name}").into());
    without_orphans(&mut schema);
    schema
}

/// Removes definitions that nothing refers to: keys that a kind of file does not read leave theirs behind.
fn without_orphans(schema: &mut Schema) {
    loop {
        let text = schema.as_value().to_string();
        let Some(Value::Object(all)) = schema.get_mut("$defs") else { return };
        let before = all.len();
        all.retain(|name, _| text.contains(&format!("\"#/$defs/{name}\"")));
        if all.len() == before {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Serialize, JsonSchema)]
    struct Zeros {
        values: Vec<Option<f64>>,
    }

    impl Answer for Zeros {
        const NAME: &'static str = "zeros";
    }

    #[test]
    fn a_schema_names_its_answer_and_no_other() {
        let schema = schema::<Zeros>();
        assert_eq!(schema.get("$id"), Some(&Value::from("urn:epicyclic:schema:1:answer:zeros")));
        assert_eq!(schema.pointer("/properties/answer/const"), Some(&Value::from("zeros")));
        assert_eq!(schema.pointer("/properties/schema_version/const"), Some(&Value::from(1)));
    }

    #[test]
    fn zero_has_no_sign() {
        let json = to_json(&Zeros { values: vec![Some(-0.0), Some(-1.5), None] }).unwrap();
        let due = "{\n  \"schema_version\": 1,\n  \"answer\": \"zeros\",\n  \"values\": [\n    0.0,\n    -1.5,\n    \
                   null\n  ]\n}\n";
        assert_eq!(json, due);
    }
}
