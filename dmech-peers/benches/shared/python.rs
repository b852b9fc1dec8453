//! heyoka in a process of its own: a Python that has it, kept and asked for one run at a time, so that it takes its turn with
//! all others. What is timed is its loop alone, which is compiled; neither the making of the integrator nor Python.

use std::env;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// The Python with heyoka in it: `DMECH_PYTHON`, or `python3`.
#[derive(Debug)]
pub(crate) struct Process {
    process: Child,
    ask: ChildStdin,
    answers: BufReader<ChildStdout>,
}

impl Process {
    /// Starts a program, and says so with the version of heyoka, or why it is not there.
    pub(crate) fn found(program: &str) -> Option<Process> {
        match Process::start(program) {
            Ok((process, version)) => {
                println!("With {version}.\n");
                Some(process)
            }
            Err(cause) => {
                println!("Without heyoka, which is left out ({cause}); DMECH_PYTHON names a Python that has it.\n");
                None
            }
        }
    }

    fn start(program: &str) -> Result<(Process, String), String> {
        let python = env::var("DMECH_PYTHON").unwrap_or_else(|_| "python3".to_owned());
        let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("python").join(program);
        let mut command = Command::new(&python);
        command.arg(program).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut process = command.spawn().map_err(|error| format!("{python}: {error}"))?;
        let (Some(ask), Some(answers)) = (process.stdin.take(), process.stdout.take()) else {
            return Err("no pipes to Python".to_owned());
        };
        let mut started = Process { process, ask, answers: BufReader::new(answers) };
        match started.answer() {
            Ok(version) => Ok((started, version)),
            // The last line of what Python says, such as that there is no such module.
            Err(cause) => {
                let errors = started.process.stderr.take().map(BufReader::new);
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

    /// The numbers of the answer to a line.
    pub(crate) fn numbers(&mut self, request: &str) -> Result<Vec<f64>, String> {
        writeln!(self.ask, "{request}").and_then(|()| self.ask.flush()).map_err(|error| error.to_string())?;
        let answer = self.answer()?;
        let Some(numbers) = answer.strip_prefix("ok ") else { return Err(answer) };
        let numbers = numbers.split(' ').map(str::parse).collect::<Result<_, _>>();
        numbers.map_err(|error| format!("{error}: {answer}"))
    }
}

/// Asks Python to end, and waits for it.
impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
