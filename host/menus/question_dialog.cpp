#include "menus/question_dialog.h"

#include "plain/plain.h"
#include "text/difference.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

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

QString marked(const std::string& line, const std::string& other) {
    const text::Edit edit = text::difference(other, line);
    const auto escaped = [](const std::string& s) {
        return QString::fromStdString(s).toHtmlEscaped();
    };
    const std::size_t from = edit.range.from, length = edit.text.size();
    return escaped(line.substr(0, from)) + "<b>" + escaped(line.substr(from, length)) + "</b>" +
           escaped(line.substr(from + length));
}

// Each line as it is and as it would be; a line that is new alone.
QString worded(const std::vector<ipc::ChangedLine>& changes) {
    QString shown;
    for (const ipc::ChangedLine& one : changes) {
        if (!one.before.empty())
            shown += QStringLiteral("<div><code><s>%1</s></code></div>")
                         .arg(marked(one.before, one.after));
        shown += QStringLiteral("<div><code>%1</code></div>").arg(marked(one.after, one.before));
    }
    return shown.isEmpty() ? shown : QuestionDialog::whichLines(changes) + shown;
}

} // namespace

QuestionDialog::QuestionDialog(media::LiveSubdocument& live, ipc::MenuInvoke call,
                               const ipc::Question& question, QWidget* parent)
    : QDialog(parent), live_(&live), call_(std::move(call)), note_(sentence("questionNote")),
      form_(new QFormLayout), refusal_(sentence("questionRefusal")), changes_(plain::markupLabel()),
      ways_(new QVBoxLayout),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setObjectName("questionDialog");
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    column->addLayout(form_);
    column->addWidget(note_);
    column->addWidget(refusal_);
    changes_->setObjectName("questionChanges");
    changes_->setWordWrap(true);
    changes_->setMinimumWidth(leastWidth);
    column->addWidget(changes_);
    column->addLayout(ways_);
    column->addWidget(buttons_);
    column->setSizeConstraint(QLayout::SetFixedSize);
    connect(buttons_, &QDialogButtonBox::accepted, this, &QuestionDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QuestionDialog::reject);
    connect(&live, &media::LiveSubdocument::processGone, this, &QuestionDialog::reject);
    connect(&live, &QObject::destroyed, this, &QuestionDialog::reject);
    show(question);
}

QString QuestionDialog::whichLines(const std::vector<ipc::ChangedLine>& changes) {
    QStringList lines;
    for (const ipc::ChangedLine& one : changes)
        if (const QString line = QString::number(one.line); !lines.contains(line))
            lines << line;
    if (lines.isEmpty())
        return {};
    const QString last = lines.takeLast();
    return lines.isEmpty() ? tr("Line %1 of its text:").arg(last)
                           : tr("Lines %1 and %2 of its text:").arg(lines.join(", "), last);
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
            connect(field, &QLineEdit::textEdited, this, &QuestionDialog::tryTyped);
            form_->addRow(plain::label(label), field);
            fields_.push_back(field);
        }
        if (!fields_.empty()) {
            fields_.front()->setFocus();
            fields_.front()->selectAll();
        }
    }
    setWords(*refusal_, question.refusal);
    tries_ = question.tries;
    changes_->setText(worded(question.changes));
    changes_->setVisible(!question.changes.empty());
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

ipc::MenuInvoke QuestionDialog::typed() const {
    ipc::MenuInvoke call = call_;
    for (const QLineEdit* field : fields_)
        call.values.push_back(field->text().toStdString());
    return call;
}

void QuestionDialog::tryTyped() {
    if (!tries_)
        return;
    ipc::MenuInvoke call = typed();
    call.isTrial = true;
    send(call);
}

void QuestionDialog::accept() {
    if (fields_.empty()) // there is nothing to send
        return reject();
    send(typed());
}

// One after the other; of those that wait the last, but no trial in place of what is to be done.
void QuestionDialog::send(const ipc::MenuInvoke& call) {
    if (!live_)
        return;
    if (waits_) {
        if (!call.isTrial || !next_ || next_->isTrial)
            next_ = call;
        return;
    }
    waits_ = true;
    live_->answer(call, [self = QPointer(this)](const media::Outcome<ipc::Invoked>& outcome) {
        if (!self)
            return;
        self->waits_ = false;
        if (const auto* error = std::get_if<ipc::Error>(&outcome))
            setWords(*self->refusal_, error->message);
        else if (const auto& question = std::get<ipc::Invoked>(outcome).question)
            self->show(*question);
        else
            return self->done(QDialog::Accepted);
        if (const auto next = std::exchange(self->next_, std::nullopt))
            self->send(*next);
    });
}

} // namespace menus
