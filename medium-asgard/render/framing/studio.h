// The colours behind a scene in a window: ground, horizon and sky, by day and by night.
#pragma once

#include <Eigen/Core>

namespace render {

struct StudioColors {                           // sRGB
    Eigen::Vector3f near, far, haze, low, high; // ground, horizon, sky
};

[[nodiscard]] inline const StudioColors& studioColors(bool dark) {
    static const StudioColors day{{0.855F, 0.862F, 0.870F},
                                  {0.915F, 0.920F, 0.926F},
                                  {0.958F, 0.963F, 0.970F},
                                  {0.915F, 0.938F, 0.965F},
                                  {0.760F, 0.835F, 0.915F}};
    static const StudioColors night{{0.128F, 0.132F, 0.140F},
                                    {0.185F, 0.191F, 0.202F},
                                    {0.262F, 0.278F, 0.305F},
                                    {0.205F, 0.222F, 0.252F},
                                    {0.100F, 0.115F, 0.145F}};
    return dark ? night : day;
}

} // namespace render
