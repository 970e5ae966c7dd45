#include "frame/hint_line.h"

#include "plain/plain.h"

#include <QLabel>
#include <QResizeEvent>

#include <algorithm>

namespace views {

namespace {

// Most texts of a picture have no more.
constexpr int usualLetters = 130;
constexpr int mostLines = 3;

} // namespace

HintLine::HintLine(QWidget* parent) : QWidget(parent), shown_(plain::label({}, this)) {
    QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    shown_->setWordWrap(true);
    shown_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    shown_->setForegroundRole(QPalette::PlaceholderText);
    shown_->setAccessibleName(tr("What the buttons do here"));
}

QString HintLine::text() const { return shown_->text(); }

void HintLine::say(const QString& parts, bool isFault) {
    all_ = parts;
    shown_->setForegroundRole(isFault ? QPalette::WindowText : QPalette::PlaceholderText);
    fit();
}

int HintLine::heightForWidth(int width) const {
    const QFontMetrics metrics = shown_->fontMetrics();
    const int usual = usualLetters * metrics.averageCharWidth();
    const int lines = std::clamp((usual + width - 1) / std::max(width, 1), 1, mostLines);
    return metrics.height() + (lines - 1) * metrics.lineSpacing();
}

QSize HintLine::sizeHint() const { return {0, heightForWidth(width())}; }

void HintLine::fit() {
    const QString between = QStringLiteral("  ·  ");
    const QFontMetrics metrics = shown_->fontMetrics();
    // On a screen with finer pixels letters are a little wider or narrower than told here.
    const QRect room(0, 0, width() - width() / 50, std::max(height(), metrics.height()));
    const auto fits = [&](const QString& text) {
        const QRect taken =
            metrics.boundingRect(room, Qt::TextWordWrap | Qt::AlignTop | Qt::AlignLeft, text);
        return taken.height() <= room.height() && taken.width() <= room.width();
    };
    QStringList parts = all_.split(between);
    QString text = all_;
    while (!fits(text) && parts.size() > 1) {
        parts.removeLast();
        text = parts.join(between) + between + QStringLiteral("…");
    }
    for (QString words = parts.front(); !fits(text) && !words.isEmpty();) {
        words.chop(1);
        text = words.trimmed() + QStringLiteral("…");
    }
    shown_->setText(text);
    setToolTip(text == all_ ? QString() : plain::tip(all_));
}

void HintLine::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (height() != heightForWidth(width()))
        updateGeometry();        // lines come and go with the width
    shown_->setGeometry(rect()); // a layout's height would follow the text
    fit();
}

} // namespace views
