// Elements in the text: what pictures can change has the colour of its handle, and who selects a
// command selects its elements in every view, and the other way round (dissertation 4.2).
#pragma once

#include "editing/editable.h"
#include "handles/handles.h"
#include "language/draft.h"

#include <QTimer>

#include <memory>
#include <vector>

namespace views {

// The handle that shows this value in pictures.
[[nodiscard]] render::HandleKind handleOf(const editing::Editable& value,
                                          const scene::Scene& scene);

class ElementMarks : public QObject, public EditorTool {
    Q_OBJECT
public:
    ElementMarks(SceneEditor& editor, SceneDocument& document, Draft& draft);
    ~ElementMarks() override;

    [[nodiscard]] QString tip(std::size_t byte) const override;
    bool key(const QKeyEvent& event) override;

Q_SIGNALS:
    void wanted(scene::Range range); // selected elsewhere: to be seen

private:
    // Short texts at once; of long ones what can be changed is found out by another thread, once
    // they rest, and marked a little at a time.
    void markArguments();
    void findOut();
    void markSome();
    void caretMoved(int updated);
    void showSelection();
    void markSelection();
    // Places of the document's text in the editor's, and back.
    [[nodiscard]] scene::Range inEditor(scene::Range range) const;
    [[nodiscard]] scene::Range inDocument(scene::Range range) const;

    SceneEditor& editor_;
    SceneDocument& document_;
    Draft& draft_;
    struct Coloured {
        scene::Range range;
        int value;
    };
    [[nodiscard]] static std::vector<Coloured>
    colouredOf(const std::string& text, const std::shared_ptr<const scene::Scene>& scene);
    struct Errand; // of the other thread
    std::shared_ptr<Errand> errand_;
    QTimer rest_, more_;
    std::vector<Coloured> toMark_; // from the back
    int toMarkRevision_ = -1;
    bool selecting_ = false; // the caret did it: it need not be shown where it is
    scene::Range caret_;
    int marked_ = -1; // the revision that has its marks
};

} // namespace views
