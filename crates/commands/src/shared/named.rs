//! Choices that are read from their names and written by them.

/// One of several with a name.
pub(crate) trait Named: Copy + 'static {
    const ALL: &'static [Self];
    fn named(self) -> &'static str;
}

pub(crate) fn read<T: Named>(text: &str) -> Result<T, String> {
    let all = T::ALL.iter().copied();
    all.clone().find(|one| one.named() == text.trim()).ok_or_else(|| {
        let names: Vec<&str> = all.map(Named::named).collect();
        format!("{text:?} is none of {}", names.join(", "))
    })
}

macro_rules! named {
    ($($type:ident { $($variant:ident $name:literal)* })*) => {$(
        impl $crate::shared::named::Named for $type {
            const ALL: &'static [Self] = &[$(Self::$variant),*];

            fn named(self) -> &'static str {
                match self { $(Self::$variant => $name),* }
            }
        }

        impl std::str::FromStr for $type {
            type Err = String;

            fn from_str(text: &str) -> Result<Self, String> {
                $crate::shared::named::read(text)
            }
        }

        impl std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad($crate::shared::named::Named::named(*self))
            }
        }
    )*};
}

/// Conversion of choices of commands to those of a calculation and back, by pairs of equal variants.
macro_rules! paired {
    ($($type:ident, $other:ty { $($variant:ident $same:ident)* })*) => {$(
        impl $type {
            pub(crate) const fn of(other: $other) -> Self {
                match other { $(<$other>::$same => Self::$variant),* }
            }

            /// Converts the choice for the search.
            #[must_use]
            pub const fn of_search(self) -> $other {
                match self { $(Self::$variant => <$other>::$same),* }
            }
        }
    )*};
}

pub(crate) use {named, paired};
