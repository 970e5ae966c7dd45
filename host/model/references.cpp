#include "model/references.h"

#include "model/resolving.h"

namespace model {

References::References(const ModelWalk::Trail& trail) {
    for (const ModelWalk::Segment& segment : trail)
        for (const Name& name : segment.names)
            names_.try_emplace(name.id, name.reference);
}

bool References::differFrom(const References& other) const { return names_ != other.names_; }

Run References::resolved(const Run& run) const {
    const std::string id = run.target.substr(1);
    const auto known = names_.find(id);
    const bool isBroken = known == names_.end();
    Run now = run;
    if (isBroken)
        now.text = "(missing)";
    else
        now.text = run.byNumber ? known->second.number : known->second.name;
    if (now.text.empty())
        now.text = id;
    now.style = isBroken ? run.looks.broken : run.looks.usual;
    return now;
}

std::shared_ptr<const Block> References::resolved(const std::shared_ptr<const Block>& block) const {
    return model::resolved(block, [this](const Run& run) -> std::optional<Run> {
        if (!run.refers)
            return std::nullopt;
        Run now = resolved(run);
        if (now.text == run.text && now.style == run.style)
            return std::nullopt;
        return now;
    });
}

} // namespace model
