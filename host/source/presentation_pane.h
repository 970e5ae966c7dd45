// A presentation's file beside the pages that it presents: they follow what is typed after a short
// pause. It has an undo of its own, and is saved by Ctrl+S in it.
#pragma once

#include "source/edit_frame.h"
#include "source/presentation_draft.h"
#include "view/document_view.h"

#include <QDockWidget>

class QMainWindow;

namespace source {

class PresentationPane : public QDockWidget {
    Q_OBJECT

public:
    // The view outlives it. It is not shown before a file is opened.
    PresentationPane(view::DocumentView& view, QMainWindow* parent);

    [[nodiscard]] SourceEdit& edit() const { return frame_->edit(); }
    // False: another one is there, is not saved, and stays.
    bool open(const schemas::Schemas::File& file);
    bool save();
    [[nodiscard]] bool hasKeyboard() const;
    [[nodiscard]] QString fileName() const; // that is shown; "": none
    // The presentation is as it comes with the program again; the user's own file is put aside.
    void bringSupplied(const QString& name);
    // Asks about what is not saved. False: it stays.
    [[nodiscard]] bool mayClose();

Q_SIGNALS:
    // The present text of that presentation file: to be shown.
    void edited(const QString& name, const QString& path, const std::string& text);
    void said(const QString& sentence); // for the status line

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void read();
    void fill();
    void standBeside();
    void present(const std::string& text);
    void tell();

    view::DocumentView& view_;
    EditFrame* frame_;
    QLabel* whose_;
    std::optional<PresentationDraft> draft_;
    QString path_;                   // of the file that was opened
    std::string text_;               // as it is typed
    std::vector<Mark> marks_;        // of it
    std::vector<std::size_t> lines_; // where each begins
    QTimer pause_;
};

} // namespace source
