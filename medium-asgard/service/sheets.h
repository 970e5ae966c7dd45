// The presentations of a scene that are no picture of its bodies: its text, and charts of its
// plots. A picture has the values of its plots, too, where they stand beside bodies. The plots are
// sampled beside the thread that answers the host; meanwhile those of before are shown. The
// subdocument's descriptor becomes readable when they are there.
#pragma once

#include "charts/plot_sampler.h"
#include "ipc/messages.h"
#include "meters/meters.h"
#include "render/renderer.h"
#include "service/subdocument.h"

#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace service {

enum class Presentation { picture, text, chart };

// All that the medium has, as a host may ask for them.
[[nodiscard]] ipc::Presentations presentations();
// Of a name from there; "" is the first. None: there is no such presentation.
[[nodiscard]] std::optional<Presentation> presentationNamed(const std::string& id);

// What decides how a sheet looks.
struct SheetLook {
    unsigned generation = 0; // of its text; of the scene and motion whose plots it has, 0: of none
    double time = 0;         // of charts
    std::size_t row = 0;     // of texts: the first that is seen
};

class Sheets {
public:
    explicit Sheets(const Subdocument& of);

    // At scale 1. A text has room for all its lines, as far as there is room.
    [[nodiscard]] ipc::PreferredSize preferredSize(Presentation presentation, double availableWidth,
                                                   std::optional<double> availableHeight) const;
    // Of the scene and its motion as they are. False: plots are being sampled.
    [[nodiscard]] bool upToDate(Presentation presentation);
    // There is something to draw, perhaps of an older motion.
    [[nodiscard]] bool drawable(Presentation presentation);
    // Those that came last: for the values beside the bodies of a picture.
    [[nodiscard]] const meters::Sampled& sampled() const { return shown_.of; }
    // `row`: where the reader has moved the text to.
    [[nodiscard]] SheetLook lookOf(Presentation presentation, double time, std::size_t row) const;
    // `scale`: device pixels to 1/96 inch.
    void draw(Presentation presentation, const SheetLook& look, double scale,
              const render::Image& into) const;
    // The row at the top of a text after so many more; not behind the last full page.
    [[nodiscard]] std::size_t scrolled(std::size_t row, double rows, render::Size size,
                                       double scale) const;
    // The time at a point of a chart, in device pixels.
    [[nodiscard]] double timeAt(double x, render::Size size, double scale) const;

private:
    void drawText(charts::Canvas& canvas, double width, double height, std::size_t row) const;
    void drawCharts(charts::Canvas& canvas, double width, double height, double time) const;
    void collect(); // asks for plots, and takes those that came
    [[nodiscard]] charts::PlotArea areaOf(std::size_t plot, std::size_t count, double width,
                                          double height) const;
    [[nodiscard]] std::set<std::size_t> faultyLines() const;

    struct Sampled {
        meters::Sampled of;
        std::optional<unsigned> generation; // of the subdocument
    };
    const Subdocument& of_;
    std::optional<unsigned> asked_; // generation
    Sampled shown_;
    std::mutex mutex_;
    std::optional<Sampled> came_; // under mutex_
    charts::PlotSampler sampler_; // the first to go
};

} // namespace service
