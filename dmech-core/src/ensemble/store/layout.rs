//! The tables of a store, as SQL.

use dmech_scalar::Exact;

use crate::ensemble::told::Named;
use crate::flat::Flat;
use crate::name::Name;

/// What the columns depend on.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// The names of the numbers of a body: where a number has several parts, of each.
    body: Vec<String>,
    /// Bodies have rows of their own.
    listed: bool,
    /// What each member has by name.
    pub(super) columns: Named,
}

/// The tables that every store has.
pub(super) const TABLES: [&str; 7] = ["sweep", "member", "last", "drift", "event", "change", "state"];

/// Columns of one type.
fn of(kind: &str, names: impl IntoIterator<Item = impl AsRef<str>>) -> String {
    names.into_iter().map(|name| format!("\"{}\" {kind}, ", name.as_ref())).collect()
}

impl Layout {
    pub(super) fn of<X: Flat>(columns: Named) -> Self {
        let numbers = ["q", "v"].into_iter().flat_map(|x| (0..X::DIMENSION).map(move |i| format!("{x}{i}")));
        let parts = |number: String| (0..X::Scalar::PARTS).map(move |n| number.clone() + &X::Scalar::part(n));
        Layout { body: numbers.flat_map(parts).collect(), listed: X::LISTED, columns }
    }

    /// Whether members have lists of further numbers.
    pub(super) fn has_lists(&self) -> bool {
        !self.columns.words.is_empty()
    }

    /// The name of a number of a state, by its place among all of them.
    pub(super) fn number(&self, place: usize) -> Name {
        let Some(place) = place.checked_sub(1) else { return Name::of(&["t"]) };
        let (body, name) = (place / self.body.len(), &self.body[place % self.body.len()]);
        if self.listed { Name::of(&[name, " of body ", &body.to_string()]) } else { Name::of(&[name]) }
    }

    /// The tables with a row, or more, for each member.
    fn tables(&self) -> impl Iterator<Item = &'static str> + '_ {
        let lists = ["number"].into_iter().filter(|_| self.has_lists());
        TABLES.into_iter().skip(1).chain(lists).chain(["body"].into_iter().filter(|_| self.listed))
    }

    /// The columns of a table with their types, in the order in which they are written and read; a comma after each.
    fn columns(&self, table: &str) -> String {
        let body = of("REAL", &self.body);
        // Where bodies have rows of their own, how many there are.
        let state = if self.listed { "t REAL, bodies INTEGER, ".to_owned() } else { format!("t REAL, {body}") };
        let met = if self.listed { "a INTEGER, b INTEGER, " } else { "" };
        let Named { words, numbers } = &self.columns;
        match table {
            "member" => {
                let (words, numbers) = (of("TEXT", words.iter()), of("REAL", numbers));
                format!("k INTEGER, {words}{numbers}{state}acts INTEGER, bits BLOB, seal INTEGER, ")
            }
            "last" => format!(
                "k INTEGER, failed TEXT, {state}stopped INTEGER, steps INTEGER, evaluations INTEGER, iterations INTEGER, \
                 rough INTEGER, nanoseconds INTEGER, shortest REAL, longest REAL, bits BLOB, seal INTEGER, "
            ),
            // As a drift has them itself; what follows from them is beside, for those who look.
            "drift" => "k INTEGER, number INTEGER, start REAL, last REAL, max_abs REAL, samples REAL, mean_t REAL, mean_x REAL, \
                 moment_tt REAL, moment_tx REAL, bits BLOB, max_relative REAL, slope REAL, invariant TEXT, "
                .to_owned(),
            "event" => format!("k INTEGER, n INTEGER, which INTEGER, rising INTEGER, {met}{state}bits BLOB, "),
            "number" => "k INTEGER, n INTEGER, name TEXT, value REAL, bits BLOB, ".to_owned(),
            "body" => format!("k INTEGER, what TEXT, n INTEGER, body INTEGER, {body}bits BLOB, "),
            _ => format!("k INTEGER, n INTEGER, {state}bits BLOB, "),
        }
    }

    /// The names of the columns.
    fn names(&self, table: &str) -> Vec<String> {
        let columns = self.columns(table);
        columns.split_terminator(", ").map(|column| column.split(' ').next().unwrap_or(column).to_owned()).collect()
    }

    /// What tells the rows of a table apart.
    fn key(table: &str) -> &'static str {
        match table {
            "member" | "last" => "k",
            "drift" => "k, number",
            "body" => "what, k, n, body",
            _ => "k, n",
        }
    }

    /// All tables, empty.
    pub(super) fn create(&self) -> String {
        let create = |table| {
            let (columns, key) = (self.columns(table), Layout::key(table));
            let rows = if key == "k" { "" } else { " WITHOUT ROWID" };
            format!("CREATE TABLE {table} ({columns}PRIMARY KEY ({key})){rows};\n")
        };
        let sweep = "CREATE TABLE sweep (key TEXT PRIMARY KEY, value) WITHOUT ROWID;\n".to_owned();
        core::iter::once(sweep).chain(self.tables().map(create)).collect()
    }

    /// Writes a row, also over one.
    pub(super) fn insert(&self, table: &str) -> String {
        let columns = self.names(table);
        let places = vec!["?"; columns.len()].join(", ");
        format!("INSERT OR REPLACE INTO {table} ({}) VALUES ({places})", columns.join(", "))
    }

    /// Takes away what was written of the runs of members from one number to another that failed: when they are moved again there may be
    /// less of it.
    pub(super) fn forget(&self) -> impl Iterator<Item = (&'static str, String)> {
        let of = "k IN (SELECT k FROM last WHERE failed IS NOT NULL AND k >= ? AND k < ?)";
        let bodies = ["body"].into_iter().filter(|_| self.listed);
        ["drift", "event", "change", "state"].into_iter().chain(bodies).map(move |table| {
            // Named one by one, so that their rows are found by the key.
            let what = if table == "body" { "what IN ('last', 'event', 'change', 'state') AND " } else { "" };
            (table, format!("DELETE FROM {table} WHERE {what}{of}"))
        })
    }

    /// The rows of members from one number to another, in order; of bodies those of one kind of state.
    pub(super) fn select(&self, table: &str) -> String {
        let (columns, key) = (self.names(table).join(", "), Layout::key(table));
        let what = if table == "body" { "what = ? AND " } else { "" };
        format!("SELECT {columns} FROM {table} WHERE {what}k >= ? AND k < ? ORDER BY {key}")
    }
}
