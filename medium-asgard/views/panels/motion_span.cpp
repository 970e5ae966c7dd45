#include "panels/motion_span.h"

#include "editing/number_text.h"
#include "editing/value_edit.h"
#include "element_edits/creation.h"
#include "frame/typed_field.h"
#include "plain/plain.h"
#include "script/numbers.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QTimer>
#include <QToolTip>

#include <string_view>

namespace views {

namespace {

constexpr const char* startOption = "-start";
constexpr const char* finishOption = "-finish";

QString written(double value) { return QString::fromStdString(editing::numberText(value, 0)); }

} // namespace

MotionSpan::MotionSpan(SceneDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), later_(document) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    start_ = addField(tr("Motion from"), tr("Start of the motion"),
                      tr("When the motion begins, in seconds"), startOption);
    finish_ = addField(tr("to"), tr("End of the motion"), tr("When the motion ends, in seconds"),
                       finishOption);
    row->addWidget(plain::label(tr("s")));
    row->addStretch();
    connect(&document_, &SceneDocument::sceneChanged, this, &MotionSpan::show);
    show();
}

QLineEdit* MotionSpan::addField(const QString& label, const QString& name, const QString& tip,
                                const char* option) {
    auto* field = new QLineEdit;
    field->setAlignment(Qt::AlignRight);
    field->setFixedWidth(field->fontMetrics().horizontalAdvance(QStringLiteral("0000.000")) + 14);
    field->setToolTip(plain::tip(tip));
    field->setObjectName(option + 1); // without its hyphen
    field->setAccessibleName(name);
    new TypedField(*field, document_,
                   {[this, field, option](bool) {
                        later_.take(field, [this, field, option] { take(field, option); });
                    },
                    [this, field] {
                        field->setModified(false);
                        show();
                    },
                    [this] { Q_EMIT left(); }});
    auto* before = plain::label(label);
    before->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    layout()->addWidget(before);
    layout()->addWidget(field);
    return field;
}

void MotionSpan::show() {
    const scene::Simulator& simulator = document_.shown().scene->simulator;
    for (const auto& [field, value] :
         {std::pair(start_, simulator.start), std::pair(finish_, simulator.finish)})
        if (!field->isModified())
            field->setText(written(value));
}

void MotionSpan::take(QLineEdit* field, const char* option) {
    if (!field->isModified())
        return;
    field->setModified(false);
    const auto value = script::decimalNumber(field->text().trimmed().toStdString());
    const QString why =
        value ? change(option, *value) : tr("\"%1\" is not a decimal number.").arg(field->text());
    show();
    TypedField::setRefusal(*field, why);
    if (why.isEmpty())
        return;
    Q_EMIT refused(why);
    // The keyboard goes elsewhere first, and a tip goes with it.
    QTimer::singleShot(0, field, [field, why] {
        QToolTip::showText(field->mapToGlobal(field->rect().bottomLeft()), plain::tip(why), field);
    });
}

QString MotionSpan::change(const char* option, double value) {
    if (QString fault = document_.whyNotCurrent(); !fault.isEmpty())
        return fault;
    const auto& scene = document_.shown().scene;
    const bool isStart = option == std::string_view(startOption);
    const scene::Simulator& now = scene->simulator;
    if (value == (isStart ? now.start : now.finish))
        return {};
    if (isStart ? value >= now.finish : value <= now.start)
        return isStart ? tr("The motion ends at %1 s: its start must be before that.")
                             .arg(written(now.finish))
                       : tr("The motion begins at %1 s: its end must be after that.")
                             .arg(written(now.start));
    const QString label = isStart ? tr("Start of the Motion") : tr("End of the Motion");
    const std::string& text = document_.text();
    if (!now.source) {
        const editing::NewElement made{
            editing::Kind::simulator, "", {option, editing::numberText(value, 0)}, {}};
        document_.setText(text::applied(text, editing::created(text, *scene, {made})), label);
        return {};
    }
    editing::Wish wish;
    wish.element = {editing::Kind::simulator, 0};
    wish.option = option;
    wish.values = {value};
    wish.absent = {isStart ? scene::Simulator().start : scene::Simulator().finish};
    const editing::Answer answer = editing::Mapper(text, scene).answer(wish);
    if (answer.possible())
        document_.setText(text::applied(text, answer.edits), label);
    return QString::fromStdString(answer.reason);
}

} // namespace views
