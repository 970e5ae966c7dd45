// A number of the text that the pointer drags or keys count up and down.
//
// Alt and the left button on a number, or the grip that appears below a number under the pointer;
// then left and right. Alt+Up and Alt+Down do the same by keys until Alt is let go. In the
// document's text the scene follows at once and all is one step of undo; in a draft it is typing.
#pragma once

#include "language/draft.h"

#include <memory>

namespace views {

class NumberDrag : public QObject, public EditorTool {
    Q_OBJECT
public:
    NumberDrag(SceneEditor& editor, SceneDocument& document, Draft& draft);

    [[nodiscard]] bool active() const { return static_cast<bool>(gesture_); }
    // Of the draft as it was when it began, where there is one.
    [[nodiscard]] std::optional<Asked> asked() const;
    // Counts the number at the caret by so many steps; false: there is none.
    bool count(int steps);
    void finish();
    void cancel();

    bool pressed(const QMouseEvent& event) override;
    bool moved(const QMouseEvent& event) override;
    bool released(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    bool keyReleased(const QKeyEvent& event) override;
    void left() override;
    void paint(QPainter& painter) override;

private:
    struct Gesture {
        std::string text; // when it began
        int since = 0;    // its revision
        scene::Range number;
        double value = 0, step = 1;
        std::string now; // what stands there
        int startX = 0;
        long steps = 0;
        bool byPointer = false;
        bool inDraft = false;
    };
    [[nodiscard]] std::optional<scene::Range> numberAt(std::size_t byte) const;
    bool begin(scene::Range number);
    void letGo(); // before another's text comes in
    void set(long steps);
    void hover(const QPoint& position, bool alt);
    [[nodiscard]] QRectF gripOf(scene::Range number) const;

    SceneEditor& editor_;
    SceneDocument& document_;
    Draft& draft_;
    std::unique_ptr<Gesture> gesture_;
    std::optional<scene::Range> hovered_;
};

} // namespace views
