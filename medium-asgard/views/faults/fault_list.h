// All faults and warnings in one list: of the text, and of its motion.
//
// A click selects the element, in every picture and beside the text, and goes to the time at which
// the fault comes; Return or a double click also opens the text there. Nothing is done while it is
// hidden.
#pragma once

#include "workbench/scene_document.h"

#include <QTreeWidget>
#include <QWidget>

#include <functional>
#include <vector>

class QLabel;

namespace views {

struct FaultListActions {
    std::function<void(double time)> seek;
    std::function<void()> showText; // where what is selected is marked
};

class FaultList : public QWidget {
    Q_OBJECT
public:
    FaultList(SceneDocument& document, FaultListActions actions, QWidget* parent = nullptr);

    [[nodiscard]] QTreeWidget& list() { return *list_; }
    [[nodiscard]] QString summary() const;

    [[nodiscard]] QSize sizeHint() const override { return {400, 120}; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void refresh();
    void fill();
    void goTo(const QTreeWidgetItem& item);

    SceneDocument& document_;
    FaultListActions actions_;
    std::vector<scene::Diagnostic> faults_;
    QLabel* summary_;
    QTreeWidget* list_;
};

} // namespace views
