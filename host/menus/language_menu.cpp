#include "menus/language_menu.h"

#include "plain/plain.h"
#include "view/document_view.h"

#include <QLocale>
#include <algorithm>

namespace menus {

namespace {

struct Language {
    QString code, name;
};

// In the order of their own names. LIMIT: any other one is written into the document's text.
std::vector<Language> languages() {
    std::vector<Language> all{{"cs", "Čeština"},
                              {"da", "Dansk"},
                              {"de", "Deutsch"},
                              {"de-AT", "Deutsch (Österreich)"},
                              {"de-CH", "Deutsch (Schweiz)"},
                              {"el", "Ελληνικά"},
                              {"en-GB", "English (United Kingdom)"},
                              {"en-US", "English (United States)"},
                              {"es", "Español"},
                              {"fr", "Français"},
                              {"it", "Italiano"},
                              {"hu", "Magyar"},
                              {"nl", "Nederlands"},
                              {"nb", "Norsk bokmål"},
                              {"pl", "Polski"},
                              {"pt", "Português"},
                              {"pt-BR", "Português (Brasil)"},
                              {"ro", "Română"},
                              {"ru", "Русский"},
                              {"fi", "Suomi"},
                              {"sv", "Svenska"},
                              {"tr", "Türkçe"},
                              {"uk", "Українська"}};
    const QString own = desktopLanguage();
    const bool isThere = std::ranges::any_of(all, [&](const Language& one) {
        return one.code == own || one.code == own.section('-', 0, 0);
    });
    if (!own.isEmpty() && !isThere)
        all.push_back({own, QLocale(own).nativeLanguageName()});
    return all;
}

} // namespace

QString desktopLanguage() {
    const QLocale system = QLocale::system();
    return system.language() == QLocale::C ? QString() : system.name().replace('_', '-');
}

LanguageMenu::LanguageMenu(const QString& title, Of of, view::DocumentView& view, QWidget* parent)
    : CommandMenu(title, view, parent), of_(of) {
    addNone();
    for (const Language& one : languages())
        addLanguage(one.code, one.name);
    connect(this, &QMenu::aboutToShow, this, &LanguageMenu::markCurrent);
}

namespace {

std::size_t topOf(const authoring::Manuscript& in) {
    const sgml::Tree& tree = in.document.tree();
    return tree.node(tree.classElement(tree.root())).startTag.from;
}

// "Deutsch"; a document that says none is English.
QString nameOf(const QString& code) {
    if (code.isEmpty())
        return LanguageMenu::tr("English");
    const std::vector<Language> all = languages();
    const auto known = std::ranges::find(all, code, &Language::code);
    return known != all.end() ? known->name : QLocale(code).nativeLanguageName();
}

QString spelledAs(std::string_view language) {
    return QString::fromUtf8(language.data(), static_cast<qsizetype>(language.size()))
        .replace('_', '-');
}

} // namespace

// Text is as its document then.
void LanguageMenu::addNone() {
    const bool isOfDocument = of_ == Of::document;
    const auto command = [isOfDocument](const authoring::Manuscript& in, authoring::Selection at) {
        return isOfDocument ? authoring::setDocumentLanguage(in, at, {})
                            : authoring::setLanguage(in, at, authoring::languageAt(in, topOf(in)));
    };
    none_ = add(isOfDocument ? "documentLanguage-" : "language-", {}, {}, command);
    none_->setCheckable(true);
    addSeparator();
}

QString LanguageMenu::ofDocument() const {
    const authoring::Manuscript in = view().writing().manuscript();
    return spelledAs(authoring::languageAt(in, topOf(in)));
}

void LanguageMenu::addLanguage(const QString& code, const QString& name) {
    const auto set = of_ == Of::document ? authoring::setDocumentLanguage : authoring::setLanguage;
    const std::string wanted = code.toStdString();
    QAction* action =
        add((of_ == Of::document ? "documentLanguage-" : "language-") + code, plain::caption(name),
            {}, [set, wanted](const authoring::Manuscript& in, authoring::Selection at) {
                return set(in, at, wanted);
            });
    action->setCheckable(true);
    action->setData(code);
}

// That of the last selected letter. "de-DE" is the entry "de" where it has none of its own.
void LanguageMenu::markCurrent() {
    const authoring::Manuscript in = view().writing().manuscript();
    const auto at = view().writing().place();
    const bool isOfDocument = of_ == Of::document || !at;
    const QString whole = ofDocument();
    const QString said =
        isOfDocument ? whole
                     : spelledAs(authoring::languageAt(in, std::max(at->anchor, at->caret)));
    none_->setText(plain::caption(of_ == Of::document
                                      ? tr("Not Said: %1").arg(nameOf({}))
                                      : tr("As the Document: %1").arg(nameOf(whole))));
    const QList<QAction*> all = actions();
    const auto entryOf = [&](const QString& code) {
        return std::ranges::find_if(all, [&](const QAction* action) {
            return action != none_ && !code.isEmpty() && action->data().toString() == code;
        });
    };
    auto current = entryOf(said);
    if (current == all.end())
        current = entryOf(said.section('-', 0, 0));
    const QAction* marked = current == all.end() ? nullptr : *current;
    if (said.isEmpty() || (of_ == Of::selection && said == whole))
        marked = none_;
    for (QAction* action : all)
        action->setChecked(action == marked);
}

} // namespace menus
