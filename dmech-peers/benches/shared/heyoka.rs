//! heyoka in a process of its own: a Python that has it, kept and asked for one run at a time, so that it takes its turn with
//! all others. What is timed is its loop alone, which is compiled; neither the making of the integrator nor Python.

use std::env;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::Duration;

use dmech::prelude::State;

/// The Python with heyoka in it: `DMECH_PYTHON`, or `python3`.
#[derive(Debug)]
pub(crate) struct Heyoka {
    process: Child,
    ask: ChildStdin,
    answers: BufReader<ChildStdout>,
}

impl Heyoka {
    /// Starts it, and says so with its version, or why it is not there.
    pub(crate) fn found() -> Option<Heyoka> {
        match Heyoka::start() {
            Ok((heyoka, version)) => {
                println!("With {version}.\n");
                Some(heyoka)
            }
            Err(cause) => {
                println!("Without heyoka ({cause}); DMECH_PYTHON names a Python that has it.\n");
                None
            }
        }
    }

    fn start() -> Result<(Heyoka, String), String> {
        let python = env::var("DMECH_PYTHON").unwrap_or_else(|_| "python3".to_owned());
        let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("python/heyoka_race.py");
        let mut command = Command::new(&python);
        command.arg(program).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut process = command.spawn().map_err(|error| format!("{python}: {error}"))?;
        let (Some(ask), Some(answers)) = (process.stdin.take(), process.stdout.take()) else {
            return Err("no pipes to Python".to_owned());
        };
        let mut heyoka = Heyoka { process, ask, answers: BufReader::new(answers) };
        match heyoka.answer() {
            Ok(version) => Ok((heyoka, version)),
            // The last line of what Python says, such as that there is no such module.
            Err(cause) => {
                let errors = heyoka.process.stderr.take().map(BufReader::new);
                let last = errors.and_then(|errors| errors.lines().map_while(Result::ok).last());
                Err(format!("{python}: {}", last.unwrap_or(cause)))
            }
        }
    }

    fn answer(&mut self) -> Result<String, String> {
        let mut line = String::new();
        match self.answers.read_line(&mut line) {
            Ok(0) => Err("Python has ended".to_owned()),
            Ok(_) => Ok(line.trim_end().to_owned()),
            Err(error) => Err(error.to_string()),
        }
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
        writeln!(self.ask, "{request}").and_then(|()| self.ask.flush()).map_err(|error| error.to_string())?;
        let answer = self.answer()?;
        let Some(numbers) = answer.strip_prefix("ok ") else { return Err(answer) };
        let numbers = numbers.split(' ').map(str::parse).collect::<Result<Vec<f64>, _>>();
        let numbers = numbers.map_err(|error| format!("{error}: {answer}"))?;
        let [seconds, _steps, _order, state @ ..] = numbers.as_slice() else { return Err(answer) };
        let halves = state.split_first_chunk::<D>().and_then(|(q, v)| Some((q, v.first_chunk::<D>()?)));
        let (q, v) = halves.ok_or_else(|| format!("not {} numbers: {answer}", 2 * D))?;
        let time = Duration::try_from_secs_f64(*seconds).map_err(|error| error.to_string())?;
        Ok((State::new(*q, *v), time))
    }
}

/// Asks Python to end, and waits for it.
impl Drop for Heyoka {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
