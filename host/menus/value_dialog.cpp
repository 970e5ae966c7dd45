#include "menus/value_dialog.h"

#include "model/value_text.h"
#include "plain/plain.h"
#include "session/open_document.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

namespace menus {

namespace {

constexpr int pauseMs = 150; // of typing, before the number is asked for
constexpr int wanted = -1;   // a process that is nearer than anything that is seen

} // namespace

std::vector<ValuedFigure> valuedFigures(const session::OpenDocument& document,
                                        const authoring::Manuscript& in,
                                        const model::Model& model) {
    std::vector<ValuedFigure> result;
    int number = 0;
    for (const document::SubdocumentId id : document.document().subdocuments()) {
        const media::LiveSubdocument* live = document.live(id);
        if (!live)
            continue;
        ++number;
        const document::Subdocument* of = document.document().subdocument(id);
        const std::vector<Target> captions =
            described({authoring::wholeFigure(in, of->element)}, model);
        const media::Manifest& manifest = live->manifest();
        const QString kind = manifest.title.isEmpty() ? manifest.name : manifest.title;
        QString words = !captions.empty()  ? captions.front().words
                        : of->name.empty() ? ValueDialog::tr("%1 %2").arg(kind).arg(number)
                                           : QString::fromStdString(of->name);
        result.push_back({of->element, id, words});
    }
    return result;
}

ValueDialog::ValueDialog(session::OpenDocument& document, std::vector<ValuedFigure> figures,
                         const document::ValueUse& now, std::string language, QWidget* parent)
    : QDialog(parent), document_(document), figures_(std::move(figures)),
      language_(std::move(language)), form_{.figure = new QComboBox(this),
                                            .expression = new QLineEdit(this),
                                            .list = new QListWidget(this),
                                            .number = plain::label({}, this),
                                            .fixed = new QRadioButton(tr("&Always at"), this),
                                            .time = new QDoubleSpinBox(this),
                                            .digits = new QSpinBox(this),
                                            .unit = new QComboBox(this)} {
    setObjectName("valueDialog");
    setWindowTitle(tr("Value of a Figure"));
    look_.setSingleShot(true);
    makeForm(now);
    connect(&look_, &QTimer::timeout, this, &ValueDialog::askForNumber);
    connect(form_.figure, &QComboBox::currentIndexChanged, this, &ValueDialog::chooseFigure);
    connect(form_.expression, &QLineEdit::textChanged, this, &ValueDialog::look);
    connect(form_.expression, &QLineEdit::textEdited, this, &ValueDialog::filter);
    connect(form_.list, &QListWidget::itemClicked, this, &ValueDialog::takeOffer);
    connect(form_.list, &QListWidget::itemActivated, this, &ValueDialog::takeOffer);
    connect(form_.fixed, &QRadioButton::toggled, this, &ValueDialog::look);
    connect(form_.time, &QDoubleSpinBox::valueChanged, this, [this] {
        form_.fixed->setChecked(true);
        look();
    });
    connect(form_.digits, &QSpinBox::valueChanged, this, &ValueDialog::look);
    connect(form_.unit, &QComboBox::currentIndexChanged, this, &ValueDialog::look);
    chooseFigure();
    look();
    form_.expression->setFocus();
}

ValueDialog::~ValueDialog() {
    if (asked_)
        document_.media().setDistance(*asked_, this, media::LiveMedia::notNeeded);
}

void ValueDialog::makeForm(const document::ValueUse& now) {
    form_.figure->setObjectName("figure");
    form_.figure->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    int known = -1;
    for (const ValuedFigure& figure : figures_) {
        form_.figure->addItem(figure.words);
        if (document_.document().subdocument(figure.id)->name == now.of && !now.of.empty())
            known = form_.figure->count() - 1;
    }
    // One that is not here is not taken for another: it is to be chosen.
    form_.figure->setCurrentIndex(known >= 0 || now.of.empty() ? std::max(known, 0) : -1);
    form_.figure->setPlaceholderText(QString::fromStdString(now.of));
    form_.expression->setObjectName("expression");
    form_.expression->setPlaceholderText(tr("Words of the list, or an expression of the figure"));
    const QString written = QString::fromStdString(now.expression);
    form_.expression->setMaxLength(std::max(static_cast<int>(ipc::longestExpression.most / 4),
                                            static_cast<int>(written.size()))); // bytes, in UTF-8
    form_.expression->setText(written);
    form_.expression->setClearButtonEnabled(true);
    form_.expression->installEventFilter(this);
    form_.list->setObjectName("offers");
    form_.list->setAccessibleName(tr("Values of the figure"));
    form_.list->setMinimumSize(420, 150);
    form_.list->setFocusPolicy(Qt::NoFocus); // the arrows of the line above choose
    form_.number->setObjectName("number");
    form_.number->setWordWrap(true);
    form_.number->setMinimumHeight(form_.number->fontMetrics().lineSpacing() * 2);
    form_.number->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* follows = new QRadioButton(tr("As the figure &shows it"), this);
    follows->setObjectName("follows");
    form_.fixed->setObjectName("fixed");
    (now.time ? form_.fixed : follows)->setChecked(true);
    form_.time->setObjectName("time");
    form_.time->setDecimals(3);
    form_.time->setRange(-1e6, 1e6);
    form_.time->setSuffix(tr(" s"));
    form_.time->setAccessibleName(tr("Time"));
    form_.time->setValue(now.time.value_or(0));
    at_.written = now.time;
    at_.shown = form_.time->value();
    form_.digits->setObjectName("digits");
    form_.digits->setRange(0, std::max(document::mostDecimals, document::mostDigits));
    form_.digits->setValue(now.digits.count);
    form_.digits->setAccessibleName(tr("How many digits"));
    form_.unit->setObjectName("unit");
    form_.unit->addItems({tr("digits in all"), tr("behind the point")});
    form_.unit->setCurrentIndex(now.digits.areDecimals ? 1 : 0);
    form_.unit->setAccessibleName(tr("Which digits"));
    auto* when = new QHBoxLayout;
    for (QWidget* one : std::initializer_list<QWidget*>{follows, form_.fixed, form_.time})
        when->addWidget(one);
    when->addStretch();
    auto* digits = new QHBoxLayout;
    digits->addWidget(form_.digits);
    digits->addWidget(form_.unit);
    digits->addStretch();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form_.ok = buttons->button(QDialogButtonBox::Ok);
    auto* form = new QFormLayout(this);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("&Figure:"), form_.figure);
    form->addRow(tr("&Value:"), form_.expression);
    QListWidget* offers = form_.list;
    form->addRow(offers);
    form->addRow(tr("Time:"), when);
    form->addRow(tr("&Digits:"), digits);
    if (auto* label = qobject_cast<QLabel*>(form->labelForField(digits)))
        label->setBuddy(form_.digits); // a row that is a layout gives it none
    form->addRow(tr("Number:"), form_.number);
    form->addRow(buttons);
}

media::LiveSubdocument* ValueDialog::live() const {
    const int at = form_.figure->currentIndex();
    return at < 0 ? nullptr : document_.live(figures_.at(static_cast<std::size_t>(at)).id);
}

sgml::NodeId ValueDialog::figure() const {
    return figures_.at(static_cast<std::size_t>(std::max(form_.figure->currentIndex(), 0))).element;
}

document::ValueUse ValueDialog::use() const {
    document::ValueUse use{.of = {},
                           .expression = form_.expression->text().trimmed().toStdString()};
    use.digits.areDecimals = form_.unit->currentIndex() == 1;
    use.digits.count = use.digits.areDecimals
                           ? std::min(form_.digits->value(), document::mostDecimals)
                           : std::max(form_.digits->value(), 1);
    if (form_.fixed->isChecked()) // digits that the field does not show stay, unless it was changed
        use.time =
            at_.written && form_.time->value() == at_.shown ? *at_.written : form_.time->value();
    return use;
}

// --- what its medium says ----------------------------------------------------------------------

void ValueDialog::chooseFigure() {
    if (asked_) {
        asked_->disconnect(this);
        document_.media().setDistance(*asked_, this, media::LiveMedia::notNeeded);
    }
    asked_ = live();
    offers_.clear();
    filter();
    if (!asked_)
        return look();
    document_.media().setDistance(*asked_, this, wanted);
    const auto ask = [this] {
        askForOffers();
        look();
    };
    connect(asked_, &media::LiveSubdocument::loaded, this, ask);
    connect(asked_, &media::LiveSubdocument::conditionChanged, this, &ValueDialog::look);
    connect(asked_, &media::LiveSubdocument::diagnosticsChanged, this, ask); // the text is read
    ask();
}

void ValueDialog::askForOffers() {
    const QPointer<ValueDialog> guard(this);
    const QPointer<media::LiveSubdocument> of = asked_;
    of->listValues([guard, of](const std::vector<ipc::ValueOffer>& offers) {
        if (!guard || guard->asked_ != of || offers.empty())
            return;
        guard->offers_ = offers;
        guard->filter();
    });
}

bool ValueDialog::isOffered(const QString& expression) const {
    return std::ranges::any_of(offers_, [&](const ipc::ValueOffer& offer) {
        return expression == QString::fromStdString(offer.expression);
    });
}

// All where the expression is one of them.
void ValueDialog::filter() {
    const QString words = form_.expression->text().simplified();
    form_.list->clear();
    const bool isOne = isOffered(words);
    for (std::size_t i = 0; i < offers_.size(); ++i) {
        const QString expression = QString::fromStdString(offers_[i].expression);
        const QString label = QString::fromStdString(offers_[i].label);
        const QString unit = QString::fromStdString(offers_[i].unit);
        const QString shown =
            label + (unit.isEmpty() ? QString() : " (" + unit + ")") +
            (label == expression ? QString() : QStringLiteral("   ") + expression);
        if (!isOne && !shown.contains(words, Qt::CaseInsensitive))
            continue;
        auto* item = new QListWidgetItem(shown, form_.list);
        item->setData(Qt::UserRole, expression);
        if (isOne && words == expression)
            form_.list->setCurrentItem(item);
    }
}

void ValueDialog::takeOffer() {
    if (const QListWidgetItem* item = form_.list->currentItem())
        form_.expression->setText(item->data(Qt::UserRole).toString());
}

// Words that are no expression stand for the first value of the list that has them.
void ValueDialog::accept() {
    if (!isComplete())
        return;
    if (answer_ == Answer::awaited || answer_ == Answer::awaitedByOk) {
        answer_ = Answer::awaitedByOk;
        look_.stop();
        return askForNumber();
    }
    if (answer_ == Answer::fault) {
        const QListWidgetItem* first = form_.list->item(0);
        if (!first)
            return;
        form_.expression->setText(first->data(Qt::UserRole).toString());
    }
    QDialog::accept();
}

bool ValueDialog::isComplete() const {
    return !form_.expression->text().trimmed().isEmpty() && form_.figure->currentIndex() >= 0;
}

void ValueDialog::setAnswer(Answer answer) {
    const bool isAwaited = answer_ == Answer::awaitedByOk && answer != Answer::awaited;
    answer_ = answer;
    form_.ok->setEnabled(isComplete() && answer_ != Answer::fault);
    if (isAwaited)
        accept();
}

// The arrows choose while one types, and Enter takes.
bool ValueDialog::eventFilter(QObject* watched, QEvent* event) {
    if (watched == form_.expression && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
        if (step != 0 && form_.list->count() > 0) {
            form_.list->setCurrentRow(
                std::clamp(form_.list->currentRow() + step, 0, form_.list->count() - 1));
            takeOffer();
            return true;
        }
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            accept();
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

void ValueDialog::look() {
    ++asking_; // answers on their way are of another question
    setAnswer(Answer::awaited);
    look_.start(pauseMs);
}

void ValueDialog::askForNumber() {
    const document::ValueUse use = this->use();
    if (use.expression.empty() || !asked_) {
        form_.number->clear();
        return setAnswer(Answer::value);
    }
    const media::Condition condition = asked_->condition();
    const bool comes = condition == media::Condition::starting ||
                       condition == media::Condition::still ||
                       (condition == media::Condition::live && !asked_->hasLoaded());
    if (comes) {
        form_.number->setText(tr("%1 is starting.").arg(asked_->name()));
        return setAnswer(Answer::value); // for all that is known
    }
    const QPointer<ValueDialog> guard(this);
    asked_->readValues({use.expression}, use.time, [guard, asking = asking_](auto outcome) {
        if (guard && guard->asking_ == asking)
            guard->show(outcome);
    });
}

void ValueDialog::show(const media::Outcome<ipc::Values>& outcome) {
    const auto* read = std::get_if<ipc::Values>(&outcome);
    if (read && std::isfinite(read->values[0])) {
        form_.number->setText(
            QString::fromStdString(model::written(read->values[0], use().digits, language_)));
        return setAnswer(Answer::value);
    }
    const std::string fault = read && !read->faults.empty() ? read->faults[0] : std::string();
    const std::string why = read ? fault : std::get<ipc::Error>(outcome).message;
    // A value that the figure offers may have none at this time.
    const bool isFault = !fault.empty() && !isOffered(form_.expression->text().simplified());
    QString says = why.empty() ? tr("It has no value now.") : QString::fromStdString(why);
    if (const QListWidgetItem* first = form_.list->item(0); first && isFault)
        says += '\n' + tr("Enter takes %1.").arg(first->data(Qt::UserRole).toString());
    form_.number->setText(says);
    setAnswer(isFault ? Answer::fault : Answer::value);
}

} // namespace menus
