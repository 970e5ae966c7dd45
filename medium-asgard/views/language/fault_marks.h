// The faults of a scene's text, at their words and in a list (dissertation 4.2.3).
//
// A fault is underlined, told in full below its line, and listed; one without a place is listed
// only. While the text is a draft the marks stay with their words, as faults of the last update.
#pragma once

#include "language/scene_editor.h"
#include "workbench/scene_document.h"

class QListWidget;

namespace views {

class FaultMarks : public QObject, public EditorTool {
    Q_OBJECT
public:
    FaultMarks(SceneEditor& editor, QListWidget& list);

    // `places`: the text is the one that the faults are of.
    void show(const std::vector<scene::Diagnostic>& faults, bool places);
    void hideNotes(); // below the lines: the text is not as they say any more
    void next(bool forward = true);
    // The first error that comes while it is expected appears to the author.
    void expect(bool expected) { expected_ = expected; }

    [[nodiscard]] QString tip(std::size_t byte) const override;

Q_SIGNALS:
    void wanted(scene::Range range); // the author wants to see it
    void appeared(scene::Range range);

private:
    void list(const scene::Diagnostic& fault, bool places);
    void mark(const scene::Diagnostic& fault);

    SceneEditor& editor_;
    QListWidget& list_;
    std::vector<scene::Diagnostic> placed_;
    bool expected_ = false;
};

} // namespace views
