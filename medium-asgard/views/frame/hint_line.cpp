#include "frame/hint_line.h"

#include "plain/plain.h"

#include <QResizeEvent>

namespace views {

HintLine::HintLine(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    setForegroundRole(QPalette::PlaceholderText);
}

void HintLine::say(const QString& parts) {
    all_ = parts;
    fit();
}

void HintLine::fit() {
    const QString between = QStringLiteral("  ·  ");
    const auto fits = [this](const QString& text) {
        return fontMetrics().horizontalAdvance(text) <= contentsRect().width();
    };
    QStringList parts = all_.split(between);
    QString text = all_;
    while (!fits(text) && parts.size() > 1) {
        parts.removeLast();
        text = parts.join(between) + between + QStringLiteral("…");
    }
    if (!fits(text))
        text = fontMetrics().elidedText(parts.front(), Qt::ElideRight, contentsRect().width());
    setText(text);
    setToolTip(text == all_ ? QString() : plain::tip(all_));
}

void HintLine::resizeEvent(QResizeEvent* event) {
    QLabel::resizeEvent(event);
    fit();
}

} // namespace views
