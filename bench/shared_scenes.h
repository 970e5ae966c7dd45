// The scenes of equations.h, gas.h and plain.cpp in the scene language, for us.
#pragma once

#include <string>

namespace bench {

[[nodiscard]] std::string s1Scene();
[[nodiscard]] std::string s2aScene();
// The exact pins as angle formulas: x and y of one body are the two angles.
[[nodiscard]] std::string s2bScene();
// Each pendulum's angle is the x of a body.
[[nodiscard]] std::string s3Scene(int count, double ratio);
[[nodiscard]] std::string s4Scene(int perEdge);
[[nodiscard]] std::string s5Scene(int n);
[[nodiscard]] std::string s6Scene(double tightness);

} // namespace bench
