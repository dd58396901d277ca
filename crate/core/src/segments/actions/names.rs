//! Names of actions: letters in order of first appearance.

/// Returns a name for each item, equal for the items of a group; `first_members` has the first member of
/// each item's group.
pub(crate) fn in_order(first_members: &[usize]) -> Vec<String> {
    let mut names: Vec<String> = Vec::with_capacity(first_members.len());
    let mut count = 0;
    for (item, &first) in first_members.iter().enumerate() {
        let name = if first == item { letters(count) } else { names[first].clone() };
        count += usize::from(first == item);
        names.push(name);
    }
    names
}

/// Returns the name of an action: A, B, …, Z, AA, AB, ….
fn letters(index: usize) -> String {
    let letter = char::from(b'A' + (index % 26) as u8);
    match index / 26 {
        0 => letter.into(),
        more => letters(more - 1) + &letter.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_continue_after_z() {
        let names = [0, 1, 25, 26, 27, 26 + 26 * 26 - 1, 26 + 26 * 26].map(letters);
        assert_eq!(names, ["A", "B", "Z", "AA", "AB", "ZZ", "AAA"]);
    }

    #[test]
    fn names_are_in_order_of_first_appearance() {
        assert_eq!(in_order(&[0, 1, 0, 3, 1]), ["A", "B", "A", "C", "B"]);
        assert_eq!(in_order(&[]), [""; 0]);
    }
}
