// Long lists of points are shown as a mark that says how many there are (dissertation 4.2.1).
//
// They stay in the text, byte for byte: they are only not drawn. Opened, they stand on a background
// of their own. Text is never hidden while it is typed: lists are hidden when the text is the
// document's, and by toggle(). The caret jumps over a mark; Backspace and Delete beside it select
// it first.
#pragma once

#include "editing/point_lists.h"
#include "language/scene_editor.h"

namespace views {

class Elision : public QObject, public EditorTool {
    Q_OBJECT
public:
    explicit Elision(SceneEditor& editor);

    // Hides what is long and was not opened, unless the caret stands in it.
    void refresh();
    // The list at this byte is opened, or hidden again; false: there is none.
    bool toggle(std::size_t byte);
    void openAll();
    void hideAll();
    // So that these bytes can be seen.
    void reveal(scene::Range range);
    // The selected text is about to be replaced: Scintilla changes nothing that it does not show.
    // LIMIT: hidden points that are dragged elsewhere with the pointer stay behind.
    void releaseSelected();
    [[nodiscard]] std::vector<scene::Range> hidden() const { return editor_.marks(Mark::elided); }

    bool pressed(const QMouseEvent& event) override;
    bool key(const QKeyEvent& event) override;
    void replacing() override { releaseSelected(); }
    void paint(QPainter& painter) override;
    [[nodiscard]] QString tip(std::size_t byte) const override;

private:
    struct Chip { // what is drawn in the place of a list
        scene::Range range;
        QString label;
        std::size_t marked = 0; // bytes [range.from, marked) give it room
    };
    [[nodiscard]] std::vector<editing::PointList> lists() const;
    void hide(scene::Range range);
    void open(scene::Range range);
    void changed();
    void hideLines();
    void jump();
    void releaseAround(const QKeyEvent& event);
    [[nodiscard]] QRectF rectOf(const Chip& chip) const;
    [[nodiscard]] const Chip* chipAt(const QPoint& position) const;

    SceneEditor& editor_;
    std::vector<Chip> chips_;
    bool linesHidden_ = false;
    std::size_t caret_ = 0;
};

} // namespace views
