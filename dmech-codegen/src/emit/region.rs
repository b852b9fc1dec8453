//! Where a value is computed: in the body of a function, or only in the branch that needs it.

use dmech_symbolic::program::{Operation, Program, Value};

/// A branch of a choice: the choice's value and which branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Branch {
    pub(super) choice: Value,
    pub(super) yes: bool,
}

/// For every value the branch that it is computed in; none for the body itself.
pub(super) struct Regions {
    of: Vec<Option<Branch>>,
}

impl Regions {
    pub(super) fn new(program: &Program) -> Self {
        let count = program.operations.len();
        let mut uses: Vec<Vec<(usize, Option<bool>)>> = vec![vec![]; count];
        for (i, operation) in program.operations.iter().enumerate() {
            match operation {
                Operation::Select(test, yes, no) => {
                    test.operands().iter().for_each(|v| uses[v.index()].push((i, None)));
                    uses[yes.index()].push((i, Some(true)));
                    uses[no.index()].push((i, Some(false)));
                }
                _ => operation.operands().iter().for_each(|v| uses[v.index()].push((i, None))),
            }
        }
        let values: Vec<Value> = program.values().collect();
        let mut is_output = vec![false; count];
        program.outputs.iter().for_each(|v| is_output[v.index()] = true);
        let mut regions = Self { of: vec![None; count] };
        for i in (0..count).rev() {
            let shared = matches!(program.operations[i], Operation::Symbol(_) | Operation::Number(_));
            if shared || is_output[i] {
                continue;
            }
            let mut wanted = uses[i].iter().map(|&(user, branch)| match branch {
                Some(yes) => Some(Branch { choice: values[user], yes }),
                None => regions.of[user],
            });
            let first = wanted.next().flatten();
            let common = wanted.fold(first, |common, region| regions.meet(common, region));
            regions.of[i] = common;
        }
        regions
    }

    pub(super) fn of(&self, value: Value) -> Option<Branch> {
        self.of[value.index()]
    }

    /// The innermost region around both.
    pub(super) fn meet(&self, one: Option<Branch>, two: Option<Branch>) -> Option<Branch> {
        let outward = |region: Option<Branch>| {
            std::iter::successors(Some(region), |r| r.map(|branch| self.of[branch.choice.index()]))
        };
        outward(one).find(|r| outward(two).any(|other| other == *r)).flatten()
    }
}
