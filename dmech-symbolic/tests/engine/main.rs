//! What is promised of the engine.

mod choices;
mod common;
mod degree;
mod derivatives;
mod discrete_gradient;
mod divided_difference;
mod forced;
mod jacobian;
mod kick_by_mean;
mod limits;
mod linear;
mod normal_form;
mod pairs;
mod paper;
mod piecewise;
mod programs;
mod quotients;
mod rules;
mod structure;
