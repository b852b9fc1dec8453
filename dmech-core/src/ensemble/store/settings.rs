//! What all members have in common, as a store has it.

use rusqlite::types::Value;
use rusqlite::{Connection, OptionalExtension};

use super::layout::Layout;
use crate::ensemble::Rides;
use crate::ensemble::plan::Plan;
use crate::error::{Reach, StoreError};
use crate::law::Fields;
use crate::method::Method;
use crate::name::Name;
use crate::run::{Attend, Due};
use crate::span::Span;
use crate::state::State;

/// The form of a store, to be raised when a table changes.
const FORMAT: i64 = 2;

/// Writes a value of the whole.
pub(super) fn set(database: &Connection, key: &str, value: &Value) -> Result<(), StoreError> {
    database.execute("INSERT OR REPLACE INTO sweep (key, value) VALUES (?, ?)", (key, value))?;
    Ok(())
}

/// Reads a value of the whole.
pub(super) fn get(database: &Connection, key: &str) -> Result<Option<Value>, StoreError> {
    Ok(database.query_row("SELECT value FROM sweep WHERE key = ?", [key], |row| row.get(0)).optional()?)
}

impl<L: Fields<D>, S: Rides<L, D> + Sync, O: Attend<State<D>>, const D: usize> Plan<'_, L, S, O, D> {
    /// What is said of the whole, in the order in which it is compared.
    pub(super) fn settings(&self, layout: &Layout) -> Vec<(&'static str, Value)> {
        let count = |n: usize| Value::Integer(n as i64);
        let number = |x: Option<f64>| x.map_or(Value::Null, Value::Real);
        let scheme = &self.common.scheme;
        let [steps, end] = self.reach();
        let looks = match self.common.due() {
            Due::Every(n) => format!("after every {n} steps"),
            Due::Apart(dt) => format!("every {dt:?} of time"),
            Due::At(times) => format!("at t = {times:?}"),
        };
        vec![
            ("format", Value::Integer(FORMAT)),
            ("members", count(self.members)),
            ("dimension", count(D)),
            ("scheme", Value::Text(S::NAME.to_owned())),
            ("order", count(S::ORDER as usize)),
            ("tolerance", number(scheme.tolerance())),
            ("dt", number(self.common.settings.dt)),
            ("options", Value::Text(format!("{scheme:?}"))),
            ("steps", steps),
            ("end", end),
            ("looks", Value::Text(looks)),
            ("fields", Value::Text(layout.fields.join(", "))),
            ("invariants", Value::Text(L::INVARIANTS.join(", "))),
            ("company", Value::Text(self.company())),
        ]
    }

    /// Refuses a store of another ensemble, as far as all members have it in common.
    pub(super) fn compare_settings(&self, database: &Connection, layout: &Layout) -> Result<(), StoreError> {
        for (key, here) in self.settings(layout) {
            let store = get(database, key)?.ok_or(StoreError::Setting { key })?;
            let same = match (&store, &here) {
                (Value::Null, Value::Real(x)) => x.is_nan(),
                (store, here) => store == here,
            };
            if same {
                continue;
            }
            if let ("steps" | "end", Some(here)) = (key, reach(&self.reach())) {
                let store = [get(database, "steps")?, get(database, "end")?].map(|value| value.unwrap_or(Value::Null));
                return Err(
                    reach(&store).map_or(StoreError::Setting { key }, |store| StoreError::Reach { store, here })
                );
            }
            return Err(difference::<S>(key, &store, &here));
        }
        Ok(())
    }

    /// Steps, and the end.
    fn reach(&self) -> [Value; 2] {
        match self.span {
            Span::Steps(steps) => [Value::Integer(steps.cast_signed()), Value::Null],
            Span::Until(end) => [Value::Null, Value::Real(end)],
        }
    }
}

fn reach(values: &[Value; 2]) -> Option<Reach> {
    match *values {
        [Value::Integer(steps), Value::Null] => Some(Reach::Steps(steps.cast_unsigned())),
        [Value::Null, Value::Real(end)] => Some(Reach::Until(end)),
        [Value::Null, Value::Null] => Some(Reach::Until(f64::NAN)),
        _ => None,
    }
}

fn difference<S: Method>(key: &'static str, store: &Value, here: &Value) -> StoreError {
    let damaged = StoreError::Setting { key };
    let number = |value: &Value| match *value {
        Value::Real(x) => Some(x),
        Value::Null => Some(f64::NAN),
        _ => None,
    };
    match (key, store, here) {
        ("format", &Value::Integer(store), &Value::Integer(here)) => StoreError::Format { store, here },
        ("members", &Value::Integer(store), &Value::Integer(here)) => StoreError::Members { store, here },
        ("dimension", &Value::Integer(store), &Value::Integer(here)) => StoreError::Dimension { store, here },
        ("scheme", Value::Text(store), _) => StoreError::Scheme { store: Name::of(&[store]), here: S::NAME },
        ("options" | "order", ..) => StoreError::Options { scheme: S::NAME },
        ("looks", Value::Text(store), _) => StoreError::Looks { store: Name::of(&[store]) },
        ("fields" | "invariants", Value::Text(store), _) => StoreError::Law { what: key, store: Name::of(&[store]) },
        ("company", Value::Text(store), _) => StoreError::Company { store: Name::of(&[store]) },
        ("tolerance" | "dt", ..) => match (number(store), number(here)) {
            (Some(store), Some(here)) if key == "dt" => StoreError::TimeStep { store, here },
            (Some(store), Some(here)) => StoreError::Tolerance { store, here },
            _ => damaged,
        },
        _ => damaged,
    }
}
