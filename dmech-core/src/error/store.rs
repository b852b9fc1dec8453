//! Why a store of an ensemble is refused, or cannot be written.

use core::fmt;

use thiserror::Error;

use crate::name::Name;
use crate::text::{Longest, Number};

/// What is wrong with the store of an ensemble ([`Ensemble::store`](crate::Ensemble::store)): it is damaged, it belongs to another
/// sweep, or it cannot be written.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum StoreError {
    /// The disk, or the file system, has no room for more. What was written stays, and the sweep goes on from it.
    #[error("there is no room for more; what was written stays, and the sweep goes on from it")]
    Full,
    /// A name of nothing.
    #[error("the path of the store is empty")]
    NoPath,
    /// The folder in which it is to be is not there.
    #[error("there is no such folder as that of the store: make it first")]
    NoFolder,
    /// A folder has its name.
    #[error("the path of the store is that of a folder: name a file in it")]
    Folder,
    /// The file is not a database of SQLite.
    #[error("the file is not a database of SQLite")]
    NotADatabase,
    /// A database, but not of an ensemble.
    #[error("the database holds something else than an ensemble")]
    NotAnEnsemble,
    /// SQLite finds its file damaged.
    #[error("the file is damaged: SQLite cannot read what it has written")]
    Damaged,
    /// What was written of a member is not what stands there.
    #[error("the file is damaged, or was changed after it was written: table `{table}`, member {member}")]
    Changed {
        /// The table.
        table: &'static str,
        /// The number of the member.
        member: u64,
    },
    /// A table, or a column of one, is not there.
    #[error("the file is damaged, or was changed after it was written: table `{table}`, or a column of it, is missing")]
    Missing {
        /// The table.
        table: &'static str,
    },
    /// What was written of the whole sweep is not what stands there.
    #[error("the file is damaged, or was changed after it was written: table `sweep`, key `{key}`")]
    Setting {
        /// The first key that is not understood.
        key: &'static str,
    },
    /// SQLite refuses for another reason: no such directory, no right to write, locked by somebody else.
    #[error("SQLite says: {} ({code})", said(*code))]
    Sqlite {
        /// Its [extended result code](https://www.sqlite.org/rescode.html).
        code: i32,
    },
    /// It was written by another version of this crate.
    #[error("the store has the format {store}, this version reads {here}")]
    Format {
        /// That of the store.
        store: i64,
        /// That which is understood.
        here: i64,
    },
    /// The number of members.
    #[error("the store has {store} members, this ensemble {here}")]
    Members {
        /// In the store.
        store: i64,
        /// In the ensemble.
        here: i64,
    },
    /// The numbers of positions and velocities.
    #[error("the numbers of the store are {store}, those of this ensemble {here}")]
    Scalar {
        /// In the store.
        store: Name,
        /// In the ensemble.
        here: &'static str,
    },
    /// The number of coordinates.
    #[error("the dimension is {store} in the store against {here}")]
    Dimension {
        /// In the store.
        store: i64,
        /// In the ensemble.
        here: i64,
    },
    /// The scheme.
    #[error("the store is of {store}, this ensemble of {here}")]
    Scheme {
        /// In the store.
        store: Name,
        /// In the ensemble.
        here: &'static str,
    },
    /// The options of the scheme.
    #[error("the scheme has other options: `{store}` in the store against `{here}`")]
    Options {
        /// The first that differs, in the store.
        store: Name,
        /// In the ensemble.
        here: &'static str,
    },
    /// The tolerance; NaN where there is none.
    #[error("the tolerance is {} in the store against {}", Number(*store), Number(*here))]
    Tolerance {
        /// In the store.
        store: f64,
        /// In the ensemble.
        here: f64,
    },
    /// The time step; NaN where there is none.
    #[error("dt is {} in the store against {}", Longest(*store), Longest(*here))]
    TimeStep {
        /// In the store.
        store: f64,
        /// In the ensemble.
        here: f64,
    },
    /// How far the members go.
    #[error("the members of the store go {store}, those of this ensemble {here}")]
    Reach {
        /// In the store.
        store: Reach,
        /// In the ensemble.
        here: Reach,
    },
    /// When states are recorded, or looked at for the invariants.
    #[error("states are recorded, or looked at, {store} in the store, {here} in this ensemble")]
    Looks {
        /// In the store.
        store: Name,
        /// In the ensemble.
        here: &'static str,
    },
    /// The names of the numbers that the law reads of itself, or of its own invariants.
    #[error("the law of the store has the {what} [{store}], that of this ensemble [{here}]")]
    Law {
        /// `fields` or `invariants`.
        what: &'static str,
        /// In the store.
        store: Name,
        /// In the ensemble.
        here: &'static str,
    },
    /// Events and watched quantities of the members.
    #[error("each member of the store has {store}, of this ensemble {here}")]
    Company {
        /// In the store.
        store: Name,
        /// In the ensemble.
        here: &'static str,
    },
    /// A number of the law, the mass or the start of a member.
    #[error("member {member} has another {column}: {} in the store against {}", Number(*store), Number(*here))]
    Member {
        /// The first member that differs.
        member: u64,
        /// The column of the table `member`.
        column: Name,
        /// In the store.
        store: f64,
        /// In the ensemble.
        here: f64,
    },
    /// Something that is said of a member in words: the options of its scheme, when it is looked at, the invariants of its law.
    #[error("member {member} has other {column}: `{store}` in the store, `{here}` here")]
    Words {
        /// The first member that differs.
        member: u64,
        /// The column of the table `member`.
        column: &'static str,
        /// In the store.
        store: &'static str,
        /// In the ensemble.
        here: &'static str,
    },
    /// A member is set up from other numbers than in the store: of bodies, of bonds, of the fields of its laws.
    #[error(
        "member {member} is made of other numbers than in the store: the {name} are not as many, or others stand there"
    )]
    Numbers {
        /// The first member that differs.
        member: u64,
        /// The first of them, as the table `number` names it, or `bodies`.
        name: &'static str,
    },
    /// The law itself: with the same numbers something else acts.
    #[error(
        "the laws differ: where member {member} starts and beside it they do not give the same potential and force to the bit"
    )]
    Acts {
        /// The first member whose law differs.
        member: u64,
    },
}

/// How far a run goes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reach {
    /// So many steps.
    Steps(u64),
    /// Until a time.
    Until(f64),
}

impl fmt::Display for Reach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Reach::Steps(steps) => write!(f, "{steps} steps"),
            Reach::Until(end) => write!(f, "until t = {}", Number(end)),
        }
    }
}

fn said(code: i32) -> &'static str {
    rusqlite::ffi::code_to_str(code)
}

impl From<rusqlite::Error> for StoreError {
    fn from(error: rusqlite::Error) -> Self {
        use rusqlite::ErrorCode::{DatabaseCorrupt, DiskFull, NotADatabase};
        match error.sqlite_error() {
            Some(cause) => match cause.code {
                DiskFull => StoreError::Full,
                NotADatabase => StoreError::NotADatabase,
                DatabaseCorrupt => StoreError::Damaged,
                _ => StoreError::Sqlite { code: cause.extended_code },
            },
            // A column or a row that is missing, or of another kind.
            None => StoreError::Damaged,
        }
    }
}
