//! What the papers computed.

mod kanatani;
mod kepler;
mod molecules;
mod orbit;
mod pendulum;
mod string;
