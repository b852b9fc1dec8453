//! Every construct that the body of a law may use, through the real macro: what is generated is compared with the method
//! that the user wrote, called directly.

#[path = "language/constructs.rs"]
mod constructs;
#[path = "language/edges.rs"]
mod edges;
#[path = "language/functions.rs"]
mod functions;
#[path = "language/moments.rs"]
mod moments;
#[path = "language/oracle.rs"]
mod oracle;
#[path = "language/vectors.rs"]
mod vectors;
