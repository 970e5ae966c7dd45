#include "menus/medium_menu.h"

#include "menus/figure_menu.h"
#include "menus/gallery_dialog.h"
#include "menus/medium_files.h"
#include "plain/plain.h"
#include "session/samples.h"
#include "view/document_view.h"

#include <algorithm>

namespace menus {

using authoring::Manuscript, authoring::Selection;

namespace {

std::string spelled(double number) {
    constexpr int digits = 6;
    return QString::number(number, 'g', digits).toStdString();
}

} // namespace

MediumMenu::MediumMenu(const media::Manifest& manifest, view::DocumentView& view, QWidget* parent)
    : CommandMenu('&' + plain::caption(manifest.title), view, parent), manifest_(manifest) {
    setObjectName("insert" + manifest.documentClass);
    const Command probe = [this](const Manuscript& in, Selection at) {
        return authoring::insertFigure(in, at, embedded({}, {}));
    };
    addAsking("insertEmpty", tr("&New"), {}, probe,
              [this] { insert(manifest_.newText.toStdString(), {}, Then::edit); });
    if (!manifest.samples.isEmpty())
        addAsking("insertSample", tr("From the &Gallery..."), {}, probe,
                  [this] { askForSample(); });
    if (!manifest.fileEndings.isEmpty())
        addAsking("insertFile", tr("From a &File..."), {}, probe, [this] { askForFile(); });
}

// With a size of its own: what one reads stays where it is while the medium starts and while the
// text changes.
authoring::EmbeddedText MediumMenu::embedded(const std::string& text,
                                             const authoring::Attributes& more) const {
    authoring::EmbeddedText result{.className = manifest_.documentClass.toStdString(),
                                   .storage = manifest_.storage.toStdString(),
                                   .text = text,
                                   .attributes = {{"WIDTH", spelled(manifest_.size.width())},
                                                  {"HEIGHT", spelled(manifest_.size.height())}}};
    result.attributes.insert(result.attributes.end(), more.begin(), more.end());
    return result;
}

void MediumMenu::insert(const std::string& text, const authoring::Attributes& more, Then then) {
    session::OpenDocument& open = view().document();
    const auto before = open.document().subdocuments();
    if (!view().writing().perform([&](const Manuscript& in, Selection at) {
            return authoring::insertFigure(in, at, embedded(text, more));
        }))
        return;
    view().settle();
    for (const document::SubdocumentId id : open.document().subdocuments()) {
        if (std::ranges::count(before, id) > 0)
            continue;
        view().scrollTo(id);
        view().setFocus();
        if (then == Then::edit)
            openEditor(view(), id);
        return;
    }
}

void MediumMenu::insertSample(int sample) {
    const media::Sample& wanted = manifest_.samples[sample];
    const session::MediumText read = session::readMediumText(fileOf(manifest_, wanted));
    if (!read.fault.isEmpty())
        return plain::Message::tell(QMessageBox::Critical, parentWidget(), tr("Insert"),
                                    read.fault);
    authoring::Attributes more;
    if (wanted.time)
        more.emplace_back("POSTER", spelled(*wanted.time));
    if (!wanted.about.isEmpty())
        more.emplace_back("ALT", wanted.about.toStdString());
    insert(read.text, more, Then::show);
}

void MediumMenu::askForSample() {
    GalleryDialog dialog(view().document().media(), manifest_, parentWidget());
    if (dialog.exec() == QDialog::Accepted && dialog.chosen() >= 0)
        insertSample(dialog.chosen());
}

void MediumMenu::askForFile() {
    const QString file = askForMediumFile(manifest_, tr("Insert"), parentWidget());
    if (file.isEmpty())
        return;
    const session::MediumText read = session::readMediumText(file);
    if (!read.fault.isEmpty())
        return plain::Message::tell(QMessageBox::Critical, parentWidget(), tr("Insert"),
                                    read.fault);
    insert(read.text, {}, Then::show);
}

} // namespace menus
