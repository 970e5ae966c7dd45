#include "window/file_bar.h"

#include "plain/plain.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace window {

FileBar::FileBar(session::FileFollower& file, QWidget* parent)
    : QFrame(parent), file_(file), sentence_(plain::label({}, this)),
      keep_(new QPushButton(tr("&Keep Mine"), this)),
      take_(new QPushButton(tr("&Take Theirs"), this)) {
    setObjectName("fileBar");
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    sentence_->setObjectName("fileSentence");
    sentence_->setForegroundRole(QPalette::ToolTipText);
    sentence_->setWordWrap(true);
    keep_->setObjectName("keepMine");
    take_->setObjectName("takeTheirs");
    keep_->setToolTip(plain::tip(tr("The text here stays where both changed it; saving writes it. "
                                    "Changes of the other program elsewhere are taken.")));
    take_->setToolTip(plain::tip(tr("The file's text is taken where both changed it. Your changes "
                                    "elsewhere stay; Undo brings the others back.")));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    row->addWidget(sentence_, 1);
    row->addWidget(keep_);
    row->addWidget(take_);
    connect(keep_, &QPushButton::clicked, &file, &session::FileFollower::keepMine);
    connect(take_, &QPushButton::clicked, &file, &session::FileFollower::takeTheirs);
    connect(&file, &session::FileFollower::stateChanged, this, &FileBar::update);
    update();
}

void FileBar::update() {
    using State = session::FileFollower::State;
    const bool asks = file_.state() == State::disputed || file_.state() == State::damaged;
    sentence_->setText(file_.sentence());
    keep_->setVisible(asks);
    take_->setVisible(asks);
    setVisible(file_.state() != State::quiet);
}

} // namespace window
