#include "faults/close_joints.h"

#include "plain/plain.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPointer>
#include <QThreadPool>
#include <QToolTip>

namespace views {

CloseJoints::CloseJoints(SceneDocument& document, QWidget* parent)
    : QPushButton(parent), document_(document) {
    setObjectName(QStringLiteral("closeJoints"));
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    setToolTip(plain::tip(tr("Moves the free bodies as little as possible, so that joints close "
                             "and no bodies overlap, and writes it into the text")));
    connect(this, &QPushButton::clicked, this, &CloseJoints::startOrStop);
    connect(&document_, &SceneDocument::textChanged, this, &CloseJoints::textChanged);
    for (const auto signal : {&SceneDocument::diagnosticsChanged, &SceneDocument::workChanged})
        connect(&document_, signal, this, &CloseJoints::refresh);
    refresh();
}

CloseJoints::~CloseJoints() { cancel(); }

void CloseJoints::refresh() {
    const auto misplaced = commands::misplacedIn(document_.diagnostics());
    setText(search_ ? tr("Stop Moving") : QString::fromStdString(commands::offerOf(misplaced)));
    setVisible(search_ || (misplaced != commands::Misplaced() && document_.sceneIsCurrent()));
}

void CloseJoints::startOrStop() {
    if (!search_)
        return start();
    cancel();
    reason_ = tr("Stopped: all bodies are where they were.");
    say();
}

void CloseJoints::mouseDoubleClickEvent(QMouseEvent* event) { event->accept(); }

void CloseJoints::cancel() {
    if (!search_)
        return;
    *search_ = true;
    search_.reset();
    refresh();
}

void CloseJoints::textChanged() {
    if (!search_)
        return;
    cancel();
    reason_ = tr("The text has changed meanwhile: try again.");
    say();
}

void CloseJoints::start() {
    reason_ = document_.whyNotCurrent();
    if (!reason_.isEmpty())
        return say();
    search_ = std::make_shared<std::atomic<bool>>(false);
    refresh();
    QThreadPool::globalInstance()->start([button = QPointer<CloseJoints>(this),
                                          text = document_.text(), scene = document_.shown().scene,
                                          search = search_] {
        const auto take =
            [button, now = commands::closed(text, scene, [&] { return search->load(); }), search] {
                if (button)
                    button->take(now, search);
            };
        QMetaObject::invokeMethod(qApp, take, Qt::QueuedConnection);
    });
}

void CloseJoints::take(const commands::Closed& now, const Search& search) {
    if (search != search_)
        return; // it was ended
    search_.reset();
    refresh();
    reason_ = QString::fromStdString(now.reason);
    if (!reason_.isEmpty())
        return say();
    document_.setText(now.text, QString::fromStdString(commands::labelOf(
                                    commands::misplacedIn(document_.diagnostics()))));
}

void CloseJoints::say() const {
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), plain::tip(reason_));
}

} // namespace views
