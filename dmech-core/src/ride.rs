//! Numbers of members that ride side by side.

use dmech_scalar::Rows;

/// A number of each member that rides. Registers stand side by side so that none waits for the root and the quotient of another, as many
/// as the target has room for.
#[cfg(target_feature = "avx512f")]
pub type Ride = Rows<4>;
/// A number of each member that rides. Registers stand side by side so that none waits for the root and the quotient of another, as many
/// as the target has room for.
#[cfg(all(target_feature = "avx2", not(target_feature = "avx512f")))]
pub type Ride = Rows<2>;
/// A number of each member that rides. Registers stand side by side so that none waits for the root and the quotient of another, as many
/// as the target has room for.
#[cfg(not(any(target_feature = "avx2", target_feature = "avx512f")))]
pub type Ride = Rows<1>;
