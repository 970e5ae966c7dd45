// What a chart contains, read from its SVG and the first bytes of the others.
#include "charts/marks.h"
#include "charts/work_precision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace {

charts::WorkPrecision example() {
    return {
        .title = "Methods on a swing",
        .subtitle = "ten seconds",
        .series = {{.name = "dop853",
                    .points = {{.seconds = 1e-3, .error = 1e-3, .failure = ""},
                               {.seconds = 2e-3, .error = 1e-6, .failure = "", .chosen = true}}},
                   {.name = "forward-euler",
                    .points = {{.seconds = 1e-2, .error = {}, .failure = "unstable"},
                               {.seconds = 1e-1, .error = 0.5, .failure = "drift"}}}}};
}

std::string written(const charts::WorkPrecision& chart, const std::string& name) {
    const std::string file = (std::filesystem::path(testing::TempDir()) / name).string();
    EXPECT_EQ(charts::draw(chart, file), "");
    std::ostringstream content;
    content << std::ifstream(file, std::ios::binary).rdbuf();
    return content.str();
}

} // namespace

TEST(WorkPrecision, IsWrittenInTheFormatThatItsNameSays) {
    EXPECT_EQ(written(example(), "chart.pdf").substr(0, 4), "%PDF");
    EXPECT_EQ(written(example(), "chart.png").substr(1, 3), "PNG");
    EXPECT_NE(written(example(), "chart.svg").find("<svg"), std::string::npos);
}

// Each point has a marker, and the chosen one a ring: the drawing grows by them.
TEST(WorkPrecision, ShowsEveryPointAndTheChosenOne) {
    const auto paths = [](const charts::WorkPrecision& chart) {
        const std::string svg = written(chart, "count.svg");
        std::size_t count = 0;
        for (std::size_t at = svg.find("<path"); at != std::string::npos;
             at = svg.find("<path", at + 1))
            ++count;
        return count;
    };
    charts::WorkPrecision chart = example();
    const std::size_t with = paths(chart);
    chart.series[0].points[1].chosen = false;
    EXPECT_GE(with,
              paths(chart) + 2); // its ring and the legend's; glyphs of the words are paths too
    charts::WorkPrecision fewer = chart;
    fewer.series[0].points.pop_back();
    EXPECT_LT(paths(fewer), paths(chart));
}

TEST(WorkPrecision, RefusesOtherFormatsAndPlacesThatCannotBeWritten) {
    EXPECT_NE(charts::draw(example(), "chart.bmp"), "");
    EXPECT_NE(charts::draw(example(), "/nowhere/chart.svg"), "");
    EXPECT_NE(charts::draw(example(), "/nowhere/chart.png"), "");
}

// Sixteen methods: no two have a colour in common.
TEST(Marks, StayApart) {
    for (std::size_t a = 0; a < 16; ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const charts::Color x = charts::colorOf(a), y = charts::colorOf(b);
            const double apart =
                std::abs(x.red - y.red) + std::abs(x.green - y.green) + std::abs(x.blue - y.blue);
            EXPECT_GT(apart, 0.2) << a << " and " << b;
        }
}
