//! The tables of a store, as SQL.

/// What the columns depend on.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// Coordinates.
    pub(super) dimension: usize,
    /// The columns of the law's fields.
    pub(super) fields: Vec<String>,
}

/// The columns of a drift, as it has them itself; what follows from them is beside, for those who look.
const DRIFT: &str = "start, last, max_abs, samples, mean_t, mean_x, moment_tt, moment_tx";
const LAST: &str = "stopped, steps, evaluations, iterations, rough, nanoseconds, shortest, longest, bits, seal";

impl Layout {
    /// Columns for fields of these names, none twice; SQLite does not tell large letters from small ones.
    pub(super) fn of(dimension: usize, names: &[&str]) -> Self {
        let mut fields: Vec<String> = Vec::with_capacity(names.len());
        for (i, name) in names.iter().enumerate() {
            let is_list = names.iter().filter(|other| *other == name).count() > 1;
            let place = names[..i].iter().filter(|other| *other == name).count();
            let mut column = if is_list { format!("law_{name}_{place}") } else { format!("law_{name}") };
            while fields.iter().any(|other| other.eq_ignore_ascii_case(&column)) {
                column.push('_');
            }
            fields.push(column);
        }
        Layout { dimension, fields }
    }

    /// The names of the numbers of a state.
    fn state(&self) -> Vec<String> {
        let vectors = ["q", "v"].into_iter().flat_map(|x| (0..self.dimension).map(move |i| format!("{x}{i}")));
        core::iter::once("t".to_owned()).chain(vectors).collect()
    }

    /// The names of the numbers of a member: its mass, its law, its start.
    pub(super) fn member(&self) -> Vec<String> {
        let start = self.state();
        core::iter::once("mass".to_owned()).chain(self.fields.iter().cloned()).chain(start).collect()
    }

    /// All tables, empty.
    pub(super) fn create(&self) -> String {
        let real = |columns: &[String]| columns.iter().map(|name| format!("\"{name}\" REAL, ")).collect::<String>();
        let (member, state) = (real(&self.member()), real(&self.state()));
        let drift = DRIFT.split(", ").map(|name| format!("{name} REAL, ")).collect::<String>();
        format!(
            "CREATE TABLE sweep (key TEXT PRIMARY KEY, value) WITHOUT ROWID;
             CREATE TABLE member (k INTEGER PRIMARY KEY, {member} acts INTEGER, bits BLOB, seal INTEGER);
             CREATE TABLE last (
                 k INTEGER PRIMARY KEY, failed TEXT, {state} stopped INTEGER, steps INTEGER, evaluations INTEGER, iterations INTEGER, rough INTEGER,
                 nanoseconds INTEGER, shortest REAL, longest REAL, bits BLOB, seal INTEGER
             );
             CREATE TABLE drift (
                 k INTEGER, number INTEGER, invariant TEXT, {drift} bits BLOB, max_relative REAL, slope REAL, PRIMARY KEY (k, number)
             ) WITHOUT ROWID;
             CREATE TABLE event (
                 k INTEGER, n INTEGER, which INTEGER, rising INTEGER, {state} bits BLOB, PRIMARY KEY (k, n)
             ) WITHOUT ROWID;
             CREATE TABLE state (k INTEGER, n INTEGER, {state} bits BLOB, PRIMARY KEY (k, n)) WITHOUT ROWID;"
        )
    }

    fn columns(&self, table: &str) -> String {
        let list = |names: &[String]| names.iter().map(|name| format!("\"{name}\"")).collect::<Vec<_>>().join(", ");
        match table {
            "member" => format!("k, {}, acts, bits, seal", list(&self.member())),
            "last" => format!("k, failed, {}, {LAST}", list(&self.state())),
            "drift" => format!("k, number, {DRIFT}, bits, max_relative, slope, invariant"),
            "event" => format!("k, n, which, rising, {}, bits", list(&self.state())),
            _ => format!("k, n, {}, bits", list(&self.state())),
        }
    }

    /// Writes a row, also over one.
    pub(super) fn insert(&self, table: &str) -> String {
        let columns = self.columns(table);
        let places = vec!["?"; columns.split(", ").count()].join(", ");
        format!("INSERT OR REPLACE INTO {table} ({columns}) VALUES ({places})")
    }

    /// The rows of members from one number to another, in order.
    pub(super) fn select(&self, table: &str) -> String {
        let order = match table {
            "drift" => ", number",
            "event" | "state" => ", n",
            _ => "",
        };
        format!("SELECT {} FROM {table} WHERE k >= ? AND k < ? ORDER BY k{order}", self.columns(table))
    }
}
