// The faults of a document, by line and column: of its format, of its structure, and of its
// subdocuments.
#pragma once

#include "session/open_document.h"

#include <QDockWidget>
#include <QTimer>

class QTreeWidget;

namespace panes {

class FaultsPane : public QDockWidget {
    Q_OBJECT

public:
    FaultsPane(session::OpenDocument& document, QWidget* parent);
    [[nodiscard]] int count() const;
    // As they are listed: they follow the document when it pauses.
    [[nodiscard]] const std::vector<session::ListedFault>& faults() const { return faults_; }

Q_SIGNALS:
    void activated(const session::ListedFault& fault);
    void countChanged(int errors, int warnings);

private:
    void refresh();

    session::OpenDocument& document_;
    QTreeWidget* list_;
    QTimer timer_;
    std::vector<session::ListedFault> faults_;
};

} // namespace panes
