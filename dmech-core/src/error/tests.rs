//! What messages look like.

#[cfg(feature = "scene")]
use super::SceneError;
use super::{Error, Place};

/// Every error, with a number for each of its numbers.
fn all(x: f64) -> Vec<Error> {
    let (quantity, step, body, time, dt, end, value) = ("force", 7, 4, x, x, x, x);
    let mut all = vec![
        Error::MissingTimeStep,
        Error::TimeStep { dt },
        Error::Tolerance { tolerance: x },
        Error::TurnVanished { tolerance: x, angle: x },
        Error::NoTimeScale { step, time },
        Error::StepVanished { step, time, dt },
        Error::Mass { mass: x },
        Error::State { quantity, value },
        Error::RecordEvery,
        Error::RecordDt { dt },
        Error::RecordAt { time, start: x },
        Error::Recording { states: 7, bytes: 2_500_000_000_000 },
        Error::WatchedTwice { name: "height" },
        Error::OutsideStep { time, from: x, to: end },
        Error::Stream(std::io::ErrorKind::StorageFull),
        Error::EndTime { end, dt },
        Error::TimeStandsStill { time, dt, next: x },
        Error::Law { quantity, value, time },
        Error::Underflow { coordinate: 1, slope: x, time },
        Error::Link { a: 1, b: 2, distance: x, step, time },
        Error::NotFinite { step, time, dt },
        Error::NotConverged { step, time, dt, iterations: 12, residual: x },
        Error::Span { start: x, end },
        Error::ComesToRest { event: 4, time, since: x },
        Error::ChangedTime { time, changed: x },
        Error::BehindWall { event: 4, time, value: x },
        Error::LeftDomain { time },
    ];
    #[cfg(feature = "scene")]
    {
        let scenes = [
            SceneError::Empty,
            SceneError::Mass { body, mass: x },
            SceneError::State { body, quantity, value },
            SceneError::Pin { body, bodies: 3 },
            SceneError::NoBody { body, bodies: 3 },
            SceneError::Encounter { distance: x },
            SceneError::Overlap { a: 1, b: 2, apart: x, distance: end, time },
            SceneError::PinnedMoves { body, speed: x },
            SceneError::Driven { body },
            SceneError::DrivenTwice { body },
            SceneError::Bond { a: 1, b: 5, bodies: 3 },
            SceneError::SelfBond { body },
            SceneError::DuplicateBond { a: 1, b: 2 },
            SceneError::Bodies { given: 2, bodies: 3 },
        ];
        all.extend(scenes.map(Error::Scene));
    }
    #[cfg(feature = "serde")]
    {
        use crate::error::Difference;
        let (checkpoint, here) = (x, x);
        let differences = [
            Difference::TimeStep { checkpoint, here },
            Difference::Start { checkpoint, here },
            Difference::Mass { body, checkpoint, here },
        ];
        all.extend(differences.map(Error::Checkpoint));
    }
    #[cfg(feature = "store")]
    {
        use crate::error::{Reach, StoreError};
        let (store, here, column) = (x, x, crate::name::Name::of(&["law_gm"]));
        let differences = [
            StoreError::Tolerance { store, here },
            StoreError::TimeStep { store, here },
            StoreError::Reach { store: Reach::Until(x), here: Reach::Steps(7) },
            StoreError::Member { member: 3, column, store, here },
        ];
        all.extend(differences.map(Error::Store));
    }
    all.push(Error::Path { body, at: x, step, time });
    for place in [Place::new(&[x]), Place::new(&[x; 2]), Place::new(&[x; 5])] {
        all.push(Error::Body { body, value, place, step, time });
        all.push(Error::LawInStep { quantity, value, place, step, time, dt });
    }
    all
}

/// Whether the error is among them; a new one is asked for here.
fn listed(error: &Error) -> bool {
    use Error::*;
    match error {
        MissingTimeStep | TimeStep { .. } | Tolerance { .. } | TurnVanished { .. } => true,
        NoTimeScale { .. } | StepVanished { .. } => true,
        Mass { .. } | State { .. } | RecordEvery | EndTime { .. } | TimeStandsStill { .. } | Law { .. } => true,
        Underflow { .. } | Link { .. } | Body { .. } | Path { .. } | NotFinite { .. } => true,
        LawInStep { .. } | NotConverged { .. } | Span { .. } => true,
        RecordDt { .. } | RecordAt { .. } | Recording { .. } | OutsideStep { .. } | Stream(_) => true,
        WatchedTwice { .. } | ComesToRest { .. } | ChangedTime { .. } | BehindWall { .. } | LeftDomain { .. } => true,
        #[cfg(feature = "scene")]
        Scene(_) => true,
        #[cfg(feature = "serde")]
        Checkpoint(_) => true,
        #[cfg(feature = "store")]
        Store(_) => true,
        #[cfg(feature = "ranks")]
        OtherEnsemble { .. } | FirstRank => true,
        // It tells in words of its own.
        NotAsWritten(_) => false,
    }
}

/// Nobody reads three hundred digits: a number that is large or small has an exponent.
#[test]
fn numbers_in_messages_have_few_digits() {
    let longest = |text: &str| text.split(|c: char| !c.is_ascii_digit()).map(str::len).max().unwrap_or(0);
    let mut numbers = 0;
    for error in [2.5e300, -2.5e-300, 2.5].into_iter().flat_map(all) {
        assert!(listed(&error));
        let text = error.to_string();
        // As many as it takes to tell two numbers apart.
        assert!(longest(&text) <= 17, "{text}");
        numbers += text.matches("2.5").count();
    }
    let store = if cfg!(feature = "store") { 7 } else { 0 };
    let scene = if cfg!(feature = "scene") { 7 } else { 0 };
    assert_eq!(numbers, 3 * (70 + scene + if cfg!(feature = "serde") { 6 } else { 0 } + store));
}

/// What was not said is not shown as a number; what has two names has both.
#[test]
fn messages_name_what_was_asked_for() {
    let endless = |dt| Error::EndTime { end: f64::INFINITY, dt }.to_string();
    assert!(endless(0.5).contains("t = inf in steps of 0.5:") && endless(f64::INFINITY).contains("t = inf: the end"));
    let never = Error::Span { start: 2.0, end: f64::INFINITY }.to_string();
    assert!(never.contains("finite") && never.contains("from t = 2 to t = inf"), "{never}");
    let none = Error::RecordEvery.to_string();
    assert!(none.contains("record_every") && none.contains("look_every"), "{none}");
}

/// What ends a member on another machine comes home as it is; what cannot happen there is not written.
#[cfg(feature = "ranks")]
#[test]
fn errors_travel() {
    use crate::error::{Culprit, Disagreement};
    let (place, culprit) = ([0.1, 0.2, 0.3], Culprit::Alone);
    let law = Disagreement {
        quantity: "force",
        written: 1.5,
        derived: 2.5,
        panics: false,
        time: 0.5,
        place,
        dimension: 2,
        culprit,
    };
    let mut travelled = 0;
    for error in all(2.5).into_iter().chain([Error::NotAsWritten(law), Error::FirstRank]) {
        match postcard::to_allocvec(&error) {
            Ok(bytes) => {
                assert_eq!(postcard::from_bytes::<Error>(&bytes).as_ref(), Ok(&error));
                travelled += 1;
            }
            Err(_) => assert!(stays(&error), "{error:?}"),
        }
    }
    assert!(travelled > 25, "{travelled}");
}

#[cfg(feature = "ranks")]
fn stays(error: &Error) -> bool {
    match error {
        Error::Stream(_) => true,
        #[cfg(feature = "scene")]
        Error::Scene(_) => true,
        #[cfg(feature = "store")]
        Error::Store(_) => true,
        error => matches!(error, Error::Checkpoint(_)),
    }
}

/// A correction of 0 would be taken for a solution that was found.
#[test]
fn a_step_without_a_root_tells_no_correction_of_nothing() {
    let failed = |residual| Error::NotConverged { step: 3, time: 0.2, dt: 0.1, iterations: 295, residual }.to_string();
    assert!(
        failed(0.0).ends_with("no root was found in 295 iterations, as at rest where the force jumps"),
        "{}",
        failed(0.0)
    );
    assert!(
        failed(1e-20).contains("after 295 iterations the last correction was 1e-20 (in sweeps of `Gauss` and"),
        "{}",
        failed(1e-20)
    );
}
