#include "menus/question_dialog.h"

#include "plain/plain.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace menus {

namespace {

constexpr int leastWidth = 340; // of the sentences, which fold

QLabel* sentence(const QString& name) {
    QLabel* label = plain::label({});
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setMinimumWidth(leastWidth);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

void setWords(QLabel& label, const std::string& words) {
    label.setText(QString::fromStdString(words));
    label.setVisible(!words.empty());
}

} // namespace

QuestionDialog::QuestionDialog(media::LiveSubdocument& live, ipc::MenuInvoke call,
                               const ipc::Question& question, QWidget* parent)
    : QDialog(parent), live_(&live), call_(std::move(call)), note_(sentence("questionNote")),
      form_(new QFormLayout), refusal_(sentence("questionRefusal")), ways_(new QVBoxLayout),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setObjectName("questionDialog");
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    column->addLayout(form_);
    column->addWidget(note_);
    column->addWidget(refusal_);
    column->addLayout(ways_);
    column->addWidget(buttons_);
    column->setSizeConstraint(QLayout::SetFixedSize);
    connect(buttons_, &QDialogButtonBox::accepted, this, &QuestionDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QuestionDialog::reject);
    connect(&live, &media::LiveSubdocument::processGone, this, &QuestionDialog::reject);
    connect(&live, &QObject::destroyed, this, &QuestionDialog::reject);
    show(question);
}

// Typed words stay in the fields, unless the next question has others.
void QuestionDialog::show(const ipc::Question& question) {
    setWindowTitle(plain::title(QString::fromStdString(question.title)));
    setWords(*note_, question.note);
    if (fields_.size() != question.fields.size()) {
        while (form_->rowCount() > 0)
            form_->removeRow(0);
        fields_.clear();
        for (const ipc::AskedField& one : question.fields) {
            const QString label = QString::fromStdString(one.label);
            auto* field = new QLineEdit(QString::fromStdString(one.value));
            field->setObjectName(QStringLiteral("answer%1").arg(fields_.size() + 1));
            field->setAccessibleName(label);
            form_->addRow(plain::label(label), field);
            fields_.push_back(field);
        }
        if (!fields_.empty()) {
            fields_.front()->setFocus();
            fields_.front()->selectAll();
        }
    }
    setWords(*refusal_, question.refusal);
    while (QLayoutItem* item = ways_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const ipc::Way& one : question.ways) {
        auto* button = new QPushButton(plain::caption(QString::fromStdString(one.label)));
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this, [this, id = one.id] {
            ipc::MenuInvoke way = call_;
            way.id = id;
            send(way);
        });
        ways_->addWidget(button);
    }
}

void QuestionDialog::accept() {
    if (fields_.empty()) // there is nothing to send
        return reject();
    ipc::MenuInvoke call = call_;
    for (const QLineEdit* field : fields_)
        call.values.push_back(field->text().toStdString());
    send(call);
}

void QuestionDialog::send(const ipc::MenuInvoke& call) {
    if (!live_ || waits_)
        return;
    waits_ = true;
    live_->answer(call, [self = QPointer(this)](const media::Outcome<ipc::Invoked>& outcome) {
        if (!self)
            return;
        self->waits_ = false;
        if (const auto* error = std::get_if<ipc::Error>(&outcome))
            setWords(*self->refusal_, error->message);
        else if (const auto& next = std::get<ipc::Invoked>(outcome).question)
            self->show(*next);
        else
            self->done(QDialog::Accepted);
    });
}

} // namespace menus
