#include "filing/templates.h"

#include "document/document.h"
#include "menus/language_menu.h"
#include "sgml/edit.h"
#include "text/edit.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <algorithm>

namespace filing {

namespace {

std::string inLanguage(const std::string& bytes, const QString& language) {
    const document::Document document(bytes);
    const sgml::Tree& tree = document.tree();
    const sgml::NodeId top = tree.classElement(tree.root());
    if (language.isEmpty() || top == sgml::noNode)
        return bytes;
    return text::applied(bytes, sgml::attributeEdit(tree, top, "LANG", language.toStdString()));
}

} // namespace

Template::Read Template::read() const { return readIn(menus::desktopLanguage()); }

Template::Read Template::readIn(const QString& language) const {
    if (file.startsWith(':')) {
        QFile own(file);
        (void)own.open(QIODevice::ReadOnly);
        return {inLanguage(own.readAll().toStdString(), language)};
    }
    const document::Document::Loaded loaded = document::Document::load(file);
    return loaded.document ? Read{loaded.document->bytes()} : Read{{}, loaded.failure};
}

QString templateFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           QStringLiteral("/ensemble/templates");
}

std::vector<Template> templates() {
    std::vector<Template> all;
    for (const char* name : {"Memo", "Report", "Laboratory Report"})
        all.push_back({QString::fromUtf8(name), QStringLiteral(":/templates/%1.ens").arg(name)});
    const QDir folder(templateFolder());
    for (const QFileInfo& file : folder.entryInfoList({"*.ens"}, QDir::Files, QDir::Name)) {
        const auto same = std::ranges::find(all, file.completeBaseName(), &Template::name);
        if (same != all.end())
            same->file = file.filePath();
        else
            all.push_back({file.completeBaseName(), file.filePath()});
    }
    return all;
}

} // namespace filing
