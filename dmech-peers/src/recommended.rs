//! The scheme of dmech that is chosen for an error before anything is measured: the README's advice, in names of pictures.

/// For motions without close encounters: the largest error down to which a scheme is advised, from the coarsest.
const EVEN: [(f64, &str); 2] = [(1e-3, "FG 4"), (0.0, "Gauss 16")];

/// For close encounters: steps that follow the motion.
const FOLLOWING: [(f64, &str); 2] = [(1e-3, "RKN 6 ad."), (0.0, "Gauss 16 ad.")];

/// The name in pictures of the scheme that is advised for an error.
pub fn recommended(error: f64, encounters: bool) -> &'static str {
    let list: &[(f64, &str)] = if encounters { &FOLLOWING } else { &EVEN };
    let (_, last) = list[list.len() - 1];
    list.iter().find(|(least, _)| error >= *least).map_or(last, |(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_error_has_its_scheme() {
        assert_eq!(recommended(1e-3, false), "FG 4");
        assert_eq!(recommended(1e-12, false), EVEN[EVEN.len() - 1].1);
        assert_eq!(recommended(1e-3, true), "RKN 6 ad.");
        assert_eq!(recommended(1e-12, true), FOLLOWING[FOLLOWING.len() - 1].1);
    }

    /// Names that no scheme has would advise nothing.
    #[test]
    fn advised_schemes_take_part() {
        let problem = crate::eccentric();
        let schemes = crate::law_schemes(dmech::models::Kepler { gm: 1.0 }, &problem);
        for (_, name) in EVEN.into_iter().chain(FOLLOWING) {
            assert!(schemes.iter().any(|scheme| scheme.label == name), "{name}");
        }
    }
}
