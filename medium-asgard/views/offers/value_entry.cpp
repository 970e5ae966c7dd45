#include "offers/value_entry.h"

#include "editing/number_text.h"
#include "offers/edit_preview.h"
#include "offers/offer_list.h"
#include "plain/plain.h"
#include "script/numbers.h"

#include <QFontDatabase>
#include <QGridLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace views {

ValueEntry::ValueEntry(SceneDocument& document, commands::AskedValue asked, QWidget* parent)
    : QFrame(parent), document_(document), asked_(std::move(asked)) {
    setObjectName(QStringLiteral("valueEntry"));
    setFrameStyle(QFrame::StyledPanel | QFrame::Raised);
    setAutoFillBackground(true);
    setFocusPolicy(Qt::StrongFocus);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 8);
    column->setSpacing(6);
    auto* title = plain::label(QString::fromStdString(asked_.title));
    title->setObjectName("valueTitle");
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    column->addWidget(title);
    addFields(column);
    const auto addQuiet = [&](const QString& words) {
        auto* quiet = plain::label(words);
        quiet->setWordWrap(true);
        quiet->setForegroundRole(QPalette::PlaceholderText);
        column->addWidget(quiet);
    };
    if (!asked_.note.empty())
        addQuiet(QString::fromStdString(asked_.note));
    addQuiet(tr("Return takes it  ·  Escape leaves it as it is"));
    says_ = plain::markupLabel();
    says_->setWordWrap(true);
    says_->setAccessibleName(tr("What changes in the text"));
    column->addWidget(says_);
    offers_ = new QVBoxLayout;
    offers_->setSpacing(4);
    column->addLayout(offers_);
    setFixedWidth(330);
    connect(&document_, &SceneDocument::textChanged, this, &ValueEntry::leave);
    update();
}

void ValueEntry::addFields(QVBoxLayout* column) {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(3);
    const std::vector<std::string> shown = commands::shownNumbers(asked_);
    for (std::size_t i = 0; i < asked_.now.size(); ++i) {
        const int row = static_cast<int>(i);
        const std::string& written = asked_.written[i];
        const bool literal = script::decimalNumber(written).has_value();
        auto* field = new QLineEdit(QString::fromStdString(shown[i]));
        field->setObjectName(QStringLiteral("value%1").arg(row + 1));
        const QString name = QString::fromStdString(asked_.names[i]);
        field->setAccessibleName(name);
        field->installEventFilter(this);
        connect(field, &QLineEdit::textEdited, this, &ValueEntry::update);
        grid->addWidget(plain::label(name), row, 0);
        grid->addWidget(field, row, 1);
        if (!literal && !written.empty()) { // the source text, where it is no number
            auto* source = plain::label(QString::fromStdString(written));
            source->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
            source->setForegroundRole(QPalette::PlaceholderText);
            source->setToolTip(tr("What stands in the text"));
            source->setMaximumWidth(140);
            grid->addWidget(source, row, 2);
        }
        fields_.push_back(field);
    }
    column->addLayout(grid);
}

std::optional<std::vector<double>> ValueEntry::values() const {
    std::vector<std::string> typed;
    for (const QLineEdit* field : fields_)
        typed.push_back(field->text().toStdString());
    return commands::typedNumbers(asked_, typed);
}

void ValueEntry::update() {
    const auto wanted = values();
    answer_ = {};
    if (!wanted) {
        says_->setText(tr("Decimal numbers, please."));
    } else if (*wanted == asked_.now) {
        // Nothing is typed yet: can it be changed at all?
        answer_ = asked_.answer(*wanted);
        answer_.edits.clear();
        says_->setText(QString::fromStdString(answer_.reason).toHtmlEscaped());
        answer_.offers.clear();
    } else {
        answer_ = asked_.answer(*wanted);
        says_->setText(answer_.possible() ? previewOf(asked_.text, answer_.edits)
                                          : QString::fromStdString(answer_.reason).toHtmlEscaped());
    }
    says_->setStyleSheet(answer_.possible() && wanted ? QString()
                                                      : QStringLiteral("color: #aa1e14"));
    says_->setVisible(!says_->text().isEmpty());
    showOffers(*offers_, asked_.text, answer_.offers,
               [this](const text::Edits& edits) { take(edits); });
    adjustSize();
    if (parentWidget())
        move(std::clamp(x(), 0, std::max(0, parentWidget()->width() - width())),
             std::clamp(y(), 0, std::max(0, parentWidget()->height() - height())));
}

void ValueEntry::propose(const std::vector<editing::Wish>& wishes) {
    std::size_t at = 0;
    for (const editing::Wish& wish : wishes)
        for (const double value : wish.values) {
            if (at == fields_.size())
                return;
            const bool same = std::abs(value - asked_.now[at]) <= 0.5 * wish.resolution;
            if (!same)
                fields_[at]->setText(
                    QString::fromStdString(editing::numberText(value, wish.resolution)));
            ++at;
        }
    update();
}

void ValueEntry::openAt(const QPoint& handle) {
    adjustSize();
    const QSize room = parentWidget()->size();
    const bool left = handle.x() + 20 + width() > room.width();
    move(std::clamp(left ? handle.x() - 20 - width() : handle.x() + 20, 0,
                    std::max(0, room.width() - width())),
         std::clamp(handle.y() - 30, 0, std::max(0, room.height() - height())));
    show();
    raise();
    fields_.front()->setFocus();
    fields_.front()->selectAll();
}

void ValueEntry::take(const text::Edits& edits) {
    const std::string text = text::applied(asked_.text, edits);
    const QString label = QString::fromStdString(asked_.label);
    SceneDocument& document = document_;
    leave();
    document.setText(text, label);
}

void ValueEntry::accept() {
    const auto wanted = values();
    if (!wanted)
        return;
    if (answer_.possible())
        take(*wanted == asked_.now ? text::Edits() : answer_.edits);
}

// Back to the picture; deleted later, since a child of this may be sending the event.
void ValueEntry::leave() {
    disconnect(&document_, nullptr, this, nullptr);
    hide();
    parentWidget()->setFocus();
    deleteLater();
}

void ValueEntry::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        leave();
    else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        accept();
    event->accept(); // none is a shortcut of the picture
}

bool ValueEntry::focusNextPrevChild(bool next) {
    QList<QWidget*> all(fields_.begin(), fields_.end());
    for (QPushButton* offer : findChildren<QPushButton*>())
        all += offer;
    const auto from = std::max<qsizetype>(0, all.indexOf(focusWidget()));
    all[(from + (next ? 1 : all.size() - 1)) % all.size()]->setFocus(next ? Qt::TabFocusReason
                                                                          : Qt::BacktabFocusReason);
    return true;
}

bool ValueEntry::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) { // typed, not a command of the window
        event->accept();
        return true;
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace views
