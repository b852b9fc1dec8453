//! The variables in sight.

use super::value::Value;

/// A variable.
#[derive(Clone)]
pub(super) struct Local {
    pub(super) name: String,
    pub(super) value: Value,
}

/// The variables of one function, the innermost last.
#[derive(Clone, Default)]
pub(super) struct Scope {
    pub(super) locals: Vec<Local>,
}

impl Scope {
    pub(super) fn bind(&mut self, name: String, value: Value) {
        self.locals.push(Local { name, value });
    }

    /// The place of the innermost variable of that name.
    pub(super) fn find(&self, name: &str) -> Option<usize> {
        self.locals.iter().rposition(|local| local.name == name)
    }

    /// How many variables there are, to return to later.
    pub(super) fn mark(&self) -> usize {
        self.locals.len()
    }

    /// Forgets what was bound after the mark.
    pub(super) fn reset(&mut self, mark: usize) {
        self.locals.truncate(mark);
    }
}
