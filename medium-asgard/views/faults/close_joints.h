// The offer to close joints that their bodies miss at the start: a button that is there while a
// fault says so.
//
// A click moves the free bodies as little as possible, as `asgard assemble` does, and writes it
// into the text as one step of undo. It is found out on another thread; a text that changes
// meanwhile stays as it is. Where joints cannot close, a sentence at the button says why.
#pragma once

#include "workbench/scene_document.h"

#include <QPushButton>

namespace views {

// How many faults tell of joints that miss.
[[nodiscard]] int openJoints(const SceneDocument& document);

class CloseJoints : public QPushButton {
    Q_OBJECT
public:
    explicit CloseJoints(SceneDocument& document, QWidget* parent = nullptr);

    // Why the last click changed nothing; "": it did.
    [[nodiscard]] const QString& reason() const { return reason_; }

private:
    void refresh();
    void close();
    struct Closed {
        std::string text, reason;
    };
    [[nodiscard]] static Closed closed(const std::string& text,
                                       const std::shared_ptr<const scene::Scene>& scene);
    void take(const Closed& now, int revision);
    void say() const;

    SceneDocument& document_;
    bool closing_ = false;
    QString reason_;
};

} // namespace views
