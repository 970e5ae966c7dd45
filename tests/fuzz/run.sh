#!/usr/bin/env bash
# run.sh build: builds the targets by the preset `fuzz`.
# run.sh TARGET [OPTION...]: gives one of them bytes for FUZZ_SECONDS (60; 0: the seeds alone), beginning at FUZZ_SEED (1).
# Options are libFuzzer's.
# Without clang++ that has libFuzzer both say so and exit with 77.
set -eu
cd "$(dirname "$0")/../.."

if ! echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' |
    clang++ -x c++ -fsanitize=fuzzer,address -o /dev/null - 2>/dev/null; then
    echo "Not fuzzed: there is no clang++ with libFuzzer (packages clang and libclang-rt-14-dev)."
    exit 77
fi

if [ "$1" = build ]; then
    cmake --preset fuzz >/dev/null
    exec cmake --build --preset fuzz
fi

target=$1
shift
program=build/fuzz/bin/fuzz_$target
corpus=build/fuzz/corpus/$target # grows from run to run; the seeds are only read
found=build/fuzz/found/$target-
mkdir -p "$corpus" build/fuzz/found
limit=(-max_total_time="${FUZZ_SECONDS:-60}")
[ "${FUZZ_SECONDS:-60}" != 0 ] || limit=(-runs=0)
status=0
"$program" "${limit[@]}" -seed="${FUZZ_SEED:-1}" -max_len=4096 -timeout=20 -rss_limit_mb=2048 \
    -dict="tests/fuzz/$target.dict" -artifact_prefix="$found" -print_final_stats=1 \
    "$@" "$corpus" "tests/fuzz/seeds/$target" 2>build/fuzz/"$target.log" || status=$?
if [ $status -ne 0 ]; then
    tail -n 60 build/fuzz/"$target.log"
    echo "The bytes lie in $found*; once more: $program FILE"
    exit 1
fi
grep -aE '^stat::(number_of_executed_units|average_exec_per_sec|peak_rss_mb)' build/fuzz/"$target.log"
