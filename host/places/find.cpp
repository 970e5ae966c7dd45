#include "places/find.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace places {

using layout::Page;
using layout::Pages;
using layout::Piece;
using layout::TextPiece;
using paragraphs::Paragraph;

namespace {

// As on a keyboard; letter by letter.
QString plainly(QString text) {
    for (QChar& sign : text) {
        if (QStringView(u"“”„«»").contains(sign))
            sign = '"';
        else if (QStringView(u"‘’‚‹›").contains(sign))
            sign = '\'';
        else if (QStringView(u"–−\u2010\u2011").contains(sign))
            sign = '-';
        else if (QStringView(u"\u00A0\u202F\u2009").contains(sign))
            sign = ' ';
    }
    return text;
}

// One page. A page's matches are known from its own lines alone.
class Finding {
public:
    explicit Finding(const Search& search)
        : search_(search), isPlain_(plainly(search.words) == search.words) {}

    void line(const TextPiece& piece) {
        const Paragraph& of = *piece.paragraph;
        const auto [from, to] = of.rangeOfLine(piece.line);
        // Lines of a paragraph follow each other: the first one tells what is on the page before.
        const int begin = firstLetters_.try_emplace(&of, from).first->second;
        const int length = static_cast<int>(search_.words.size());
        // A match may have begun on the line before, and may end on the next. No more of the text
        // is read for it, but the letters beside it.
        const int first = std::max(0, from - length);
        const QString letters = of.text(first, to + length - first);
        const QString text = isPlain_ ? plainly(letters) : letters;
        const auto cases = search_.matchesCase ? Qt::CaseSensitive : Qt::CaseInsensitive;
        for (auto at = text.indexOf(search_.words, 0, cases); at >= 0;) {
            const int match = first + static_cast<int>(at);
            const bool isOnLine = match < to && match + length > from;
            const bool isMatch = !search_.isWhole || isWhole(text, at, length);
            if (isMatch && isOnLine && match >= begin)
                mark(piece, match, std::max(match, from), std::min(match + length, to));
            at = text.indexOf(search_.words, at + (isMatch ? length : 1), cases);
        }
    }
    std::vector<Found> found;

private:
    static bool isWhole(const QString& text, qsizetype at, qsizetype length) {
        const auto isInWord = [&](qsizetype i) {
            return i >= 0 && i < text.size() && text[i].isLetterOrNumber();
        };
        return !isInWord(at - 1) && !isInWord(at + length);
    }
    void mark(const TextPiece& piece, int match, int from, int to) {
        const auto [place, isNew] =
            places_.emplace(std::pair(piece.paragraph.get(), match), found.size());
        if (isNew) {
            Found one;
            one.from = match;
            one.to = match + static_cast<int>(search_.words.size());
            found.push_back(std::move(one));
        }
        found[place->second].parts.push_back({piece.paragraph, piece.line, from, to, piece.at});
    }

    const Search& search_;
    bool isPlain_; // quotes, dashes and blanks of a keyboard: they find the typographic ones, too
    std::map<const Paragraph*, int> firstLetters_; // on this page
    // By where they begin: the parts of one on several lines are one.
    std::map<std::pair<const Paragraph*, int>, std::size_t> places_;
};

std::vector<Found> foundOn(const Page& page, std::size_t index, const Search& search) {
    if (search.words.isEmpty())
        return {};
    Finding finding(search);
    for (const Piece& piece : page.pieces)
        if (const auto* text = std::get_if<TextPiece>(&piece); text && !text->isRepeated)
            finding.line(*text);
    for (Found& one : finding.found)
        one.page = index;
    return std::move(finding.found);
}

} // namespace

double Found::Part::bottom() const {
    return at.y() + paragraph->lines()[static_cast<std::size_t>(line)].height;
}

QRectF Found::Part::rect() const {
    const double left = paragraph->leftOf(line, from), right = paragraph->leftOf(line, to);
    return {at.x() + std::min(left, right), at.y(), std::abs(right - left), bottom() - at.y()};
}

std::vector<Found> findText(const Pages& pages, const Search& search) {
    std::vector<Found> result;
    for (std::size_t i = 0; i < pages.pages.size(); ++i)
        std::ranges::move(foundOn(*pages.pages[i], i, search), std::back_inserter(result));
    return result;
}

std::optional<text::Range> placesOf(const Paragraph& of, int from, int to,
                                    const model::RunPlaces& places) {
    const std::vector<model::Run>& runs = of.block()->runs;
    std::optional<text::Range> result;
    int known = from; // letters up to there have places
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const int start = of.startOfRun(i), end = of.endOfRun(i);
        if (end <= known)
            continue;
        if (start >= to)
            break;
        if (!places.isText(runs[i]) || start > known)
            return std::nullopt;
        const std::size_t last = places.placeOf(runs[i], of.byteAt(i, std::min(to, end)));
        if (!result)
            result = text::Range{places.placeOf(runs[i], of.byteAt(i, from)), last};
        result->to = last;
        known = end;
    }
    return known >= to ? result : std::nullopt;
}

std::optional<text::Range> placesOf(const Found& found, const model::RunPlaces& places) {
    return placesOf(*found.parts.front().paragraph, found.from, found.to, places);
}

// --- pages that change -------------------------------------------------------------------------

void Finder::look(const Search& search, const Pages& pages) {
    if (search == search_)
        return follow(pages);
    search_ = search;
    pages_.clear();
    follow(pages);
}

void Finder::follow(const Pages& pages) {
    std::vector<OnPage> old = std::exchange(pages_, {});
    std::unordered_map<const Page*, std::size_t> moved; // read when the first one has moved
    const auto known = [&](std::size_t index) -> OnPage* {
        const Page* page = pages.pages[index].get();
        if (index < old.size() && old[index].page.get() == page)
            return &old[index];
        if (moved.empty())
            for (std::size_t i = 0; i < old.size(); ++i)
                moved.emplace(old[i].page.get(), i);
        const auto at = moved.find(page);
        return at == moved.end() || !old[at->second].page ? nullptr : &old[at->second];
    };
    count_ = 0;
    pages_.reserve(pages.pages.size());
    for (std::size_t i = 0; i < pages.pages.size(); ++i) {
        OnPage now{pages.pages[i], {}, count_};
        if (OnPage* before = known(i)) {
            now.found = std::move(before->found);
            before->page.reset(); // a page that stands twice is read twice
            for (Found& one : now.found)
                one.page = i;
        } else {
            now.found = foundOn(*pages.pages[i], i, search_);
            pagesRead_ += search_.words.isEmpty() ? 0 : 1;
        }
        count_ += now.found.size();
        pages_.push_back(std::move(now));
    }
}

const Found& Finder::at(std::size_t index) const {
    const auto isUpTo = [](std::size_t i, const OnPage& page) { return i < page.before; };
    const auto behind = std::upper_bound(pages_.begin(), pages_.end(), index, isUpTo);
    const OnPage& page = *std::prev(behind);
    return page.found[index - page.before];
}

std::span<const Found> Finder::on(std::size_t page) const {
    return page < pages_.size() ? std::span<const Found>(pages_[page].found)
                                : std::span<const Found>();
}

std::size_t Finder::firstFrom(std::size_t page) const {
    return page < pages_.size() ? pages_[page].before : count_;
}

} // namespace places
