#include "source/find_line.h"

#include "plain/plain.h"
#include "source/edit_frame.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>

namespace source {

FindLine::FindLine(QPlainTextEdit& text, QWidget* parent)
    : QWidget(parent), text_(text), field_(new QLineEdit(this)), says_(plain::label({}, this)) {
    setObjectName("findLine");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 2, 4, 2);
    field_->setObjectName("findInText");
    field_->setAccessibleName(tr("Find"));
    field_->setPlaceholderText(tr("Find"));
    field_->setClearButtonEnabled(true);
    row->addWidget(field_, 1);
    row->addWidget(says_);
    connect(field_, &QLineEdit::textChanged, this, &FindLine::look);
    hide();
}

FindLine* FindLine::of(const QWidget* widget) {
    for (const QWidget* at = widget; at; at = at->parentWidget())
        if (const auto* frame = qobject_cast<const EditFrame*>(at))
            return frame->findChild<FindLine*>();
    return nullptr;
}

void FindLine::open() {
    show();
    field_->setFocus();
    field_->selectAll();
}

QString FindLine::says() const { return says_->text(); }

// From where the found words begin, while one types.
void FindLine::look() {
    const QTextCursor now = text_.textCursor();
    tell(find(std::min(now.anchor(), now.position()), 1));
}

void FindLine::next(int step) {
    if (isHidden())
        return open();
    const QTextCursor now = text_.textCursor();
    tell(find(step < 0 ? now.selectionStart() : now.selectionEnd(), step));
}

bool FindLine::find(int from, int step) {
    const QTextDocument& all = *text_.document();
    const auto flags = step < 0 ? QTextDocument::FindBackward : QTextDocument::FindFlags();
    QTextCursor found = all.find(field_->text(), from, flags);
    if (found.isNull())
        found = all.find(field_->text(), step < 0 ? all.characterCount() - 1 : 0, flags);
    if (!found.isNull())
        text_.setTextCursor(found);
    return !found.isNull();
}

void FindLine::tell(bool isFound) {
    says_->setText(isFound || field_->text().isEmpty() ? QString() : tr("Not found"));
}

void FindLine::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        next(event->modifiers() & Qt::ShiftModifier ? -1 : 1);
    } else if (event->key() == Qt::Key_Escape) {
        hide();
        text_.setFocus();
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace source
