#include "console/batch_document.h"

#include "files/read.h"
#include "terminal/terminal.h"

#include <QCoreApplication>

namespace console {

void complain(const QString& text) { terminal::complain(text.toStdString()); }

BatchDocument::BatchDocument(const QString& input)
    : schemas_(schemas::Schemas::load(schemas::Schemas::standardFolders())),
      media_(media::Registry::read(media::registryFolders(QCoreApplication::applicationDirPath())),
             QCoreApplication::applicationDirPath(), pipes_) {
    for (const QString& fault : media_.registry().faults())
        complain(fault);
    std::unique_ptr<document::Document> document;
    if (input == "-") {
        files::ReadFile in =
            files::readStandardInput(files::FileSystem::real(), sgml::Limits{}.bytes);
        if (in.read)
            document = std::make_unique<document::Document>(std::move(in.bytes));
        else
            failure_ = QStringLiteral("standard input cannot be read: %1.")
                           .arg(QString::fromStdString(in.reason));
    } else {
        document::Document::Loaded loaded = document::Document::load(input);
        failure_ = loaded.failure;
        document = std::move(loaded.document);
    }
    if (!document)
        return;
    document_ = std::make_unique<session::OpenDocument>(std::move(document), schemas_, media_);
    for (const document::SubdocumentId id : document_->document().subdocuments())
        if (media::LiveSubdocument* live = document_->live(id))
            live->setMode(media::Mode::batch);
}

void BatchDocument::settleValues() {
    QEventLoop loop;
    QObject::connect(&document_->values(), &session::Values::settled, &loop, &QEventLoop::quit);
    document_->values().settle();
    loop.exec();
}

} // namespace console
