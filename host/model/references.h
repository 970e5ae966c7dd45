// The texts of references: a run that refers shows the number or the name of what has its ID, or
// that nothing has it.
#pragma once

#include "model/model_walk.h"

#include <string>
#include <unordered_map>

namespace model {

class References {
public:
    // Of two equal IDs the first one counts.
    explicit References(const ModelWalk::Trail& trail);
    References() = default;

    // The block itself when all its references have their texts already, those in its cells and
    // footnotes included.
    [[nodiscard]] std::shared_ptr<const Block>
    resolved(const std::shared_ptr<const Block>& block) const;
    // Some ID is referred to by another text there.
    [[nodiscard]] bool differFrom(const References& other) const;

private:
    [[nodiscard]] Run resolved(const Run& run) const;

    std::unordered_map<std::string, Reference> names_;
};

} // namespace model
