#include "panes/spelling_commands.h"

#include "plain/plain.h"
#include "view/document_view.h"
#include "view/writing.h"

#include <QDir>
#include <QLocale>
#include <QMenu>
#include <QSettings>
#include <QStandardPaths>

namespace panes {

namespace {

constexpr auto setting = "spelling";

// The document's language, else the desktop's. LIMIT: text in another language is not checked.
QString languageOf(const document::Document& document) {
    const sgml::Tree& tree = document.tree();
    const sgml::NodeId top = tree.classElement(tree.root());
    const auto said = top == sgml::noNode ? std::nullopt : tree.attribute(top, "LANG");
    return said ? QString::fromUtf8(said->data(), static_cast<qsizetype>(said->size()))
                : QLocale::system().name();
}

// "American English", of the dictionary that is used.
QString nameOf(const spelling::Dictionary& dictionary) {
    return QLocale(dictionary.language).nativeLanguageName();
}

QString ownWords() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation))
        .filePath("ensemble/words");
}

// One for all windows, as long as one of them uses it: the user's words are known in all.
std::shared_ptr<spelling::Speller> spellerOf(const spelling::Dictionary& dictionary) {
    static std::map<QString, std::weak_ptr<spelling::Speller>> all;
    std::weak_ptr<spelling::Speller>& known = all[dictionary.words];
    std::shared_ptr<spelling::Speller> speller = known.lock();
    if (!speller)
        known = speller = std::make_shared<spelling::Speller>(dictionary, ownWords());
    return speller;
}

} // namespace

SpellingCommands::SpellingCommands(view::DocumentView& view, QObject* parent)
    : QObject(parent), view_(view), marks_(view), toggle_(new QAction(tr("&Spelling"), this)) {
    toggle_->setObjectName("spelling");
    toggle_->setCheckable(true);
    connect(toggle_, &QAction::triggered, this, [](bool on) { QSettings().setValue(setting, on); });
    connect(toggle_, &QAction::toggled, this, &SpellingCommands::update);
    connect(&view_, &view::DocumentView::writingChanged, this, &SpellingCommands::update);
    connect(&view_, &view::DocumentView::laidOut, this, &SpellingCommands::followLanguage);
    followLanguage();
}

void SpellingCommands::followLanguage() {
    const QString now = languageOf(view_.document().document());
    if (now == language_)
        return;
    language_ = now;
    const bool isThere = dictionary().isThere();
    toggle_->setChecked(isThere && QSettings().value(setting, true).toBool());
    toggle_->setEnabled(isThere);
    toggle_->setText(isThere ? tr("&Spelling (%1)").arg(plain::caption(nameOf(dictionary())))
                             : tr("&Spelling"));
    toggle_->setToolTip(
        plain::tip(isThere ? QString() : spelling::Speller(dictionary(), {}).whyNot()));
    update();
}

spelling::Dictionary SpellingCommands::dictionary() const {
    return spelling::dictionaryFor(language_.value_or(QString()), spelling::dictionaryFolders());
}

// A dictionary is read when somebody begins to write.
void SpellingCommands::update() {
    if (!toggle_->isChecked() || !view_.isWriting()) {
        Q_EMIT languageChanged({});
        return marks_.use(nullptr);
    }
    Q_EMIT languageChanged(nameOf(dictionary()));
    std::shared_ptr<spelling::Speller> speller = spellerOf(dictionary());
    if (!speller->whyNot().isEmpty())
        Q_EMIT said(speller->whyNot());
    marks_.use(std::move(speller));
}

void SpellingCommands::replace(text::Range place, const QString& word) {
    view_.writing().perform([&](const authoring::Manuscript& in, authoring::Selection) {
        return authoring::replaceAll(in, {place}, word.toStdString()).result;
    });
}

void SpellingCommands::addTo(QMenu& menu, const QPoint& at) {
    const QPointF point = view_.viewport()->mapFromGlobal(at);
    // By key the place is the lower end of the caret.
    auto wrong = marks_.wrongAt(point);
    if (!wrong)
        wrong = marks_.wrongAt(point - QPointF(0, 3));
    if (!wrong)
        return;
    const QStringList suggestions = marks_.speller()->suggestions(wrong->word);
    for (const QString& word : suggestions)
        menu.addAction(plain::caption(word), this,
                       [this, place = wrong->place, word] { replace(place, word); });
    if (suggestions.isEmpty())
        menu.addAction(tr("No suggestions"))->setEnabled(false);
    menu.addSeparator();
    menu.addAction(tr("Add to &Dictionary"), this,
                   [this, word = wrong->word] {
                       if (const QString failed = marks_.speller()->add(word); !failed.isEmpty())
                           Q_EMIT said(failed);
                       marks_.checkAnew();
                   })
        ->setObjectName("addWord");
    menu.addAction(tr("&Ignore"), this,
                   [this, word = wrong->word] {
                       marks_.speller()->ignore(word);
                       marks_.checkAnew();
                   })
        ->setObjectName("ignoreWord");
    menu.addSeparator();
}

} // namespace panes
