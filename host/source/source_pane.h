// The source of a document beside its pages: its own bytes, in step with them both ways. They are
// written where the view is a writing one.
#pragma once

#include "source/document_mirror.h"
#include "source/edit_frame.h"
#include "source/in_step.h"

#include <QDockWidget>

class QMainWindow;

namespace source {

class SourcePane : public QDockWidget {
    Q_OBJECT

public:
    // The view outlives it.
    SourcePane(view::DocumentView& view, QMainWindow* parent);
    ~SourcePane() override;

    [[nodiscard]] SourceEdit& edit() const { return *edit_; }
    [[nodiscard]] DocumentMirror& mirror() const { return *mirror_; }
    [[nodiscard]] const InStep& steps() const { return *steps_; }
    // In its last place, as wide and as visible as then.
    void placeIn(QMainWindow& window);

    void setFaults(const std::vector<session::ListedFault>& faults);
    // The caret, with the keyboard, where the pane is shown.
    void goTo(const text::Position& place);

Q_SIGNALS:
    void said(const QString& sentence); // for the status line

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void updateWritable();
    void keepWidth() const;

    view::DocumentView& view_;
    EditFrame* frame_;
    SourceEdit* edit_; // in it
    DocumentMirror* mirror_;
    InStep* steps_;
};

} // namespace source
