//! Registers in which members ride side by side.

use dmech_scalar::Rows;

/// Rows of eight lanes for motions of few coordinates. They stand side by side so that none waits for the root and the quotient of
/// another, as many as the target has room for.
pub(super) const WIDE: usize = if cfg!(target_feature = "avx512f") {
    4
} else if cfg!(target_feature = "avx2") {
    2
} else {
    1
};

/// The most members that ride side by side.
pub const LANES: usize = Rows::<WIDE>::COUNT;

/// The rows in which motions of so many coordinates ride: from six on one is faster, as the numbers of a member fill the registers by
/// themselves.
pub(super) const fn rows(coordinates: usize) -> usize {
    if coordinates < 6 { WIDE } else { 1 }
}
