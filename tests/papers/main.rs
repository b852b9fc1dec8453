//! What the papers computed.

mod kanatani;
mod kepler;
mod molecules;
mod pendulum;
mod string;
mod table_1;
