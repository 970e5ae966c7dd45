// The plots of a scene, each a chart of its quantities against time, in step with the motion.
//
// Values are read from the motion on a thread: an expression of a large scene takes its time.
#pragma once

#include "views/plot_chart.h"
#include "views/scene_document.h"

#include <QMainWindow>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

class QLabel;
class QVBoxLayout;

namespace views {

class PlotsWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit PlotsWindow(SceneDocument& document);
    ~PlotsWindow() override;

    [[nodiscard]] const std::vector<PlotChart*>& charts() const { return charts_; }

private:
    void ask();        // for what is shown now
    void makeCharts(); // of its plots, still without values
    void run();        // on the thread
    // The samples are of no use any more.
    [[nodiscard]] bool isOvertaken() const { return overtaken_; }
    void take(const Shown& of, std::vector<charts::Plot> plots);

    SceneDocument& document_;
    QVBoxLayout* column_;
    QLabel* none_;
    std::vector<PlotChart*> charts_;

    std::mutex mutex_;
    std::condition_variable asked_;
    std::optional<Shown> wish_;                   // under mutex_
    bool stop_ = false;                           // under mutex_
    std::shared_ptr<const scene::Scene> sampled_; // under mutex_: what the thread works on
    std::atomic<bool> overtaken_{false};
    std::thread thread_;
};

} // namespace views
