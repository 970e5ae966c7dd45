#include "language/scene_lexer.h"

#include "language/scene_editor.h"
#include "script/commands.h"
#include "script/structure.h"

#include <QFontDatabase>
#include <QGuiApplication>
#include <QPalette>

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace views {

namespace {

bool isNumber(std::string_view word) {
    std::size_t i = word.starts_with('-') || word.starts_with('+') ? 1 : 0;
    bool digits = false;
    for (; i < word.size(); ++i) {
        const auto c = static_cast<unsigned char>(word[i]);
        digits = digits || std::isdigit(c) != 0;
        const bool sign = (c == '-' || c == '+') && (word[i - 1] == 'e' || word[i - 1] == 'E');
        if (std::isdigit(c) == 0 && c != '.' && c != 'e' && c != 'E' && !sign)
            return false;
    }
    return digits;
}

bool isOption(std::string_view word) {
    return word.size() > 1 && word[0] == '-' &&
           std::isalpha(static_cast<unsigned char>(word[1])) != 0;
}

bool separates(char c) {
    return std::string_view(" \t\n{}[]\";").find(c) != std::string_view::npos;
}

class Painter {
public:
    Painter(std::string_view text, const script::Structure& structure)
        : text_(text), styles_(text.size(), SceneLexer::plain) {
        paintPieces();
        for (const script::Command& command : structure.commands)
            paintCommand(command);
        for (const script::Range& comment : structure.comments)
            paint(comment.from, comment.to, SceneLexer::comment);
    }
    std::vector<char> take() { return std::move(styles_); }

private:
    void paint(std::size_t from, std::size_t to, char style) {
        for (std::size_t i = from; i < std::min(to, styles_.size()); ++i)
            styles_[i] = style;
    }

    // Numbers, options and variables look the same wherever they stand.
    void paintPieces() {
        for (std::size_t i = 0; i < text_.size();) {
            if (separates(text_[i])) {
                ++i;
                continue;
            }
            std::size_t end = i;
            while (end < text_.size() && !separates(text_[end]))
                ++end;
            const std::string_view piece = text_.substr(i, end - i);
            if (isNumber(piece))
                paint(i, end, SceneLexer::number);
            else if (isOption(piece))
                paint(i, end, SceneLexer::option);
            else
                paintVariables(i, end);
            i = end;
        }
    }

    void paintVariables(std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            if (text_[i] != '$')
                continue;
            std::size_t end = i + 1;
            while (end < to && (std::isalnum(static_cast<unsigned char>(text_[end])) != 0 ||
                                text_[end] == '_' || text_[end] == ':'))
                ++end;
            paint(i, end, SceneLexer::variable);
        }
    }

    void paintCommand(const script::Command& command) {
        const std::string_view name = command.name(text_);
        for (const script::Word& word : command.words)
            if (word.quoted) {
                for (std::size_t i = word.range.from; i < word.range.to; ++i)
                    if (styles_[i] == SceneLexer::plain)
                        styles_[i] = SceneLexer::string;
            }
        if (command.words.empty() || name.empty())
            return;
        const script::Range place = command.words[0].range;
        if (script::isSceneCommand(name))
            paint(place.from, place.to, SceneLexer::sceneCommand);
        else if (script::isTclCommand(name))
            paint(place.from, place.to, SceneLexer::tclCommand);
    }

    std::string_view text_;
    std::vector<char> styles_;
};

bool isDark() { return QGuiApplication::palette().color(QPalette::Base).lightness() < 128; }

} // namespace

SceneLexer::SceneLexer(QsciScintilla* editor) : QsciLexerCustom(editor) {}

QString SceneLexer::description(int style) const {
    switch (style) {
    case plain:
        return tr("Text");
    case comment:
        return tr("Comment");
    case sceneCommand:
        return tr("Scene command");
    case tclCommand:
        return tr("Tcl command");
    case option:
        return tr("Option");
    case number:
        return tr("Number");
    case variable:
        return tr("Variable");
    case string:
        return tr("Quoted word");
    case hidden:
        return tr("Hidden points");
    case mark:
        return tr("Mark of hidden points");
    default:
        return {};
    }
}

QColor SceneLexer::defaultColor(int style) const {
    const bool dark = isDark();
    switch (style) {
    case comment:
        return dark ? QColor(0x8A, 0x99, 0x8A) : QColor(0x6A, 0x7B, 0x6A);
    case sceneCommand:
        return dark ? QColor(0x7F, 0xB5, 0xF0) : QColor(0x12, 0x55, 0xA8);
    case tclCommand:
        return dark ? QColor(0xC5, 0x9B, 0xE0) : QColor(0x7A, 0x3A, 0x96);
    case option:
        return dark ? QColor(0x6F, 0xC3, 0xB7) : QColor(0x0B, 0x70, 0x6A);
    case number:
        return dark ? QColor(0xE5, 0xB0, 0x6B) : QColor(0xA2, 0x4A, 0x08);
    case variable:
        return dark ? QColor(0xE0, 0x8F, 0x9A) : QColor(0xA0, 0x28, 0x45);
    case string:
        return dark ? QColor(0xB5, 0xC9, 0x7A) : QColor(0x4D, 0x6B, 0x0A);
    case mark:
        return defaultPaper(mark);
    default:
        return QGuiApplication::palette().color(QPalette::Text);
    }
}

QColor SceneLexer::defaultPaper(int style) const {
    if (style == mark)
        return isDark() ? QColor(0x3E, 0x3A, 0x58) : QColor(0xE4, 0xE1, 0xF4);
    return QGuiApplication::palette().color(QPalette::Base);
}

QFont SceneLexer::defaultFont(int style) const {
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    if (font.pointSizeF() < 10)
        font.setPointSizeF(10);
    font.setBold(style == sceneCommand);
    font.setItalic(style == comment);
    return font;
}

void SceneLexer::styleText(int, int) {
    if (editor() == nullptr)
        return;
    const auto& scene = static_cast<const SceneEditor&>(*editor()); // nobody else makes one
    const std::string& text = scene.bytes();
    std::vector<char> styles = Painter(text, scene.structure()).take();
    for (const Hidden& range : hidden_ ? hidden_() : std::vector<Hidden>())
        for (std::size_t i = range.from; i < std::min(range.to, styles.size()); ++i)
            if (text[i] != '\n')
                styles[i] = i < range.marked ? mark : hidden;
    startStyling(0);
    editor()->SendScintilla(QsciScintillaBase::SCI_SETSTYLINGEX,
                            static_cast<unsigned long>(styles.size()), styles.data());
}

} // namespace views
