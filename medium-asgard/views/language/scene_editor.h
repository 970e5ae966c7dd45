// A text widget in which places are bytes of the scene's text: QScintilla, with marks of the
// language viewer's own.
//
// The abilities of a language viewer attach to it as tools (elision.h, number_drag.h, ...): each
// sees the pointer and the keys before Scintilla, and paints above the text.
#pragma once

#include "language/scintilla.h"
#include "scene/scene.h"
#include "script/structure.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace views {

// Kinds of marked stretches. A mark moves with its text.
enum class Mark {
    error = 8,
    warning,
    argument, // what pictures change too, in the colour of its handle
    elided,   // hidden behind a mark
    opened,   // would be hidden, but was opened
    conflict, // someone else changed what the draft changed too
    found,
    number // that the pointer can drag
};

class EditorTool {
public:
    virtual ~EditorTool() = default;
    // True: nobody else gets it.
    virtual bool pressed(const QMouseEvent&) { return false; }
    virtual bool moved(const QMouseEvent&) { return false; }
    virtual bool released(const QMouseEvent&) { return false; }
    virtual bool key(const QKeyEvent&) { return false; }
    virtual bool keyReleased(const QKeyEvent&) { return false; }
    virtual void replacing() {} // the selected text is about to become something else
    virtual void left() {}      // the pointer or the focus left
    virtual void paint(QPainter&) {}
    // The tip for the byte below the pointer, "" when there is none.
    [[nodiscard]] virtual QString tip(std::size_t) const { return {}; }
};

class SceneEditor : public QsciScintilla {
    Q_OBJECT
public:
    explicit SceneEditor(QWidget* parent = nullptr);

    [[nodiscard]] const std::string& bytes() const;
    // Gone through once for each text, however many ask.
    [[nodiscard]] const script::Structure& structure() const;
    [[nodiscard]] std::size_t length() const;
    void replace(scene::Range range, std::string_view text);

    [[nodiscard]] std::size_t caret() const;
    [[nodiscard]] scene::Range selection() const;
    void select(scene::Range range);                  // and shows it
    void reveal(scene::Range range);                  // its lines and what is noted below them
    [[nodiscard]] int lineOf(std::size_t byte) const; // from 0
    [[nodiscard]] QString word(scene::Range range) const;

    // `value`: a colour for Mark::argument, else 1.
    void mark(Mark kind, scene::Range range, int value = 1);
    void unmark(Mark kind);
    void unmark(Mark kind, scene::Range range);
    [[nodiscard]] bool isMarked(Mark kind, std::size_t byte) const;
    [[nodiscard]] std::vector<scene::Range> marks(Mark kind) const;
    // The marked stretch that this byte is in.
    [[nodiscard]] std::optional<scene::Range> markAt(Mark kind, std::size_t byte) const;

    // Where a byte is drawn, the height of its line.
    [[nodiscard]] QRect rectOf(std::size_t byte) const;
    // Whether a list or a tip at that byte has a screen to be on. Scintilla asks for the screen at
    // the byte's place without a look at whether there is one: nothing is shown there else.
    [[nodiscard]] bool isOnScreen(std::size_t byte) const;
    [[nodiscard]] std::optional<std::size_t> byteAt(const QPoint& position) const;

    // Not owned; forgetTools() before they go.
    void addTool(EditorTool* tool) { tools_.push_back(tool); }
    void forgetTools() { tools_.clear(); }
    void adaptToPalette();
    [[nodiscard]] bool isDark() const;

Q_SIGNALS:
    void menuWanted(const QPoint& global); // by the right button or its key

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void inputMethodEvent(QInputMethodEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    void defineMarks();
    void followChanges();

    mutable std::optional<std::string> bytes_; // as long as nothing is changed
    mutable std::optional<script::Structure> structure_;
    bool changing_ = false; // Scintilla is about to change the text, or has not said that it did
    std::vector<EditorTool*> tools_;
    bool taken_ = false; // the press was a tool's: so are moves until the release
};

} // namespace views
