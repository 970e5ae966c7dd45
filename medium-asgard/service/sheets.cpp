#include "service/sheets.h"

#include "charts/text_page.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace service {
namespace {

constexpr double widest = 480, narrowest = 120, chartHeight = 200; // 1/96 inch
constexpr double tallest = 16'384;                                 // that the protocol allows
constexpr std::size_t mostPlots = 20;                              // drawn; what is left is counted

// Does it show values of the scene's plots?
bool hasPlots(Presentation presentation, const scene::Scene& scene) {
    return presentation == Presentation::chart ||
           (presentation == Presentation::picture &&
            std::ranges::any_of(scene.plots, &scene::Plot::beside));
}

} // namespace

ipc::Presentations presentations() {
    return {{{"picture", "Picture"}, {"chart", "Charts of its plots"}, {"text", "Its text"}}};
}

std::optional<Presentation> presentationNamed(const std::string& id) {
    if (id.empty() || id == "picture")
        return Presentation::picture;
    if (id == "text")
        return Presentation::text;
    if (id == "chart")
        return Presentation::chart;
    return std::nullopt;
}

Sheets::Sheets(const Subdocument& of)
    : of_(of), sampler_(
                   [this](const charts::PlotSampler::Wish& wish, std::vector<charts::Plot> plots) {
                       {
                           const std::lock_guard lock(mutex_);
                           came_ = {{wish.scene, std::move(plots)}, wish.number};
                       }
                       of_.wake();
                   },
                   meters::most) {}

ipc::PreferredSize Sheets::preferredSize(Presentation presentation, double availableWidth,
                                         std::optional<double> availableHeight) const {
    const double width = std::clamp(availableWidth, narrowest, widest);
    double height = 0;
    if (presentation == Presentation::text) {
        height = charts::TextPage(of_.shownText(), {}, width).height();
    } else {
        const std::size_t count = of_.scene() ? of_.scene()->plots.size() : 1;
        height = chartHeight * static_cast<double>(std::clamp<std::size_t>(count, 1, mostPlots));
    }
    if (availableHeight)
        height = std::min(height, std::max(*availableHeight, narrowest));
    return {width, std::min(std::ceil(height), tallest)};
}

SheetLook Sheets::lookOf(Presentation presentation, double time, std::size_t row) const {
    if (presentation == Presentation::text)
        return {of_.textGeneration(), 0, row};
    if (!of_.scene() || !hasPlots(presentation, *of_.scene()))
        return {0, time, 0};
    return {shown_.generation.value_or(0), time, 0};
}

void Sheets::draw(Presentation presentation, const SheetLook& look, double scale,
                  const render::Image& into) const {
    const double width = into.size.width / scale, height = into.size.height / scale;
    charts::Canvas canvas(width, height, scale);
    if (presentation == Presentation::text)
        drawText(canvas, width, height, look.row);
    else
        drawCharts(canvas, width, height, look.time);
    const charts::Pixels pixels = canvas.pixels();
    const auto rows = static_cast<std::size_t>(std::min(pixels.height, into.size.height));
    const auto columns = static_cast<std::size_t>(std::min(pixels.width, into.size.width));
    for (std::size_t y = 0; y < rows; ++y)
        std::memcpy(into.pixels.data() + y * into.stride,
                    pixels.colors.data() + y * static_cast<std::size_t>(pixels.width), 4 * columns);
}

// --- the text ----------------------------------------------------------------------------------

std::set<std::size_t> Sheets::faultyLines() const {
    std::set<std::size_t> lines;
    for (const scene::Diagnostic& fault : of_.faults())
        if (fault.line > 0)
            lines.insert(static_cast<std::size_t>(fault.line));
    return lines;
}

void Sheets::drawText(charts::Canvas& canvas, double width, double height, std::size_t row) const {
    charts::TextPage(of_.shownText(), faultyLines(), width).draw(canvas, height, row);
}

std::size_t Sheets::scrolled(std::size_t row, double rows, render::Size size, double scale) const {
    const charts::TextPage page(of_.shownText(), {}, size.width / scale);
    const double wanted = std::max(0.0, static_cast<double>(row) + rows);
    return page.top(static_cast<std::size_t>(wanted), size.height / scale);
}

// --- the charts --------------------------------------------------------------------------------

charts::PlotArea Sheets::areaOf(std::size_t plot, std::size_t count, double width,
                                double height) const {
    const double each = height / static_cast<double>(count);
    const Span& span = of_.playback.span();
    return {0, each * static_cast<double>(plot), width, each, span.start, span.finish};
}

void Sheets::collect() {
    if (of_.scene() && asked_ != of_.generation()) {
        asked_ = of_.generation();
        sampler_.sample({of_.scene(), of_.motion(), of_.generation()});
    }
    const std::lock_guard lock(mutex_);
    if (came_)
        shown_ = *std::exchange(came_, std::nullopt);
}

bool Sheets::upToDate(Presentation presentation) {
    if (!of_.scene() || !hasPlots(presentation, *of_.scene()))
        return true;
    collect();
    return shown_.generation == of_.generation();
}

bool Sheets::drawable(Presentation presentation) {
    return upToDate(presentation) || presentation != Presentation::chart || shown_.generation;
}

void Sheets::drawCharts(charts::Canvas& canvas, double width, double height, double time) const {
    if (!shown_.generation)
        return;
    const std::vector<charts::Plot>& plots = shown_.of.plots;
    if (plots.empty()) {
        canvas.ink({}, 0.7);
        canvas.text(width / 2, height / 2, "This scene has no plots.", 12,
                    charts::Canvas::Anchor::middle);
        return;
    }
    const std::size_t drawn = std::min(plots.size(), mostPlots);
    for (std::size_t i = 0; i < drawn; ++i)
        charts::draw(canvas, plots[i], areaOf(i, drawn, width, height), time);
    if (const std::size_t total = shown_.of.scene->plots.size(); total > drawn) {
        canvas.ink({}, 0.7);
        canvas.text(width - 4, height - 4, std::to_string(total - drawn) + " more plots", 11,
                    charts::Canvas::Anchor::end);
    }
}

double Sheets::timeAt(double x, render::Size size, double scale) const {
    return charts::insideOf(areaOf(0, 1, size.width / scale, size.height / scale))
        .timeAt(x / scale);
}

} // namespace service
