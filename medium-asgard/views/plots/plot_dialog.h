// Asks what a new plot shows: one of the scene's quantities, or an expression, which is refused
// with the reason while it is wrong.
#pragma once

#include "editing/element.h"
#include "workbench/scene_document.h"

#include <QDialog>

#include <optional>

class QLabel;
class QLineEdit;
class QTreeWidget;

namespace views {

// Why that is no expression of the scene to chart; "": it is one.
[[nodiscard]] QString faultOfPlotted(const scene::Scene& scene, const QString& expression);

class PlotDialog : public QDialog {
    Q_OBJECT
public:
    // `about`: what is selected; of that a quantity is proposed (commands/proposal.h).
    PlotDialog(const Shown& shown, QWidget* parent,
               const std::optional<editing::Element>& about = std::nullopt);

    [[nodiscard]] QString expression() const;
    [[nodiscard]] QString name() const; // of its curve; "": the expression tells it
    void accept() override;             // only what can be charted

protected:
    void showEvent(QShowEvent* event) override;

private:
    QTreeWidget* makeList(const simulation::Motion* motion,
                          const std::optional<editing::Element>& about);

    std::shared_ptr<const scene::Scene> scene_;
    QTreeWidget* list_ = nullptr;
    QLineEdit* field_;
    QLabel* fault_;
};

} // namespace views
