#include "window/status_line.h"

#include "plain/plain.h"

#include <QScrollBar>
#include <QStatusBar>

namespace window {

StatusLine::StatusLine(view::DocumentView& view, QStatusBar& bar, QObject* parent)
    : QObject(parent), view_(view), bar_(bar), language_(plain::label({}, &bar)),
      page_(plain::label({}, &bar)), zoom_(plain::label({}, &bar)) {
    language_->setObjectName("spellingLanguage");
    page_->setObjectName("page");
    zoom_->setObjectName("zoom");
    for (QLabel* one : {language_, page_, zoom_}) {
        one->setContentsMargins(6, 0, 6, 0);
        bar_.addPermanentWidget(one);
    }
    bar_.setSizeGripEnabled(false);
    language_->hide();
    connect(&view_, &view::DocumentView::zoomChanged, this, &StatusLine::showPlace);
    connect(&view_, &view::DocumentView::laidOut, this, &StatusLine::showPlace);
    connect(view_.verticalScrollBar(), &QScrollBar::valueChanged, this, &StatusLine::showPlace);
    connect(&view_, &view::DocumentView::chosenChanged, this, &StatusLine::followActive);
    showPlace();
}

void StatusLine::say(const QString& sentence) {
    constexpr int longEnoughMs = 8000;
    speaker_ = document::noSubdocument;
    bar_.showMessage(sentence, longEnoughMs);
}

void StatusLine::sayOf(document::SubdocumentId figure, const QString& sentence) {
    if (sentence.isEmpty() && speaker_ != figure)
        return; // another sentence has come
    say(sentence);
    speaker_ = sentence.isEmpty() ? document::noSubdocument : figure;
}

void StatusLine::showLanguage(const QString& name) {
    language_->setText(tr("Spelling: %1").arg(name));
    language_->setVisible(!name.isEmpty());
}

void StatusLine::showPlace() {
    zoom_->setText(tr("%1 %").arg(qRound(view_.zoom() * 100)));
    const auto pages = static_cast<int>(view_.pages().pages.size());
    page_->setText(tr("Page %1 of %2").arg(view_.currentPage() + 1).arg(pages));
}

void StatusLine::followActive() {
    if (speaker_ && speaker_ != view_.chosen()) {
        speaker_ = document::noSubdocument;
        bar_.clearMessage();
    }
}

} // namespace window
