// Cameras that show a given extent well.
#pragma once

#include "framing/camera.h"
#include "framing/extent.h"

namespace render {

// From the front, a little to the side and above: the direction towards the viewer.
[[nodiscard]] Vector sideAndAbove(const Vector& up);

// The attitude from which an extent is best seen: straight on when the motion is flat, else from
// slightly above and to the side; up is up.
[[nodiscard]] Quaternion bestAttitude(const Extent& extent);

// The camera of that attitude in which all balls fill the picture but for a margin.
[[nodiscard]] Camera fitted(const Extent& extent, const Quaternion& attitude, Size size,
                            bool orthographic = false);

// The same about a given centre: it stays in the middle, only the scale is fitted.
[[nodiscard]] Camera fittedAbout(const Extent& extent, const Quaternion& attitude,
                                 const Vector& center, Size size, bool orthographic = false);

// The camera from so much further away that the picture shows all of these balls whole: what is in
// the middle stays there.
[[nodiscard]] Camera steppedBack(const Camera& camera, Size size, const std::vector<Ball>& balls);

// The camera for a picture of another size that still shows what of these balls the picture of the
// first size shows whole: the same one, or from further away.
[[nodiscard]] Camera keeping(const Camera& camera, Size before, Size now,
                             const std::vector<Ball>& balls);
// The picture shows all of the ball, but for what stands before it.
[[nodiscard]] bool isWithin(const Camera& camera, Size size, const Ball& ball);

// The world's direction towards the sun: over the left shoulder of whoever looks from there.
[[nodiscard]] Vector sunOf(const Extent& extent);

} // namespace render
