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
/// The entries are constants of one type with the fields `name`, `title` and `description`, and those that
/// are listed after `with`; each of them becomes a method. The first variant is the default. To add an
/// item, write its entry and add one line to the enum.
///
/// The methods return constants and do not refer to the entries: a program that only lists the items does
/// not contain their functions.
macro_rules! registry {
    (
        $(#[$attribute:meta])*
        pub enum $Item:ident: $Entry:ty as $kind:literal {
            $($(#[$variant_attribute:meta])* $Variant:ident => $entry:expr,)+
        }
        with {
            $($(#[$field_attribute:meta])* $field:ident: $Field:ty,)*
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
        }

        $crate::registry::registry! {
            @fields $Item [$($Variant => $entry),+]
            /// Returns the name for the command line and documents.
            name: &'static str,
            /// Returns the display name.
            title: &'static str,
            /// Returns a description in one sentence.
            description: &'static str,
            $($(#[$field_attribute])* $field: $Field,)*
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
    (@fields $Item:ident $entries:tt $($(#[$attribute:meta])* $field:ident: $Field:ty,)*) => {
        $($crate::registry::registry! { @field $Item $entries $(#[$attribute])* $field: $Field })*
    };
    (
        @field $Item:ident [$($Variant:ident => $entry:expr),+]
        $(#[$attribute:meta])* $field:ident: $Field:ty
    ) => {
        impl $Item {
            $(#[$attribute])*
            pub fn $field(self) -> $Field {
                match self {
                    $($Item::$Variant => const { $entry.$field },)+
                }
            }
        }
    };
}

pub(crate) use registry;
