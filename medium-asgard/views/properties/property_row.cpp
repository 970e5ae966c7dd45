#include "properties/property_row.h"

#include "frame/readable.h"
#include "frame/typed_field.h"
#include "offers/offer_list.h"
#include "plain/plain.h"
#include "script/numbers.h"
#include "script/svg_colors.h"

#include <QColorDialog>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPainter>
#include <QStyleOptionFrame>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace views {

namespace {

using editing::Wants;

constexpr int fieldsApart = 3;
constexpr const char* usualNumber = "-1.234567"; // is seen whole where there is room
constexpr const char* leastNumber = "-1.2345";   // is seen whole in any window

bool isChosen(Wants wants) {
    return wants == Wants::flag || wants == Wants::choice || wants == Wants::body ||
           wants == Wants::shapeSet || wants == Wants::trajectory || wants == Wants::joint;
}

// #rrggbb, a name, or three numbers from 0 to 1.
QColor colorOf(const std::string& text) {
    if (const auto named = script::namedColor(text))
        return QColor::fromRgbF(named->red, named->green, named->blue);
    if (text.starts_with('#'))
        return QColor::fromString(QString::fromStdString(text));
    const QStringList parts = QString::fromStdString(text).split(' ', Qt::SkipEmptyParts);
    double rgb[3] = {};
    for (int i = 0; i < 3; ++i) {
        const auto number =
            parts.size() == 3 ? script::decimalNumber(parts[i].toStdString()) : std::nullopt;
        if (!number)
            return {};
        rgb[i] = std::clamp(*number, 0.0, 1.0);
    }
    return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
}

// A caption may break before its unit, and not in it.
QString withUnit(const QString& caption, QString unit) {
    constexpr QChar noBreak(0x00A0), joiner(0x2060);
    unit.replace(' ', noBreak).replace(QStringLiteral("/"), QStringLiteral("/") + joiner);
    return unit.isEmpty() ? caption : QStringLiteral("%1, %2").arg(caption, unit);
}

} // namespace

PropertyRow::PropertyRow(const SceneDocument& document, const editing::OptionHint& option,
                         const QString& caption, std::size_t most, QGridLayout& grid,
                         QObject* parent)
    : QObject(parent), option_(option), name_(caption), caption_(plain::label(caption)),
      fault_(plain::label()), offers_(new QVBoxLayout) {
    const int row = grid.rowCount();
    const QString tip = QString::fromUtf8(option.name.data(), option.name.size()) +
                        QStringLiteral(": ") +
                        QString::fromUtf8(option.words.data(), option.words.size());
    caption_->setToolTip(plain::tip(tip));
    caption_->setWordWrap(true);
    grid.addWidget(caption_, row, 0);
    auto* line = new QHBoxLayout;
    line->setSpacing(fieldsApart);
    if (isChosen(option.wants))
        addBox(*line, caption);
    else
        addFields(document, *line, caption, most);
    if (option.wants == Wants::color)
        addColorButton(*line);
    grid.addLayout(line, row, 1);
    auto* below = new QVBoxLayout;
    below->setSpacing(3);
    fault_->setWordWrap(true);
    fault_->setAccessibleName(tr("Why it is not taken"));
    fault_->hide();
    below->addWidget(fault_);
    below->addLayout(offers_);
    grid.addLayout(below, row + 1, 0, 1, 2);
}

namespace {

// In which these words are seen whole.
int widthOf(const QLineEdit& field, const char* words) {
    QStyleOptionFrame option;
    option.initFrom(&field);
    option.lineWidth = field.style()->pixelMetric(QStyle::PM_DefaultFrameWidth, &option, &field);
    constexpr int beside = 2; // between the frame and the words, as QLineEdit has it
    const QSize whole(field.fontMetrics().horizontalAdvance(QLatin1String(words)) + 2 * beside +
                          field.fontMetrics().averageCharWidth() / 2,
                      field.fontMetrics().height());
    return field.style()->sizeFromContents(QStyle::CT_LineEdit, &option, whole, &field).width();
}

} // namespace

int PropertyRow::widthOfFields(const QWidget& form, bool atLeast) {
    QLineEdit field;
    field.setFont(form.font());
    return 3 * widthOf(field, atLeast ? leastNumber : usualNumber) + 2 * fieldsApart;
}

void PropertyRow::addFields(const SceneDocument& document, QHBoxLayout& line,
                            const QString& caption, std::size_t most) {
    static const char* const axes[] = {"x", "y", "z"};
    for (std::size_t i = 0; i < most; ++i) {
        auto* field = new QLineEdit;
        const QString part = most == 1   ? QString()
                             : most == 3 ? QStringLiteral(" ") + QString::fromLatin1(axes[i])
                             : i == 0    ? tr(" degrees")
                                         : tr(" axis ") + QString::fromLatin1(axes[i - 1]);
        field->setObjectName(QString::fromUtf8(option_.name.data(), option_.name.size()) +
                             (most == 4 ? QStringLiteral("turn") : QString()) +
                             (most == 1 ? QString() : QString::number(i + 1)));
        field->setAccessibleName(caption + part);
        field->setMinimumWidth(most == 1 ? 80 : most == 3 ? widthOf(*field, leastNumber) : 36);
        new TypedField(
            *field, document,
            {[this](bool asked) { finish(asked); }, [this, field] { bringBack(*field); }});
        line.addWidget(field, 1);
        fields_.push_back(field);
    }
}

void PropertyRow::addBox(QHBoxLayout& line, const QString& caption) {
    box_ = new QComboBox;
    box_->setObjectName(QString::fromUtf8(option_.name.data(), option_.name.size()));
    box_->setAccessibleName(caption);
    box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box_->setMinimumContentsLength(6);
    box_->setFocusPolicy(Qt::StrongFocus);
    box_->installEventFilter(this);
    if (option_.wants == Wants::flag) {
        const bool isNoElse = option_.choices == "0";
        box_->addItem(isNoElse ? tr("no") : tr("as by default"), QString());
        box_->addItem(tr("yes"), QStringLiteral("1"));
        if (!isNoElse)
            box_->addItem(tr("no"), QStringLiteral("0"));
    } else if (option_.wants == Wants::choice) {
        setChoices(QString::fromUtf8(option_.choices.data(), option_.choices.size())
                       .split(' ', Qt::SkipEmptyParts));
    }
    connect(box_, &QComboBox::activated, this,
            [this] { Q_EMIT entered({box_->currentData().toString().toStdString()}); });
    line.addWidget(box_, 1);
}

void PropertyRow::addColorButton(QHBoxLayout& line) {
    color_ = new QToolButton;
    color_->setObjectName(QStringLiteral("color"));
    color_->setAccessibleName(tr("Choose a colour"));
    color_->setToolTip(tr("Choose a colour"));
    connect(color_, &QToolButton::clicked, this, &PropertyRow::chooseColor);
    line.addWidget(color_);
}

void PropertyRow::chooseColor() {
    const QColor now = colorOf(fields_[0]->text().toStdString());
    const QColor color =
        QColorDialog::getColor(now.isValid() ? now : QColor(178, 178, 178), color_, tr("Colour"));
    if (color.isValid())
        Q_EMIT entered({color.name().toStdString()});
}

void PropertyRow::showColor() {
    if (!color_)
        return;
    const QColor color = colorOf(fields_[0]->text().toStdString());
    QPixmap swatch(32, 32);
    swatch.fill(Qt::transparent);
    QPainter painter(&swatch);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(color_->palette().color(QPalette::Mid), 2));
    if (color.isValid())
        painter.setBrush(color);
    painter.drawRoundedRect(QRectF(2, 2, 28, 28), 5, 5);
    color_->setIcon(QIcon(swatch));
}

void PropertyRow::setNames(const QStringList& names) {
    name_ = names.size() == 1 ? names.front() : tr("Size");
    setUnit(QStringLiteral("m"));
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const auto at = static_cast<qsizetype>(i);
        fields_[i]->setAccessibleName(at < names.size() ? names[at] : name_);
        fields_[i]->setPlaceholderText(at < names.size() ? names[at] : QString());
    }
}

void PropertyRow::setUnit(const QString& unit) {
    caption_->setText(plain::ours(withUnit(name_, unit)));
}

void PropertyRow::setVisible(bool visible) {
    caption_->setVisible(visible);
    for (QLineEdit* field : fields_)
        field->setVisible(visible);
}

void PropertyRow::setChoices(const QStringList& choices) {
    if (!box_ || option_.wants == Wants::flag ||
        (box_->count() > 0 && box_->property("choices").toStringList() == choices))
        return;
    const QVariant chosen = box_->currentData();
    box_->setProperty("choices", choices);
    box_->clear();
    box_->addItem(tr("none"), QString());
    for (const QString& choice : choices)
        box_->addItem(choice, choice);
    box_->setCurrentIndex(std::max(0, box_->findData(chosen)));
}

void PropertyRow::show(const PropertyParts& parts, const QString& absent, const QString& source,
                       const std::vector<DifferingPart>& differing) {
    shown_ = parts;
    const auto different = [&](std::size_t i) {
        return i < differing.size() ? differing[i] : DifferingPart{tr("different"), {}};
    };
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        fields_[i]->setVisible(i < parts.size());
        if (i >= parts.size() || fields_[i]->isModified())
            continue;
        const QString text = QString::fromStdString(parts[i].value_or(""));
        if (fields_[i]->text() != text) {
            fields_[i]->setText(text);
            fields_[i]->setCursorPosition(0);
        }
        fields_[i]->setPlaceholderText(parts[i] ? absent : different(i).brief);
        const QString tip = !parts[i]          ? different(i).each
                            : source.isEmpty() ? QString()
                                               : tr("The text has: %1").arg(source);
        fields_[i]->setToolTip(tip.isEmpty() ? QString() : plain::tip(tip));
    }
    showColor();
    if (!box_)
        return;
    QString value = QString::fromStdString(parts.empty() || !parts[0] ? std::string() : *parts[0]);
    if (option_.wants == Wants::flag && value == QLatin1String(option_.choices))
        value.clear(); // it is written what it is anyway
    int index = parts.empty() || !parts[0] ? -1 : box_->findData(value);
    if (index < 0 && !value.isEmpty()) {
        box_->addItem(value, value);
        index = box_->count() - 1;
    }
    box_->setCurrentIndex(index);
    box_->setPlaceholderText(tr("different"));
    const QString each = parts.empty() || parts[0] ? QString() : different(0).each;
    box_->setToolTip(each.isEmpty() ? QString() : plain::tip(each));
}

void PropertyRow::setEnabled(bool enabled) {
    for (QLineEdit* field : fields_)
        field->setReadOnly(!enabled);
    if (box_)
        box_->setEnabled(enabled);
    if (color_)
        color_->setEnabled(enabled);
}

void PropertyRow::setFault(const QString& why) {
    why_ = why;
    showFault();
}

void PropertyRow::setNote(const QString& note) {
    if (note == note_)
        return;
    note_ = note;
    showFault();
}

void PropertyRow::setRemark(const QString& remark) {
    if (remark == remark_)
        return;
    remark_ = remark;
    showFault();
}

void PropertyRow::showFault() {
    const QString why = fault();
    fault_->setText(why.isEmpty() ? remark_ : why);
    fault_->setVisible(!fault_->text().isEmpty());
    fault_->setForegroundRole(why.isEmpty() ? QPalette::PlaceholderText : QPalette::WindowText);
    QPalette palette = fault_->parentWidget() ? fault_->parentWidget()->palette() : QPalette();
    palette.setColor(QPalette::WindowText,
                     readable(QColor(200, 40, 30), palette.color(QPalette::Window)));
    fault_->setPalette(palette);
    for (QLineEdit* field : fields_) {
        field->setAccessibleDescription(why);
        TypedField::setRefusal(*field, field->isModified() ? why_ : QString());
    }
}

QString PropertyRow::fault() const { return why_.isEmpty() ? note_ : why_; }

void PropertyRow::setOffers(const std::string& text, const std::vector<editing::Offer>& offers,
                            const std::function<void(const text::Edits& edits)>& take) {
    showOffers(*offers_, text, offers, take);
}

void PropertyRow::taken(const PropertyParts& entered) {
    for (std::size_t i = 0; i < fields_.size() && i < entered.size(); ++i)
        if (entered[i] && fields_[i]->text().toStdString() == *entered[i])
            fields_[i]->setModified(false);
    if (entered_ == entered)
        entered_.clear();
    refused_.clear();
    setFault({});
    setOffers({}, {}, {});
}

void PropertyRow::refuse(const PropertyParts& entered, const QString& why) {
    if (entered_ == entered)
        entered_.clear();
    refused_ = entered;
    setFault(why);
}

void PropertyRow::forget() {
    for (QLineEdit* field : fields_)
        field->setModified(false);
    taken(entered_);
}

void PropertyRow::finish(bool asked) {
    PropertyParts parts(shown_.size());
    bool isChanged = false;
    for (std::size_t i = 0; i < parts.size() && i < fields_.size(); ++i) {
        const std::string typed = fields_[i]->text().toStdString();
        if (!fields_[i]->isModified() || (shown_[i] && typed == *shown_[i]))
            continue;
        parts[i] = typed;
        isChanged = true;
    }
    if (!isChanged || parts == entered_ || (!asked && parts == refused_)) // it was said why
        return;
    entered_ = parts;
    Q_EMIT entered(parts);
}

void PropertyRow::bringBack(QLineEdit& field) {
    const auto i = static_cast<std::size_t>(std::ranges::find(fields_, &field) - fields_.begin());
    field.setModified(false);
    field.setText(i < shown_.size() ? QString::fromStdString(shown_[i].value_or("")) : QString());
    refused_.clear();
    setFault({});
    setOffers({}, {}, {});
}

// A wheel over a box that has no keyboard scrolls what is around.
bool PropertyRow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Wheel || box_->hasFocus())
        return QObject::eventFilter(watched, event);
    event->ignore();
    return true;
}

} // namespace views
