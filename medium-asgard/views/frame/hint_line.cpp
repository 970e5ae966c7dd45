#include "frame/hint_line.h"

#include "plain/plain.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QResizeEvent>

namespace views {

HintLine::HintLine(QWidget* parent) : QWidget(parent), shown_(plain::label({}, this)) {
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    shown_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    shown_->setForegroundRole(QPalette::PlaceholderText);
    shown_->setAccessibleName(tr("What the buttons do here"));
    auto* const layout = new QHBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(shown_);
}

QString HintLine::text() const { return shown_->text(); }

void HintLine::say(const QString& parts) {
    all_ = parts;
    fit();
}

void HintLine::fit() {
    const QString between = QStringLiteral("  ·  ");
    const auto fits = [this](const QString& text) {
        return shown_->fontMetrics().horizontalAdvance(text) <= width();
    };
    QStringList parts = all_.split(between);
    QString text = all_;
    while (!fits(text) && parts.size() > 1) {
        parts.removeLast();
        text = parts.join(between) + between + QStringLiteral("…");
    }
    if (!fits(text))
        text = shown_->fontMetrics().elidedText(parts.front(), Qt::ElideRight, width());
    shown_->setText(text);
    setToolTip(text == all_ ? QString() : plain::tip(all_));
}

void HintLine::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

} // namespace views
