#!/usr/bin/env bash
# 100,000 random sequences of edits, undo and redo over several viewers, and a million interleaved edits in six, against
# a model (medium-asgard/views/random_undo_test.cpp); ./test runs a hundredth.
#
#     tests/edits/undo_at_length.sh build/release/bin/views_test [SEED]
set -eu
export QT_QPA_PLATFORM=offscreen LC_NUMERIC=C
export ASGARD_UNDO_SEQUENCES=100000 ASGARD_INTERLEAVED_EDITS=1000000 ASGARD_SEED=${2:-1}
time "$1" --gtest_filter='RandomUndoTest.*'
