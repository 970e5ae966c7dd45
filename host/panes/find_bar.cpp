#include "panes/find_bar.h"

#include "plain/plain.h"
#include "view/folds.h"
#include "view/text_hand.h"
#include "view/writing.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace panes {

FindBar::FindBar(view::DocumentView& view, QWidget* parent)
    : QWidget(parent), view_(view), replacing_(new QWidget(this)) {
    setObjectName("findBar");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 4, 10, 4);
    column->setSpacing(4);
    addFindRow(*column);
    addReplaceRow(*column);
    putInTabOrder();
    connect(field_, &QLineEdit::textChanged, this, &FindBar::look);
    connect(matchCase_, &QCheckBox::toggled, this, &FindBar::look);
    connect(wholeWords_, &QCheckBox::toggled, this, &FindBar::look);
    connect(&view_, &view::DocumentView::laidOut, this, &FindBar::tell);
    connect(&view_, &view::DocumentView::writingChanged, this, &FindBar::offerReplacing);
    replacing_->hide();
    hide();
}

QLineEdit* FindBar::addField(QBoxLayout& row, const QString& name, const QString& label) {
    auto* field = new QLineEdit(this);
    constexpr int labelWidth = 60, leastWidth = 120, fieldWidth = 320;
    auto* said = plain::label(label, this);
    said->setBuddy(field);
    said->setMinimumWidth(labelWidth);
    field->setObjectName(name);
    field->setAccessibleName(label);
    field->setClearButtonEnabled(true);
    field->setMinimumWidth(leastWidth);
    field->setMaximumWidth(fieldWidth);
    row.addWidget(said);
    row.addWidget(field, 1);
    return field;
}

void FindBar::putButton(QBoxLayout& row, const QString& name, const QString& text,
                        const std::function<void()>& done) {
    auto* button = new QPushButton(plain::ours(text), this);
    button->setObjectName(name);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, done);
    row.addWidget(button);
}

void FindBar::putArrow(QBoxLayout& row, const QString& name, Qt::ArrowType arrow,
                       const QString& says, const std::function<void()>& done) {
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setArrowType(arrow);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(says);
    button->setToolTip(plain::tip(says));
    connect(button, &QToolButton::clicked, this, done);
    row.addWidget(button);
}

void FindBar::addFindRow(QBoxLayout& column) {
    auto* row = new QHBoxLayout;
    column.addLayout(row);
    field_ = addField(*row, "find", tr("Find"));
    putArrow(*row, "findPrevious", Qt::UpArrow, tr("Previous"), [this] { next(-1); });
    putArrow(*row, "findNext", Qt::DownArrow, tr("Next"), [this] { next(1); });
    matchCase_ = new QCheckBox(tr("Match case"), this);
    matchCase_->setObjectName("matchCase");
    wholeWords_ = new QCheckBox(tr("Whole words"), this);
    wholeWords_->setObjectName("wholeWords");
    row->addWidget(matchCase_);
    row->addWidget(wholeWords_);
    count_ = plain::label({}, this);
    count_->setObjectName("found");
    row->addWidget(count_, 1);
}

void FindBar::addReplaceRow(QBoxLayout& column) {
    column.addWidget(replacing_);
    auto* row = new QHBoxLayout(replacing_);
    row->setContentsMargins(0, 0, 0, 0);
    with_ = addField(*row, "replaceWith", tr("Replace"));
    with_->setAccessibleName(tr("Replace with"));
    putButton(*row, "replace", tr("Replace"), [this] { replace(); });
    putButton(*row, "replaceAll", tr("Replace All"), [this] { replaceAll(); });
    row->addStretch(1);
}

// Both fields before the buttons.
void FindBar::putInTabOrder() {
    QWidget* before = field_;
    for (QWidget* next : {static_cast<QWidget*>(with_), findChild<QWidget*>("findPrevious"),
                          findChild<QWidget*>("findNext"), static_cast<QWidget*>(matchCase_),
                          static_cast<QWidget*>(wholeWords_), findChild<QWidget*>("replace"),
                          findChild<QWidget*>("replaceAll")}) {
        setTabOrder(before, next);
        before = next;
    }
}

QString FindBar::says() const { return count_->text(); }

void FindBar::open() {
    show();
    field_->setFocus();
    field_->selectAll();
    look();
}

void FindBar::openReplace() {
    replacing_->setVisible(view_.isWriting());
    open();
}

void FindBar::offerReplacing() {
    if (!view_.isWriting())
        replacing_->hide();
}

void FindBar::look() {
    view_.find(places::Search{field_->text(), matchCase_->isChecked(), wholeWords_->isChecked()});
    tell();
}

void FindBar::next(int step) {
    if (isHidden())
        return open();
    view_.showFound(view_.shownFound() + (isSeen() ? step : 0));
    selectShown();
    tell();
}

// Or in a section that is folded?
bool FindBar::isSeen() const { return view_.found().seen(view_.found().shown()) != nullptr; }

void FindBar::tell() {
    const int count = view_.foundCount();
    count_->setText(field_->text().isEmpty() ? QString()
                    : count == 0             ? tr("Not found")
                    : !isSeen()              ? tr("%1, folded").arg(count)
                                : tr("%1 of %2").arg(view_.shownFound() + 1).arg(count));
}

// --- replacing ---------------------------------------------------------------------------------

std::optional<text::Range> FindBar::placeOfShown() const {
    if (view_.foundCount() == 0)
        return std::nullopt;
    const view::FoundWords& found = view_.found();
    return places::placesOf(found.finder().at(found.shown()),
                            model::RunPlaces(view_.document().document().tree()));
}

// In a writing view, the next letter replaces the word that is found.
void FindBar::selectShown() {
    if (!view_.isWriting() || view_.chosen())
        return;
    if (const std::optional<text::Range> place = placeOfShown())
        view_.text().cursor().set({place->from, place->to});
}

bool FindBar::replace() {
    view_.settle();
    if (view_.foundCount() > 0 && !isSeen()) { // to be seen first
        next(0);
        return false;
    }
    const std::optional<text::Range> place = placeOfShown();
    if (!place) {
        if (view_.foundCount() > 0)
            Q_EMIT replaced(tr("This is a number or a reference, which the program writes."));
        return false;
    }
    const std::string with = with_->text().toStdString();
    const bool isDone =
        view_.writing().perform([&](const authoring::Manuscript& in, authoring::Selection) {
            return authoring::replaceAll(in, {*place}, with).result;
        });
    view_.settle();
    if (const auto caret = view_.text().cursor().selection(); isDone && caret)
        view_.showFoundFrom(caret->caret);
    selectShown();
    tell();
    return isDone;
}

void FindBar::replaceAll() {
    view_.settle();
    const model::RunPlaces places(view_.document().document().tree());
    std::vector<text::Range> all;
    std::size_t generated = 0;
    for (std::size_t i = 0; i < view_.found().finder().count(); ++i) {
        if (const auto place = places::placesOf(view_.found().finder().at(i), places))
            all.push_back(*place);
        else
            ++generated;
    }
    // In their order; a header row that is on several pages is one.
    const auto before = [](const text::Range& a, const text::Range& b) { return a.from < b.from; };
    std::ranges::sort(all, before);
    const auto same = [](const text::Range& a, const text::Range& b) { return a.from == b.from; };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    for (const text::Range& one : all)
        view_.folds().reveal(one.from);
    const std::string with = with_->text().toStdString();
    authoring::Replacement replacement;
    if (!view_.writing().perform([&](const authoring::Manuscript& in, authoring::Selection) {
            replacement = authoring::replaceAll(in, all, with);
            return replacement.result;
        }))
        return;
    view_.settle();
    const std::size_t left = replacement.left + generated;
    const QString done = tr("%1 replaced").arg(replacement.replaced);
    Q_EMIT replaced(left == 0 ? done
                              : tr("%1; %2 left, which may not be changed").arg(done).arg(left));
    tell();
}

void FindBar::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (auto* button = qobject_cast<QAbstractButton*>(focusWidget());
        isEnter && button && !button->isCheckable()) {
        button->click();
    } else if (isEnter && focusWidget() == with_) {
        replace();
    } else if (isEnter) {
        next(event->modifiers() & Qt::ShiftModifier ? -1 : 1);
    } else if (event->key() == Qt::Key_Escape) {
        hide();
        replacing_->hide();
        view_.find(QString());
        view_.setFocus();
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace panes
