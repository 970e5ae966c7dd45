// The language of what is selected, or of the whole document: a choice, with that at the caret
// marked. It says how words are divided and spelled, and which quotes are typed. The first entry is
// for what says none itself, with the language that is in force then.
#pragma once

#include "menus/command_menu.h"

namespace menus {

class LanguageMenu : public CommandMenu {
    Q_OBJECT

public:
    enum class Of { selection, document };
    LanguageMenu(const QString& title, Of of, view::DocumentView& view, QWidget* parent = nullptr);

private:
    void addNone();
    void addLanguage(const QString& code, const QString& name);
    void markCurrent();
    [[nodiscard]] QString ofDocument() const; // "": it says none

    Of of_;
    QAction* none_ = nullptr;
};

// As documents spell it, "de-AT"; "": the desktop says none.
[[nodiscard]] QString desktopLanguage();

} // namespace menus
