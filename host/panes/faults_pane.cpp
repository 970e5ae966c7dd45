#include "panes/faults_pane.h"

#include "controls/icons.h"
#include "plain/plain.h"

#include <QFileInfo>
#include <QHeaderView>
#include <QTreeWidget>

namespace panes {

FaultsPane::FaultsPane(session::OpenDocument& document, QWidget* parent)
    : QDockWidget(tr("Faults"), parent), document_(document), list_(new QTreeWidget(this)) {
    setObjectName("faults");
    setAllowedAreas(Qt::BottomDockWidgetArea | Qt::TopDockWidgetArea);
    list_->setHeaderLabels({tr("Place"), tr("What is wrong")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setAccessibleName(tr("Faults"));
    list_->header()->setStretchLastSection(true);
    setWidget(list_);
    // Media report while a text is being typed: the list follows when they pause.
    constexpr int delayMs = 60;
    timer_.setSingleShot(true);
    timer_.setInterval(delayMs);
    connect(&timer_, &QTimer::timeout, this, &FaultsPane::refresh);
    connect(&document_, &session::OpenDocument::faultsChanged, &timer_,
            qOverload<>(&QTimer::start));
    connect(list_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        Q_EMIT activated(faults_[static_cast<std::size_t>(list_->indexOfTopLevelItem(item))]);
    });
    timer_.start(0);
}

int FaultsPane::count() const { return static_cast<int>(faults_.size()); }

void FaultsPane::refresh() {
    std::vector<session::ListedFault> faults = document_.faults();
    if (faults == faults_)
        return;
    faults_ = std::move(faults);
    list_->clear();
    int errors = 0;
    QList<QTreeWidgetItem*> items;
    for (const session::ListedFault& fault : faults_) {
        QString place =
            fault.position.line > 0
                ? QStringLiteral("%1:%2").arg(fault.position.line).arg(fault.position.column)
                : QString();
        if (!fault.file.isEmpty())
            place.prepend(QFileInfo(fault.file).fileName() + QLatin1Char(':'));
        auto* item = new QTreeWidgetItem({place, fault.message});
        item->setIcon(0, controls::iconNamed(fault.isError ? "dialog-error" : "dialog-warning"));
        item->setToolTip(1, plain::tip(fault.message));
        items << item;
        errors += fault.isError;
    }
    list_->addTopLevelItems(items);
    list_->resizeColumnToContents(0);
    Q_EMIT countChanged(errors, static_cast<int>(faults_.size()) - errors);
}

} // namespace panes
