// Asks what a new plot charts: an expression, which is refused with the reason while it is wrong.
#pragma once

#include "scene/scene.h"

#include <QDialog>

class QLabel;
class QLineEdit;

namespace views {

// Why that is no expression of the scene to chart; "": it is one.
[[nodiscard]] QString faultOfPlotted(const scene::Scene& scene, const QString& expression);

class PlotDialog : public QDialog {
    Q_OBJECT
public:
    PlotDialog(std::shared_ptr<const scene::Scene> scene, QWidget* parent);

    [[nodiscard]] QString expression() const;
    void accept() override; // only what can be charted

private:
    void check();

    std::shared_ptr<const scene::Scene> scene_;
    QLineEdit* field_;
    QLabel* fault_;
};

} // namespace views
