// The language of what is selected, or of the whole document: a choice, with that at the caret
// marked. It says how words are divided and spelled, and which quotes are typed.
#pragma once

#include "menus/command_menu.h"

namespace menus {

class LanguageMenu : public CommandMenu {
    Q_OBJECT

public:
    enum class Of { selection, document };
    LanguageMenu(const QString& title, Of of, view::DocumentView& view, QWidget* parent = nullptr);

private:
    void addLanguage(const QString& code, const QString& name);
    void markCurrent();

    Of of_;
};

// As documents spell it, "de-AT"; "": the desktop says none.
[[nodiscard]] QString desktopLanguage();

} // namespace menus
