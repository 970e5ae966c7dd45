#include "window/find_bar.h"

#include "plain/plain.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>

namespace window {

FindBar::FindBar(view::DocumentView& view, QWidget* parent)
    : QWidget(parent), view_(view), field_(new QLineEdit(this)), count_(plain::label({}, this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 4, 10, 4);
    auto* label = plain::label(tr("Find"), this);
    label->setBuddy(field_);
    setObjectName("findBar");
    field_->setObjectName("find");
    field_->setAccessibleName(tr("Find"));
    field_->setClearButtonEnabled(true);
    field_->setMaximumWidth(320);
    row->addWidget(label);
    row->addWidget(field_);
    row->addWidget(count_, 1);
    connect(field_, &QLineEdit::textChanged, this, &FindBar::look);
    connect(&view_, &view::DocumentView::laidOut, this, [this] {
        if (isVisible())
            look();
    });
    hide();
}

QString FindBar::says() const { return count_->text(); }

void FindBar::open() {
    show();
    field_->setFocus();
    field_->selectAll();
    look();
}

void FindBar::look() {
    view_.find(field_->text());
    tell();
}

void FindBar::next(int step) {
    if (isHidden())
        return open();
    view_.showFound(view_.shownFound() + step);
    tell();
}

void FindBar::tell() {
    const int count = view_.foundCount();
    count_->setText(field_->text().isEmpty() ? QString()
                    : count == 0             ? tr("Not found")
                                 : tr("%1 of %2").arg(view_.shownFound() + 1).arg(count));
}

void FindBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        next(event->modifiers() & Qt::ShiftModifier ? -1 : 1);
    } else if (event->key() == Qt::Key_Escape) {
        hide();
        view_.find({});
        view_.setFocus();
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace window
