#!/usr/bin/env bash
# The sweep on the ranks of this machine: scripts/local.sh [ranks] [file of the store]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../dmech-mpi"

ranks=${1:-4}
cargo build --release --quiet --example sweep
target=${CARGO_TARGET_DIR:-target}
# Each rank has one thread's work here; the system finds a core for it.
mpirun -n "$ranks" --oversubscribe --bind-to none "$target/release/examples/sweep" "${@:2}"
