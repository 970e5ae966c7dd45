// What a test measured, for the charts of docs/numerics.md: kept with the test's result, where
// charts.py reads it (--gtest_output=json:FILE).
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

inline void mark(const std::string& chart, const std::string& series, double x, double y) {
    char at[40], value[40];
    std::snprintf(at, sizeof at, "%.4g", x);
    std::snprintf(value, sizeof value, "%.4g", y);
    testing::Test::RecordProperty("mark|" + chart + "|" + series + "|" + at, value);
}
