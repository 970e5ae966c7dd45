// The submenu of Insert for one medium: an empty subdocument of it, one of its samples, or one of
// its files. It comes in at the caret as a figure, and the caret goes on in its caption or behind
// it; an empty one opens its editor.
#pragma once

#include "menus/command_menu.h"
#include "processes/manifest.h"

namespace menus {

class MediumMenu : public CommandMenu {
    Q_OBJECT

public:
    // The view outlives it.
    MediumMenu(const media::Manifest& manifest, view::DocumentView& view, QWidget* parent);

private:
    enum class Then { show, edit };
    void insert(const std::string& text, const authoring::Attributes& more, Then then);
    void insertSample(int sample);
    void askForSample();
    void askForFile();
    [[nodiscard]] authoring::EmbeddedText embedded(const std::string& text,
                                                   const authoring::Attributes& more) const;

    media::Manifest manifest_;
};

} // namespace menus
