// A document on paper and as PDF: the pages of a presentation, with pictures of what lives in it.
#pragma once

#include "session/open_document.h"

#include <QWidget>

namespace filing {

// The document of a window in one of its presentations. All outlive it.
class Printing : public QObject {
    Q_OBJECT

public:
    Printing(session::OpenDocument& document, QWidget& window);

    void askAndExport(const QString& presentation);
    void exportTo(const QString& fileName, const QString& presentation);
    // `title`: of the job, as a queue of a printer shows it.
    void askAndPrint(const QString& presentation, const QString& title);

Q_SIGNALS:
    void said(const QString& sentence); // for the status line

private:
    session::OpenDocument& document_;
    QWidget& window_;
};

} // namespace filing
