//! The way from the root of a document to a node.

use std::fmt;

/// Keys and indices from the root to a node.
///
/// Displays as `given.shafts[2].torque`; a key that would be misread stands in quotes: `expect["speeds.g1"]`.
///
/// ```
/// use epicyclic_formats::document::Path;
///
/// let path = Path::root().key("given").key("shafts").index(2).key("torque");
/// assert_eq!(path.to_string(), "given.shafts[2].torque");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Path(Vec<Segment>);

/// One step of a [`Path`].
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Segment {
    /// Into a map.
    Key(String),
    /// Into a sequence, counted from 0.
    Index(usize),
}

impl Path {
    /// The root.
    #[must_use]
    pub const fn root() -> Self {
        Self(Vec::new())
    }

    /// One step further, into a map.
    #[must_use]
    pub fn key(mut self, key: impl Into<String>) -> Self {
        self.0.push(Segment::Key(key.into()));
        self
    }

    /// One step further, into a sequence.
    #[must_use]
    pub fn index(mut self, index: usize) -> Self {
        self.0.push(Segment::Index(index));
        self
    }

    /// One step further into a sequence, if there is an index.
    pub(crate) fn indexed(self, index: Option<usize>) -> Self {
        match index {
            Some(index) => self.index(index),
            None => self,
        }
    }

    /// A path from its keys joined by dots: `gear_set.module`.
    pub(crate) fn dotted(keys: &str) -> Self {
        keys.split('.').filter(|key| !key.is_empty()).fold(Self::root(), Self::key)
    }

    /// A path that leads from the end of this one.
    pub(crate) fn join(&self, further: &Self) -> Self {
        self.0.iter().chain(&further.0).cloned().collect()
    }

    /// Whether this is the root.
    #[must_use]
    pub const fn is_root(&self) -> bool {
        self.0.is_empty()
    }

    /// The steps, from the root.
    #[must_use]
    pub fn segments(&self) -> &[Segment] {
        &self.0
    }

    pub(crate) fn push(&mut self, segment: Segment) {
        self.0.push(segment);
    }

    pub(crate) fn pop(&mut self) -> Option<Segment> {
        self.0.pop()
    }
}

impl FromIterator<Segment> for Path {
    fn from_iter<I: IntoIterator<Item = Segment>>(segments: I) -> Self {
        Self(segments.into_iter().collect())
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, segment) in self.0.iter().enumerate() {
            match segment {
                Segment::Index(index) => write!(f, "[{index}]")?,
                Segment::Key(key)
                    if key.is_empty()
                        || key.contains(|c: char| !c.is_alphanumeric() && !"_-".contains(c)) =>
                {
                    write!(f, "[{key:?}]")?;
                }
                Segment::Key(key) if at == 0 => f.write_str(key)?,
                Segment::Key(key) => write!(f, ".{key}")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_reads_as_an_engineer_would_say_it() {
        let path = Path::root().key("expect").key("speeds.g1").key("ω").index(0).index(1);
        assert_eq!(path.to_string(), r#"expect["speeds.g1"].ω[0][1]"#);
        assert_eq!(Path::root().to_string(), "");
    }
}
