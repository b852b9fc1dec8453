//! The scheme of dmech that is chosen for an error before anything is measured: the README's advice, in names of pictures.

/// What the advice depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A few coordinates, in even motion.
    Even,
    /// Close encounters, for which steps that follow the motion are advised.
    Encounters,
    /// Many bodies.
    Many,
}

/// For a few coordinates in even motion: the largest error down to which a scheme is advised, from the coarsest.
const EVEN: [(f64, &str); 2] = [(1e-3, "FG 4"), (0.0, "Gauss 16")];

/// For close encounters: steps that follow the motion.
const FOLLOWING: [(f64, &str); 2] = [(1e-3, "RKN 6 ad."), (0.0, "Gauss 16 ad.")];

/// For many bodies: a sweep of eight stages is as long as eight forces there, which explicit steps do not wait for, down to errors
/// where these are very short.
const MANY: [(f64, &str); 4] = [(1e-3, "FG 4"), (1e-9, "RKN 6"), (1e-11, "RKN 8"), (0.0, "Gauss 16")];

/// The name in pictures of the scheme that is advised for an error.
pub fn recommended(error: f64, kind: Kind) -> &'static str {
    let list: &[(f64, &str)] = match kind {
        Kind::Even => &EVEN,
        Kind::Encounters => &FOLLOWING,
        Kind::Many => &MANY,
    };
    let (_, last) = list[list.len() - 1];
    list.iter().find(|(least, _)| error >= *least).map_or(last, |(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_error_has_its_scheme() {
        assert_eq!(recommended(1e-3, Kind::Even), "FG 4");
        assert_eq!(recommended(1e-12, Kind::Even), EVEN[EVEN.len() - 1].1);
        assert_eq!([1e-6, 1e-11, 1e-12].map(|error| recommended(error, Kind::Many)), ["RKN 6", "RKN 8", "Gauss 16"]);
        assert_eq!(recommended(1e-3, Kind::Encounters), "RKN 6 ad.");
        assert_eq!(recommended(1e-12, Kind::Encounters), FOLLOWING[FOLLOWING.len() - 1].1);
    }

    /// Names that no scheme has would advise nothing.
    #[test]
    fn advised_schemes_take_part() {
        let problem = crate::eccentric();
        let schemes = crate::law_schemes(dmech::models::Kepler { gm: 1.0 }, &problem);
        for (_, name) in EVEN.into_iter().chain(FOLLOWING).chain(MANY) {
            assert!(schemes.iter().any(|scheme| scheme.label == name), "{name}");
        }
    }
}
