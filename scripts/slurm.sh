#!/usr/bin/env bash
# The sweep on many machines: sbatch scripts/slurm.sh
# Killed by the limit of time it goes on from its store: submit it again.
#SBATCH --job-name=dmech-sweep
#SBATCH --nodes=8
#SBATCH --ntasks-per-node=1
#SBATCH --cpus-per-task=64
#SBATCH --time=00:30:00
#SBATCH --output=sweep-%j.log
set -euo pipefail
cd "${SLURM_SUBMIT_DIR:-$(dirname "${BASH_SOURCE[0]}")/..}/dmech-mpi"

# Built once, on the first node, for its processor.
export RUSTFLAGS="${RUSTFLAGS:--C target-cpu=native}"
cargo build --release --example sweep
# A rank for each machine and a thread for each of its cores; only the first rank opens the store.
srun --cpu-bind=none "${CARGO_TARGET_DIR:-target}/release/examples/sweep" sweep.sqlite
