// Runs whose text comes from elsewhere in a document, or from outside of it, get it in copies of
// their blocks: a block that a model holds never changes.
#pragma once

#include "model/model.h"

#include <functional>
#include <optional>

namespace model {

// The run as it is now; nothing: it is as it was.
using RunNow = std::function<std::optional<Run>(const Run&)>;

// The block itself when all its runs are as they were, those in its cells and footnotes included.
[[nodiscard]] std::shared_ptr<const Block> resolved(const std::shared_ptr<const Block>& block,
                                                    const RunNow& runNow);

} // namespace model
