// A medium's question about one of its commands: fields with values to type anew, and, where they
// cannot be, why and what can be done instead. It stays open until the medium takes the answer.
// A medium that tries values says while they are typed which lines of its text they would change.
#pragma once

#include "media/live_subdocument.h"

#include <QDialog>
#include <QPointer>

#include <optional>
#include <vector>

class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace menus {

class QuestionDialog : public QDialog {
    Q_OBJECT

public:
    // `call`: the command that was answered with the question.
    QuestionDialog(media::LiveSubdocument& live, ipc::MenuInvoke call,
                   const ipc::Question& question, QWidget* parent);

    void accept() override; // the values go to the medium

    // "Lines 3, 7 and 9 of its text:"; "" of none.
    [[nodiscard]] static QString whichLines(const std::vector<ipc::ChangedLine>& changes);

private:
    void show(const ipc::Question& question);
    void send(const ipc::MenuInvoke& call);
    [[nodiscard]] ipc::MenuInvoke typed() const;
    void tryTyped();

    QPointer<media::LiveSubdocument> live_;
    ipc::MenuInvoke call_;
    QLabel* note_;
    QFormLayout* form_;
    std::vector<QLineEdit*> fields_;
    QLabel* refusal_;
    QLabel* changes_;
    QVBoxLayout* ways_;
    QDialogButtonBox* buttons_;
    bool tries_ = false;                  // the medium does
    bool waits_ = false;                  // for an answer
    std::optional<ipc::MenuInvoke> next_; // to be sent when that is there
};

} // namespace menus
