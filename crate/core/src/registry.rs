//! Registries: enums whose variants are described by one entry each.

/// An entry of a registry does not exist.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown {kind} {name:?}; use one of {}", .known.join(", "))]
pub struct UnknownName {
    /// Kind of item, as in `method`.
    pub kind: &'static str,
    /// The name that was looked up.
    pub name: String,
    /// The names of all items.
    pub known: Vec<&'static str>,
}

/// Returns the position of a name in a list of `kind`.
pub(crate) fn position(kind: &'static str, names: &[&'static str], name: &str) -> Result<usize, UnknownName> {
    let position = names.iter().position(|other| *other == name);
    position.ok_or_else(|| UnknownName { kind, name: name.into(), known: names.into() })
}

/// Declares an enum and the entry of each variant: `Variant => path::ENTRY`.
///
/// The entries are constants of one type with the fields `name`, `title` and `description`. The first
/// variant is the default. To add an item, write its entry and add one line to the enum.
macro_rules! registry {
    (
        $(#[$attribute:meta])*
        pub enum $Item:ident: $Entry:ty as $kind:literal {
            $($(#[$variant_attribute:meta])* $Variant:ident => $entry:expr,)+
        }
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
        pub enum $Item {
            $($(#[$variant_attribute])* $Variant,)+
        }

        impl $Item {
            #[doc = concat!("Every ", $kind, ", the default first.")]
            pub const ALL: &'static [$Item] = &[$($Item::$Variant),+];

            fn entry(self) -> &'static $Entry {
                match self {
                    $($Item::$Variant => &$entry,)+
                }
            }

            /// Returns the name for the command line and documents.
            pub fn name(self) -> &'static str {
                self.entry().name
            }

            /// Returns the display name.
            pub fn title(self) -> &'static str {
                self.entry().title
            }

            /// Returns a description in one sentence.
            pub fn description(self) -> &'static str {
                self.entry().description
            }
        }

        impl std::fmt::Display for $Item {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(self.name())
            }
        }

        impl std::str::FromStr for $Item {
            type Err = $crate::registry::UnknownName;

            fn from_str(name: &str) -> Result<$Item, $crate::registry::UnknownName> {
                const NAMES: &[&str] = &[$($entry.name),+];
                Ok($Item::ALL[$crate::registry::position($kind, NAMES, name)?])
            }
        }
    };
}

pub(crate) use registry;
