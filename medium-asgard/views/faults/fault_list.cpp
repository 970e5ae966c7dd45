#include "faults/fault_list.h"

#include "editing/changes.h"
#include "faults/close_joints.h"
#include "plain/plain.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>

namespace views {

FaultList::FaultList(SceneDocument& document, FaultListActions actions, QWidget* parent)
    : QWidget(parent), document_(document), actions_(std::move(actions)), summary_(plain::label()),
      list_(new QTreeWidget) {
    setObjectName(QStringLiteral("faults"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(6);
    auto* head = new QHBoxLayout;
    head->addWidget(summary_, 1);
    head->addWidget(new CloseJoints(document_, this));
    column->addLayout(head);
    column->addWidget(list_, 1);
    list_->setObjectName(QStringLiteral("faultItems"));
    list_->setAccessibleName(tr("Faults and warnings"));
    list_->setColumnCount(3);
    list_->setHeaderLabels({tr("Fault"), tr("Line"), tr("Time")});
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    list_->setRootIsDecorated(false);
    list_->setWordWrap(true);
    connect(list_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) { goTo(*item); });
    connect(list_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        goTo(*item);
        actions_.showText();
    });
    for (const auto signal : {&SceneDocument::diagnosticsChanged, &SceneDocument::workChanged})
        connect(&document_, signal, this, [this] {
            if (isVisible())
                refresh();
        });
    refresh();
}

void FaultList::showEvent(QShowEvent* event) {
    refresh();
    QWidget::showEvent(event);
}

QString FaultList::summary() const { return summary_->text(); }

void FaultList::refresh() {
    if (faults_ != document_.diagnostics()) { // else the keyboard keeps its place in it
        faults_ = document_.diagnostics();
        fill();
    }
    const auto errors =
        std::ranges::count(faults_, scene::Severity::error, &scene::Diagnostic::severity);
    const auto warnings = static_cast<long>(faults_.size()) - errors;
    QStringList parts;
    if (errors > 0)
        parts << (errors == 1 ? tr("1 error") : tr("%1 errors").arg(errors));
    if (warnings > 0)
        parts << (warnings == 1 ? tr("1 warning") : tr("%1 warnings").arg(warnings));
    QString text = parts.isEmpty() ? tr("No faults") : parts.join(QStringLiteral(", "));
    if (errors > 0 && !document_.sceneIsCurrent())
        text += tr(": the last good scene is shown");
    summary_->setText(text);
}

void FaultList::fill() {
    list_->clear();
    for (const scene::Diagnostic& fault : faults_) {
        const bool isError = fault.severity == scene::Severity::error;
        QString message = QString::fromStdString(fault.message);
        if (!fault.suggestion.empty())
            message += QStringLiteral(" – ") + QString::fromStdString(fault.suggestion);
        auto* item = new QTreeWidgetItem(
            list_, QStringList{message, fault.line > 0 ? QString::number(fault.line) : QString(),
                               fault.time ? tr("%1 s").arg(*fault.time, 0, 'g', 4) : QString()});
        item->setIcon(0, style()->standardIcon(isError ? QStyle::SP_MessageBoxCritical
                                                       : QStyle::SP_MessageBoxWarning));
        item->setToolTip(0, plain::tip(message));
        item->setData(0, Qt::AccessibleTextRole,
                      (isError ? tr("Error: %1") : tr("Warning: %1")).arg(message));
    }
    list_->viewport()->update(); // columns that become narrower leave their numbers behind
}

void FaultList::goTo(const QTreeWidgetItem& item) {
    const int index = list_->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(&item));
    if (index < 0 || static_cast<std::size_t>(index) >= faults_.size())
        return;
    const scene::Diagnostic fault = faults_[static_cast<std::size_t>(index)];
    if (document_.sceneIsCurrent())
        document_.select(editing::elementsAt(*document_.shown().scene, fault.range));
    if (fault.time)
        actions_.seek(*fault.time);
}

} // namespace views
