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
    use dmech_scalar::{DoubleDouble, Real};

    use crate::state::State;

    #[test]
    fn a_state_is_read_as_it_was_written() {
        let state = State::new([0.1, -2.0, 1e-300], [3.0, 0.25, -7.5]).at_time(1.5);
        let text = serde_json::to_string(&state).unwrap();
        assert_eq!(text, r#"{"t":1.5,"q":[0.1,-2.0,1e-300],"v":[3.0,0.25,-7.5]}"#);
        assert_eq!(serde_json::from_str::<State<3>>(&text).unwrap(), state);
        let refused = serde_json::from_str::<State<2>>(&text).unwrap_err().to_string();
        assert!(refused.contains("2 components"), "{refused}");

        let digits = State::of([0.1, -0.0].map(DoubleDouble::from), [DoubleDouble::new(1.0, 5e-324); 2]);
        let text = serde_json::to_string(&digits).unwrap();
        assert_eq!(text, r#"{"t":0.0,"q":[[0.1,0.0],[-0.0,0.0]],"v":[[1.0,5e-324],[1.0,5e-324]]}"#);
        let read: State<2, DoubleDouble> = serde_json::from_str(&text).unwrap();
        assert!(read == digits && read.q[1].hi().is_sign_negative());
        // Of a number whose low part is one of the smallest there are, exp has rounded that up to half a place.
        let x = DoubleDouble::new(-706.6445214963145, 2.5498671023637177e-14).exp();
        assert!(x.hi() + x.lo() != x.hi());
        assert_eq!(serde_json::from_str::<DoubleDouble>(&serde_json::to_string(&x).unwrap()).unwrap(), x);
        let refused = serde_json::from_str::<DoubleDouble>("[1.0,0.5]").unwrap_err().to_string();
        assert!(refused.contains("0.5 is more than rounding leaves out of 1.0"), "{refused}");
    }
}
