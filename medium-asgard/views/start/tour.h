// A tour that builds a pendulum of two rods, as the one of the dissertation (Figure 4.6), in five
// steps: it tells the next one and sees in the scene when it was done.
#pragma once

#include "workbench/scene_document.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace views {

class Tour : public QWidget {
    Q_OBJECT
public:
    static constexpr int steps = 5;

    explicit Tour(SceneDocument& document, QWidget* parent = nullptr);

    // The steps that are done, from the first one on; `steps`: all.
    [[nodiscard]] int done() const { return done_; }
    void played(); // the motion was seen

Q_SIGNALS:
    void built(); // all but the last step is done, the motion known, and the tour shown
    void ended(); // by the reader, or another scene was opened

protected:
    void showEvent(QShowEvent* event) override;

private:
    void look();
    void showSteps();

    SceneDocument& document_;
    QList<QLabel*> lines_;
    QLabel* what_ = nullptr;
    QPushButton* end_ = nullptr;
    bool played_ = false, isBuilt_ = false;
    int done_ = 0;
};

// The fault of a step that was done otherwise, and its way out; "": there is none.
[[nodiscard]] QString whyNotDone(const scene::Scene& scene);
// The steps that a scene has done, without the one that plays it.
[[nodiscard]] int stepsDone(const scene::Scene& scene);

} // namespace views
