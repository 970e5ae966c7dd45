#include "shared_scenes.h"

#include "equations.h"
#include "gas.h"

#include <cstdarg>
#include <cstdio>

namespace bench {
namespace {

__attribute__((format(printf, 1, 2))) std::string text(const char* format, ...) {
    char buffer[2000];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(buffer, sizeof buffer, format, arguments);
    va_end(arguments);
    return buffer;
}

} // namespace

std::string s1Scene() {
    return text("simulator -finish %g -collisions 0\n"
                "shape_set block -desc {-sub {-box {1 1 1}}}\n"
                "body b block -mass 1 -inertia {1 2 3} -init_drot {0.01 1 0}\n",
                s1Span);
}

std::string s2aScene() {
    const double damping = 2 * std::sqrt(rods::tightness * rods::mass);
    return text("simulator -finish %g -collisions 0\n"
                "shape_set rod -desc {-sub {-box {10 1.1 1.1}}}\n"
                "body r1 rod -mass 10 -init_pos {-5 0 0}\n"
                "body r2 rod -mass 10 -init_pos {-15 0 0}\n"
                "force -body r1 -gravitational {0 -10 0}\n"
                "force -body r2 -gravitational {0 -10 0}\n"
                "link -body1 r1 -offset1 {5 0 0} -x 0 -y 0 -z 0 -tightness 5000 -damping %.17g\n"
                "link -body1 r1 -offset1 {-5 0 0} -body2 r2 -offset2 {5 0 0} -tightness 5000 "
                "-damping %.17g\n",
                s2Span, damping, damping);
}

std::string s2bScene() {
    using namespace rods;
    const double m22 = inertia + mass * half * half, m11 = m22 + 4 * mass * half * half;
    const double b = 2 * mass * half * half, g1 = 3 * mass * half * gravity,
                 g2 = mass * half * gravity;
    const std::string cosine = text("%.17g*cos(a.x-a.y)", b), sine = text("%.17g*sin(a.x-a.y)", b);
    const std::string r1 = text("(-%s*a.dy^2-%.17g*cos(a.x))", sine.c_str(), g1);
    const std::string r2 = text("(%s*a.dx^2-%.17g*cos(a.y))", sine.c_str(), g2);
    const std::string determinant = text("(%.17g-(%s)^2)", m11 * m22, cosine.c_str());
    return text("simulator -finish %g -collisions 0\n"
                "shape_set ball -desc {-sub {-sphere 0.1}}\n"
                "body a ball -mass 1 -init_pos {%.17g %.17g 0}\n",
                s2Span, pi<double>, pi<double>) +
           text("force -body a -x {(%.17g*%s-%s*%s)/%s}", m22, r1.c_str(), cosine.c_str(),
                r2.c_str(), determinant.c_str()) +
           text(" -y {(%.17g*%s-%s*%s)/%s} -z 0\n", m11, r2.c_str(), cosine.c_str(), r1.c_str(),
                determinant.c_str());
}

std::string s3Scene(int count, double ratio) {
    std::string scene = text("simulator -finish %g -collisions 0\n"
                             "shape_set ball -desc {-sub {-sphere 0.1}}\n",
                             s3Span);
    for (int p = 0; p < count; ++p)
        scene += text("body b%d ball -mass 1 -init_pos {%.17g 0 0}\n"
                      "force -body b%d -x {-%.17g*sin(b%d.x)} -y 0 -z 0\n",
                      p, amplitudeOf(p, count), p, gravityOf(p, ratio), p);
    return scene;
}

std::string s4Scene(int perEdge) {
    std::string scene = text("simulator -finish %g\n"
                             "shape_set ball -desc {-sub {-sphere %g}}\n"
                             "shape_set sides -desc {-sub {-box {1 4 4}}}\n"
                             "shape_set floors -desc {-sub {-box {4 1 4}}}\n"
                             "shape_set ends -desc {-sub {-box {4 4 1}}}\n"
                             "body left sides -fixed 1 -init_pos {-1.5 0 0}\n"
                             "body right sides -fixed 1 -init_pos {1.5 0 0}\n"
                             "body bottom floors -fixed 1 -init_pos {0 -1.5 0}\n"
                             "body top floors -fixed 1 -init_pos {0 1.5 0}\n"
                             "body back ends -fixed 1 -init_pos {0 0 -1.5}\n"
                             "body front ends -fixed 1 -init_pos {0 0 1.5}\n",
                             s4Span, gasRadius);
    int i = 0;
    for (const GasStart& ball : gasOf(perEdge))
        scene += text("body b%d ball -mass 1 -init_pos {%.17g %.17g %.17g} "
                      "-init_dpos {%.17g %.17g %.17g}\n",
                      i++, ball.position[0], ball.position[1], ball.position[2], ball.velocity[0],
                      ball.velocity[1], ball.velocity[2]);
    return scene;
}

std::string s5Scene(int n) {
    return text("simulator -finish 10\n"
                "shape_set wall -desc {-sub {-box {1 2 2}}}\n"
                "shape_set ball -desc {-sub {-sphere 0.1}}\n"
                "body wall wall -fixed 1 -init_pos {-0.5 0 0}\n"
                "body light ball -mass 1 -init_pos {1.1 0 0}\n"
                "body heavy ball -mass %.17g -init_pos {2.3 0 0} -init_dpos {-1 0 0}\n",
                std::pow(100.0, n));
}

std::string s6Scene(double tightness) {
    return text("simulator -finish %g -collisions 0\n"
                "shape_set ball -desc {-sub {-sphere 0.1}}\n"
                "body b ball -mass 1 -init_pos {1 0 0}\n"
                "link -body1 b -x 0 -y 0 -z 0 -tightness %.17g\n",
                s6Span, tightness);
}

} // namespace bench
