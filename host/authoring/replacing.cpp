// Text is replaced at many places at once.
#include "authoring/commands.h"

#include "sgml/edit.h"

namespace authoring {

using sgml::NodeId;

namespace {

class Replacing {
public:
    Replacing(const Manuscript& manuscript, std::string_view text)
        : manuscript_(manuscript), tree_(manuscript.document.tree()), text_(text) {}

    void replace(text::Range place) {
        if (replaceInContent(place))
            return;
        flush();
        const Selection selection{place.from, place.to};
        const Result one = text_.empty() ? erase(manuscript_, selection, Direction::forward)
                                         : type(manuscript_, selection, text_);
        const auto* made = std::get_if<Step>(&one);
        if (made == nullptr)
            why_ = std::get<Refusal>(one).why;
        // Two places that share letters are replaced once: the first of them.
        if (made != nullptr &&
            isBehind(made->edits.empty() ? place.from : made->edits.front().range.from))
            take(made->edits, place.to);
        else
            ++all_.left;
    }

    Replacement result() {
        flush();
        if (all_.replaced == 0) {
            all_.result =
                refused(why_.isEmpty() ? QStringLiteral("There is nothing to replace.") : why_);
            return std::move(all_);
        }
        const std::size_t after = text::moved(last_, step_.edits, text::Gravity::behind);
        step_.label = QStringLiteral("Replace");
        step_.after = {after, after};
        all_.result = std::move(step_);
        return std::move(all_);
    }

private:
    // False: it is over an element's end, or all of a content, whose element may then have to go.
    bool replaceInContent(text::Range place) {
        const NodeId content = tree_.innermostAt(place.from);
        if (tree_.node(content).kind != sgml::NodeKind::content)
            return false;
        const text::Range all = tree_.contentRange(content);
        if (place.from < all.from || place.to > all.to ||
            (place.size() == all.size() && text_.empty()))
            return false;
        if (content != content_) {
            flush();
            content_ = content;
            unescaped_ = tree_.unescaped(content);
        }
        if (isBehind(place.from)) {
            inContent_.push_back(
                {{unescaped_.textOffset(place.from), unescaped_.textOffset(place.to)},
                 std::string(text_)});
            last_ = place.to;
            ++all_.replaced;
        } else {
            ++all_.left;
        }
        return true;
    }
    // Those of one content together: braces that lose their partners are seen by all of them.
    void flush() {
        if (inContent_.empty())
            return;
        const text::Edits edits = sgml::contentEdits(tree_, content_, inContent_);
        step_.edits.insert(step_.edits.end(), edits.begin(), edits.end());
        inContent_.clear();
        content_ = sgml::noNode;
    }
    void take(const text::Edits& edits, std::size_t end) {
        step_.edits.insert(step_.edits.end(), edits.begin(), edits.end());
        last_ = end;
        ++all_.replaced;
    }
    [[nodiscard]] bool isBehind(std::size_t at) const {
        return at >= last_ && (step_.edits.empty() || step_.edits.back().range.to <= at);
    }

    const Manuscript& manuscript_;
    const sgml::Tree& tree_;
    std::string_view text_;
    Step step_;
    Replacement all_;
    QString why_;
    std::size_t last_ = 0;          // the end of the last place
    NodeId content_ = sgml::noNode; // that the next ones may be in, too
    sgml::Unescaped unescaped_;     // of it
    text::Edits inContent_;         // of its text
};

} // namespace

Replacement replaceAll(const Manuscript& manuscript, const std::vector<text::Range>& places,
                       std::string_view text) {
    Replacing replacing(manuscript, text);
    for (const text::Range& place : places)
        replacing.replace(place);
    return replacing.result();
}

} // namespace authoring
