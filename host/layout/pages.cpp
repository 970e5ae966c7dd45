#include "layout/pages.h"

#include "layout/paginator.h"
#include "paragraphs/measure.h"
#include "paragraphs/typeface.h"

#include <utility>

namespace layout {

using paragraphs::Objects;
using paragraphs::twipsPerPoint;

std::vector<TextPiece> Pages::headersOf(std::size_t page) const {
    return headers ? headers->on(page, pages.size()) : std::vector<TextPiece>{};
}

std::vector<PlacedSubdocument> Pages::subdocuments() const {
    std::vector<PlacedSubdocument> result;
    for (std::size_t i = 0; i < pages.size(); ++i)
        for (const PlacedObject& object : pages[i]->objects)
            if (object.subdocument)
                result.push_back({object.subdocument, i, object.rect});
    return result;
}

std::vector<OutlineEntry> Pages::outline() const {
    std::vector<OutlineEntry> result;
    for (std::size_t i = 0; i < pages.size(); ++i)
        for (const Heading& heading : pages[i]->headings)
            result.push_back({i, heading});
    return result;
}

std::optional<std::pair<std::size_t, double>> Pages::anchor(const std::string& name) const {
    for (std::size_t i = pages.size(); i-- > 0;)
        for (const auto& [anchor, top] : pages[i]->anchors)
            if (anchor == name)
                return std::pair(i, top);
    return std::nullopt;
}

Pagination::Pagination(const ModelPointer& model, const Objects& objects, const Pages& old)
    : paginator_(std::make_unique<Paginator>(model, objects, old)) {}

Pagination::~Pagination() = default;

bool Pagination::step() { return paginator_->step(); }
Pages Pagination::pages() const { return paginator_->pages(); }
std::size_t Pagination::count() const { return paginator_->count(); }
Pages Pagination::take() { return paginator_->take(); }

Pages layOut(const ModelPointer& model, const Objects& objects) {
    return relaid({}, model, objects);
}

Pages relaid(const Pages& old, const ModelPointer& model, const Objects& objects) {
    Pagination pagination(model, objects, old);
    while (pagination.step())
        continue;
    return pagination.take();
}

const model::Run* runAt(const Page& page, QPointF point) {
    for (const Piece& piece : page.pieces) {
        const auto* text = std::get_if<TextPiece>(&piece);
        if (!text)
            continue;
        const double height = text->letters().height;
        if (point.y() >= text->at.y() && point.y() < text->at.y() + height)
            if (const auto* run = text->paragraph->runAt(text->line, point.x() - text->at.x()))
                return run;
    }
    return nullptr;
}

std::string printed(const Pages& pages) {
    QString result;
    const auto line = [&](const char* kind, QRectF rect, const QString& text) {
        rect = {rect.topLeft() / twipsPerPoint, rect.size() / twipsPerPoint};
        result += QStringLiteral("  %1 %2,%3 %4x%5 %6\n")
                      .arg(QLatin1String(kind))
                      .arg(qRound(rect.x()))
                      .arg(qRound(rect.y()))
                      .arg(qRound(rect.width()))
                      .arg(qRound(rect.height()))
                      .arg(text.trimmed());
    };
    const auto textLine = [&](const TextPiece& text) {
        const auto& of = text.letters();
        line("text", {text.at, QSizeF(text.paragraph->naturalWidth(), of.height)},
             text.paragraph->textOfLine(text.line));
    };
    for (std::size_t i = 0; i < pages.pages.size(); ++i) {
        result += QStringLiteral("page %1\n").arg(i + 1);
        for (const Piece& piece : pages.pages[i]->pieces) {
            if (const auto* text = std::get_if<TextPiece>(&piece))
                textLine(*text);
            else if (const auto* placed = std::get_if<SubdocumentPiece>(&piece))
                line("subdocument", placed->rect, QString::number(placed->subdocument));
            else if (const auto* frame = std::get_if<FramePiece>(&piece))
                line("frame", frame->rect, {});
            else if (const auto* number = std::get_if<PageNumberPiece>(&piece))
                line("page-number", number->rect, [&] {
                    const auto anchor = pages.anchor(number->target);
                    return anchor ? QString::number(anchor->first + 1) : QString();
                }());
            else if (const auto* image = std::get_if<ImagePiece>(&piece))
                line("image", image->rect, image->alternative);
        }
        for (const TextPiece& text : pages.headersOf(i))
            textLine(text);
    }
    return result.toStdString();
}

} // namespace layout
