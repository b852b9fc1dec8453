//! Conditions that several choices of a program ask.
//!
//! In a law whose choices are nested, thousands of choices ask a few dozen conditions. Each such condition is a mask of its
//! own, and what is chosen by it stands in blocks: the incremental compiler goes through the types of a whole function once
//! for every closure in it.

use std::collections::HashMap;

use dmech_symbolic::program::{Operation, Program, Test, Value};
use proc_macro2::Ident;

use super::region::{Branch, Regions};

/// The conditions that are asked more than once.
pub(super) struct SharedTests {
    of: HashMap<Test, SharedTest>,
    /// In each region the tests that are made there, by the last of the values that they need.
    made_in: HashMap<Option<Branch>, Vec<(Value, Test)>>,
}

struct SharedTest {
    choices: Vec<Value>,
    mask: Option<Ident>,
}

impl SharedTests {
    pub(super) fn new(program: &Program, regions: &Regions) -> Self {
        let mut of: HashMap<Test, SharedTest> = HashMap::new();
        for value in program.values() {
            if let Operation::Select(test, ..) = program.operation(value) {
                let entry = of.entry(test.clone()).or_insert(SharedTest { choices: vec![], mask: None });
                entry.choices.push(value);
            }
        }
        of.retain(|_, shared| shared.choices.len() > 1);
        let mut made_in: HashMap<Option<Branch>, Vec<(Value, Test)>> = HashMap::new();
        for (test, shared) in &of {
            let around = shared.choices.iter().map(|&choice| regions.of(choice));
            let region = around.reduce(|one, two| regions.meet(one, two)).flatten();
            let last = test.operands().into_iter().max().expect("a condition compares values");
            made_in.entry(region).or_default().push((last, test.clone()));
        }
        // Latest first; among tests of the same values the one that is asked first.
        for tests in made_in.values_mut() {
            tests.sort_by_key(|(last, test)| std::cmp::Reverse((*last, of[test].choices[0])));
        }
        Self { of, made_in }
    }

    /// How often each value is used, if each condition is evaluated once.
    pub(super) fn uses(&self, program: &Program) -> Vec<usize> {
        let mut uses = program.uses();
        for (test, shared) in &self.of {
            for operand in test.operands() {
                uses[operand.index()] -= shared.choices.len() - 1;
            }
        }
        uses
    }

    /// A condition that is to be evaluated in the region before the value is, as all that it needs is known.
    pub(super) fn due(&mut self, region: Option<Branch>, value: Value) -> Option<Test> {
        let tests = self.made_in.get_mut(&region)?;
        let (last, _) = tests.last()?;
        if *last < value { tests.pop().map(|(_, test)| test) } else { None }
    }

    /// Gives the mask its name.
    pub(super) fn name(&mut self, test: &Test, mask: Ident) {
        self.of.get_mut(test).expect("the condition is shared").mask = Some(mask);
    }

    /// The mask of a condition that several choices ask.
    pub(super) fn mask(&self, test: &Test) -> Option<Ident> {
        self.of.get(test)?.mask.clone()
    }
}
