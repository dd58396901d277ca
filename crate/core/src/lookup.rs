//! Things that have names of their own.

/// The one of that name; an error says which `kind` of thing there is and under which names.
pub(crate) fn named<T: Copy>(
    kind: &str,
    all: &[T],
    name_of: fn(T) -> &'static str,
    asked: &str,
) -> Result<T, String> {
    all.iter().copied().find(|&item| name_of(item) == asked).ok_or_else(|| {
        let names: Vec<&str> = all.iter().map(|&item| name_of(item)).collect();
        format!("there is no {kind} {asked:?}; there are {}", names.join(", "))
    })
}
