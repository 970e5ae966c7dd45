#include "views/value_entry.h"

#include "editing/number_text.h"
#include "gestures/handle_meaning.h"
#include "gestures/new_point.h"
#include "script/numbers.h"
#include "views/edit_preview.h"

#include <QFontDatabase>
#include <QGridLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QVBoxLayout>

namespace views {

namespace {

QString plain(double value) { return QString::fromStdString(script::numberText(value, true)); }

std::vector<double> allOf(const std::vector<editing::Wish>& wishes,
                          std::vector<double> editing::Wish::*which) {
    std::vector<double> all;
    for (const editing::Wish& wish : wishes)
        all.insert(all.end(), (wish.*which).begin(), (wish.*which).end());
    return all;
}

} // namespace

ValueEntry::ValueEntry(SceneDocument& document, const Shown& of, const render::Handle& handle,
                       QWidget* parent)
    : QFrame(parent), document_(document), text_(document.text()), scene_(of.scene),
      motion_(of.motion), mapper_(text_, scene_,
                                  [this](const std::string& name) {
                                      return render::constantValue(*scene_, motion_.get(), name);
                                  }),
      handle_(handle) {
    setObjectName(QStringLiteral("valueEntry"));
    setFrameStyle(QFrame::StyledPanel | QFrame::Raised);
    setAutoFillBackground(true);
    setFocusPolicy(Qt::StrongFocus);
    wishes_ = gestures::wishesFor(*scene_, handle_, handle_.place, 0, false);
    if (handle_.kind == render::HandleKind::orientation && mapper_.count(wishes_.front()) == 4)
        wishes_ = gestures::wishesFor(*scene_, handle_, handle_.place, 0, true);
    if (handle_.kind == render::HandleKind::trajectoryPoint) {
        path_.emplace(text_, scene_, handle_.element);
        wishes_ = {path_->wishOf(gestures::pointOf(*path_, handle_))};
    }
    now_ = allOf(wishes_, &editing::Wish::values);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 8);
    column->setSpacing(6);
    auto* title = new QLabel(
        tr("%1: %2").arg(QString::fromStdString(gestures::subjectOf(*scene_, handle_)),
                         QString::fromStdString(gestures::quantityOf(*scene_, handle_))));
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    column->addWidget(title);
    addFields(column);
    says_ = new QLabel;
    says_->setWordWrap(true);
    says_->setTextFormat(Qt::RichText);
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
    std::vector<std::string> written;
    for (const editing::Wish& wish : wishes_)
        for (const std::string& one : mapper_.written(wish))
            written.push_back(one);
    const bool four = now_.size() == 4;
    const QStringList names = !four ? QStringList{tr("x"), tr("y"), tr("z")}
                              : handle_.kind == render::HandleKind::orientation
                                  ? QStringList{tr("w"), tr("x"), tr("y"), tr("z")}
                                  : QStringList{tr("t"), tr("x"), tr("y"), tr("z")};
    for (std::size_t i = 0; i < now_.size(); ++i) {
        const int row = static_cast<int>(i);
        const bool literal = script::decimalNumber(written[i]).has_value();
        const QString text = literal ? QString::fromStdString(written[i]) : plain(now_[i]);
        auto* field = new QLineEdit(text);
        field->setAccessibleName(names[row]);
        field->installEventFilter(this);
        connect(field, &QLineEdit::textEdited, this, &ValueEntry::update);
        grid->addWidget(new QLabel(names[row]), row, 0);
        grid->addWidget(field, row, 1);
        if (!literal && !written[i].empty()) { // the source text, where it is no number
            auto* source = new QLabel(QString::fromStdString(written[i]));
            source->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
            source->setForegroundRole(QPalette::PlaceholderText);
            source->setToolTip(tr("What stands in the text"));
            source->setMaximumWidth(140);
            grid->addWidget(source, row, 2);
        }
        fields_.push_back(field);
        first_.push_back(text);
    }
    column->addLayout(grid);
}

std::optional<std::vector<double>> ValueEntry::values() const {
    std::vector<double> values = now_;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        if (fields_[i]->text() == first_[i])
            continue;
        const auto number = script::decimalNumber(fields_[i]->text().toStdString());
        if (!number)
            return std::nullopt;
        values[i] = *number;
    }
    return values;
}

// A point that ends one curve and begins the next moves in both, with its tangents.
editing::Answer ValueEntry::asked(const std::vector<double>& wanted) const {
    if (!path_ || !path_->hasOwnTangents())
        return mapper_.answer(gestures::withValues(wishes_, wanted));
    const std::size_t point = gestures::pointOf(*path_, handle_);
    return path_->move(point, path_->points()[point].time, {wanted[0], wanted[1], wanted[2]}, 0);
}

void ValueEntry::update() {
    const auto wanted = values();
    answer_ = {};
    if (!wanted) {
        says_->setText(tr("Decimal numbers, please."));
    } else if (*wanted == now_) {
        // Nothing is typed yet: can it be changed at all?
        auto asked = wishes_;
        for (editing::Wish& wish : asked)
            wish.now.clear();
        answer_ = mapper_.answer(asked);
        answer_.edits.clear();
        says_->setText(QString::fromStdString(answer_.reason).toHtmlEscaped());
        answer_.offers.clear();
    } else {
        answer_ = asked(*wanted);
        says_->setText(answer_.possible() ? previewOf(text_, answer_.edits)
                                          : QString::fromStdString(answer_.reason).toHtmlEscaped());
    }
    says_->setStyleSheet(answer_.possible() && wanted ? QString()
                                                      : QStringLiteral("color: #aa1e14"));
    says_->setVisible(!says_->text().isEmpty());
    showOffers();
    adjustSize();
    if (parentWidget())
        move(std::clamp(x(), 0, std::max(0, parentWidget()->width() - width())),
             std::clamp(y(), 0, std::max(0, parentWidget()->height() - height())));
}

void ValueEntry::showOffers() {
    while (QLayoutItem* item = offers_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const editing::Offer& offer : answer_.offers) {
        auto* button = new QPushButton(QString::fromStdString(offer.label));
        connect(button, &QPushButton::clicked, this, [this, edits = offer.edits] { take(edits); });
        offers_->addWidget(button);
        auto* shown = new QLabel(previewOf(text_, offer.edits));
        shown->setWordWrap(true);
        offers_->addWidget(shown);
    }
}

void ValueEntry::propose(const std::vector<editing::Wish>& wishes) {
    std::size_t at = 0;
    for (const editing::Wish& wish : wishes)
        for (const double value : wish.values) {
            if (at == fields_.size())
                return;
            const bool same = std::abs(value - now_[at]) <= 0.5 * wish.resolution;
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

void ValueEntry::take(const std::vector<editing::TextEdit>& edits) {
    const std::string text = editing::applied(text_, edits);
    const QString label = QString::fromStdString(gestures::labelOf(*scene_, handle_));
    SceneDocument& document = document_;
    leave();
    document.setText(text, label);
}

void ValueEntry::accept() {
    const auto wanted = values();
    if (!wanted)
        return;
    if (answer_.possible())
        take(*wanted == now_ ? std::vector<editing::TextEdit>() : answer_.edits);
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
