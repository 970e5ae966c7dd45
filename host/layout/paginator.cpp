#include "layout/paginator.h"

#include "paragraphs/measure.h"
#include "paragraphs/typeface.h"
#include "strips/cells.h"

#include <algorithm>

namespace layout {

using paragraphs::colorOf;
using paragraphs::fromPoints;
using paragraphs::Objects;

namespace {

constexpr double rulePoints = 0.5;
constexpr double noteGapPoints = 8;
constexpr double captionPoints = 80; // of a page that a picture leaves to its caption
constexpr double leastPicturePoints = 50;

std::shared_ptr<Basis> basisOf(const ModelPointer& model, const Objects& objects,
                               const Pages& old) {
    const bool sameStyles =
        old.basis && old.basis->stock->materials()->looks.styles() == model->textStyles;
    const std::shared_ptr<Stock> stock =
        sameStyles ? old.basis->stock : std::make_shared<Stock>(model->textStyles);
    stock->sizes().follow(objects);
    return std::make_shared<Basis>(model, stock);
}

// Pages of the same size, set by the same styles.
Pages comparable(const Pages& old, const Basis& now) {
    if (!old.basis || old.basis->stock != now.stock ||
        old.size != QSizeF(fromPoints(now.model->page.width), fromPoints(now.model->page.height)) ||
        textAreaOf(old.basis->model->page) != textAreaOf(now.model->page) ||
        old.basis->model->page.balance != now.model->page.balance)
        return {};
    return old;
}

} // namespace

Paginator::Paginator(const ModelPointer& model, const Objects& objects, const Pages& old)
    : area_(textAreaOf(model->page)), basis_(basisOf(model, objects, old)),
      old_(comparable(old, *basis_), *basis_,
           basis_->stock->sizes().changedSince(old.basis ? old.basis->sizes : 0)),
      in_{*basis_->stock, pages_.work, area_.width,
          std::max(area_.height() - fromPoints(captionPoints), fromPoints(leastPicturePoints)),
          area_.height()},
      groups_(in_, model->blocks), notes_(in_), plan_(in_, *model, notes_) {
    basis_->stock->materials()->pictureHeight = in_.pictureHeight;
    pages_.size = {fromPoints(model->page.width), fromPoints(model->page.height)};
    pages_.paper = colorOf(model->page.background);
    const bool sameHeaders = old.headers && old.headers->isOf(model->page, model->title);
    pages_.headers =
        sameHeaders ? old.headers : std::make_shared<const Headers>(model->page, model->title);
    if (const auto part = old_.first())
        follow(*part);
    else
        beginPage({});
}

bool Paginator::step() {
    if (std::exchange(pageBegun_, false)) {
        if (const auto part = old_.met(basis_->starts.back())) {
            basis_->starts.pop_back();
            follow(*part);
            return stage_ != Stage::done;
        }
        fillNotes(true);
    }
    switch (stage_) {
    case Stage::read:
        stage_ = readGroup();
        break;
    case Stage::begin:
        stage_ = Stage::consider;
        if ((hand_.strips.front().breakBefore || plan_.beginsNext(hand_.start)) && !atTop()) {
            newPage(PageStart::Next::afterBreak);
            stage_ = Stage::afterBreak;
        }
        break;
    case Stage::afterBreak:
        placeFloats(); // figures from before the break, on pages of their own
        stage_ = atTop() ? Stage::consider : Stage::begin;
        break;
    case Stage::consider:
        stage_ = considerGroup();
        break;
    case Stage::afterFull:
        placeFloats();
        stage_ = Stage::place;
        if (!mayBegin(hand_) && !isFresh())
            newPage(PageStart::Next::place);
        break;
    case Stage::place:
        stage_ = placeHand();
        break;
    case Stage::rest:
        if (!floats_.empty() || notes_.isWaiting()) {
            newPage(PageStart::Next::within);
            placeFloats();
            break;
        }
        finishPage();
        stage_ = Stage::done;
        break;
    case Stage::done:
        break;
    }
    return stage_ != Stage::done;
}

Pages Paginator::pages() const {
    Pages result = pages_;
    if (stage_ == Stage::done || basis_->starts.empty())
        return result;
    const auto& old = old_.pages().pages;
    const std::size_t rest = old_.behind(basis_->starts.back());
    result.pages.insert(result.pages.end(),
                        old.begin() + static_cast<std::ptrdiff_t>(std::min(rest, old.size())),
                        old.end());
    return result;
}

Pages Paginator::take() {
    pages_.basis = basis_;
    return std::move(pages_);
}

// --- old pages ---------------------------------------------------------------------------------

void Paginator::follow(const OldPages::Part& part) {
    const auto& old = old_.pages().pages;
    for (std::size_t i = part.from; i < part.to; ++i) {
        pages_.pages.push_back(old[i]);
        basis_->starts.push_back(old_.startOf(i, part.shift));
    }
    if (part.next)
        resume(*part.next);
    else
        stage_ = Stage::done;
}

Group Paginator::groupAt(const GroupStart& start) {
    groups_.seek(start);
    Group group;
    while (groups_.read(group) == Made::pause)
        continue;
    return group;
}

void Paginator::resume(const PageStart& start) {
    floats_.clear();
    for (const GroupStart& waiting : start.floats)
        floats_.push_back(groupAt(waiting));
    hand_ = {};
    groups_.seek(start.group);
    using Next = PageStart::Next;
    if (start.next != Next::read)
        hand_ = groupAt(start.group);
    strip_ = start.strip;
    notes_.resume(start.notes);
    stage_ = start.next == Next::read         ? Stage::read
             : start.next == Next::afterBreak ? Stage::afterBreak
             : start.next == Next::afterFull  ? Stage::afterFull
                                              : Stage::place;
    beginPage(start);
    pageBegun_ = true;
}

// --- groups ------------------------------------------------------------------------------------

Paginator::Stage Paginator::readGroup() {
    switch (groups_.read(hand_)) {
    case Made::pause:
        return Stage::read;
    case Made::strip:
        strip_ = 0;
        return Stage::begin;
    case Made::end:
        break;
    }
    hand_ = {groups_.next()};
    return Stage::rest;
}

double Paginator::gapBefore(const Strip& strip) const {
    if (atTop() && !strip.firstOfBlock)
        return 0;
    if (atTop() && !strip.beginsDocument())
        return basis_->frames.above(strip.block);
    return std::max(filling_.after, strip.before);
}

double Paginator::roomBelow() const {
    if (notes_.isWaiting())
        return -1; // it is full of notes
    return area_.bottom - filling_.y -
           (notes_.isEmpty() ? 0 : notes_.height() + fromPoints(noteGapPoints));
}

bool Paginator::fits(double height, const std::vector<Notes::Pointer>& notes) {
    const double room = roomBelow();
    if (notes.empty())
        return height <= room;
    const Notes::Wanted wanted = notes_.wanted(notes, area_.height());
    const double gap = notes_.isEmpty() ? fromPoints(noteGapPoints) : 0;
    if (height + gap + wanted.all <= room)
        return true;
    // Notes for which no page would be high enough are divided where their mark stands.
    return height + gap + wanted.all > area_.height() && height + gap + wanted.least <= room;
}

bool Paginator::fits(const Group& group) {
    std::vector<Notes::Pointer> notes;
    for (const Strip& strip : group.strips)
        notes.insert(notes.end(), strip.footnotes.begin(), strip.footnotes.end());
    pages_.work.strips += group.strips.size();
    return fits(gapBefore(group.strips.front()) + group.height, notes);
}

bool Paginator::fits(const Group& group, std::size_t strip) {
    double height = gapBefore(group.strips[strip]) + group.strips[strip].height;
    std::vector<Notes::Pointer> notes = group.strips[strip].footnotes;
    for (; group.strips[strip].keepWithNextLine && strip + 1 < group.strips.size(); ++strip) {
        const Strip& next = group.strips[strip + 1];
        height += next.height;
        notes.insert(notes.end(), next.footnotes.begin(), next.footnotes.end());
    }
    return fits(height, notes);
}

// Here, that is: all of it, or of what is taller than a page anyway its first two strips.
bool Paginator::mayBegin(const Group& group) {
    if (group.height <= area_.height())
        return fits(group);
    double height = gapBefore(group.strips.front());
    for (std::size_t i = 0; i < std::min<std::size_t>(2, group.strips.size()); ++i)
        height += group.strips[i].before + group.strips[i].height;
    return height <= roomBelow();
}

Paginator::Stage Paginator::considerGroup() {
    if (!mayBegin(hand_) && !isFresh()) {
        if (hand_.mayFloat) {
            floats_.push_back(std::exchange(hand_, {}));
            return Stage::read;
        }
        newPage(PageStart::Next::afterFull);
        return Stage::afterFull;
    }
    if (hand_.mayFloat && !floats_.empty()) {
        floats_.push_back(std::exchange(hand_, {})); // figures keep their order
        return Stage::read;
    }
    return Stage::place;
}

// The rest of the group, or as much as the page takes.
Paginator::Stage Paginator::placeHand() {
    if (strip_ == 0 && isFresh())
        plan_.begin(hand_.start);
    for (; strip_ < hand_.strips.size(); ++strip_) {
        const Strip& strip = hand_.strips[strip_];
        if (!strip.cells && !fits(hand_, strip_) && !isFresh()) {
            newPage(PageStart::Next::place);
            return Stage::place;
        }
        placeStrip(strip);
    }
    return Stage::read;
}

void Paginator::placeFloats() {
    while (!floats_.empty() && (isFresh() || fits(floats_.front()))) {
        const Group group = std::move(floats_.front());
        floats_.pop_front();
        for (std::size_t i = 0; i < group.strips.size(); ++i) {
            while (!fits(group, i) && !isFresh())
                newPage(PageStart::Next::within);
            placeStrip(group.strips[i]);
        }
    }
}

void Paginator::placeStrip(const Strip& strip) {
    if (strip.cells)
        return placeCells(strip);
    while (!fits(strip) && !isFresh())
        newPage(PageStart::Next::within);
    repeatHeader(strip);
    filling_.y += gapBefore(strip);
    put(strip, strip.firstOfBlock, strip.lastOfBlock);
}

// As much of a tall row as there is room for, on as many pages as it takes.
void Paginator::placeCells(const Strip& strip) {
    Cells& cells = *strip.cells;
    bool begun = false;
    while (!cells.isTaken()) {
        repeatHeader(strip);
        const double gap = begun ? 0 : gapBefore(strip);
        Strip part = cells.take(roomBelow() - gap, isFresh());
        if (part.height > 0 || cells.isTaken()) {
            filling_.y += gap;
            part.block = strip.block;
            part.after = strip.after;
            part.columns = strip.columns;
            part.left = strip.left;
            put(part, strip.firstOfBlock && !begun, strip.lastOfBlock && cells.isTaken());
            begun = true;
        }
        if (!cells.isTaken())
            newPage(PageStart::Next::within);
    }
}

// --- pages -------------------------------------------------------------------------------------

void Paginator::put(const Strip& strip, bool first, bool last) {
    if (first)
        remember(strip);
    const model::Block* block = basis_->model->blocks[strip.block].get();
    for (const Piece& piece : strip.pieces)
        put(moved(piece, {area_.left, filling_.y}), block);
    if (strip.columns)
        rememberRows(strip);
    filling_.placed.push_back({strip.block, first, last, filling_.y, filling_.y + strip.height});
    filling_.y += strip.height;
    filling_.after = strip.after;
    for (const Notes::Pointer& note : strip.footnotes)
        notes_.mark(note, block);
    fillNotes(false);
}

void Paginator::rememberRows(const Strip& strip) {
    auto& tables = filling_.page->tables;
    if (tables.empty() || tables.back().columns != strip.columns)
        tables.push_back({strip.columns, area_.left + strip.left, filling_.y, 0});
    tables.back().bottom = filling_.y + strip.height;
}

// The header of a table that goes on on this page, where there is room for it and the strip.
void Paginator::repeatHeader(const Strip& strip) {
    if (!strip.header || filling_.y > area_.top ||
        (!strip.cells && strip.header->height + strip.height > roomBelow()))
        return;
    for (const Piece& piece : strip.header->pieces)
        put(moved(piece, {area_.left, filling_.y}), nullptr);
    filling_.placed.push_back(
        {strip.block, false, false, filling_.y, filling_.y + strip.header->height});
    filling_.y += strip.header->height;
    filling_.top = filling_.y;
}

// The things that refer to places: the outline and the anchors.
void Paginator::remember(const Strip& strip) {
    const model::Block& block = *basis_->model->blocks[strip.block];
    for (const std::string& anchor : block.anchors)
        filling_.page->anchors.emplace_back(anchor, filling_.y);
    if (block.headingLevel <= 0)
        return;
    QString text = QString::fromStdString(block.marker);
    for (const model::Run& run : block.runs)
        if (run.kind == model::RunKind::text)
            text += (text.isEmpty() || text.endsWith(' ') || &run != &block.runs.front()
                         ? QString()
                         : QStringLiteral(" ")) +
                    QString::fromStdString(run.text);
    filling_.page->headings.push_back({text, block.headingLevel, filling_.y});
}

void Paginator::put(const Piece& piece, const model::Block* block) {
    if (const auto* placed = std::get_if<SubdocumentPiece>(&piece))
        filling_.page->objects.push_back(
            {placed->subdocument, {}, placed->rect, block, sgml::noNode, placed->align});
    else if (std::holds_alternative<PageNumberPiece>(piece))
        filling_.page->hasPageNumbers = true;
    else if (const auto* image = std::get_if<ImagePiece>(&piece))
        filling_.page->objects.push_back({document::noSubdocument, image->source, image->rect,
                                          block, image->element, image->align});
    filling_.page->pieces.push_back(piece);
}

void Paginator::fillNotes(bool forced) {
    if (notes_.isWaiting())
        notes_.fill(area_.bottom - filling_.y - fromPoints(noteGapPoints), forced);
}

void Paginator::newPage(PageStart::Next next) {
    finishPage();
    PageStart start;
    start.next = next;
    start.group = hand_.start;
    start.strip = strip_;
    start.first = start.group.at.block;
    if (!floats_.empty())
        start.first = floats_.front().start.at.block;
    start.reached = std::max(groups_.reached(), plan_.reached());
    for (const Group& waiting : floats_)
        start.floats.push_back(waiting.start);
    if (auto waiting = notes_.waiting())
        start.notes = std::move(*waiting);
    else
        start.next = PageStart::Next::within;
    beginPage(start);
    if (next == PageStart::Next::within)
        fillNotes(true);
    else
        pageBegun_ = true;
}

void Paginator::beginPage(const PageStart& start) {
    basis_->starts.push_back(start);
    filling_ = {std::make_shared<Page>(), {}, area_.top, 0, area_.top};
    plan_.forget();
    ++pages_.work.pages;
}

// Boxes lie behind what is in them; footnotes stand at the bottom.
void Paginator::finishPage() {
    const std::vector<FramePiece> behind =
        basis_->frames.on(filling_.placed, area_.left, area_.width, pages_.work.boxes);
    auto& pieces = filling_.page->pieces;
    pieces.insert(pieces.begin(), behind.begin(), behind.end());
    addNotes();
    pages_.pages.push_back(std::move(filling_.page));
}

void Paginator::addNotes() {
    if (notes_.isEmpty())
        return;
    const double y = area_.bottom - notes_.height();
    const double ruleTop = y - fromPoints(noteGapPoints / 2);
    put(FramePiece{{area_.left, ruleTop, area_.width / 4, fromPoints(rulePoints)},
                   schemas::Color{150, 150, 150},
                   {}},
        nullptr);
    for (const Notes::Taken& taken : notes_.take()) {
        Piece piece = moved(taken.piece, {area_.left, y});
        if (auto* text = std::get_if<TextPiece>(&piece))
            text->isOfNote = true;
        put(piece, taken.block);
    }
}

} // namespace layout
