#include "lettering/values_beside.h"

#include "lettering/lettering.h"

namespace lettering {

std::vector<ValueBeside> valuesBeside(const render::Drawing& drawing, const render::Size& size,
                                      double scale, const meters::Sampled& sampled) {
    std::vector<ValueBeside> all;
    for (const meters::Meter& meter : meters::metersOf(*drawing.scene))
        if (const auto place = meters::placeOf(drawing, {drawing.camera, size}, meter.of, scale))
            all.push_back(
                {meters::wordsOf(meter, sampled.of(drawing.scene->plots[meter.plot]), drawing.time),
                 {meter.of, *place, Eigen::Vector2d::Zero()}});
    return all;
}

std::vector<Eigen::AlignedBox2d> drawValues(const std::vector<ValueBeside>& values, double scale,
                                            bool isDark, const render::Image& into) {
    if (values.empty())
        return {};
    Lettering letters(into, scale, isDark);
    std::vector<meters::Wish> wishes;
    wishes.reserve(values.size());
    for (const ValueBeside& value : values) {
        wishes.push_back(value.wish);
        wishes.back().size = letters.sizeOf(value.words) / scale;
    }
    const auto boxes =
        meters::boxesFor(wishes, Eigen::Vector2d(into.size.width, into.size.height) / scale);
    const double grey = isDark ? 0.9 : 0.1;
    std::vector<Eigen::AlignedBox2d> taken;
    for (std::size_t i = 0; i < values.size(); ++i) {
        taken.emplace_back(scale * boxes[i].rect.min(), scale * boxes[i].rect.max());
        letters.write(values[i].words, taken.back(), {grey, grey, grey});
    }
    return taken;
}

} // namespace lettering
