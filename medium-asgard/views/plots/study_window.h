// Speed against accuracy on this scene: a chart of all methods, which grows while it is measured.
//
// The study runs on a thread of its own, on the scene as it was when the window was opened; closing
// the window ends it. Beside other work the measured times are longer than alone; the errors are
// the same.
#pragma once

#include "study/study.h"

#include <QLabel>
#include <QMainWindow>
#include <QProgressBar>
#include <QPushButton>

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

namespace views {

class StudyWindow : public QMainWindow {
    Q_OBJECT
public:
    // `name` of the scene, for titles.
    StudyWindow(std::shared_ptr<const scene::Scene> scene, simulation::StudyPlan plan,
                const QString& name);
    ~StudyWindow() override; // ends the study

    [[nodiscard]] const simulation::StudyResult& result() const { return shown_; }
    [[nodiscard]] bool isMeasuring() const { return measuring_; }
    // "" or the sentence that says what went wrong. By the name's ending a chart or a table (.csv).
    [[nodiscard]] QString save(const QString& path) const;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void measure(); // on the thread
    void publish(const simulation::StudyResult& result, bool done);
    void take(); // what was published, on the thread of windows
    void draw();
    void askAndSave();
    [[nodiscard]] QString words() const;

    std::shared_ptr<const scene::Scene> scene_;
    simulation::StudyPlan plan_;
    QString name_;
    QLabel *chart_, *words_;
    QProgressBar* progress_;
    QPushButton *stop_, *save_;
    simulation::StudyResult shown_;
    bool measuring_ = true;

    std::mutex mutex_;
    simulation::StudyResult published_; // under mutex_
    bool done_ = false;                 // under mutex_
    std::atomic<bool> cancelled_{false};
    std::thread thread_;
};

} // namespace views
