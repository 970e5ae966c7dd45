#!/usr/bin/env bash
# A million random keys and moves of pointer and windows in all windows of a scene, at the device scales 1, 2 and 3
# (medium-asgard/views/viewers/window_fuzz_test.cpp); ./test does 15,000. Once in 400 all windows agree with the text, undo
# leads to the first bytes and redo to the last. In pieces, each with a seed of its own, so that what has ended counts: a
# line for each, and failures in full.
#
#     tests/desktop/windows_at_length.sh build/release/bin/window_fuzz_test [SEED [PIECES]]
#
# PIECES: of a hundred, from that seed on; all of them otherwise. About 25 processor seconds each.
set -u
program=$1 first=${2:-1} pieces=${3:-100}
export QT_QPA_PLATFORM=offscreen LC_NUMERIC=C ASGARD_WINDOW_ACTIONS=10000
failed=0
for ((seed = first; seed < first + pieces; ++seed)); do
    log=$(mktemp)
    scale=$((seed % 3 + 1))
    if QT_SCALE_FACTOR=$scale ASGARD_SEED=$seed timeout 900 "$program" >"$log" 2>&1 && grep -q 'PASSED  ] 1 test' "$log"; then
        echo "seed $seed, scale $scale: $ASGARD_WINDOW_ACTIONS actions"
    else
        echo "seed $seed, scale $scale: FAILED"
        grep -v 'This plugin does not support' "$log"
        failed=1
    fi
    rm -f "$log"
done
exit $failed
