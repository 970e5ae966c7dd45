// A dialog that asks for the target of a reference, one of the numbered parts of a document, and
// whether the reference shows the number with its kind or alone.
#pragma once

#include "model/model.h"

#include <QDialog>

class QLineEdit;
class QListWidget;
class QRadioButton;

namespace menus {

// A part that may be referred to, as its reader knows it: "Figure 2: The pendulum", "1.2 Results".
struct Target {
    sgml::NodeId element = sgml::noNode;
    QString words;
    bool isNumbered = false;
    // Of a numbered one: "Figure", before its number in a reference; "": that has always one form.
    QString kind{};
    bool isNumberFitting = false; // where the reference stands: the kind is written there
};
[[nodiscard]] std::vector<Target> described(const std::vector<sgml::NodeId>& elements,
                                            const model::Model& model);

class ReferenceDialog : public QDialog {
    Q_OBJECT

public:
    // `isByNumber`: that of a reference that is there and gets another target; nothing: a new one.
    ReferenceDialog(std::vector<Target> targets, std::optional<bool> isByNumber, QWidget* parent);

    [[nodiscard]] sgml::NodeId chosen() const; // noNode: none
    [[nodiscard]] bool isByNumber() const;     // the reference shows the number alone

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void filter(const QString& words);
    void offerKinds();
    [[nodiscard]] const Target* target() const; // null: none is chosen

    std::vector<Target> targets_;
    QLineEdit* field_;
    QListWidget* list_;
    QRadioButton *byKind_, *byNumber_;
    bool isChosen_ = false; // by somebody, of the two
};

} // namespace menus
