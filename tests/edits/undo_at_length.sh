#!/usr/bin/env bash
# 100,000 random sequences of edits, undo and redo in six windows, and a million interleaved edits, against a model
# (medium-asgard/views/viewers/random_undo_test.cpp); ./test runs a hundredth. In pieces, each with a seed of its own, so that
# several can run beside each other and what has ended counts: a line for each, and failures in full.
#
#     tests/edits/undo_at_length.sh build/release/bin/viewers_test [SEED [PIECES]]
#
# PIECES: of twenty, from that seed on; all of them otherwise. About twenty processor seconds each.
set -u
program=$1 first=${2:-1} pieces=${3:-20}
export QT_QPA_PLATFORM=offscreen LC_NUMERIC=C
export ASGARD_UNDO_SEQUENCES=5000 ASGARD_INTERLEAVED_EDITS=50000
failed=0
TIMEFORMAT='%U s user, %S s system'
for ((seed = first; seed < first + pieces; ++seed)); do
    log=$(mktemp)
    { time ASGARD_SEED=$seed "$program" --gtest_filter='RandomUndoTest.*' >"$log" 2>&1; status=$?; } 2>"$log.time"
    if [ $status -eq 0 ] && grep -q 'PASSED  ] 2 tests' "$log"; then
        echo "seed $seed: $ASGARD_UNDO_SEQUENCES sequences, $ASGARD_INTERLEAVED_EDITS edits, as the model has them; $(tail -1 "$log.time")"
    else
        echo "seed $seed: FAILED"
        cat "$log"
        failed=1
    fi
    rm -f "$log" "$log.time"
done
exit $failed
