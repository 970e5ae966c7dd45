// A reader of texts that the tests of this folder share: the real evaluator.
#pragma once

#include "script/reader.h"

#include <gmock/gmock.h>

#include <memory>
#include <string>

namespace editing {

inline script::Reader& reader() {
    static script::Reader shared;
    return shared;
}

inline const std::string ballShape = "shape_set s -desc {-sub {-sphere 1}}\n";

inline std::shared_ptr<const scene::Scene> readScene(const std::string& text) {
    const auto result = reader().read(text);
    EXPECT_TRUE(result.usable) << (result.diagnostics.empty() ? ""
                                                              : result.diagnostics.front().message)
                               << "\n"
                               << text;
    return std::make_shared<const scene::Scene>(result.scene);
}

} // namespace editing
