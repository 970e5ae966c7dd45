#include "panes/reading_bar.h"

#include "plain/plain.h"
#include "view/document_view.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace panes {

ReadingBar::ReadingBar(view::DocumentView& view, QAction& write, QWidget* parent)
    : QFrame(parent), view_(view) {
    setObjectName("readingBar");
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    QLabel* sentence = plain::label(tr("This document is open for reading. To write in it: %1")
                                        .arg(write.shortcut().toString(QKeySequence::NativeText)),
                                    this);
    sentence->setObjectName("readingSentence");
    sentence->setForegroundRole(QPalette::ToolTipText);
    auto* begin = new QPushButton(tr("&Write"), this);
    begin->setObjectName("beginWriting");
    auto* stay = new QPushButton(tr("Keep &Reading"), this);
    stay->setObjectName("keepReading");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    row->addWidget(sentence, 1);
    row->addWidget(begin);
    row->addWidget(stay);
    const auto goBack = [this] {
        hide();
        view_.setFocus();
    };
    connect(begin, &QPushButton::clicked, this, [goBack, &write] {
        write.trigger();
        goBack();
    });
    connect(stay, &QPushButton::clicked, this, [this, goBack] {
        isClosed_ = true;
        goBack();
    });
    connect(&view_, &view::DocumentView::triedToWrite, this, &ReadingBar::offer);
    connect(&view_, &view::DocumentView::writingChanged, this, [this] {
        isClosed_ = false;
        hide();
    });
    hide();
}

void ReadingBar::offer() {
    if (!isClosed_)
        show();
}

} // namespace panes
