#include "paragraphs/typeface.h"

#include "paragraphs/measure.h"

#include <QStringList>

namespace paragraphs {

QStringList familiesOf(const std::string& family) {
    if (family == "serif")
        return {"Linux Libertine O", "Libertinus Serif", "P052", "Liberation Serif",
                "DejaVu Serif"};
    if (family == "sans")
        return {"Inter", "Liberation Sans", "DejaVu Sans"};
    if (family == "mono")
        return {"DejaVu Sans Mono", "Liberation Mono"};
    return {QString::fromStdString(family), "Linux Libertine O", "DejaVu Serif"};
}

QFont fontOf(const schemas::TextStyle& style) {
    // The monospaced and the sans serif faces are larger on their body than the serif one.
    const double optical = style.family == "mono" ? 0.84 : style.family == "sans" ? 0.92 : 1.0;
    QFont font;
    font.setFamilies(familiesOf(style.family));
    font.setPixelSize(std::max(1, qRound(fromPoints(style.size * optical))));
    font.setBold(style.bold);
    font.setItalic(style.italic);
    font.setUnderline(style.underline);
    font.setHintingPreference(QFont::PreferNoHinting);
    font.setKerning(true);
    // Letters a 64th of a pixel apart are not joined into ligatures: the serif face's "Th" and "tt"
    // are glyphs without a character, which would make the words of a PDF impossible to find and to
    // copy.
    font.setLetterSpacing(QFont::AbsoluteSpacing, 1.0 / 64);
    return font;
}

QTextCharFormat formatOf(const schemas::TextStyle& style) {
    QTextCharFormat format;
    format.setFont(fontOf(style));
    format.setForeground(colorOf(style.color));
    if (style.background)
        format.setBackground(colorOf(*style.background));
    if (style.raised)
        format.setVerticalAlignment(QTextCharFormat::AlignSuperScript);
    return format;
}

QColor colorOf(const schemas::Color& color) { return {color.red, color.green, color.blue}; }

} // namespace paragraphs
