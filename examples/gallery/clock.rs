//! How long a program took that has been waited for.

use std::time::{Duration, Instant};

/// Where the system tells it, the processor time: on a machine that others use as well, the time by the wall clock is
/// theirs in part.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clock {
    wall: Instant,
    processor: Option<Duration>,
}

impl Clock {
    pub(crate) fn start() -> Self {
        Clock { wall: Instant::now(), processor: processor() }
    }

    /// Of the programs that began and ended since.
    pub(crate) fn elapsed(&self) -> Duration {
        match (self.processor, processor()) {
            (Some(start), Some(end)) => end.saturating_sub(start),
            _ => self.wall.elapsed(),
        }
    }

    /// What is told.
    pub(crate) fn what() -> &'static str {
        match processor() {
            Some(_) => {
                "beside the commands: of the processor, all threads together; in what is printed: by the wall clock"
            }
            None => "by the wall clock, here and in what is printed",
        }
    }
}

/// Of all programs that were started here and have ended.
#[cfg(unix)]
fn processor() -> Option<Duration> {
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeValLike;
    let usage = getrusage(UsageWho::RUSAGE_CHILDREN).ok()?;
    let microseconds = usage.user_time().num_microseconds() + usage.system_time().num_microseconds();
    Some(Duration::from_micros(microseconds.unsigned_abs()))
}

#[cfg(not(unix))]
fn processor() -> Option<Duration> {
    None
}
