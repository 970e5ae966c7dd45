// The parser's sentences about the text's bytes, and the places of its faults.
#include "sgml/parser.h"
#include "text/characters.h"

#include <algorithm>
#include <tuple>

namespace sgml {

// Reserves a line for what is not listed, so that a text of nothing but faults stays readable.
void Parser::fault(FaultKind kind, text::Range range, std::string message, Severity severity) {
    if (tree_.faults_.size() >= limits_.faults) {
        ++unlisted_;
        return;
    }
    range.to = std::min(std::max(range.from, range.to), text_.size());
    range.from = std::min(range.from, range.to);
    tree_.faults_.push_back(
        {.kind = kind, .severity = severity, .range = range, .message = std::move(message)});
}

// UTF-16 is named, since reading it byte by byte would say nothing useful.
bool Parser::checkEncoding() {
    const bool utf16 = text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF");
    if (utf16)
        fault(FaultKind::otherEncoding, {0, 2}, "the text is UTF-16; a document is UTF-8");
    const bool tooLong = text_.size() > limits_.bytes;
    if (tooLong)
        fault(FaultKind::limit, {0, 0},
              "the text is longer than " + std::to_string(limits_.bytes) +
                  " bytes and is not read");
    if ((utf16 || tooLong) && !text_.empty())
        addNode(NodeKind::stray, {0, text_.size()});
    if (text_.empty())
        fault(FaultKind::emptyDocument, {0, 0}, "the file is empty");
    return !utf16 && !tooLong && !text_.empty();
}

void Parser::checkBytes(text::Range range) {
    const std::size_t half = limits_.faults / 2; // leaves room for the faults of structure
    const std::string_view text = text_.substr(0, range.to);
    for (text::Range bad = text::illFormed(text, range.from);
         !bad.empty() && tree_.faults_.size() < half; bad = text::illFormed(text, bad.to))
        fault(FaultKind::invalidUtf8, bad, "these bytes are not UTF-8; they are kept as they are",
              Severity::warning);
    for (std::size_t at = text.find('\0', range.from);
         at != std::string_view::npos && tree_.faults_.size() < half; at = text.find('\0', at + 1))
        fault(FaultKind::nulByte, {at, at + 1}, "a NUL byte; it is kept as it is",
              Severity::warning);
}

void Parser::countUnlisted() {
    if (unlisted_ == 0)
        return;
    const auto last = std::max_element(
        tree_.faults_.begin(), tree_.faults_.end(),
        [](const Fault& a, const Fault& b) { return a.range.from < b.range.from; });
    const text::Range range = last->range;
    tree_.faults_.push_back({.kind = FaultKind::limit,
                             .range = range,
                             .message = std::to_string(unlisted_) + " more faults are not listed"});
}

// The order is of the faults alone, whatever order they were found in.
void Tree::sortFaults() {
    const auto key = [](const Fault& fault) {
        return std::tie(fault.range.from, fault.range.to, fault.kind, fault.message);
    };
    std::sort(faults_.begin(), faults_.end(),
              [&](const Fault& a, const Fault& b) { return key(a) < key(b); });
    placeFaults(faults_, *this);
}

void placeFaults(std::vector<Fault>& faults, const Tree& tree) {
    std::vector<std::size_t> offsets;
    offsets.reserve(faults.size());
    for (const Fault& fault : faults)
        offsets.push_back(fault.range.from);
    const std::vector<text::Position> places = tree.positions(offsets);
    for (std::size_t i = 0; i < faults.size(); ++i)
        faults[i].position = places[i];
}

} // namespace sgml
