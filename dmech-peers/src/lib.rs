//! Other solvers beside dmech.
