//! Lists of the words that errors speak with.

/// An enum of words: each variant displays as its text, which is its documentation too.
///
/// ```
/// epicyclic_gears::words! {
///     /// A side of a gearbox.
///     Side {
///         Input "input side"
///         Output "output side"
///     }
/// }
/// assert_eq!(Side::Output.to_string(), "output side");
/// ```
#[macro_export]
macro_rules! words {
    ($(#[$doc:meta])* $type:ident { $($name:ident $text:literal)* }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum $type {$(
            #[doc = $text]
            $name,
        )*}

        impl $type {
            /// Every one, in the order of the enum.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];
        }

        impl ::std::fmt::Display for $type {
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                f.pad(match self {
                    $(Self::$name => $text,)*
                })
            }
        }
    };
}
