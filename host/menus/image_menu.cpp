#include "menus/image_menu.h"

#include "authoring/images.h"
#include "menus/image_dialog.h"
#include "session/picture_home.h"
#include "view/document_view.h"
#include "view/resizing.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>

namespace menus {

using authoring::Manuscript, authoring::Selection;

namespace {

CommandMenu::Command inserted(const authoring::NewImage& image) {
    return [image](const Manuscript& in, Selection at) {
        return authoring::insertImage(in, at, image);
    };
}

// The attributes of the selected image, with those values; the document's own without.
authoring::Result changed(const view::DocumentView& view, const Manuscript& in, Selection at,
                          const std::optional<authoring::Attributes>& attributes) {
    const std::optional<view::Sized> unit = view::sizedUnit(view);
    if (!unit || view.chosen())
        return authoring::Refusal{ImageMenu::tr("Click on an image first.")};
    return authoring::setAttributes(in, at, unit->element,
                                    attributes.value_or(authoring::Attributes{}),
                                    ImageMenu::tr("Image"));
}

} // namespace

ImageMenu::ImageMenu(view::DocumentView& view, QWidget* parent)
    : CommandMenu(tr("&Image"), view, parent) {
    setObjectName("imageMenu");
    addAsking("image", tr("&Image with Caption..."), QKeySequence("Ctrl+Shift+I"),
              inserted({.file = "a"}), [this] { insert(false); });
    addAsking("imageInLine", tr("Image in the &Text..."), {},
              inserted({.file = "a", .isInLine = true}), [this] { insert(true); });
    addSeparator();
    addAsking(
        "imageWords", tr("&Alternative Text and Size..."), {},
        [this](const Manuscript& in, Selection at) {
            return changed(this->view(), in, at, std::nullopt);
        },
        [this] { askForWords(); });
}

bool ImageMenu::isOnImage() const { return !view().chosen() && view::sizedUnit(view()); }

void ImageMenu::insert(bool isInLine) {
    const QString file = QFileDialog::getOpenFileName(
        parentWidget(), tr("Insert Image"), folder(),
        tr("Pictures (*.png *.jpg *.jpeg *.gif *.bmp *.webp *.tif *.tiff);;All files (*)"));
    if (file.isEmpty())
        return;
    lastFolder_ = QFileInfo(file).absolutePath();
    insertFile(file, isInLine);
}

// That of the last one, else the document's.
QString ImageMenu::folder() const {
    const QFileInfo own(view().document().document().fileName());
    if (!lastFolder_.isEmpty())
        return lastFolder_;
    return own.fileName().isEmpty()
               ? QStandardPaths::writableLocation(QStandardPaths::PicturesLocation)
               : own.absolutePath();
}

void ImageMenu::insertFile(const QString& path, bool isInLine) {
    session::OpenDocument& document = view().document();
    const session::PictureHome::Kept kept =
        session::PictureHome(document.document().fileName()).keepFile(path);
    if (!kept.fault.isEmpty())
        return Q_EMIT view().writing().refused(kept.fault);
    constexpr QSize preview(400, 400);
    const auto wishes =
        askAboutImage(tr("Insert Image"), document.images().imageNow(kept.source, preview), {},
                      !isInLine, parentWidget());
    if (wishes)
        view().writing().perform(inserted({.file = kept.source,
                                           .alternative = wishes->alternative.toStdString(),
                                           .caption = wishes->caption.toStdString(),
                                           .width = wishes->width,
                                           .isInLine = isInLine}));
}

void ImageMenu::askForWords() {
    const std::optional<view::Sized> unit = view::sizedUnit(view());
    if (!unit)
        return;
    const sgml::Tree& tree = view().document().document().tree();
    const auto attribute = [&](const char* name) {
        return std::string(tree.attribute(unit->element, name).value_or(""));
    };
    const auto width = document::numberIn(attribute("WIDTH"), 1, document::longestLength);
    constexpr QSize preview(400, 400);
    const ImageWishes now{
        QString::fromStdString(attribute("ALT")), {}, static_cast<int>(width.value_or(0))};
    const auto wishes =
        askAboutImage(tr("Image"), view().document().images().imageNow(attribute("FILE"), preview),
                      now, false, parentWidget());
    if (!wishes)
        return;
    authoring::Attributes attributes{{"ALT", wishes->alternative.toStdString()}};
    if (wishes->width != now.width) {
        attributes.emplace_back("WIDTH", wishes->width > 0 ? std::to_string(wishes->width) : "");
        attributes.emplace_back("HEIGHT", "");
    }
    view().writing().perform(
        [&](const Manuscript& in, Selection at) { return changed(view(), in, at, attributes); });
}

} // namespace menus
