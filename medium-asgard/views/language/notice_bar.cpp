#include "language/notice_bar.h"

#include "plain/plain.h"

#include <QHBoxLayout>
#include <QPushButton>

#include <algorithm>

namespace views {

using scene::Range;

namespace {

QString shortened(const QString& text) {
    constexpr int most = 60;
    const QString line = text.simplified();
    if (line.isEmpty())
        return QObject::tr("nothing");
    return QStringLiteral("“%1”").arg(line.size() > most ? line.left(most - 1) + QChar(0x2026)
                                                         : line);
}

} // namespace

Notice::Notice(const QString& name) : words_(plain::label()), row_(new QHBoxLayout(this)) {
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    setFrameStyle(QFrame::StyledPanel);
    words_->setAccessibleName(name);
    words_->setWordWrap(true);
    words_->setForegroundRole(QPalette::ToolTipText);
    row_->setContentsMargins(8, 6, 8, 6);
    row_->addWidget(words_, 1);
}

ToldBar::ToldBar() : Notice(tr("What happened")) {
    auto* read = new QPushButton(tr("&OK"));
    row_->addWidget(read);
    connect(read, &QPushButton::clicked, this, [this] { tell({}); });
    tell({});
}

void ToldBar::tell(const QString& sentence) {
    words_->setText(sentence);
    setVisible(!sentence.isEmpty());
}

NoticeBar::NoticeBar(SceneEditor& editor, Draft& draft)
    : Notice(tr("Notice")), editor_(editor), draft_(draft),
      mine_(new QPushButton(tr("&Keep Mine"))), theirs_(new QPushButton(tr("&Take the Scene's"))),
      next_(new QPushButton(tr("Ne&xt"))), drop_(new QPushButton(tr("D&rop the Draft"))) {
    mine_->setToolTip(tr("This place stays as it is here (Ctrl+Shift+M)"));
    theirs_->setToolTip(tr("This place becomes what the scene has (Ctrl+Shift+T)"));
    next_->setToolTip(tr("Shows the next place that both changed (F7)"));
    drop_->setToolTip(tr("The text becomes the scene's; what was typed here is lost"));
    for (QPushButton* button : {mine_, theirs_, next_, drop_})
        row_->addWidget(button);
    connect(mine_, &QPushButton::clicked, this, &NoticeBar::keepMine);
    connect(theirs_, &QPushButton::clicked, this, &NoticeBar::takeTheirs);
    connect(next_, &QPushButton::clicked, this, &NoticeBar::nextConflict);
    connect(drop_, &QPushButton::clicked, &draft_, &Draft::drop);
    connect(&draft_, &Draft::changed, this, &NoticeBar::showState);
    connect(&editor_, &QsciScintillaBase::SCN_UPDATEUI, this, [this] {
        if (conflicts_ > 1)
            showState();
    });
    showState();
}

std::optional<Range> NoticeBar::current() const {
    const auto all = draft_.conflicts();
    if (all.empty())
        return std::nullopt;
    const std::size_t caret = editor_.caret();
    const auto at = std::ranges::find_if(
        all, [&](Range range) { return range.from <= caret && caret <= range.to; });
    return at == all.end() ? all.front() : *at;
}

QString NoticeBar::words(const std::vector<Range>& conflicts) const {
    QString refused;
    if (draft_.edited() && !draft_.refusal().isEmpty())
        refused = tr("The document did not take this change: %1. It is kept here as a draft.")
                      .arg(draft_.refusal().endsWith('.') ? draft_.refusal().chopped(1)
                                                          : draft_.refusal());
    const auto here = current();
    if (!here)
        return refused;
    const QString mine = shortened(editor_.word(*here)), theirs = shortened(draft_.theirs(*here));
    const QString what =
        conflicts.size() == 1
            ? tr("Changed here and in another view: here %1, in the scene %2.").arg(mine, theirs)
            : tr("%1 places were changed here and in another view. Here %2, in "
                 "the scene %3.")
                  .arg(conflicts.size())
                  .arg(mine, theirs);
    if (insists_)
        return tr("Not updated: choose first. %1").arg(what);
    return refused.isEmpty() ? what : tr("%1 %2").arg(refused, what);
}

void NoticeBar::showState() {
    const auto all = draft_.conflicts();
    conflicts_ = all.size();
    insists_ = insists_ && !all.empty();
    const QString text = words(all);
    words_->setText(text);
    for (QPushButton* button : {mine_, theirs_})
        button->setVisible(!all.empty());
    next_->setVisible(all.size() > 1);
    setVisible(!text.isEmpty());
}

void NoticeBar::insist() {
    insists_ = true;
    showState();
    if (const auto here = current())
        Q_EMIT wanted(*here);
}

void NoticeBar::nextConflict() {
    const auto all = draft_.conflicts();
    if (all.empty())
        return;
    const auto after = std::ranges::find_if(
        all, [&](Range range) { return range.from >= editor_.selection().to; });
    Q_EMIT wanted(after == all.end() ? all.front() : *after);
}

void NoticeBar::keepMine() {
    if (const auto here = current())
        draft_.keepMine(*here);
}

void NoticeBar::takeTheirs() {
    if (const auto here = current())
        draft_.takeTheirs(*here);
}

} // namespace views
