//! Vectors as lists.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The components, one after the other.
pub(crate) fn serialize<R: Serialize, S: Serializer, const D: usize>(
    vector: &[R; D],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(vector)
}

/// As many components as there must be.
pub(crate) fn deserialize<'de, R: Deserialize<'de>, T: Deserializer<'de>, const D: usize>(
    deserializer: T,
) -> Result<[R; D], T::Error> {
    let list = Vec::deserialize(deserializer)?;
    let found = list.len();
    list.try_into().map_err(|_| T::Error::invalid_length(found, &format!("{D} components").as_str()))
}

/// The vectors of many bodies, one after the other.
#[cfg(feature = "scene")]
pub(crate) mod list {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serializer};

    /// Each as its components.
    pub(crate) fn serialize<S: Serializer, const D: usize>(list: &[[f64; D]], to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(list.iter().map(<[f64; D]>::as_slice))
    }

    /// Each of as many components as there must be.
    pub(crate) fn deserialize<'de, T: Deserializer<'de>, const D: usize>(from: T) -> Result<Vec<[f64; D]>, T::Error> {
        let list: Vec<Vec<f64>> = Vec::deserialize(from)?;
        let expected = format!("{D} components");
        let vector = |found: Vec<f64>| {
            found.try_into().map_err(|found: Vec<f64>| T::Error::invalid_length(found.len(), &expected.as_str()))
        };
        list.into_iter().map(vector).collect()
    }
}

#[cfg(test)]
mod tests {
    use crate::state::State;

    #[test]
    fn a_state_is_read_as_it_was_written() {
        let state = State::new([0.1, -2.0, 1e-300], [3.0, 0.25, -7.5]).at_time(1.5);
        let text = serde_json::to_string(&state).unwrap();
        assert_eq!(text, r#"{"t":1.5,"q":[0.1,-2.0,1e-300],"v":[3.0,0.25,-7.5]}"#);
        assert_eq!(serde_json::from_str::<State<3>>(&text).unwrap(), state);
        let refused = serde_json::from_str::<State<2>>(&text).unwrap_err().to_string();
        assert!(refused.contains("2 components"), "{refused}");
    }
}
