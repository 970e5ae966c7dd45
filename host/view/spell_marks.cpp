#include "view/spell_marks.h"

#include "places/find.h"
#include "view/document_view.h"
#include "view/text_hand.h"

#include <QElapsedTimer>
#include <QPainterPath>
#include <QScrollBar>

namespace view {

namespace {

// Since the last key or turn of the wheel, and how long at a time.
constexpr int restMs = 250, sliceMs = 5;
// Answers of paragraphs that are out of sight are forgotten beyond so many.
constexpr std::size_t mostKept = 2000;

// "de" of "de-AT".
std::string_view base(std::string_view language) {
    return language.substr(0, language.find_first_of("-_"));
}

std::string languageOf(const session::OpenDocument& of) {
    const sgml::Tree& tree = of.document().tree();
    const sgml::NodeId top = tree.classElement(tree.root());
    const auto said = top == sgml::noNode ? std::nullopt : tree.attribute(top, "LANG");
    return said ? std::string(*said)
                : of.schemas().presentation(of.document().className()).rootStyle().text.language;
}

// Which letters were written by the author as words: neither generated nor code nor in another
// language than the document.
std::vector<bool> writtenLetters(const paragraphs::Paragraph& paragraph, const model::Model& model,
                                 std::string_view language) {
    const std::vector<model::Run>& runs = paragraph.block()->runs;
    std::vector<bool> written;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const schemas::TextStyle& style = (*model.textStyles)[runs[i].style];
        const bool isText = runs[i].kind == model::RunKind::text &&
                            runs[i].content != sgml::noNode && style.family != "mono" &&
                            base(style.language) == base(language);
        written.resize(static_cast<std::size_t>(std::max(0, paragraph.startOfRun(i))), false);
        written.resize(static_cast<std::size_t>(std::max(0, paragraph.endOfRun(i))), isText);
    }
    return written;
}

void paintWave(QPainter& painter, QPointF from, double width) {
    constexpr double step = 30, height = 18; // twips
    QPainterPath wave(from);
    const int waves = static_cast<int>(std::ceil(width / (2 * step)));
    for (int i = 0; i < waves; ++i) {
        const double x = 2 * step * i;
        wave.lineTo(from + QPointF(std::min(x + step, width), height));
        wave.lineTo(from + QPointF(std::min(x + 2 * step, width), 0));
    }
    painter.setPen(QPen(QColor(214, 40, 40), 12));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(wave);
}

} // namespace

SpellMarks::SpellMarks(DocumentView& view) : view_(view) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &SpellMarks::checkSome);
    connect(&view_, &DocumentView::paintingPage, this, &SpellMarks::paint);
    connect(&view_, &DocumentView::laidOut, this, &SpellMarks::checkSoon);
    connect(&view_, &DocumentView::writingChanged, this, &SpellMarks::checkSoon);
    connect(view_.verticalScrollBar(), &QScrollBar::valueChanged, this, &SpellMarks::checkSoon);
    connect(&view_, &DocumentView::selectionChanged, this, &SpellMarks::checkSoon);
}

void SpellMarks::use(std::shared_ptr<spelling::Speller> speller) {
    speller_ = std::move(speller);
    checkAnew();
}

void SpellMarks::checkAnew() {
    checked_.clear();
    view_.viewport()->update();
    checkSoon();
}

void SpellMarks::checkSoon() {
    if (speller_ && view_.isWriting())
        timer_.start(restMs);
}

std::pair<std::size_t, std::size_t> SpellMarks::seen() const {
    const std::size_t count = view_.pages().pages.size();
    if (count == 0)
        return {0, 0};
    const QRectF all = view_.viewport()->rect();
    return {view_.pagePointAt(all.topLeft()).first,
            std::min(view_.pagePointAt(all.bottomRight()).first + 1, count)};
}

void SpellMarks::checkSome() {
    if (!speller_ || !view_.isWriting())
        return;
    if (checked_.size() > mostKept)
        checked_.clear();
    QElapsedTimer time;
    time.start();
    const auto [first, end] = seen();
    for (std::size_t page = first; page < end; ++page)
        for (const layout::Piece& piece : view_.pages().pages[page]->pieces) {
            const auto* text = std::get_if<layout::TextPiece>(&piece);
            if (!text || checked_.contains(text->paragraph.get()))
                continue;
            checked_[text->paragraph.get()] = {text->paragraph, wrongOf(*text->paragraph)};
            if (time.elapsed() >= sliceMs)
                return timer_.start(0); // the rest after other events
        }
    view_.viewport()->update();
}

std::vector<spelling::Word> SpellMarks::wrongOf(const paragraphs::Paragraph& paragraph) const {
    std::vector<spelling::Word> wrong;
    const std::shared_ptr<const model::Model> model = view_.model();
    if (!model)
        return wrong;
    const std::vector<bool> written =
        writtenLetters(paragraph, *model, languageOf(view_.document()));
    const QString text = paragraph.text(0, static_cast<int>(written.size()));
    for (const spelling::Word& word : spelling::wordsOf(text)) {
        const bool isWritten = std::all_of(written.begin() + word.from, written.begin() + word.to,
                                           [](bool is) { return is; });
        if (isWritten && !speller_->isRight(text.mid(word.from, word.to - word.from)))
            wrong.push_back(word);
    }
    return wrong;
}

std::optional<text::Range> SpellMarks::placeOf(const paragraphs::Paragraph& paragraph,
                                               spelling::Word word) const {
    return places::placesOf(paragraph, word.from, word.to,
                            model::RunPlaces(view_.document().document().tree()));
}

bool SpellMarks::isBeingTyped(const paragraphs::Paragraph& paragraph, spelling::Word word) const {
    const std::optional<document::Selection> at = view_.text().cursor().selection();
    if (!at || !at->isEmpty() || !view_.hasFocus())
        return false;
    const std::optional<text::Range> place = placeOf(paragraph, word);
    return place && at->caret == place->to;
}

void SpellMarks::paint(QPainter& painter, std::size_t page) const {
    if (!speller_ || !view_.isWriting() || checked_.empty())
        return;
    for (const layout::Piece& piece : view_.pages().pages[page]->pieces) {
        const auto* text = std::get_if<layout::TextPiece>(&piece);
        const auto of = text ? checked_.find(text->paragraph.get()) : checked_.end();
        if (of == checked_.end())
            continue;
        const paragraphs::Paragraph::Line& line = text->letters();
        for (const spelling::Word& word : of->second.wrong) {
            const int from = std::max(word.from, line.from), to = std::min(word.to, line.to);
            if (from >= to || isBeingTyped(*text->paragraph, word))
                continue;
            const double left = text->paragraph->leftOf(text->line, from);
            const double right = text->paragraph->leftOf(text->line, to);
            constexpr double below = 20;
            paintWave(painter, text->at + QPointF(std::min(left, right), line.baseline + below),
                      std::abs(right - left));
        }
    }
}

std::optional<SpellMarks::Wrong> SpellMarks::wrongAt(QPointF point) const {
    if (!speller_ || !view_.isWriting() || view_.pages().pages.empty())
        return std::nullopt;
    const auto [page, on] = view_.pagePointAt(point);
    for (const layout::Piece& piece : view_.pages().pages[page]->pieces) {
        const auto* text = std::get_if<layout::TextPiece>(&piece);
        const auto of = text ? checked_.find(text->paragraph.get()) : checked_.end();
        const double y = text ? on.y() - text->at.y() : -1;
        if (of == checked_.end() || y < 0 || y > text->letters().height)
            continue;
        for (const spelling::Word& word : of->second.wrong) {
            const paragraphs::Paragraph::Line& line = text->letters();
            const int from = std::max(word.from, line.from), to = std::min(word.to, line.to);
            if (from >= to)
                continue;
            const double left = text->at.x() + text->paragraph->leftOf(text->line, from);
            const double right = text->at.x() + text->paragraph->leftOf(text->line, to);
            const bool isHit = on.x() >= std::min(left, right) && on.x() <= std::max(left, right);
            const std::optional<text::Range> place =
                isHit ? placeOf(*text->paragraph, word) : std::nullopt;
            if (place)
                return Wrong{text->paragraph->text(word.from, word.to - word.from), *place};
        }
    }
    return std::nullopt;
}

std::size_t SpellMarks::count() const {
    std::size_t count = 0;
    const paragraphs::Paragraph* last = nullptr;
    const auto [first, end] = seen();
    for (std::size_t page = first; page < end; ++page)
        for (const layout::Piece& piece : view_.pages().pages[page]->pieces) {
            const auto* text = std::get_if<layout::TextPiece>(&piece);
            const auto of = text ? checked_.find(text->paragraph.get()) : checked_.end();
            if (of == checked_.end() || of->first == last)
                continue;
            last = of->first;
            count += of->second.wrong.size();
        }
    return count;
}

} // namespace view
