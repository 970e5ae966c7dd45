// The offer to close joints that their bodies miss at the start, and to move bodies apart that
// overlap there: a button that is there while a fault says so.
//
// A click moves the free bodies as little as possible, as `asgard assemble` does, and writes it
// into the text as one step of undo. Another thread finds out how; meanwhile the button stops it. A
// text that changes meanwhile stays as it is, and ends the search. If bodies have no such
// places, a sentence at the button says why.
#pragma once

#include "commands/closing.h"
#include "workbench/scene_document.h"

#include <QPushButton>

#include <atomic>
#include <memory>

namespace views {

class CloseJoints : public QPushButton {
    Q_OBJECT
public:
    explicit CloseJoints(SceneDocument& document, QWidget* parent = nullptr);
    ~CloseJoints() override; // ends the search

    // Why the last click changed nothing; "": it did.
    [[nodiscard]] const QString& reason() const { return reason_; }

protected:
    // The second click of a double one does not stop what the first has begun.
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    // How joints close, as another thread finds out. Whoever sets it ends the search.
    using Search = std::shared_ptr<std::atomic<bool>>;

    void refresh();
    void startOrStop();
    void start();
    void cancel();
    void textChanged();
    void take(const commands::Closed& now, const Search& search);
    void say() const;

    SceneDocument& document_;
    Search search_; // null: none runs
    QString reason_;
};

} // namespace views
