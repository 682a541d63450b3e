#!/usr/bin/env bash
# Builds the benchmarks, runs them and puts their tables into docs/benchmarks.md.
#   tests/bench/run.sh [registration] [accuracy] [basin] [profile] [filters]   all of them without an argument
#   tests/bench/run.sh loading    wants 10 GB of disk for tiled copies of a real flight (build/bench-files)
# ROUNDS (5), PAIRS (all), BUILD (build/release) in the environment. Wants a quiet machine; takes about 20 minutes.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${BUILD:-build/release}
parts=("$@")
if [ ${#parts[@]} = 0 ]; then parts=(registration accuracy basin profile filters); fi
VESTIGE_BENCH_COMMIT=$(git rev-parse --short HEAD 2>/dev/null || echo "(no commit)")
export VESTIGE_BENCH_COMMIT
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for part in "${parts[@]}"; do
    program=bench_$part
    if [ "$part" = loading ]; then
        ninja -C "$build" bench_loading >&2
        flight=${FLIGHT:-../shared/data/aerial/brighton/model.laz}
        files=build/bench-files
        mkdir -p "$files"
        for file in b10.ply b10.pcd b100.las b100.laz; do
            count=${file%%.*}e6
            [ -e "$files/$file" ] || "$build/bin/tile_cloud" "$flight" "$files/$file" "${count#b}" >&2
        done
        tests/bench/loading/loading.py "$build/bin" "$files"/b10.ply "$files"/b10.pcd "$files"/b100.las "$files"/b100.laz \
            --rounds "${ROUNDS:-3}" | tee /dev/stderr >"$work/$part.md"
        tests/bench/insert.py docs/benchmarks.md "$part" "$work/$part.md"
        continue
    fi
    if [ "$part" = profile ]; then program=bench_registration; fi
    ninja -C "$build" "$program" >&2
    case $part in
        registration)
            "$build/bin/$program" --rounds="${ROUNDS:-5}" ${PAIRS:+--pairs="$PAIRS"} --markdown="$work/$part.md" >&2
            ;;
        accuracy)
            { "$build/bin/$program"; echo; "$build/bin/$program" --points=1000000 --seeds=5; } >"$work/$part.md"
            ;;
        basin)
            "$build/bin/$program" | tee /dev/stderr | grep '^|' >"$work/$part.md"
            ;;
        filters)
            # The table and, after it, how far outliers agree.
            "$build/bin/$program" | tee /dev/stderr | sed -n '/^| work/,$p' >"$work/$part.md"
            ;;
        profile)
            # Where the time of improved NDT goes, one thread.
            : >"$work/$part.md"
            for pair in street tripod-1M; do
                perf record -q -e cpu-clock -F 1999 -o "$work/perf.data" "$build/bin/$program" --pairs="$pair" \
                    --threads=1 --only="improved NDT" --rounds=60 --markdown="$work/unused.md" >&2
                { echo; echo "\`$pair\`:"; echo; tests/bench/profile.py "$work/perf.data"; } >>"$work/$part.md"
            done
            ;;
    esac
    tests/bench/insert.py docs/benchmarks.md "$part" "$work/$part.md"
done
