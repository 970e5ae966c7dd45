// The values beside the bodies of a picture without a window, those of plots with `-beside 1`. They
// stand as in a graphical viewer (meters/meters.h), but nobody drags them.
#pragma once

#include "meters/meters.h"

#include <string>
#include <vector>

namespace lettering {

struct ValueBeside {
    std::string words;
    meters::Wish wish; // without its size, which the letters tell
};
// At the drawing's time. `scale`: device pixels for each of the reader's.
[[nodiscard]] std::vector<ValueBeside> valuesBeside(const render::Drawing& drawing,
                                                    const render::Size& size, double scale,
                                                    const meters::Sampled& sampled);

// Into a picture that is drawn; gives the room that they take there.
std::vector<Eigen::AlignedBox2d> drawValues(const std::vector<ValueBeside>& values, double scale,
                                            bool isDark, const render::Image& into);

} // namespace lettering
