#!/usr/bin/env bash
# Fuzzes the readers. run.sh [SECONDS each, default 600] [TARGET...] builds the preset `fuzz` first and is a search: corpora grow
# in build/fuzz/corpus. run.sh --built [INPUTS each, default 1000] [TARGET...] is the short run of ./test.sh, the same every
# time: the seeds and so many inputs made of them, whatever earlier searches found and however busy the machine is.
# A finding stays in build/fuzz/findings and ends with exit 1.
set -euo pipefail
cd "$(dirname "$0")/../.."
built=no
if [ "${1:-}" = --built ]; then
    built=yes
    shift
fi
amount=${1:-$([ $built = yes ] && echo 1000 || echo 600)}
shift || true
bin=build/fuzz/bin
if ! command -v clang++-14 >/dev/null; then
    echo "nothing to run: clang-14 is not installed"
    exit 0
fi
[ $built = yes ] || packaging/build.sh fuzz fuzz_targets
if [ ! -e $bin/fuzz_ply ]; then
    echo "nothing to run: the preset fuzz is not built"
    exit 0
fi
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
    for program in "$bin"/fuzz_*; do targets+=("${program##*/fuzz_}"); done
fi
mkdir -p build/fuzz/findings
failed=()
for target in "${targets[@]}"; do
    seeds=$(mktemp -d)
    fresh=$(mktemp -d)
    corpus=build/fuzz/corpus/$target
    if [ $built = yes ]; then corpus=$fresh; fi
    mkdir -p "$corpus"
    python3 tests/fuzz/seeds.py "$target" "$seeds"
    "$bin/write_seeds" "$target" "$seeds"
    options=(-timeout=25 -rss_limit_mb=2048 -malloc_limit_mb=512 -max_len=65536 -print_final_stats=1
        -artifact_prefix="build/fuzz/findings/$target-" -verbosity=1 -close_fd_mask=1)
    if [ $built = yes ]; then options+=(-seed=1 -runs="$amount"); else options+=(-max_total_time="$amount"); fi
    dictionary=tests/fuzz/dictionaries/$target.dict
    if [ -e "$dictionary" ]; then options+=(-dict="$dictionary"); fi
    log=build/fuzz/findings/$target.log
    status=0
    nice "$bin/fuzz_$target" "${options[@]}" "$corpus" "$seeds" >"$log" 2>&1 &
    process=$!
    wait $process || status=$?
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    took=$(sed -n 's/^Done .* in \([0-9]*\) second.*/\1/p' "$log")
    peak=$(sed -n 's/^stat::peak_rss_mb: *//p' "$log")
    echo "$target: ${runs:-?} inputs in ${took:-?} s, at most ${peak:-?} MB, $([ $status -eq 0 ] && echo clean || echo "FAILED ($log)")"
    if [ $status -ne 0 ]; then
        failed+=("$target")
        grep -m 5 -E "finding:|ERROR|SUMMARY|runtime error|Test unit written" "$log" || tail -n 5 "$log"
    fi
    rm -rf "$seeds" "$fresh"
    # What a finding left; that of another run beside this one stays.
    rm -rf "/dev/shm/vestige-fuzz-$target-$process"
done
[ ${#failed[@]} -eq 0 ]
