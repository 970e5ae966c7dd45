#include "properties/property_head.h"

#include "editing/element_values.h"
#include "element_edits/options.h"
#include "frame/readable.h"
#include "frame/typed_field.h"
#include "plain/plain.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <string>
#include <utility>

namespace views {

using editing::Element;

PropertyHead::PropertyHead(SceneDocument& document, ElementCommands& commands, WhenRead& later,
                           std::function<void()> showText, QWidget* parent)
    : QWidget(parent), document_(document), commands_(commands), later_(later) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    auto* line = new QHBoxLayout;
    title_ = plain::label();
    title_->setObjectName(QStringLiteral("propertyTitle"));
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    title_->setWordWrap(true);
    name_ = new QLineEdit;
    name_->setObjectName(QStringLiteral("elementName"));
    name_->setAccessibleName(tr("Name"));
    name_->setPlaceholderText(tr("no name"));
    name_->setToolTip(tr("Its name; another one is written wherever the text mentions it"));
    new TypedField(*name_, document_,
                   {[this](bool) { rename(); },
                    [this] {
                        name_->setModified(false);
                        TypedField::setRefusal(*name_, {});
                        showName();
                        say({});
                    }});
    line_ = new QPushButton;
    line_->setObjectName(QStringLiteral("elementLine"));
    line_->setFlat(true);
    line_->setToolTip(tr("Shows its command in the text"));
    connect(line_, &QPushButton::clicked, this, std::move(showText));
    line->addWidget(title_);
    line->addWidget(name_, 1);
    line->addWidget(line_);
    column->addLayout(line);
    fault_ = plain::label();
    fault_->setObjectName(QStringLiteral("propertyFault"));
    fault_->setWordWrap(true);
    fault_->hide();
    column->addWidget(fault_);
}

QString PropertyHead::title() const { return title_->text(); }

QString PropertyHead::fault() const { return fault_->isHidden() ? QString() : fault_->text(); }

namespace {

// "2 bodies"; "3 elements" of several kinds.
QString countOf(const std::vector<Element>& all) {
    const bool areAlike =
        std::ranges::count(all, all.front().kind, &Element::kind) == std::ssize(all);
    const std::string one = areAlike ? editing::wordOf(all.front().kind) : "element";
    QString word = QString::fromStdString(one);
    if (word.endsWith('y'))
        word.replace(word.size() - 1, 1, QStringLiteral("ie"));
    return QStringLiteral("%1 %2s").arg(all.size()).arg(word);
}

} // namespace

void PropertyHead::showElements(const std::vector<Element>& all) {
    shown_ = all;
    const scene::Scene& scene = *document_.shown().scene;
    const bool isOne = all.size() == 1;
    const editing::CommandHint* hint = isOne ? &editing::hintOf(scene, all.front()) : nullptr;
    const scene::Source* source = isOne ? editing::sourceOf(scene, all.front()) : nullptr;
    QString title;
    if (all.empty())
        title = tr("Nothing is selected. A click in the picture selects a body.");
    else if (isOne)
        title = plain::ours(QString::fromStdString(
            std::string(hint->name == "spring" ? hint->name : editing::wordOf(all.front().kind))));
    else
        title = countOf(all);
    if (!title.isEmpty())
        title[0] = title[0].toUpper();
    title_->setText(title);
    name_->setVisible(isOne && hint->named);
    showName();
    line_->setVisible(source && source->line > 0);
    if (source)
        line_->setText(plain::caption(tr("Line %1").arg(source->line)));
    showFault();
}

void PropertyHead::showName() {
    if (shown_.size() != 1)
        name_->setText({});                                          // clear() would count as typed
    else if (!name_->isModified() && shown_ == document_.selected()) // they are in the scene
        name_->setText(
            QString::fromStdString(editing::nameOf(*document_.shown().scene, shown_.front())));
}

void PropertyHead::showFault() {
    const QString why =
        shown_.empty() || document_.isPreview() ? QString() : document_.whyNotCurrent();
    const bool isFault = document_.hasErrors() && !why.isEmpty();
    fault_->setText(isFault ? why : said_);
    fault_->setVisible(!fault_->text().isEmpty());
    QPalette palette = this->palette();
    palette.setColor(QPalette::WindowText,
                     readable(QColor(200, 40, 30), palette.color(QPalette::Window)));
    fault_->setPalette(palette);
    name_->setReadOnly(isFault);
}

void PropertyHead::say(const QString& why) {
    said_ = why;
    showFault();
}

QString PropertyHead::refusal() const {
    const QString why = TypedField::refusalOf(*name_);
    return why.isEmpty() ? why : tr("Name: %1").arg(why);
}

void PropertyHead::forget() {
    said_.clear();
    ++forgotten_;
    TypedField::setRefusal(*name_, {});
    name_->setModified(false);
}

void PropertyHead::rename() {
    if (shown_.size() != 1 || shown_ != document_.selected()) // the name is another one's for now
        return;
    const QString before =
        QString::fromStdString(editing::nameOf(*document_.shown().scene, shown_.front()));
    const auto answer = [this, before, name = name_->text(),
                         when = forgotten_](const QString& why) {
        if (when != forgotten_) { // something else is selected now
            if (!why.isEmpty())
                say(meant(before, tr("Name: %1").arg(why)));
            return;
        }
        if (name_->text() == name) {
            if (!why.isEmpty())
                name_->setText(before);
            name_->setModified(false);
        }
        TypedField::setRefusal(*name_, why);
        say(why);
        Q_EMIT renamed();
    };
    later_.take(name_, [this, now = following(document_, shown_), name = name_->text(), answer] {
        if (const auto element = now()) // else it was deleted meanwhile
            commands_.rename(element->front(), name, answer);
    });
}

QString PropertyHead::meant(const QString& name, const QString& why) {
    return why.isEmpty() || name.isEmpty() ? why : tr("%1, %2").arg(name, why);
}

} // namespace views
