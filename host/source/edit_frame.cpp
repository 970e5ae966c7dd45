#include "source/edit_frame.h"

#include "plain/plain.h"

#include <QTextBlock>
#include <QVBoxLayout>

namespace source {

EditFrame::EditFrame(const QString& name, const QString& accessibleName, QWidget* parent)
    : QWidget(parent), edit_(new SourceEdit(this)), find_(new FindLine(*edit_, this)),
      place_(plain::label({}, this)) {
    edit_->setObjectName(name + QStringLiteral("Text"));
    edit_->setAccessibleName(accessibleName);
    place_->setObjectName(name + QStringLiteral("Place"));
    place_->setMargin(3);
    place_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(edit_, 1);
    column->addWidget(find_);
    column->addWidget(place_);
    connect(edit_, &QPlainTextEdit::cursorPositionChanged, this, &EditFrame::tell);
    tell();
}

void EditFrame::setFaults(const std::vector<LineFault>& faults) {
    edit_->setFaults(faults);
    tell();
}

void EditFrame::setNote(const QString& note) {
    note_ = note;
    tell();
}

// "Line 12, column 4; what is wrong there"
void EditFrame::tell() {
    const QTextCursor cursor = edit_->textCursor();
    const QString place =
        tr("Line %1, column %2").arg(cursor.blockNumber() + 1).arg(cursor.positionInBlock() + 1);
    QString more = edit_->faultOf(cursor.blockNumber());
    if (more.isEmpty())
        more = note_;
    if (const LineFault fault = edit_->firstFault(); more.isEmpty() && fault.line > 0)
        more = tr("line %1: %2").arg(fault.line).arg(fault.sentence);
    place_->setText(more.isEmpty() ? place : tr("%1; %2").arg(place, more));
    place_->setToolTip(plain::tip(more));
}

void EditFrame::goTo(const text::Position& place) {
    const QTextBlock block = edit_->document()->findBlockByNumber(place.line - 1);
    if (!block.isValid())
        return;
    QTextCursor cursor(block);
    cursor.setPosition(block.position() + std::clamp(place.column - 1, 0, block.length() - 1));
    edit_->setTextCursor(cursor);
    edit_->setFocus();
}

} // namespace source
