#include "plain/plain.h"

#include <QAbstractButton>
#include <algorithm>

namespace plain {

QLabel* label(const QString& text, QWidget* parent) {
    auto* made = new QLabel(parent);
    made->setTextFormat(Qt::PlainText);
    made->setText(text);
    return made;
}

QLabel* markupLabel(QWidget* parent) {
    auto* made = new QLabel(parent);
    made->setTextFormat(Qt::RichText);
    return made;
}

QString tip(const QString& text) {
    return Qt::mightBeRichText(text) ? Qt::convertFromPlainText(text) : text;
}

QString caption(const QString& text) {
    QString line = text;
    for (QChar& character : line)
        if (character < QChar(' '))
            character = QChar(' ');
    return line.replace(QLatin1String("&"), QLatin1String("&&"));
}

QString title(const QString& text) {
    return QString(text).replace(QLatin1String("[*]"), QLatin1String("[*][*]"));
}

Message::Message(Icon icon, const QString& title, const QString& text, StandardButtons buttons,
                 QWidget* parent)
    : QMessageBox(icon, plain::title(title), {}, buttons, parent) {
    setTextFormat(Qt::PlainText);
    setText(text);
    giveKeys();
}

// Some desktops give the buttons of a question keys and others do not: each has one everywhere.
void Message::giveKeys() {
    QString taken;
    for (const QAbstractButton* one : buttons())
        taken += one->text().section('&', 1).left(1);
    for (QAbstractButton* one : buttons()) {
        const QString words = one->text();
        const auto isFree = [&](QChar c) {
            return c.isLetter() && !taken.contains(c, Qt::CaseInsensitive);
        };
        const auto key = std::ranges::find_if(words, isFree);
        if (words.contains('&') || key == words.end())
            continue;
        taken += *key;
        one->setText(QString(words).insert(key - words.begin(), '&'));
    }
}

void Message::setSecondText(const QString& text) {
    setInformativeText(QStringLiteral(" ")); // Qt makes the label with it, for any format
    if (auto* second = findChild<QLabel*>(QStringLiteral("qt_msgbox_informativelabel"))) {
        second->setTextFormat(Qt::PlainText);
        setInformativeText(text);
    }
}

void Message::setMarkup(const QString& markup) {
    setTextFormat(Qt::RichText);
    setText(markup);
}

void Message::tell(Icon icon, QWidget* parent, const QString& title, const QString& text) {
    Message(icon, title, text, Ok, parent).exec();
}

QMessageBox::StandardButton Message::ask(Icon icon, QWidget* parent, const QString& title,
                                         const QString& text, StandardButtons buttons,
                                         StandardButton byDefault) {
    Message box(icon, title, text, buttons, parent);
    if (byDefault != NoButton)
        box.setDefaultButton(byDefault);
    return static_cast<StandardButton>(box.exec());
}

} // namespace plain
