#include "panes/file_bar.h"

#include "plain/plain.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace panes {

FileBar::FileBar(session::FileFollower& file, QWidget* parent)
    : QFrame(parent), file_(file), sentence_(plain::label({}, this)),
      keep_(new QPushButton(tr("&Keep Mine"), this)),
      take_(new QPushButton(tr("&Take Theirs"), this)), choices_(new QScrollArea(this)) {
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
    choices_->setObjectName("fileChoices");
    choices_->setAccessibleName(tr("What both wrote"));
    choices_->setWidgetResizable(true);
    choices_->setFrameShape(QFrame::NoFrame);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(8, 4, 8, 4);
    auto* row = new QHBoxLayout;
    all->addLayout(row);
    all->addWidget(choices_);
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
    showChoices();
    setVisible(file_.state() != State::quiet);
}

void FileBar::showChoices() {
    const auto& choices = file_.choices();
    choices_->setVisible(!choices.empty());
    auto* table = new QWidget;
    auto* grid = new QGridLayout(table);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    grid->setHorizontalSpacing(16);
    const auto put = [&](int row, int column, const QString& text, const char* name) {
        QLabel* label = plain::label(text, table);
        label->setObjectName(name);
        label->setWordWrap(column > 0);
        label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        grid->addWidget(label, row, column);
    };
    const auto orNothing = [](const QString& text) {
        return text.isEmpty() ? tr("(nothing)") : text;
    };
    put(0, 0, tr("Line"), "choiceHead");
    put(0, 1, tr("Mine"), "choiceHead");
    put(0, 2, tr("Theirs"), "choiceHead");
    for (QLabel* head : table->findChildren<QLabel*>("choiceHead")) {
        QFont bold = head->font();
        bold.setBold(true);
        head->setFont(bold);
    }
    int row = 0;
    for (const session::FileFollower::Choice& choice : choices) {
        put(++row, 0, QString::number(choice.line), "choiceLine");
        put(row, 1, orNothing(choice.mine), "choiceMine");
        put(row, 2, orNothing(choice.theirs), "choiceTheirs");
    }
    grid->setRowStretch(row + 1, 1);
    choices_->setWidget(table); // takes the one from before away
    constexpr int mostLines = 8;
    choices_->setFixedHeight(
        std::min(table->sizeHint().height(), mostLines * fontMetrics().lineSpacing()));
}

} // namespace panes
