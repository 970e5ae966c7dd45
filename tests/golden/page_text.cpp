#include "golden/page_text.h"

#include <algorithm>
#include <sstream>

namespace golden {

namespace {

using paragraphs::InlineObject;
using paragraphs::Paragraph;

QString colorName(const schemas::Color& color) {
    return QColor(color.red, color.green, color.blue).name();
}

QString nameOf(schemas::Align align) {
    switch (align) {
    case schemas::Align::center:
        return QStringLiteral("center");
    case schemas::Align::right:
        return QStringLiteral("right");
    case schemas::Align::justify:
        return QStringLiteral("justify");
    case schemas::Align::left:
        break;
    }
    return QStringLiteral("left");
}

QString lookOf(const schemas::TextStyle& style) {
    QString look =
        QStringLiteral("%1 %2").arg(QString::fromStdString(style.family)).arg(style.size);
    const auto add = [&look](bool is, const QString& word) { look += is ? ' ' + word : QString(); };
    add(style.bold, QStringLiteral("bold"));
    add(style.italic, QStringLiteral("italic"));
    add(style.underline, QStringLiteral("underline"));
    add(style.raised, QStringLiteral("raised"));
    add(style.color != schemas::Color{}, colorName(style.color));
    if (style.background)
        add(true, QStringLiteral("on ") + colorName(*style.background));
    return look;
}

// Signs that one does not see, or not as what they are, by their numbers.
QString readable(const QString& text) {
    QString result;
    for (const QChar sign : text) {
        const bool isSeen = sign == ' ' || (sign.isPrint() && !sign.isSpace() &&
                                            sign.category() != QChar::Other_Format);
        if (isSeen || sign.isSurrogate())
            result += sign;
        else
            result += QStringLiteral("<%1>").arg(sign.unicode(), 4, 16, QLatin1Char('0'));
    }
    return result;
}

class Writer {
public:
    void begin(std::size_t page) {
        text_ += QStringLiteral("page %1\n").arg(page + 1);
        above_ = 0;
    }
    void operator()(const layout::FramePiece& frame) {
        const QString ground = frame.background ? " on " + colorName(*frame.background) : QString();
        QString border;
        if (frame.border.width > 0) {
            border = QStringLiteral(" border %1 %2")
                         .arg(frame.border.width)
                         .arg(colorName(frame.border.color));
            for (const auto& [is, side] :
                 {std::pair(frame.border.top, " top"), std::pair(frame.border.right, " right"),
                  std::pair(frame.border.bottom, " bottom"), std::pair(frame.border.left, " left")})
                border += is ? QLatin1String(side) : QLatin1String();
        }
        box("frame", frame.rect, ground + border);
    }
    void operator()(const layout::TextPiece& piece) { line("text", piece); }
    void operator()(const layout::SubdocumentPiece& placed) {
        box("figure", placed.rect, ' ' + nameOf(placed.align));
    }
    void operator()(const layout::ImagePiece& image) {
        box("image", image.rect,
            QStringLiteral(" %1 \"%2\" %3")
                .arg(QString::fromStdString(image.source), image.alternative, nameOf(image.align)));
    }
    void operator()(const layout::PageNumberPiece& number) {
        box("number", number.rect,
            QStringLiteral(" of %1").arg(QString::fromStdString(number.target)));
    }
    void header(const layout::TextPiece& piece) { line("header", piece); }

    [[nodiscard]] std::string text() const { return text_.toStdString(); }

private:
    [[nodiscard]] QString at(const char* kind, double x, double y) {
        const int below = qRound(y) - std::exchange(above_, qRound(y));
        return QStringLiteral("  %1 %2 %3")
            .arg(QLatin1String(kind), -7)
            .arg(qRound(x), 6)
            .arg(QString::asprintf("%+d", below), 7);
    }
    void box(const char* kind, const QRectF& rect, const QString& what) {
        text_ += at(kind, rect.x(), rect.y()) + QStringLiteral("  %1 x %2%3\n")
                                                    .arg(qRound(rect.width()))
                                                    .arg(qRound(rect.height()))
                                                    .arg(what);
    }
    // By its base line; as wide as what is shown of it.
    void line(const char* kind, const layout::TextPiece& piece) {
        const Paragraph& of = *piece.paragraph;
        const Paragraph::Line& letters = piece.letters();
        double left = of.leftOf(piece.line, letters.from);
        for (int letter = letters.from; letter < letters.end; ++letter)
            left = std::min(left, of.edgesOf(piece.line, letter).first);
        QString words = of.text(letters.from, letters.end - letters.from);
        for (const InlineObject& object : of.objectsOf(piece.line))
            words[object.position - letters.from] = QChar(0x25A1);
        words = readable(words) + (letters.hyphen ? QStringLiteral("<->") : QString());
        text_ += at(kind, piece.at.x() + left, piece.at.y() + letters.baseline) +
                 QStringLiteral("  %1 wide \"%2\" %3\n")
                     .arg(qRound(of.widthOfLine(piece.line)))
                     .arg(words, looksOf(of, letters));
        for (const InlineObject& object : of.objectsOf(piece.line))
            inlined(of, piece.line, object);
    }
    // Of its letters, in their order.
    [[nodiscard]] static QString looksOf(const Paragraph& of, const Paragraph::Line& letters) {
        const model::Block& block = *of.block();
        QStringList looks;
        for (std::size_t i = 0; i < block.runs.size(); ++i) {
            if (of.startOfRun(i) >= letters.end && letters.end > letters.from)
                break;
            if (of.endOfRun(i) <= letters.from && letters.end > letters.from)
                continue;
            const QString look = lookOf(of.style(block.runs[i].style));
            if (looks.isEmpty() || looks.back() != look)
                looks.append(look);
        }
        return looks.isEmpty() ? lookOf(of.style(block.textStyle)) : looks.join(" | ");
    }
    // From the left edge of its line and above its base line.
    void inlined(const Paragraph& of, int line, const InlineObject& object) {
        const model::Run& run = of.block()->runs[object.run];
        const char* kind = run.formula ? "formula" : run.picture ? "image" : "figure";
        const QRectF rect = of.objectRect(line, object);
        text_ += QStringLiteral("    %1 in it at %2: %3 x %4, %5 below the base line\n")
                     .arg(QLatin1String(kind))
                     .arg(qRound(rect.x()))
                     .arg(qRound(rect.width()))
                     .arg(qRound(rect.height()))
                     .arg(qRound(object.depth));
    }

    QString text_;
    int above_ = 0; // where the piece before stands
};

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

} // namespace

std::string textOf(const layout::Pages& pages) {
    Writer writer;
    const std::string head = QStringLiteral("%1 x %2 twips, paper %3\n")
                                 .arg(qRound(pages.size.width()))
                                 .arg(qRound(pages.size.height()))
                                 .arg(pages.paper.name())
                                 .toStdString();
    for (std::size_t i = 0; i < pages.pages.size(); ++i) {
        writer.begin(i);
        for (const layout::Piece& piece : pages.pages[i]->pieces)
            std::visit(writer, piece);
        for (const layout::TextPiece& piece : pages.headersOf(i))
            writer.header(piece);
    }
    return head + writer.text();
}

std::string differenceOf(const std::string& was, const std::string& now) {
    const std::vector<std::string> before = linesOf(was), after = linesOf(now);
    const auto [first, other] = std::ranges::mismatch(before, after);
    if (first == before.end() && other == after.end())
        return {};
    constexpr std::ptrdiff_t shown = 6;
    std::string told = "line " + std::to_string(first - before.begin() + 1) + "\n";
    for (auto line = first; line != before.end() && line - first < shown; ++line)
        told += "- " + *line + "\n";
    for (auto line = other; line != after.end() && line - other < shown; ++line)
        told += "+ " + *line + "\n";
    return told;
}

} // namespace golden
