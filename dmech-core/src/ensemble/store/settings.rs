//! What all members have in common, as a store has it.

use rusqlite::types::Value;
use rusqlite::{Connection, OptionalExtension};

use crate::ensemble::told::{Said, Told};
use crate::error::{Reach, StoreError};
use crate::flat::Flat;
use crate::name::{Name, options_apart};
use crate::words::word;

/// The form of a store, to be raised when a table changes.
pub(super) const FORMAT: i64 = 6;

/// So many letters are shown before a difference.
const BEFORE: usize = 20;

/// Writes a value of the whole.
pub(super) fn set(database: &Connection, key: &str, value: &Value) -> Result<(), StoreError> {
    database.execute("INSERT OR REPLACE INTO sweep (key, value) VALUES (?, ?)", (key, value))?;
    Ok(())
}

/// Reads a value of the whole.
pub(super) fn get(database: &Connection, key: &str) -> Result<Option<Value>, StoreError> {
    Ok(database.query_row("SELECT value FROM sweep WHERE key = ?", [key], |row| row.get(0)).optional()?)
}

/// As SQLite has it.
fn value(said: Said) -> Value {
    match said {
        Said::Nothing => Value::Null,
        Said::Count(n) => Value::Integer(n.cast_signed()),
        Said::Number(x) => Value::Real(x),
        Said::Words(words) => Value::Text(words),
    }
}

impl<X: Flat> dyn Told<X> + '_ {
    /// What is said of the whole, in the order in which it is compared.
    pub(super) fn settings(&self) -> Vec<(&'static str, Value)> {
        let whole = self.whole().into_iter().map(|(key, said)| (key, value(said)));
        core::iter::once(("format", Value::Integer(FORMAT))).chain(whole).collect()
    }

    /// Refuses a store of another ensemble, as far as all members have it in common.
    pub(super) fn compare_settings(&self, database: &Connection) -> Result<(), StoreError> {
        let settings = self.settings();
        let said = |of| settings.iter().find(|(key, _)| *key == of).map_or(Value::Null, |(_, value)| value.clone());
        for (key, here) in &settings {
            let store = get(database, key)?.ok_or(StoreError::Setting { key })?;
            let same = match (&store, here) {
                (Value::Null, Value::Real(x)) => x.is_nan(),
                (store, here) => store == here,
            };
            if same {
                continue;
            }
            if let ("steps" | "end", Some(here)) = (*key, reached(&["steps", "end"].map(said))) {
                let store = [get(database, "steps")?, get(database, "end")?].map(|value| value.unwrap_or(Value::Null));
                return Err(
                    reached(&store).map_or(StoreError::Setting { key }, |store| StoreError::Reach { store, here })
                );
            }
            let scheme = if let Value::Text(name) = said("scheme") { word(&name) } else { "another" };
            return Err(difference(scheme, key, &store, here));
        }
        Ok(())
    }
}

/// What two sides say, from a little before the place where they differ if one is too long for an error.
pub(super) fn beside(store: &str, here: &str) -> (Name, &'static str) {
    let alike = store.char_indices().zip(here.chars()).take_while(|((_, a), b)| a == b);
    let places: Vec<usize> = alike.map(|((place, _), _)| place).collect();
    let from = if store.len().max(here.len()) > Name::ROOM { places.len().saturating_sub(BEFORE) } else { 0 };
    let (from, left) = (places.get(from).copied().unwrap_or(0), if from > 0 { "…" } else { "" });
    let [store, here] = [store, here].map(|text| Name::of(&[left, &text[from..]]));
    (store, word(here.text()))
}

fn reached(values: &[Value; 2]) -> Option<Reach> {
    match *values {
        [Value::Integer(steps), Value::Null] => Some(Reach::Steps(steps.cast_unsigned())),
        [Value::Null, Value::Real(end)] => Some(Reach::Until(end)),
        [Value::Null, Value::Null] => Some(Reach::Until(f64::NAN)),
        _ => None,
    }
}

fn difference(scheme: &'static str, key: &'static str, store: &Value, here: &Value) -> StoreError {
    let damaged = StoreError::Setting { key };
    let number = |value: &Value| match *value {
        Value::Real(x) => Some(x),
        Value::Null => Some(f64::NAN),
        _ => None,
    };
    match (key, store, here) {
        ("format", &Value::Integer(store), &Value::Integer(here)) => StoreError::Format { store, here },
        ("members", &Value::Integer(store), &Value::Integer(here)) => StoreError::Members { store, here },
        ("scalar", Value::Text(store), Value::Text(here)) => {
            StoreError::Scalar { store: Name::of(&[store]), here: word(here) }
        }
        ("dimension", &Value::Integer(store), &Value::Integer(here)) => StoreError::Dimension { store, here },
        ("scheme", Value::Text(store), _) => StoreError::Scheme { store: Name::of(&[store]), here: scheme },
        ("options", Value::Text(store), Value::Text(here)) => {
            let (store, here) = options_apart(store, here);
            StoreError::Options { store, here }
        }
        ("order", &Value::Integer(store), &Value::Integer(here)) => {
            let [store, here] = [store, here].map(|order| format!("order {order}"));
            StoreError::Options { store: Name::of(&[&store]), here: word(&here) }
        }
        ("looks" | "fields" | "invariants" | "company", Value::Text(store), Value::Text(here)) => {
            let (store, here) = beside(store, here);
            match key {
                "looks" => StoreError::Looks { store, here },
                "company" => StoreError::Company { store, here },
                what => StoreError::Law { what, store, here },
            }
        }
        ("tolerance" | "dt", ..) => match (number(store), number(here)) {
            (Some(store), Some(here)) if key == "dt" => StoreError::TimeStep { store, here },
            (Some(store), Some(here)) => StoreError::Tolerance { store, here },
            _ => damaged,
        },
        _ => damaged,
    }
}
