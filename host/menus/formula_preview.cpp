#include "menus/formula_preview.h"

#include "formulas/paint.h"

#include <QMouseEvent>
#include <QPainter>

namespace menus {

FormulaPreview::FormulaPreview(QWidget* parent) : QWidget(parent) {
    setObjectName("preview");
    setMinimumHeight(110);
    setMouseTracking(true);
}

void FormulaPreview::show(formulas::Formula formula, formulas::Style style) {
    formula_ = std::move(formula);
    style_ = style;
    setAccessibleName(QString::fromStdString(formulas::spoken(formula_)));
    update();
}

// As on paper: black on white, also where the desktop is dark.
void FormulaPreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), Qt::white);
    painter.setPen(QColor(0xd0, 0xd4, 0xda));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    const auto& font = formulas::Font::standard();
    if (!font) {
        painter.setPen(Qt::black);
        painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                         formulas::Font::missing());
        return;
    }
    if (const std::optional<Laid> all = laid())
        formulas::paint(painter, all->box, all->at, *font, Qt::black, QColor(0xc0, 0x1c, 0x28));
}

std::optional<FormulaPreview::Laid> FormulaPreview::laid() const {
    const auto& font = formulas::Font::standard();
    if (!font || formula_.nodes.empty())
        return std::nullopt;
    constexpr double usual = 26, inset = 12;
    const auto setAt = [&](double size) {
        return formulas::whole(
            formulas::typeset(formula_, style_, size, *font, formulas::Empty::framed));
    };
    formulas::Set set = setAt(usual);
    const double high = set.ascent + set.descent;
    const double fits = std::min((width() - 2 * inset) / std::max(set.width, 1.0),
                                 (height() - 2 * inset) / std::max(high, 1.0));
    if (fits < 1)
        set = setAt(usual * fits);
    if (set.pieces.empty())
        return std::nullopt;
    return Laid{std::move(set.pieces.front().box),
                {(width() - set.width) / 2, (height() + set.ascent - set.descent) / 2}};
}

std::optional<QPointF> FormulaPreview::frameAt(std::size_t place) const {
    if (const std::optional<Laid> all = laid())
        for (const formulas::PlacedPart& part : all->box.waiting)
            if (part.place == place)
                return part.frame.center() + all->at;
    return std::nullopt;
}

// Frames in scripts are small: a little beside one is in it.
std::optional<std::size_t> FormulaPreview::placeAt(QPointF point) const {
    constexpr double near = 3;
    if (const std::optional<Laid> all = laid())
        for (const formulas::PlacedPart& part : all->box.waiting)
            if (part.frame.translated(all->at).adjusted(-near, -near, near, near).contains(point))
                return part.place;
    return std::nullopt;
}

void FormulaPreview::mouseMoveEvent(QMouseEvent* event) {
    setCursor(placeAt(event->position()) ? Qt::IBeamCursor : Qt::ArrowCursor);
}

void FormulaPreview::mousePressEvent(QMouseEvent* event) {
    if (const std::optional<std::size_t> place = placeAt(event->position()))
        Q_EMIT wantsToWrite(*place);
}

} // namespace menus
