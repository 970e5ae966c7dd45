#include "formulas/font.h"

#include <QFile>
#include <QStandardPaths>
#include <algorithm>
#include <array>
#include <cmath>

namespace formulas {

namespace {

// In the order of preference. TeX Gyre Termes goes with the text's letters.
constexpr const char* files[] = {
    "texmf/fonts/opentype/public/tex-gyre-math/texgyretermes-math.otf",
    "fonts/opentype/stix-word/STIXMath-Regular.otf",
    "texmf/fonts/opentype/public/lm-math/latinmodern-math.otf",
    "fonts/truetype/dejavu/DejaVuMathTeXGyre.ttf",
};

struct Drawing {
    QPainterPath path;
    double em = 1;
    [[nodiscard]] QPointF at(float x, float y) const { return {x / em, -y / em}; }
};

Drawing& drawing(void* data) { return *static_cast<Drawing*>(data); }

hb_draw_funcs_t* drawFunctions() {
    static hb_draw_funcs_t* const drawn = [] {
        hb_draw_funcs_t* made = hb_draw_funcs_create();
        hb_draw_funcs_set_move_to_func(
            made,
            [](hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) {
                drawing(data).path.moveTo(drawing(data).at(x, y));
            },
            nullptr, nullptr);
        hb_draw_funcs_set_line_to_func(
            made,
            [](hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) {
                drawing(data).path.lineTo(drawing(data).at(x, y));
            },
            nullptr, nullptr);
        hb_draw_funcs_set_quadratic_to_func(
            made,
            [](hb_draw_funcs_t*, void* data, hb_draw_state_t*, float cx, float cy, float x, float y,
               void*) {
                drawing(data).path.quadTo(drawing(data).at(cx, cy), drawing(data).at(x, y));
            },
            nullptr, nullptr);
        hb_draw_funcs_set_cubic_to_func(
            made,
            [](hb_draw_funcs_t*, void* data, hb_draw_state_t*, float ax, float ay, float bx,
               float by, float x, float y, void*) {
                Drawing& to = drawing(data);
                to.path.cubicTo(to.at(ax, ay), to.at(bx, by), to.at(x, y));
            },
            nullptr, nullptr);
        hb_draw_funcs_set_close_path_func(
            made,
            [](hb_draw_funcs_t*, void* data, hb_draw_state_t*, void*) {
                drawing(data).path.closeSubpath();
            },
            nullptr, nullptr);
        hb_draw_funcs_make_immutable(made);
        return made;
    }();
    return drawn;
}

struct FreeBuffer {
    void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
};
using Buffer = std::unique_ptr<hb_buffer_t, FreeBuffer>;

Buffer shapedBuffer(hb_font_t* font, const std::string& text) {
    Buffer buffer(hb_buffer_create());
    hb_buffer_add_utf8(buffer.get(), text.data(), static_cast<int>(text.size()), 0, -1);
    hb_buffer_set_direction(buffer.get(), HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer.get(), HB_SCRIPT_LATIN);
    hb_buffer_set_language(buffer.get(), hb_language_from_string("en", -1));
    hb_shape(font, buffer.get(), nullptr, 0);
    return buffer;
}

hb_direction_t direction(bool vertical) { return vertical ? HB_DIRECTION_TTB : HB_DIRECTION_LTR; }

std::vector<hb_ot_math_glyph_variant_t> variantsOf(hb_font_t* font, GlyphId glyph, bool vertical) {
    std::array<hb_ot_math_glyph_variant_t, 32> found{};
    auto count = static_cast<unsigned>(found.size());
    hb_ot_math_get_glyph_variants(font, glyph, direction(vertical), 0, &count, found.data());
    return {found.begin(), found.begin() + count};
}

} // namespace

Font::Font(hb_font_t* font) : font_(font), em_(hb_face_get_upem(hb_font_get_face(font))) {}

std::shared_ptr<const Font> Font::load(const QString& file) {
    hb_blob_t* blob = hb_blob_create_from_file_or_fail(QFile::encodeName(file).constData());
    if (blob == nullptr)
        return nullptr;
    hb_face_t* face = hb_face_create(blob, 0);
    hb_blob_destroy(blob);
    const bool usable = hb_ot_math_has_data(face) != 0 && hb_face_get_upem(face) > 0;
    hb_font_t* font = usable ? hb_font_create(face) : nullptr;
    hb_face_destroy(face);
    if (font == nullptr)
        return nullptr;
    hb_font_make_immutable(font);
    return std::shared_ptr<const Font>(new Font(font));
}

const std::shared_ptr<const Font>& Font::standard() {
    static const std::shared_ptr<const Font> found = []() -> std::shared_ptr<const Font> {
        for (const char* file : files) {
            const QString path = QStandardPaths::locate(QStandardPaths::GenericDataLocation, file);
            const QString usual = path.isEmpty() ? QString("/usr/share/") + file : path;
            if (auto font = load(usual))
                return font;
        }
        return nullptr;
    }();
    return found;
}

QString Font::missing() {
    return QStringLiteral("No font for formulas is installed, so they are shown as plain text: "
                          "install the package fonts-texgyre-math.");
}

double Font::constant(hb_ot_math_constant_t constant) const {
    return hb_ot_math_get_constant(font_.get(), constant) / em_;
}

double Font::percent(hb_ot_math_constant_t constant) const {
    return hb_ot_math_get_constant(font_.get(), constant) / 100.0;
}

GlyphId Font::withFeature(char32_t code, hb_tag_t tag, std::uint32_t value) const {
    const hb_feature_t feature{tag, value, HB_FEATURE_GLOBAL_START, HB_FEATURE_GLOBAL_END};
    Buffer buffer(hb_buffer_create());
    const std::uint32_t letter = code;
    hb_buffer_add_codepoints(buffer.get(), &letter, 1, 0, 1);
    hb_buffer_set_direction(buffer.get(), HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer.get(), HB_SCRIPT_MATH);
    hb_shape(font_.get(), buffer.get(), &feature, 1);
    unsigned count = 0;
    const hb_glyph_info_t* info = hb_buffer_get_glyph_infos(buffer.get(), &count);
    return count == 1 ? info[0].codepoint : 0;
}

std::optional<GlyphId> Font::glyph(char32_t code, int scriptLevel) const {
    hb_codepoint_t glyph = 0;
    if (hb_font_get_nominal_glyph(font_.get(), code, &glyph) == 0)
        return std::nullopt;
    if (scriptLevel > 0)
        if (const GlyphId small = withFeature(code, HB_TAG('s', 's', 't', 'y'),
                                              static_cast<std::uint32_t>(scriptLevel));
            small != 0)
            return small;
    return glyph;
}

std::optional<GlyphId> Font::dotless(char32_t code) const {
    const GlyphId glyph = withFeature(code, HB_TAG('d', 't', 'l', 's'), 1);
    return glyph != 0 ? std::optional(glyph) : std::nullopt;
}

std::vector<std::pair<GlyphId, double>> Font::shaped(const std::string& text) const {
    const Buffer buffer = shapedBuffer(font_.get(), text);
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer.get(), &count);
    std::vector<std::pair<GlyphId, double>> glyphs;
    glyphs.reserve(count);
    for (unsigned i = 0; i < count; ++i)
        glyphs.emplace_back(infos[i].codepoint, places[i].x_advance / em_);
    return glyphs;
}

GlyphSize Font::size(GlyphId glyph) const {
    hb_glyph_extents_t extents{};
    hb_font_get_glyph_extents(font_.get(), glyph, &extents);
    return {hb_font_get_glyph_h_advance(font_.get(), glyph) / em_, extents.y_bearing / em_,
            -(extents.y_bearing + extents.height) / em_,
            hb_ot_math_get_glyph_italics_correction(font_.get(), glyph) / em_};
}

double Font::accentPlace(GlyphId glyph) const {
    return hb_ot_math_get_glyph_top_accent_attachment(font_.get(), glyph) / em_;
}

double Font::kern(GlyphId glyph, hb_ot_math_kern_t corner, double height) const {
    const auto units = static_cast<hb_position_t>(std::lround(height * em_));
    return hb_ot_math_get_glyph_kerning(font_.get(), glyph, corner, units) / em_;
}

Grown Font::grown(GlyphId glyph, bool vertical, double atLeast) const {
    const auto variants = variantsOf(font_.get(), glyph, vertical);
    for (const auto& variant : variants)
        if (variant.advance / em_ >= atLeast)
            return {{{variant.glyph, 0}}, variant.advance / em_};
    Grown made = assembled(glyph, vertical, atLeast);
    if (!made.pieces.empty())
        return made;
    if (!variants.empty())
        return {{{variants.back().glyph, 0}}, variants.back().advance / em_};
    const GlyphSize own = size(glyph);
    return {{{glyph, 0}}, vertical ? own.ascent + own.descent : own.width};
}

Grown Font::assembled(GlyphId glyph, bool vertical, double atLeast) const {
    std::array<hb_ot_math_glyph_part_t, 16> parts{};
    auto count = static_cast<unsigned>(parts.size());
    hb_ot_math_get_glyph_assembly(font_.get(), glyph, direction(vertical), 0, &count, parts.data(),
                                  nullptr);
    const double least =
        hb_ot_math_get_min_connector_overlap(font_.get(), direction(vertical)) / em_;
    double fixed = 0, repeated = 0;
    for (unsigned i = 0; i < count; ++i) {
        const bool extends = (parts[i].flags & HB_OT_MATH_GLYPH_PART_FLAG_EXTENDER) != 0;
        (extends ? repeated : fixed) += parts[i].full_advance / em_ - least;
    }
    constexpr double mostRepeated = 500;
    const double wanted = repeated > 0 ? std::ceil((atLeast - fixed - least) / repeated) : 0;
    const int times = static_cast<int>(std::clamp(wanted, 0.0, mostRepeated));
    std::vector<const hb_ot_math_glyph_part_t*> row;
    for (unsigned i = 0; i < count; ++i) {
        const bool extends = (parts[i].flags & HB_OT_MATH_GLYPH_PART_FLAG_EXTENDER) != 0;
        row.insert(row.end(), static_cast<std::size_t>(extends ? times : 1), &parts[i]);
    }
    if (row.empty())
        return {};
    const double longest = fixed + times * repeated + least;
    const double joints = static_cast<double>(row.size()) - 1;
    const double more = joints > 0 ? std::max(0.0, longest - atLeast) / joints : 0;
    Grown made;
    double end = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (i > 0) {
            const double most =
                std::min(row[i - 1]->end_connector_length, row[i]->start_connector_length) / em_;
            end -= std::max(least, std::min(least + more, most));
        }
        made.pieces.push_back({row[i]->glyph, end});
        end += row[i]->full_advance / em_;
    }
    made.length = end;
    return made;
}

GlyphId Font::widest(GlyphId glyph, double atMost) const {
    GlyphId best = glyph;
    for (const auto& variant : variantsOf(font_.get(), glyph, false))
        if (variant.advance / em_ <= atMost)
            best = variant.glyph;
    return best;
}

QPainterPath Font::outline(GlyphId glyph) const {
    const std::scoped_lock lock(drawing_);
    const auto [known, isNew] = outlines_.try_emplace(glyph);
    if (!isNew)
        return known->second;
    Drawing to;
    to.em = em_;
    to.path.setFillRule(Qt::WindingFill);
    hb_font_get_glyph_shape(font_.get(), glyph, drawFunctions(), &to);
    known->second = to.path;
    return to.path;
}

} // namespace formulas
