#include "viewers/motion_span.h"

#include "editing/creation.h"
#include "editing/number_text.h"
#include "editing/value_edit.h"
#include "plain/plain.h"
#include "script/numbers.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QToolTip>

#include <string_view>

namespace views {

namespace {

constexpr const char* startOption = "-start";
constexpr const char* finishOption = "-finish";

QString written(double value) { return QString::fromStdString(editing::numberText(value, 0)); }

// A field in which nothing was typed has nothing to undo: the key is the window's.
bool isOthersUndo(const QLineEdit& field, const QEvent& event) {
    if (event.type() != QEvent::ShortcutOverride || field.isModified())
        return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
}

} // namespace

MotionSpan::MotionSpan(SceneDocument& document, QWidget* parent)
    : QWidget(parent), document_(document) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    start_ = addField(tr("Motion from"), tr("Start of the motion"),
                      tr("When the motion begins, in seconds"), startOption);
    finish_ = addField(tr("to"), tr("End of the motion"), tr("When the motion ends, in seconds"),
                       finishOption);
    row->addWidget(plain::label(tr("s")));
    row->addStretch();
    connect(&document_, &SceneDocument::sceneChanged, this, [this] {
        show();
        for (const auto& [field, option] :
             {std::pair(start_, startOption), std::pair(finish_, finishOption)})
            if (!field->hasFocus())
                take(field, option);
    });
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
    field->installEventFilter(this);
    connect(field, &QLineEdit::editingFinished, this,
            [this, field, option] { take(field, option); });
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
    // While the text is being read it stays, and is taken then.
    if (!field->isModified() || (!document_.sceneIsCurrent() && !document_.hasErrors()))
        return;
    field->setModified(false);
    const auto value = script::decimalNumber(field->text().trimmed().toStdString());
    const QString why =
        value ? change(option, *value) : tr("\"%1\" is not a decimal number.").arg(field->text());
    show();
    if (!why.isEmpty())
        QToolTip::showText(field->mapToGlobal(field->rect().bottomLeft()), plain::tip(why), field);
    field->setProperty("refusal", why);
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

void MotionSpan::takeBoth() {
    take(start_, startOption);
    take(finish_, finishOption);
}

void MotionSpan::settleAll(const SceneDocument& document) {
    for (QWidget* window : QApplication::topLevelWidgets())
        for (MotionSpan* span : window->findChildren<MotionSpan*>())
            if (&span->document_ == &document)
                span->takeBoth();
}

// A press beside the field, or a shortcut, is what one does with what was typed.
bool MotionSpan::leavesField(QObject* watched, const QEvent& event) const {
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (event.type() == QEvent::Shortcut)
        return true;
    return event.type() == QEvent::MouseButtonPress && widget && widget->window() == window() &&
           widget != start_ && widget != finish_;
}

// All of the program's events are looked at only while one of the fields has the keyboard.
void MotionSpan::watch(QEvent::Type focus) {
    if (focus == QEvent::FocusIn)
        qApp->installEventFilter(this);
    else if (focus == QEvent::FocusOut)
        qApp->removeEventFilter(this);
}

// Escape leaves the field as it was, Return takes it; neither is the window's then.
bool MotionSpan::eventFilter(QObject* watched, QEvent* event) {
    if (watched != start_ && watched != finish_) {
        if (leavesField(watched, *event) && (start_->isModified() || finish_->isModified())) {
            takeBoth();
            Q_EMIT left();
        }
        return false;
    }
    watch(event->type());
    auto* field = static_cast<QLineEdit*>(watched);
    if (isOthersUndo(*field, *event)) {
        event->ignore();
        return true;
    }
    const bool asks = event->type() == QEvent::ShortcutOverride;
    if (!asks && event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key != Qt::Key_Escape && key != Qt::Key_Return && key != Qt::Key_Enter)
        return QWidget::eventFilter(watched, event);
    event->accept();
    if (asks)
        return true;
    if (key == Qt::Key_Escape)
        field->setModified(false);
    takeBoth();
    show();
    Q_EMIT left();
    return true;
}

} // namespace views
