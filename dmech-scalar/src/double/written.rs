//! The two parts, written and read.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::DoubleDouble;

impl Serialize for DoubleDouble {
    /// hi and lo, in a list.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        [self.hi, self.lo].serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for DoubleDouble {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let [hi, lo] = Deserialize::deserialize(deserializer)?;
        // Half: a low part that is rounded itself may be a whole half of the last place, and the sum then the number beside hi.
        if hi + 0.5 * lo == hi || !f64::is_finite(hi) {
            Ok(DoubleDouble::pair(hi, lo))
        } else {
            Err(D::Error::custom(format_args!("{lo:?} is more than rounding leaves out of {hi:?}")))
        }
    }
}
