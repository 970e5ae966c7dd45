// The menu Image: pictures of files come in at the caret; the one that is selected gets other words
// and another size.
#pragma once

#include "menus/command_menu.h"

namespace menus {

class ImageMenu : public CommandMenu {
    Q_OBJECT

public:
    explicit ImageMenu(view::DocumentView& view, QWidget* parent = nullptr);

    [[nodiscard]] bool isOnImage() const; // one is selected and nothing else

private:
    void insert(bool isInLine);
    void insertFile(const QString& path, bool isInLine);
    void askForWords();
    [[nodiscard]] QString folder() const; // where to look for pictures

    QString lastFolder_;
};

} // namespace menus
