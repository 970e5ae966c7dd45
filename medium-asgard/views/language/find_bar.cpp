#include "language/find_bar.h"

#include "plain/plain.h"
#include "text/edit.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>
#include <cctype>

namespace views {

using scene::Range;

namespace {

bool isWordByte(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
           (static_cast<unsigned char>(c) & 0x80) != 0;
}

bool same(char a, char b, bool anyCase) {
    return a == b || (anyCase && std::tolower(static_cast<unsigned char>(a)) ==
                                     std::tolower(static_cast<unsigned char>(b)));
}

QLineEdit* field(const QString& name, const QString& tip) {
    auto* line = new QLineEdit;
    line->setPlaceholderText(name);
    line->setAccessibleName(name);
    line->setToolTip(plain::tip(tip));
    line->setClearButtonEnabled(true);
    return line;
}

} // namespace

FindBar::FindBar(SceneEditor& editor)
    : editor_(editor), what_(field(tr("Find"), tr("Return: next; Shift+Return: previous"))),
      with_(field(tr("Replace with"), tr("Return: replace this place and go to the next"))),
      wholeWords_(new QCheckBox(tr("&Whole words"))), words_(plain::label()),
      replaceRow_(new QWidget) {
    setObjectName("findBar");
    what_->setObjectName("find");
    with_->setObjectName("replace");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    auto* row = new QHBoxLayout;
    auto* previous = new QPushButton(tr("&Previous"));
    auto* next = new QPushButton(tr("&Next"));
    words_->setAccessibleName(tr("What was found"));
    words_->setMinimumWidth(words_->fontMetrics().horizontalAdvance(tr("99 of 99")));
    row->addWidget(what_, 1);
    row->addWidget(words_);
    row->addWidget(wholeWords_);
    row->addWidget(previous);
    row->addWidget(next);
    column->addLayout(row);
    auto* second = new QHBoxLayout(replaceRow_);
    second->setContentsMargins(0, 0, 0, 0);
    auto* one = new QPushButton(tr("Re&place"));
    auto* all = new QPushButton(tr("Replace &All"));
    second->addWidget(with_, 1);
    second->addWidget(one);
    second->addWidget(all);
    column->addWidget(replaceRow_);
    connect(what_, &QLineEdit::textChanged, this, &FindBar::markAll);
    connect(wholeWords_, &QCheckBox::toggled, this, &FindBar::markAll);
    connect(&editor_, &QsciScintilla::textChanged, this, [this] {
        if (isVisible())
            markAll();
    });
    connect(next, &QPushButton::clicked, this, [this] { findNext(); });
    connect(previous, &QPushButton::clicked, this, [this] { findNext(false); });
    connect(one, &QPushButton::clicked, this, &FindBar::replaceOne);
    connect(all, &QPushButton::clicked, this, &FindBar::replaceAll);
    hide();
}

void FindBar::open(bool replacing) {
    replaceRow_->setVisible(replacing);
    show();
    const Range selected = editor_.selection();
    if (selected.known() && editor_.lineOf(selected.from) == editor_.lineOf(selected.to))
        what_->setText(editor_.word(selected));
    what_->setFocus();
    what_->selectAll();
    markAll();
}

void FindBar::close() {
    hide();
    editor_.unmark(Mark::found);
    editor_.setFocus();
}

std::vector<Range> FindBar::places(const QString& what) const {
    const std::string text = editor_.bytes(), words = what.toStdString();
    std::vector<Range> found;
    if (words.empty())
        return found;
    const bool anyCase = what == what.toLower();
    const auto at = [&](char a, char b) { return same(a, b, anyCase); };
    for (auto from = text.begin();;) {
        const auto place = std::search(from, text.end(), words.begin(), words.end(), at);
        if (place == text.end())
            return found;
        const auto i = static_cast<std::size_t>(place - text.begin());
        const std::size_t end = i + words.size();
        const bool whole =
            (i == 0 || !isWordByte(text[i - 1])) && (end == text.size() || !isWordByte(text[end]));
        if (whole || !wholeWords_->isChecked())
            found.push_back({i, end});
        from = place + static_cast<std::ptrdiff_t>(words.size());
    }
}

void FindBar::markAll() {
    editor_.unmark(Mark::found);
    const auto all = places(what_->text());
    for (const Range& range : all)
        editor_.mark(Mark::found, range);
    say(what_->text().isEmpty() ? QString()
        : all.empty()           ? tr("Not found")
                                : tr("%1 found").arg(all.size()),
        all.empty() && !what_->text().isEmpty());
}

void FindBar::say(const QString& words, bool fault) {
    words_->setText(words);
    words_->setStyleSheet(fault ? QStringLiteral("color: #C02020") : QString());
}

bool FindBar::find(const QString& what, bool forward) {
    const auto all = places(what);
    if (all.empty())
        return false;
    const Range selected = editor_.selection();
    const auto after = std::ranges::find_if(all, [&](Range range) {
        return forward ? range.from >= selected.to : range.from >= selected.from;
    });
    const auto place = forward ? (after == all.end() ? all.begin() : after)
                               : (after == all.begin() ? all.end() - 1 : after - 1);
    say(tr("%1 of %2").arg(place - all.begin() + 1).arg(all.size()));
    Q_EMIT wanted(*place);
    return true;
}

bool FindBar::findNext(bool forward) { return find(what_->text(), forward); }

void FindBar::replaceOne() {
    const Range selected = editor_.selection();
    const auto all = places(what_->text());
    if (std::ranges::find(all, selected) != all.end()) {
        const std::string with = with_->text().toStdString();
        editor_.replace(selected, with);
        const std::size_t end = selected.from + with.size();
        editor_.SendScintilla(QsciScintillaBase::SCI_SETEMPTYSELECTION, end);
    }
    findNext();
}

int FindBar::replaceAll() {
    const auto all = places(what_->text());
    const std::string with = with_->text().toStdString();
    if (!all.empty()) { // as one change: whoever follows the text does so once
        const std::string text = editor_.bytes();
        text::Edits edits;
        edits.reserve(all.size());
        for (const Range& place : all)
            edits.push_back({{place.from, place.to}, with});
        const std::string after = text::applied(text, edits);
        const Range whole{all.front().from, all.back().to};
        editor_.replace(
            whole, after.substr(whole.from, after.size() - (text.size() - whole.to) - whole.from));
    }
    say(all.empty() ? tr("Not found") : tr("%1 replaced").arg(all.size()), all.empty());
    return static_cast<int>(all.size());
}

void FindBar::keyPressEvent(QKeyEvent* event) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (event->key() == Qt::Key_Escape)
        close();
    else if (enter && with_->hasFocus())
        replaceOne();
    else if (enter)
        findNext((event->modifiers() & Qt::ShiftModifier) == 0);
    else
        QWidget::keyPressEvent(event);
}

} // namespace views
