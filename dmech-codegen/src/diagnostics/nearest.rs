//! The known name that was probably meant.

/// The known name with the fewest letters changed, if they are few enough for a slip of the fingers.
///
/// Capitals are no change, but of one letter: `M` and `m` are two masses.
pub(crate) fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = name.chars().count();
    let lower = name.to_lowercase();
    let few = if length < 4 { 0 } else { (length / 3).min(3) };
    let distances = known.into_iter().map(|other| {
        // Of two that are as near, letters swapped or mistaken are likelier than one too many.
        let same = length > 1 && other.to_lowercase() == lower;
        ((if same { 0 } else { distance(name, other) }, other.chars().count().abs_diff(length)), other)
    });
    distances
        .filter(|((distance, _), _)| *distance <= few)
        .min_by_key(|(nearness, _)| *nearness)
        .map(|(_, other)| other)
}

/// How many letters are to be added, removed, replaced or swapped with their neighbour.
fn distance(one: &str, two: &str) -> usize {
    let (one, two): (Vec<char>, Vec<char>) = (one.chars().collect(), two.chars().collect());
    let mut rows = vec![(0..=two.len()).collect::<Vec<usize>>()];
    for i in 1..=one.len() {
        let mut row = vec![i];
        for j in 1..=two.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(one[i - 1] != two[j - 1]);
            let mut least = replaced.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && one[i - 1] == two[j - 2] && one[i - 2] == two[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[one.len()][two.len()]
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_slip_of_the_fingers_is_recognised() {
        let known = ["sqrt", "sin", "sinh", "cos", "cosh", "potential", "pair", "pair_force", "hypot"];
        for (written, meant) in [
            ("sqr", None),
            ("sqtr", Some("sqrt")),
            ("sinn", Some("sinh")),
            ("potental", Some("potential")),
            ("potnetail", Some("potential")),
            ("pairforce", Some("pair_force")),
            ("hypotenuse", None),
            ("sq", None),
            ("Cos", Some("cos")),
            ("SQRT", Some("sqrt")),
            ("energy", None),
        ] {
            assert_eq!(nearest(written, known), meant, "{written}");
        }
        assert_eq!(nearest("M", ["m"]), None);
    }
}
