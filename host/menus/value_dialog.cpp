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
      language_(std::move(language)), figure_(new QComboBox(this)),
      expression_(new QLineEdit(this)), list_(new QListWidget(this)),
      number_(plain::label({}, this)), fixed_(new QRadioButton(tr("&Always at"), this)),
      time_(new QDoubleSpinBox(this)), digits_(new QSpinBox(this)), unit_(new QComboBox(this)) {
    setObjectName("valueDialog");
    setWindowTitle(tr("Value of a Figure"));
    look_.setSingleShot(true);
    makeForm(now);
    connect(&look_, &QTimer::timeout, this, &ValueDialog::askForNumber);
    connect(figure_, &QComboBox::currentIndexChanged, this, &ValueDialog::chooseFigure);
    connect(expression_, &QLineEdit::textChanged, this, &ValueDialog::look);
    connect(expression_, &QLineEdit::textEdited, this, &ValueDialog::filter);
    connect(list_, &QListWidget::itemClicked, this, &ValueDialog::takeOffer);
    connect(list_, &QListWidget::itemActivated, this, &ValueDialog::takeOffer);
    connect(fixed_, &QRadioButton::toggled, this, &ValueDialog::look);
    connect(time_, &QDoubleSpinBox::valueChanged, this, [this] {
        fixed_->setChecked(true);
        look();
    });
    connect(digits_, &QSpinBox::valueChanged, this, &ValueDialog::look);
    connect(unit_, &QComboBox::currentIndexChanged, this, &ValueDialog::look);
    chooseFigure();
    look();
    expression_->setFocus();
}

ValueDialog::~ValueDialog() {
    if (asked_)
        document_.media().setDistance(*asked_, this, media::LiveMedia::notNeeded);
}

void ValueDialog::makeForm(const document::ValueUse& now) {
    figure_->setObjectName("figure");
    figure_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    int known = -1;
    for (const ValuedFigure& figure : figures_) {
        figure_->addItem(figure.words);
        if (document_.document().subdocument(figure.id)->name == now.of && !now.of.empty())
            known = figure_->count() - 1;
    }
    // One that is not here is not taken for another: it is to be chosen.
    figure_->setCurrentIndex(known >= 0 || now.of.empty() ? std::max(known, 0) : -1);
    figure_->setPlaceholderText(QString::fromStdString(now.of));
    expression_->setObjectName("expression");
    expression_->setPlaceholderText(tr("Words of the list, or an expression of the figure"));
    const QString written = QString::fromStdString(now.expression);
    expression_->setMaxLength(std::max(static_cast<int>(ipc::longestExpression.most / 4),
                                       static_cast<int>(written.size()))); // bytes, in UTF-8
    expression_->setText(written);
    expression_->setClearButtonEnabled(true);
    expression_->installEventFilter(this);
    list_->setObjectName("offers");
    list_->setAccessibleName(tr("Values of the figure"));
    list_->setMinimumSize(420, 150);
    list_->setFocusPolicy(Qt::NoFocus); // the arrows of the line above choose
    number_->setObjectName("number");
    number_->setWordWrap(true);
    number_->setMinimumHeight(number_->fontMetrics().lineSpacing() * 2);
    number_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* follows = new QRadioButton(tr("As the figure &shows it"), this);
    follows->setObjectName("follows");
    fixed_->setObjectName("fixed");
    (now.time ? fixed_ : follows)->setChecked(true);
    time_->setObjectName("time");
    time_->setDecimals(3);
    time_->setRange(-1e6, 1e6);
    time_->setSuffix(tr(" s"));
    time_->setAccessibleName(tr("Time"));
    time_->setValue(now.time.value_or(0));
    writtenTime_ = now.time;
    shownTime_ = time_->value();
    digits_->setObjectName("digits");
    digits_->setRange(0, std::max(document::mostDecimals, document::mostDigits));
    digits_->setValue(now.digits.count);
    digits_->setAccessibleName(tr("How many digits"));
    unit_->setObjectName("unit");
    unit_->addItems({tr("digits in all"), tr("behind the point")});
    unit_->setCurrentIndex(now.digits.areDecimals ? 1 : 0);
    unit_->setAccessibleName(tr("Which digits"));
    auto* when = new QHBoxLayout;
    for (QWidget* one : std::initializer_list<QWidget*>{follows, fixed_, time_})
        when->addWidget(one);
    when->addStretch();
    auto* digits = new QHBoxLayout;
    digits->addWidget(digits_);
    digits->addWidget(unit_);
    digits->addStretch();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    ok_ = buttons->button(QDialogButtonBox::Ok);
    auto* form = new QFormLayout(this);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("&Figure:"), figure_);
    form->addRow(tr("&Value:"), expression_);
    form->addRow(list_);
    form->addRow(tr("Time:"), when);
    form->addRow(tr("&Digits:"), digits);
    if (auto* label = qobject_cast<QLabel*>(form->labelForField(digits)))
        label->setBuddy(digits_); // a row that is a layout gives it none
    form->addRow(tr("Number:"), number_);
    form->addRow(buttons);
}

media::LiveSubdocument* ValueDialog::live() const {
    const int at = figure_->currentIndex();
    return at < 0 ? nullptr : document_.live(figures_.at(static_cast<std::size_t>(at)).id);
}

sgml::NodeId ValueDialog::figure() const {
    return figures_.at(static_cast<std::size_t>(std::max(figure_->currentIndex(), 0))).element;
}

document::ValueUse ValueDialog::use() const {
    document::ValueUse use{.of = {}, .expression = expression_->text().trimmed().toStdString()};
    use.digits.areDecimals = unit_->currentIndex() == 1;
    use.digits.count = use.digits.areDecimals ? std::min(digits_->value(), document::mostDecimals)
                                              : std::max(digits_->value(), 1);
    if (fixed_->isChecked()) // digits that the field does not show stay, unless it was changed
        use.time = writtenTime_ && time_->value() == shownTime_ ? *writtenTime_ : time_->value();
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
    const QString words = expression_->text().simplified();
    list_->clear();
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
        auto* item = new QListWidgetItem(shown, list_);
        item->setData(Qt::UserRole, expression);
        if (isOne && words == expression)
            list_->setCurrentItem(item);
    }
}

void ValueDialog::takeOffer() {
    if (const QListWidgetItem* item = list_->currentItem())
        expression_->setText(item->data(Qt::UserRole).toString());
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
        const QListWidgetItem* first = list_->item(0);
        if (!first)
            return;
        expression_->setText(first->data(Qt::UserRole).toString());
    }
    QDialog::accept();
}

bool ValueDialog::isComplete() const {
    return !expression_->text().trimmed().isEmpty() && figure_->currentIndex() >= 0;
}

void ValueDialog::setAnswer(Answer answer) {
    const bool isAwaited = answer_ == Answer::awaitedByOk && answer != Answer::awaited;
    answer_ = answer;
    ok_->setEnabled(isComplete() && answer_ != Answer::fault);
    if (isAwaited)
        accept();
}

// The arrows choose while one types, and Enter takes.
bool ValueDialog::eventFilter(QObject* watched, QEvent* event) {
    if (watched == expression_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
        if (step != 0 && list_->count() > 0) {
            list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, list_->count() - 1));
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
        number_->clear();
        return setAnswer(Answer::value);
    }
    const media::Condition condition = asked_->condition();
    const bool comes = condition == media::Condition::starting ||
                       condition == media::Condition::still ||
                       (condition == media::Condition::live && !asked_->hasLoaded());
    if (comes) {
        number_->setText(tr("%1 is starting.").arg(asked_->name()));
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
        number_->setText(
            QString::fromStdString(model::written(read->values[0], use().digits, language_)));
        return setAnswer(Answer::value);
    }
    const std::string fault = read && !read->faults.empty() ? read->faults[0] : std::string();
    const std::string why = read ? fault : std::get<ipc::Error>(outcome).message;
    // A value that the figure offers may have none at this time.
    const bool isFault = !fault.empty() && !isOffered(expression_->text().simplified());
    QString says = why.empty() ? tr("It has no value now.") : QString::fromStdString(why);
    if (const QListWidgetItem* first = list_->item(0); first && isFault)
        says += '\n' + tr("Enter takes %1.").arg(first->data(Qt::UserRole).toString());
    number_->setText(says);
    setAnswer(isFault ? Answer::fault : Answer::value);
}

} // namespace menus
