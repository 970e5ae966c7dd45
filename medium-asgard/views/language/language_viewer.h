// The language viewer's window (dissertation 4.2): the scene's text, edited as plain text.
//
// Each viewer holds a draft (draft.h). Update makes it the document's text, and with that
// everyone's. Further abilities of the text attach to its editor: elision.h hides points,
// fault_marks.h says what is wrong, element_marks.h has the handles' colours and the selection,
// number_drag.h drags numbers, completer.h completes words.
#pragma once

#include "frame/windows.h"
#include "workbench/scene_document.h"

#include <QMainWindow>

class QListWidget;

namespace views {

class Completer;
class Draft;
class DraftRow;
class ElementMarks;
class Elision;
class FaultMarks;
class FindBar;
class NoticeBar;
class NumberDrag;
class SceneEditor;
class ToldBar;

class LanguageViewer : public QMainWindow {
    Q_OBJECT
public:
    // In a window of its own, or in a pane of another, whose menus then have its menus and whose
    // keys it takes while it has the keyboard.
    enum class Place { window, pane };
    LanguageViewer(SceneDocument& document, Windows windows, int number,
                   Place place = Place::window);
    ~LanguageViewer() override;

    [[nodiscard]] bool isPane() const { return place_ == Place::pane; }
    [[nodiscard]] std::string draft() const;
    // Someone typed since the draft was last the document's text.
    [[nodiscard]] bool hasDraft() const;
    [[nodiscard]] const std::string& draftBase() const; // the document's text that it is one of
    // A draft of a process that ended, upon the document's text of then.
    void restoreDraft(const std::string& base, const std::string& text);
    void undo(); // what was typed; without a draft, the scene's last change
    void redo();
    void tell(const QString& sentence); // above the text, until it was read
    [[nodiscard]] SceneEditor& editor();
    [[nodiscard]] NumberDrag& numbers() { return *numbers_; }
    [[nodiscard]] QListWidget& messages() { return *messages_; }

    // The draft becomes everyone's text; false: another view changed the same places, and which
    // of the two it is to be was not chosen.
    bool updateDocument();
    // Asks what becomes of a draft: the scene's text, or nothing. False: it stays as it is.
    bool settleDraft();
    void revert();    // back to the last saved text, or under a host to the document's
    void dropDraft(); // back to the document's text, which stays as it is
    // Marks and shows the text's bytes [from, to).
    void select(std::size_t from, std::size_t to);
    // Finds the next occurrence after the cursor, from the top when there is none; false: nowhere.
    bool find(const QString& what, bool forward = true);

Q_SIGNALS:
    void draftChanged(); // hasDraft() may be another

protected:
    bool event(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectParts();
    void buildMenus();
    void buildEditMenu();
    void buildViewMenu();
    void showDiagnostics();
    void showFault(scene::Range range);
    void updateTitle();
    void save();
    void askToRevert();
    void followed();
    [[nodiscard]] bool typingIsUndone() const;
    [[nodiscard]] QAction* commandOf(const QKeyEvent& event) const;
    bool paneKey(QEvent& event);
    void goToLine();

    SceneDocument& document_;
    Windows windows_;
    int number_;
    Place place_;
    SceneEditor* editor_;
    QListWidget* messages_;
    // Taken down before the editor, which they attach to.
    std::unique_ptr<FaultMarks> faults_;
    std::unique_ptr<Elision> elision_;
    std::unique_ptr<Draft> draft_;
    std::unique_ptr<ElementMarks> elements_;
    std::unique_ptr<NumberDrag> numbers_;
    std::unique_ptr<Completer> completer_;
    NoticeBar* notice_;
    ToldBar* told_;
    FindBar* findBar_;
    DraftRow* row_;
};

} // namespace views
