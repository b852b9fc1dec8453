//! A disk that is full, which a suite cannot have.

use super::Stored;
use super::kept::Store;
use crate::ensemble::in_order::{Hands, Nobody};
use crate::ensemble::members::OneLaw;
use crate::ensemble::plan::{Plan, sweep};
use crate::ensemble::{Checksum, Outcome};
use crate::error::{Error, StoreError};
use crate::law::{Conservative, Field, Fields, Potential};
use crate::run::{Shown, Simulation};
use crate::scheme::Leapfrog;
use crate::span::Span;
use crate::state::State;
use dmech_scalar::Real;

#[derive(Clone, Copy)]
struct Spring<R = f64> {
    k: R,
}

impl<R: Real> Conservative for Spring<R> {}
impl<R: Real> Field<1, R> for Spring<R> {}

impl<R: Real> Potential<1, R> for Spring<R> {
    fn potential(&self, [x]: [R; 1]) -> R {
        self.k * x * x
    }
    fn gradient(&self, [x]: [R; 1]) -> [R; 1] {
        [self.k * x + self.k * x]
    }
    fn hessian(&self, _: [R; 1]) -> [[R; 1]; 1] {
        [[self.k + self.k]]
    }
    fn discrete_gradient(&self, [a]: [R; 1], [b]: [R; 1]) -> [R; 1] {
        [self.k * (a + b)]
    }
    fn discrete_gradient_jacobian(&self, _: [R; 1], _: [R; 1]) -> [[R; 1]; 1] {
        [[self.k]]
    }
}

impl Fields<1> for Spring {
    type Numbers = [f64; 1];
    type Moment<R: Real> = Spring<R>;

    fn numbers(&self) -> [f64; 1] {
        [self.k]
    }

    fn moment<R: Real>([k]: [R; 1], _: R, _: R) -> Spring<R> {
        Spring { k }
    }
}

const MEMBERS: usize = 3000;

#[test]
fn a_full_disk_is_told_and_takes_nothing() {
    let file = std::env::temp_dir().join(format!("dmech-full-{}.sqlite", std::process::id()));
    let _ = std::fs::remove_file(&file);
    let common = Simulation::of((), ()).scheme(Leapfrog).dt(0.01);
    let member = |k: usize| common.clone().moving(Spring { k: 1.0 + 0.1 * k as f64 }, State::new([1.0], [0.0]));
    let plan = OneLaw {
        members: MEMBERS,
        member: &member,
        bare: &member,
        common: &common,
        span: Span::Steps(5),
        work: false,
        lanes: 8,
    };
    let go = |row: core::ops::Range<usize>| row.clone().zip(plan.go(row)).collect::<Vec<_>>();
    let store = Store::open(&file, &plan).unwrap();
    let pages: i64 = store.database.query_row("PRAGMA page_count", [], |row| row.get(0)).unwrap();
    store.database.query_row(&format!("PRAGMA max_page_count = {}", pages + 20), [], |_| Ok(())).unwrap();
    let mut written = 0;
    let refused = loop {
        assert!(written < MEMBERS, "there is room for all");
        match store.hand_over(&plan, written..written + 50, go(written..written + 50)) {
            Ok(outcomes) => written += outcomes.len(),
            Err(refused) => break refused,
        }
    };
    assert_eq!(refused, Error::Store(StoreError::Full));
    assert!(refused.to_string().contains("no room"), "{refused}");
    // In this process, and in the next, all that was written is there and nothing else.
    let expected: Vec<bool> = (0..MEMBERS).map(|k| k < written).collect();
    assert!(written > 0 && store.done(MEMBERS).unwrap() == expected, "{written}");
    drop(store);
    assert_eq!(Store::open(&file, &plan).unwrap().done(MEMBERS).unwrap(), expected);
    let mut sums = [Checksum::default(); 2];
    go(0..MEMBERS).iter().for_each(|(_, outcome)| sums[0].add(outcome.as_ref()));
    let see = &mut |_, outcome: Outcome<State<1>>| sums[1].add(outcome.as_ref());
    sweep(&plan, (Hands::ALL, Shown::default()), Stored::open(&file, &plan), see, Nobody).unwrap();
    std::fs::remove_file(&file).unwrap();
    assert_eq!(sums[0], sums[1]);
}
