//! Every construct that the body of a law may use, through the real macro: what is generated is compared with the method
//! that the user wrote, called directly.

mod constructs;
mod corners;
mod edges;
mod functions;
mod moments;
mod oracle;
mod steps;
mod vectors;
