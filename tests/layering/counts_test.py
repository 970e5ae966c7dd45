#!/usr/bin/env python3
"""counts.py finds data members, functions and circles in code as this project writes it."""
import unittest

from counts import bare, circles, classes, included, unit


class Classes(unittest.TestCase):
    def counted(self, text):
        return {name: counts for name, *counts in classes(bare(text))}

    def test_members_are_not_functions_types_or_constants(self):
        text = """
        class Motion final : private Turns { // int noMember_;
        public:
            explicit Motion(int n) : n_(n) {}
            [[nodiscard]] double at(double t) const { return t; }
            bool operator==(const Motion&) const = default;
            using Row = std::vector<double>;
            enum class Kind { one, two } kind_;
            static constexpr int most = 3;
        private:
            int n_, m_ = 0;
            std::function<void(double t, int n)> told_;
            std::map<int, std::vector<int>> rows_{1, 2};
            struct Inner { double a = 1, b; };
        };"""
        self.assertEqual(self.counted(text), {"Motion": [5, 3], "Motion::Inner": [2, 0]})

    def test_a_class_that_is_only_named_counts_nothing(self):
        self.assertEqual(self.counted("class Solver; struct Stop stop(int);"), {})


class Circles(unittest.TestCase):
    def test_what_reaches_itself_is_one_circle(self):
        self.assertEqual(circles({"a": {"b"}, "b": {"c"}, "c": {"a", "d"}, "d": set()}), [["a", "b", "c"]])
        self.assertEqual(circles({"a": {"b"}, "b": set()}), [])

    def test_sources_belong_to_the_header_that_they_are_named_after(self):
        headers = {"x/solver", "x/solver_flights"}
        self.assertEqual(unit("x/solver_kept.cpp", headers), "x/solver")
        self.assertEqual(unit("x/solver_flights.cpp", headers), "x/solver_flights")
        self.assertEqual(unit("x/workers.cpp", headers), "x/workers")

    def test_includes_are_found_by_the_end_of_a_path(self):
        self.assertEqual(included(["engine/solution/solver.h"])["solution/solver.h"], "engine/solution/solver.h")


if __name__ == "__main__":
    unittest.main()
