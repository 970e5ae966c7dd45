#include "model/references.h"

#include "model/resolving.h"

namespace model {

References::References(const ModelWalk::Trail& trail) {
    for (const ModelWalk::Segment& segment : trail)
        for (const Name& name : segment.names)
            names_.try_emplace(name.id, name.reference);
}

bool References::differFrom(const References& other) const { return names_ != other.names_; }

std::string References::textOf(const std::string& id) const {
    const auto known = names_.find(id);
    std::string text = known == names_.end() || known->second.empty() ? id : known->second;
    // "Figure 1" is not broken between its words.
    for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at))
        text.replace(at, 1, "\u00A0");
    return text;
}

std::shared_ptr<const Block> References::resolved(const std::shared_ptr<const Block>& block) const {
    return model::resolved(block, [this](const Run& run) -> std::optional<Run> {
        if (!run.refers)
            return std::nullopt;
        std::string text = textOf(run.target.substr(1));
        if (text == run.text)
            return std::nullopt;
        Run now = run;
        now.text = std::move(text);
        return now;
    });
}

} // namespace model
