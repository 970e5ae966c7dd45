// A dialog that asks for the target of a reference: one of the numbered parts of a document.
#pragma once

#include "model/model.h"

#include <QDialog>

class QLineEdit;
class QListWidget;

namespace menus {

// A part that may be referred to, as its reader knows it: "Figure 2: The pendulum", "1.2 Results".
struct Target {
    sgml::NodeId element = sgml::noNode;
    QString words;
};
[[nodiscard]] std::vector<Target> described(const std::vector<sgml::NodeId>& elements,
                                            const model::Model& model);

class ReferenceDialog : public QDialog {
    Q_OBJECT

public:
    // `isNew`: else one that is there gets another target.
    ReferenceDialog(std::vector<Target> targets, bool isNew, QWidget* parent);

    [[nodiscard]] sgml::NodeId chosen() const; // noNode: none

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void filter(const QString& words);

    std::vector<Target> targets_;
    QLineEdit* field_;
    QListWidget* list_;
};

} // namespace menus
