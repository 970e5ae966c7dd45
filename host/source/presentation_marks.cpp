#include "source/presentation_marks.h"

namespace source {

namespace {

class PresentationMarker {
public:
    explicit PresentationMarker(std::string_view text) : text_(text) {}

    std::vector<Mark> marks() {
        for (std::size_t from = 0; at_ < text_.size(); from = at_) {
            if (text_.substr(at_).starts_with("/*")) {
                at_ = behind("*/");
                add(from, Kind::comment);
            } else if (text_[at_] == '"') {
                ++at_;
                at_ = std::min(text_.find_first_of("\"\n", at_), text_.size());
                at_ = std::min(at_ + 1, text_.size());
            } else if (isSign(text_[at_])) {
                enter(text_[at_++]);
            } else {
                while (at_ < text_.size() && text_[at_] != '"' && !isSign(text_[at_]) &&
                       !text_.substr(at_).starts_with("/*"))
                    ++at_;
                add(from, inside_);
            }
        }
        return std::move(marks_);
    }

private:
    // A colon outside of a block belongs to a selector, as in ROW:first.
    [[nodiscard]] bool isSign(char c) const {
        return c == '{' || c == '}' || (inside_ != Kind::tag && (c == ':' || c == ';'));
    }
    void enter(char sign) {
        inside_ = sign == '}' ? Kind::tag : sign == ':' ? Kind::value : Kind::attribute;
    }
    [[nodiscard]] std::size_t behind(std::string_view end) const {
        const std::size_t found = text_.find(end, at_);
        return found == std::string_view::npos ? text_.size() : found + end.size();
    }
    void add(std::size_t from, Kind kind) { marks_.push_back({{from, at_}, kind}); }

    std::string_view text_;
    std::size_t at_ = 0;
    Kind inside_ = Kind::tag; // what words are here
    std::vector<Mark> marks_;
};

} // namespace

std::vector<Mark> presentationMarks(std::string_view text) {
    return PresentationMarker(text).marks();
}

} // namespace source
