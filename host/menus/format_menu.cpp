#include "menus/format_menu.h"

#include "menus/language_menu.h"

namespace menus {

using authoring::Manuscript, authoring::Selection;
using schemas::ContainerRole;

FormatMenu::FormatMenu(view::DocumentView& view, QWidget* parent)
    : CommandMenu(tr("F&ormat"), view, parent) {
    setObjectName("format");
    addBeginning();
    addToggle("emphasis", tr("&Emphasis"), QKeySequence::Italic, ContainerRole::emphasis);
    addToggle("strong", tr("&Strong"), QKeySequence::Bold, ContainerRole::strong);
    addToggle("code", tr("&Code"), QKeySequence("Ctrl+Shift+M"), ContainerRole::code);
    addSeparator();
    add("paragraph", tr("&Paragraph"), QKeySequence("Ctrl+Alt+0"), authoring::makeParagraph);
    constexpr int levels = 3;
    for (int level = 1; level <= levels; ++level)
        add(QStringLiteral("heading%1").arg(level), tr("Heading &%1").arg(level),
            QKeySequence(QStringLiteral("Ctrl+Alt+%1").arg(level)),
            [level](const Manuscript& in, Selection at) {
                return authoring::makeHeading(in, at, level);
            });
    add("verbatim", tr("Pre&formatted Text"), QKeySequence("Ctrl+Alt+9"), authoring::makeVerbatim);
    addSeparator();
    addList("bullets", tr("&Bulleted List"), QKeySequence("Shift+F12"), false);
    addList("numbers", tr("&Numbered List"), QKeySequence("F12"), true);
    // Their keys are the view's: elsewhere they are those of other commands.
    add("indent", tr("&Into the Item Before") + "\tTab", {}, authoring::indentItems);
    add("outdent", tr("&Out of the List") + "\tShift+Tab", {}, authoring::outdentItems);
    addSeparator();
    auto* language = new LanguageMenu(tr("&Language"), LanguageMenu::Of::selection, view, this);
    language->setObjectName("language");
    auto* ofAll = new LanguageMenu(tr("&Whole Document"), LanguageMenu::Of::document, view, this);
    ofAll->setObjectName("documentLanguage");
    language->addSeparator();
    language->addMenu(ofAll);
    addMenu(language);
}

// The presentation of a class tells kinds of lists apart by an attribute. LIMIT: the plain one has
// bullets, the first of the others numbers.
void FormatMenu::addList(const QString& name, const QString& text, const QKeySequence& keys,
                         bool isNumbered) {
    add(name, text, keys, [isNumbered](const Manuscript& in, Selection at) -> authoring::Result {
        if (!isNumbered)
            return authoring::makeList(in, at);
        const authoring::Grammar* grammar = in.grammars.of(in.document.className());
        if (grammar)
            for (const auto& kind : grammar->variants(grammar->named(ContainerRole::list)))
                return authoring::makeList(in, at, kind.attribute, kind.value);
        return authoring::Refusal{tr("Documents of this class have no numbered lists.")};
    });
}

} // namespace menus
