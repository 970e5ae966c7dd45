#include "layout/paginator.h"

#include "layout/measure.h"
#include "layout/typeface.h"

#include <algorithm>

namespace layout {

namespace {

constexpr double rulePoints = 0.5;
constexpr double noteGapPoints = 8;
constexpr double captionPoints = 80; // of a page that a picture leaves to its caption
constexpr double leastPoints = 50;   // of a text area, whatever the margins are

} // namespace

Paginator::Paginator(const document::Model& model, const Objects& objects)
    : model_(model), left_(fromPoints(model.page.marginLeft)),
      top_(fromPoints(model.page.marginTop)),
      bottom_(std::max(fromPoints(model.page.height - model.page.marginBottom),
                       top_ + fromPoints(leastPoints))),
      width_(std::max(fromPoints(model.page.width - model.page.marginRight) - left_,
                      fromPoints(leastPoints))),
      in_{model,
          objects,
          pages_.work,
          width_,
          std::max(pageHeight() - fromPoints(captionPoints), fromPoints(leastPoints)),
          pageHeight()},
      flow_(in_, model.blocks), notes_(in_), frames_(model) {
    pages_.size = {fromPoints(model.page.width), fromPoints(model.page.height)};
    pages_.paper = colorOf(model.page.background);
    newPage();
}

bool Paginator::step() {
    switch (stage_) {
    case Stage::text: {
        const Made made = readGroup();
        if (made == Made::strip)
            placeOrFloat(std::exchange(group_, {}));
        if (made == Made::end)
            stage_ = Stage::rest;
        return true;
    }
    case Stage::rest:
        if (!floats_.empty() || notes_.isWaiting()) {
            newPage();
            placeFloats();
            return true;
        }
        finishPage();
        stage_ = Stage::headers;
        return true;
    case Stage::headers:
        if (headed_ < pages_.pages.size()) {
            addHeaders(headed_++);
            return true;
        }
        stage_ = Stage::done;
        return false;
    case Stage::done:
        break;
    }
    return false;
}

// --- groups ------------------------------------------------------------------------------------

void Paginator::append(Strip strip) {
    std::vector<Strip>& strips = group_.strips;
    if (strips.empty())
        group_.mayFloat = strip.mayFloat && !tooTall_;
    else
        group_.height += std::max(strips.back().after, strip.before);
    group_.height += strip.cells ? 2 * pageHeight() : strip.height;
    strips.push_back(std::move(strip));
}

// Made::strip: there is a group. No more is read of one than a page takes: what is taller cannot be
// kept together.
Made Paginator::readGroup() {
    for (;;) {
        Strip strip;
        const Made made = ahead_ ? Made::strip : flow_.next(strip);
        if (made != Made::strip)
            return made == Made::end && !group_.strips.empty() ? Made::strip : made;
        if (ahead_)
            strip = std::move(*std::exchange(ahead_, {}));
        if (strip.breakBefore) {
            tooTall_ = false;
            if (!group_.strips.empty()) {
                ahead_ = std::move(strip);
                return Made::strip;
            }
        }
        const bool goesOn = strip.keepWithNext;
        append(std::move(strip));
        tooTall_ = goesOn && (tooTall_ || group_.height > pageHeight());
        if (group_.height > pageHeight())
            group_.mayFloat = false;
        if (!goesOn || tooTall_)
            return Made::strip;
    }
}

double Paginator::gapBefore(const Strip& strip) const {
    if (atTop())
        return strip.firstOfBlock ? frames_.above(strip.block) : 0;
    return std::max(after_, strip.before);
}

double Paginator::roomBelow() const {
    if (notes_.isWaiting())
        return -1; // it is full of notes
    return bottom_ - y_ - (notes_.isEmpty() ? 0 : notes_.height() + fromPoints(noteGapPoints));
}

bool Paginator::fits(double height, const std::vector<Notes::Footnote>& notes) {
    const double room = roomBelow();
    if (notes.empty())
        return height <= room;
    const Notes::Wanted wanted = notes_.wanted(notes, pageHeight());
    const double gap = notes_.isEmpty() ? fromPoints(noteGapPoints) : 0;
    if (height + gap + wanted.all <= room)
        return true;
    // Notes for which no page would be high enough are divided where their mark stands.
    return height + gap + wanted.all > pageHeight() && height + gap + wanted.least <= room;
}

bool Paginator::fits(const Group& group) {
    std::vector<Notes::Footnote> notes;
    for (const Strip& strip : group.strips)
        notes.insert(notes.end(), strip.footnotes.begin(), strip.footnotes.end());
    pages_.work.strips += group.strips.size();
    return fits(gapBefore(group.strips.front()) + group.height, notes);
}

// Here, that is: all of it, or of what is taller than a page anyway its first two strips.
bool Paginator::mayBegin(const Group& group) {
    if (group.height <= pageHeight())
        return fits(group);
    double height = gapBefore(group.strips.front());
    for (std::size_t i = 0; i < std::min<std::size_t>(2, group.strips.size()); ++i)
        height += group.strips[i].before + group.strips[i].height;
    return height <= roomBelow();
}

void Paginator::placeOrFloat(Group group) {
    const Strip& front = group.strips.front();
    if (front.breakBefore && !atTop()) {
        newPage();
        placeFloats();
    }
    if (!mayBegin(group) && !isFresh()) {
        if (group.mayFloat) {
            floats_.push_back(std::move(group));
            return;
        }
        newPage();
        placeFloats();
        if (!mayBegin(group) && !isFresh())
            newPage();
    } else if (group.mayFloat && !floats_.empty()) {
        floats_.push_back(std::move(group)); // figures keep their order
        return;
    }
    place(group);
}

void Paginator::placeFloats() {
    while (!floats_.empty() && (isFresh() || fits(floats_.front()))) {
        const Group group = std::move(floats_.front());
        floats_.pop_front();
        place(group);
    }
}

// --- pages -------------------------------------------------------------------------------------

void Paginator::place(const Group& group) {
    for (const Strip& strip : group.strips) {
        if (strip.cells) {
            placeCells(strip);
            continue;
        }
        while (!fits(gapBefore(strip) + strip.height, strip.footnotes) && !isFresh())
            newPage();
        y_ += gapBefore(strip);
        put(strip, strip.firstOfBlock, strip.lastOfBlock);
    }
}

// As much of a tall row as there is room for, on as many pages as it takes.
void Paginator::placeCells(const Strip& strip) {
    Cells& cells = *strip.cells;
    bool begun = false;
    while (!cells.isTaken()) {
        const double gap = begun ? 0 : gapBefore(strip);
        Strip part = cells.take(roomBelow() - gap, isFresh());
        if (part.height > 0 || cells.isTaken()) {
            y_ += gap;
            part.block = strip.block;
            part.after = strip.after;
            put(part, strip.firstOfBlock && !begun, strip.lastOfBlock && cells.isTaken());
            begun = true;
        }
        if (!cells.isTaken())
            newPage();
    }
}

void Paginator::put(const Strip& strip, bool first, bool last) {
    if (first)
        remember(strip);
    for (const Piece& piece : strip.pieces)
        put(moved(piece, {left_, y_}));
    placed_.push_back({strip.block, first, last, y_, y_ + strip.height});
    y_ += strip.height;
    after_ = strip.after;
    for (const Notes::Footnote& note : strip.footnotes)
        notes_.mark(note);
    fillNotes(false);
}

// What refers to places: the outline and the anchors.
void Paginator::remember(const Strip& strip) {
    const document::Block& block = *model_.blocks[strip.block];
    const std::size_t page = pages_.pages.size() - 1;
    for (const std::string& anchor : block.anchors)
        pages_.anchors[anchor] = {page, y_};
    if (block.headingLevel <= 0)
        return;
    QString text = QString::fromStdString(block.marker);
    for (const document::Run& run : block.runs)
        if (run.kind == document::RunKind::text)
            text += (text.isEmpty() || text.endsWith(' ') || &run != &block.runs.front()
                         ? QString()
                         : QStringLiteral(" ")) +
                    QString::fromStdString(run.text);
    pages_.outline.push_back({text, block.headingLevel, page, y_});
}

void Paginator::put(const Piece& piece) {
    if (const auto* placed = std::get_if<SubdocumentPiece>(&piece))
        pages_.subdocuments.push_back({placed->subdocument, pages_.pages.size() - 1, placed->rect});
    pages_.pages.back().pieces.push_back(piece);
}

void Paginator::fillNotes(bool forced) {
    if (notes_.isWaiting())
        notes_.fill(bottom_ - y_ - fromPoints(noteGapPoints), forced);
}

void Paginator::newPage() {
    if (!pages_.pages.empty())
        finishPage();
    pages_.pages.emplace_back();
    y_ = top_;
    after_ = 0;
    fillNotes(true);
}

// Boxes lie behind what is in them; footnotes stand at the bottom.
void Paginator::finishPage() {
    const std::vector<FramePiece> behind = frames_.on(placed_, left_, width_, pages_.work.boxes);
    auto& pieces = pages_.pages.back().pieces;
    pieces.insert(pieces.begin(), behind.begin(), behind.end());
    addNotes();
    placed_.clear();
}

void Paginator::addNotes() {
    if (notes_.isEmpty())
        return;
    const double y = bottom_ - notes_.height();
    const double ruleTop = y - fromPoints(noteGapPoints / 2);
    put(FramePiece{
        {left_, ruleTop, width_ / 4, fromPoints(rulePoints)}, document::Color{150, 150, 150}, {}});
    for (const Piece& piece : notes_.take())
        put(moved(piece, {left_, y}));
}

// --- headers and footers -----------------------------------------------------------------------

void Paginator::addHeaders(std::size_t page) {
    const document::PageStyle& style = model_.page;
    const double height = fromPoints(style.headerStyle.size * 1.2);
    if (page > 0 || style.headerOnFirstPage) {
        const double y = top_ / 2 - height / 2;
        addLine(page, style.headerLeft, document::Align::left, y);
        addLine(page, style.headerCenter, document::Align::center, y);
        addLine(page, style.headerRight, document::Align::right, y);
    }
    const double y = bottom_ + (pages_.size.height() - bottom_) / 2 - height / 2;
    addLine(page, style.footerLeft, document::Align::left, y);
    addLine(page, style.footerCenter, document::Align::center, y);
    addLine(page, style.footerRight, document::Align::right, y);
}

void Paginator::addLine(std::size_t page, const std::string& pattern, document::Align align,
                        double y) {
    if (pattern.empty())
        return;
    QString text = QString::fromStdString(pattern);
    text.replace("{page}", QString::number(page + 1));
    text.replace("{pages}", QString::number(pages_.pages.size()));
    text.replace("{title}", QString::fromStdString(model_.title));
    static const Objects none;
    document::Model model;
    const auto styles = std::make_shared<document::TextStyles>();
    styles->numberOf(model_.page.headerStyle);
    model.textStyles = styles;
    document::Block block;
    block.style.align = align;
    document::Run run;
    run.text = text.toStdString();
    block.runs.push_back(run);
    const auto paragraph = std::make_shared<Paragraph>(model, block, width_, none);
    if (paragraph->makeLine(0))
        pages_.pages[page].pieces.push_back(TextPiece{paragraph, 0, {left_, y}});
}

} // namespace layout
