// A medium's question about one of its commands: fields with values to type anew, and, where they
// cannot be, why and what can be done instead. It stays open until the medium takes the answer.
#pragma once

#include "media/live_subdocument.h"

#include <QDialog>
#include <QPointer>

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

private:
    void show(const ipc::Question& question);
    void send(const ipc::MenuInvoke& call);

    QPointer<media::LiveSubdocument> live_;
    ipc::MenuInvoke call_;
    QLabel* note_;
    QFormLayout* form_;
    std::vector<QLineEdit*> fields_;
    QLabel* refusal_;
    QVBoxLayout* ways_;
    QDialogButtonBox* buttons_;
    bool waits_ = false; // for an answer
};

} // namespace menus
