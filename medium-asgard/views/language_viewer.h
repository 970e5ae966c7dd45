// The language viewer's window (dissertation 4.2): the scene's text, edited as plain text.
//
// Each viewer holds a draft. Update makes it the document's text, and with that everyone's; what
// another view changes meanwhile replaces a draft only while nobody has typed in it. What a host
// refuses is a draft again, with the reason above it. Faults are marked at their words, told in
// full under their lines, and listed below; those without a place are only listed.
#pragma once

#include "views/graphical_viewer.h"
#include "views/scene_document.h"

#include <QMainWindow>

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QsciScintilla;

namespace views {

class LanguageViewer : public QMainWindow {
    Q_OBJECT
public:
    LanguageViewer(SceneDocument& document, Windows windows, int number);

    [[nodiscard]] std::string draft() const;
    // Someone typed since the draft was last the document's text.
    [[nodiscard]] bool hasDraft() const { return edited_; }
    [[nodiscard]] QsciScintilla& editor() { return *editor_; }
    [[nodiscard]] QListWidget& messages() { return *messages_; }

    void updateDocument(); // the Update button: makes the draft everyone's text
    void revert();         // back to the last saved text, or under a host to the document's
    void dropDraft();      // back to the document's text, which stays as it is
    // Marks and shows the text's bytes [from, to).
    void select(std::size_t from, std::size_t to);
    // Finds the next occurrence after the cursor, from the top when there is none; false: nowhere.
    bool find(const QString& what, bool forward = true);

Q_SIGNALS:
    void draftChanged(); // hasDraft() may be another

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void buildEditor();
    void buildMenus();
    QWidget* buildFindBar();
    QWidget* buildButtons();
    void colourEditor();
    void setEditorText(const std::string& text);
    void textTyped();
    void followDocument();
    void becomeDraftAgain(const QString& why);
    void showDiagnostics();
    void markDiagnostic(const scene::Diagnostic& diagnostic);
    void markArguments();
    void clearMarks();
    void updateTitle();
    void updateNotice();
    void openFind();

    SceneDocument& document_;
    Windows windows_;
    int number_;
    bool edited_ = false;
    bool setting_ = false;   // the text changes because the document's did
    int draftRevision_ = -1; // of the document, when draft and document were last the same
    std::optional<std::string> submitted_; // this viewer's update, until the host has accepted it
    QString refusal_;                      // why the host did not
    QsciScintilla* editor_;
    QListWidget* messages_;
    QLabel* notice_;
    QWidget* findBar_;
    QLineEdit* findText_;
    QPushButton *updateButton_, *saveButton_, *revertButton_;
};

} // namespace views
