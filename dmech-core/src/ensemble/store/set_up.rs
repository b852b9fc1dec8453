//! What an ensemble is set up from, and whether a store has the same.

use rusqlite::types::Value;
use rusqlite::{Connection, params};

use super::layout::Layout;
use super::settings::{FORMAT, get, reach, set};
use super::table::{Reader, Seal, Writer};
use crate::ensemble::Rides;
use crate::ensemble::plan::Plan;
use crate::error::StoreError;
use crate::law::{Field, Fields, Numbers, Potential};
use crate::name::Name;
use crate::run::{Attend, Due, Simulation};
use crate::span::Span;
use crate::state::State;

/// The numbers of a member, and what acts on it.
pub(super) struct Member {
    numbers: Vec<f64>,
    acts: i64,
}

impl Member {
    /// Of a row, and the seal that stands there.
    fn read(row: &mut Reader<'_>, count: usize) -> Option<(Self, i64)> {
        let mut numbers = vec![0.0; count];
        row.numbers(&mut numbers)?;
        let acts = row.count()?.cast_signed();
        row.bits(&mut numbers)?;
        Some((Member { numbers, acts }, row.count()?.cast_signed()))
    }

    fn seal(&self, k: usize) -> i64 {
        let mut seal = Seal::default();
        seal.count(k as u64);
        seal.numbers(&self.numbers);
        seal.count(self.acts.cast_unsigned());
        seal.value()
    }
}

/// An ensemble as a store sees it, whatever the law and the scheme.
pub(super) trait SetUp {
    /// How many members there are.
    fn members(&self) -> usize;

    /// The columns; those of the law are named by the first member.
    fn layout(&self) -> Layout;

    /// What a member begins with.
    fn member(&self, k: usize) -> Member;

    /// What is said of the whole, in the order in which it is compared.
    fn settings(&self, layout: &Layout) -> Vec<(&'static str, Value)>;

    /// How far it goes.
    fn span(&self) -> Span;

    /// The name of the scheme.
    fn scheme(&self) -> &'static str;
}

impl<L: Fields<D>, S: Rides<L, D> + Sync, O: Attend<State<D>>, const D: usize> SetUp for Plan<'_, L, S, O, D> {
    fn members(&self) -> usize {
        self.members
    }

    fn layout(&self) -> Layout {
        let mut names = Vec::new();
        let numbers = <L::Numbers as Numbers>::COUNT;
        if self.members > 0 {
            if let Some(written) = (self.bare)(0).law.written() {
                written.fields(&mut |name, _| names.push(name));
            }
            if names.len() + D == numbers {
                names.extend(["masses"; D]);
            }
        }
        if names.len() == numbers {
            return Layout::of(D, &names);
        }
        let names: Vec<String> = (0..numbers).map(|i| i.to_string()).collect();
        Layout::of(D, &names.iter().map(String::as_str).collect::<Vec<_>>())
    }

    fn member(&self, k: usize) -> Member {
        let Simulation { law, start: State { t, q, v }, settings, .. } = (self.bare)(k);
        let numbers = [&[settings.mass], law.numbers().list().as_slice(), &[t], &q, &v].concat();
        let field = law.field(settings.mass, t);
        let mut seal = Seal::default();
        // Beside the start too, where nothing is zero by symmetry.
        let beside = core::array::from_fn(|i| q[i] + 0.5 * v[i] + 0.0625 * (i + 1) as f64);
        for place in [q, beside] {
            let acting = field.slope(place, v).map(|x| if x.is_nan() { f64::NAN } else { x });
            let potential = field.potential(place);
            seal.numbers(&[if potential.is_nan() { f64::NAN } else { potential }]);
            seal.numbers(&acting);
        }
        Member { numbers, acts: seal.value() }
    }

    fn settings(&self, layout: &Layout) -> Vec<(&'static str, Value)> {
        let count = |n: usize| Value::Integer(n as i64);
        let number = |x: Option<f64>| x.map_or(Value::Null, Value::Real);
        let scheme = &self.common.scheme;
        let [steps, end] = reach(self.span);
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

    fn span(&self) -> Span {
        self.span
    }

    fn scheme(&self) -> &'static str {
        S::NAME
    }
}

impl dyn SetUp + '_ {
    /// Writes the set-up of all members into an empty database, whole or not at all.
    pub(super) fn begin(&self, database: &Connection, layout: &Layout) -> Result<(), StoreError> {
        let transaction = database.unchecked_transaction()?;
        database.execute_batch(&layout.create())?;
        for (key, value) in self.settings(layout) {
            set(database, key, &value)?;
        }
        let mut all = Seal::default();
        let mut row = Writer::new(database, &layout.insert("member"))?;
        for k in 0..self.members() {
            let member = self.member(k);
            row.count(k as u64)?;
            row.numbers(&member.numbers)?;
            row.put(member.acts)?;
            row.bits(&member.numbers)?;
            let seal = member.seal(k);
            row.put(seal)?;
            row.end()?;
            all.count(seal.cast_unsigned());
        }
        drop(row);
        set(database, "set_up", &Value::Text(format!("{:016x}", all.value())))?;
        Ok(transaction.commit()?)
    }

    /// Refuses a store of another ensemble, with what differs.
    pub(super) fn compare(&self, database: &Connection, layout: &Layout) -> Result<(), StoreError> {
        self.compare_settings(database, layout)?;
        let columns = layout.member();
        let mut all = Seal::default();
        let mut statement = database.prepare(&layout.select("member"))?;
        let mut rows = statement.query(params![0, i64::MAX])?;
        for k in 0..self.members() {
            let changed = StoreError::Changed { table: "member", member: k as u64 };
            let here = self.member(k);
            let mut row = Reader::new(rows.next()?.ok_or(changed)?);
            let number = row.count();
            let (stored, seal) = Member::read(&mut row, columns.len()).ok_or(changed)?;
            if number != Some(k as u64) || seal != stored.seal(k) {
                return Err(changed);
            }
            let mut numbers = columns.iter().zip(stored.numbers.iter().zip(&here.numbers));
            if let Some((column, (&store, &here))) = numbers.find(|(_, (a, b))| a.to_bits() != b.to_bits()) {
                return Err(StoreError::Member { member: k as u64, column: Name::of(&[column]), store, here });
            }
            if stored.acts != here.acts {
                return Err(StoreError::Acts { member: k as u64 });
            }
            all.count(seal.cast_unsigned());
        }
        let whole = Value::Text(format!("{:016x}", all.value()));
        if rows.next()?.is_some() || get(database, "set_up")? != Some(whole) {
            return Err(StoreError::Setting { key: "set_up" });
        }
        Ok(())
    }
}
