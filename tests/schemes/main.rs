//! What every scheme promises, over laws.

mod adaptive;
mod allocation;
mod compensated;
mod composed;
mod double_double;
mod hard_cases;
mod order;
mod round_off;
mod seams;
mod splittings;
