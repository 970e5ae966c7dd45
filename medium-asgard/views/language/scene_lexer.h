// Colours of a scene's text: commands, options, numbers, comments, as the language knows them.
//
// Commands, words and comments come from script/structure.h, which follows Tcl's rules; so a scene
// command in the body of a loop is coloured and the same letters in a string are not.
#pragma once

#include "language/scintilla.h"

#include <functional>
#include <vector>

namespace views {

class SceneLexer : public QsciLexerCustom {
    Q_OBJECT
public:
    enum Style {
        plain,
        comment,
        sceneCommand,
        tclCommand,
        option,
        number,
        variable,
        string,
        hidden, // points that are not shown ...
        mark
    }; // ... and the bytes behind what is shown in their place

    explicit SceneLexer(QsciScintilla* editor);

    [[nodiscard]] const char* language() const override { return "Asgard"; }
    [[nodiscard]] QString description(int style) const override;
    [[nodiscard]] QColor defaultColor(int style) const override;
    [[nodiscard]] QColor defaultPaper(int style) const override;
    [[nodiscard]] QFont defaultFont(int style) const override;

    // Which bytes are hidden and which lie behind a mark, asked whenever the text is coloured.
    struct Hidden {
        std::size_t from = 0, marked = 0, to = 0; // mark: [from, marked)
    };
    void setHidden(std::function<std::vector<Hidden>()> ranges) { hidden_ = std::move(ranges); }

    // Bytes [start, end) are to be coloured; the whole text is, since a brace changes all below.
    void styleText(int start, int end) override;

private:
    std::function<std::vector<Hidden>()> hidden_;
};

} // namespace views
