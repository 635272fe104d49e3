#!/usr/bin/env bash
# Mutation testing of a fixed sample: which changes of one expression do the tests of a crate not notice?
#
# Needs cargo-mutants (`cargo install cargo-mutants --locked`). Takes hours on two cores; not part of the gate.
#
#   scripts/mutants.sh [CRATE…]        all four crates unless some are named
#
# The sample of a crate is one share of its mutants, dealt out in turn: the same tree gives the same sample, and
# another seed (SEED=1, 2, …) another one. Outcomes stand in target/mutants/<crate>/mutants.out.
set -euo pipefail
cd "$(dirname "$0")/.."

seed=${SEED:-0}
# Crate and how many of its mutants are tried: gears and the solver, on which all else stands, most.
sample='gears 70
train 80
layout 40
hydromotor 60'
wanted=${*:-$(cut -d' ' -f1 <<<"$sample")}

while read -r crate count; do
    grep -qw "$crate" <<<"$wanted" || continue
    all=$(cargo mutants --list --package "epicyclic-$crate" | wc -l)
    shares=$(((all + count - 1) / count))
    mkdir -p "target/mutants/$crate"
    # Exit code 2 says that some were missed: that is the answer, not a failure.
    cargo mutants --package "epicyclic-$crate" --shard "$((seed % shares))/$shares" --sharding round-robin \
        --timeout 300 --no-shuffle --colors never \
        --output "target/mutants/$crate" || [ $? -eq 2 ]
done <<<"$sample"

echo
for crate in $wanted; do
    outcomes="target/mutants/$crate/mutants.out"
    count() { grep -c . "$outcomes/$1.txt" || true; }
    echo "$crate: $(count caught) caught, $(count timeout) timed out, $(count missed) missed, $(count unviable) not viable"
    sed 's/^/  missed: /' "$outcomes/missed.txt"
done
