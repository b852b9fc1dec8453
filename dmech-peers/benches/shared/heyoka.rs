//! heyoka on one motion at a time.

#[path = "python.rs"]
mod python;

use std::time::Duration;

use dmech::prelude::State;
use python::Process;

/// A Python that moves by `python/heyoka_race.py`.
#[derive(Debug)]
pub(crate) struct Heyoka(Process);

impl Heyoka {
    /// Starts it, and says so with its version, or why it is not there.
    pub(crate) fn found() -> Option<Heyoka> {
        Process::found("heyoka_race.py").map(Heyoka)
    }

    /// From a state at t = 0 to a time: the state then, and how long that took.
    pub(crate) fn propagate<const D: usize>(
        &mut self,
        motion: &str,
        tolerance: f64,
        options: &str,
        start: &State<D>,
        end: f64,
    ) -> Result<(State<D>, Duration), String> {
        let mut request = format!("{motion} {tolerance:e} {options} {end:e}");
        for x in start.q.into_iter().chain(start.v) {
            request += &format!(" {x:e}");
        }
        let numbers = self.0.numbers(&request)?;
        let short = || format!("not {} numbers: {numbers:?}", 3 + 2 * D);
        let [seconds, _steps, _order, state @ ..] = numbers.as_slice() else { return Err(short()) };
        let halves = state.split_first_chunk::<D>().and_then(|(q, v)| Some((q, v.first_chunk::<D>()?)));
        let (q, v) = halves.ok_or_else(short)?;
        let time = Duration::try_from_secs_f64(*seconds).map_err(|error| error.to_string())?;
        Ok((State::new(*q, *v), time))
    }
}
