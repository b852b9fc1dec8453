//! The core alone, with laws written by hand.

mod allocation;
mod common;
mod conservation;
mod field;
mod gravity;
mod newton;
mod order;
mod output;
mod papers;
mod refusals;
mod reversal;
mod scene;
mod study;
mod threads;
