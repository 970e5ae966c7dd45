// Commands for pictures of files.
#pragma once

#include "authoring/authoring.h"

namespace authoring {

struct NewImage {
    std::string file{};        // as IMAGE's FILE names it
    std::string alternative{}; // for who does not see it
    std::string caption{};     // plain; "": none
    int width = 0;             // 1/96 inch; 0: the picture's own
    bool isInLine = false;     // without a figure around it
};
// In a figure, where the class has figures and one may stand there.
[[nodiscard]] Result insertImage(const Manuscript& manuscript, Selection selection,
                                 const NewImage& image);

} // namespace authoring
