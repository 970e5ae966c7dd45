#include "service/handle_labels.h"

#include "handles/handle_layout.h"
#include "lettering/lettering.h"

#include <utility>
#include <vector>

namespace service {

void drawLabels(const render::HandleSet& handles, const gestures::Sight& sight, double scale,
                bool isDark, std::vector<Eigen::AlignedBox2d> taken, const render::Image& into) {
    const std::vector<const render::Handle*> all = render::labelled(handles);
    if (all.empty())
        return;
    lettering::Lettering letters(into, scale, isDark);
    std::vector<render::LabelWish> wishes;
    wishes.reserve(all.size());
    for (const render::Handle* handle : all)
        wishes.push_back({render::standOf(*handle, sight.camera, sight.size),
                          letters.sizeOf(handle->label), 7 * scale});
    const Eigen::AlignedBox2d picture(Eigen::Vector2d(0, 0),
                                      Eigen::Vector2d(into.size.width, into.size.height));
    const auto boxes = render::placedLabels(wishes, picture, std::move(taken));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const double ink = isDark ? 1.3 : 0.65;
        const scene::Color& color = render::colorOf(all[i]->kind);
        letters.write(all[i]->label, boxes[i],
                      {ink * color.red, ink * color.green, ink * color.blue});
    }
}

} // namespace service
