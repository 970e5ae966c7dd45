#include "frame/panes.h"

#include "plain/plain.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>
#include <utility>

namespace views {

namespace {

constexpr int version = 2; // of arrangements: another set of panes begins anew

class ScrolledContent : public QScrollArea {
public:
    ScrolledContent(QWidget* content, bool isLow) : isLow_(isLow) {
        setFrameShape(QFrame::NoFrame);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setWidgetResizable(true);
        setFocusPolicy(Qt::NoFocus);
        setWidget(content);
        content->show();
        fit();
    }

    [[nodiscard]] QSize sizeHint() const override {
        const QSize hint = QScrollArea::sizeHint();
        return isLow_ ? QSize(hint.width(), maximumHeight()) : hint;
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        const bool is = QScrollArea::eventFilter(watched, event);
        if (watched == widget() && event->type() == QEvent::LayoutRequest)
            fit();
        return is;
    }
    void resizeEvent(QResizeEvent* event) override {
        QScrollArea::resizeEvent(event);
        fit();
    }

private:
    void fit() {
        const QWidget& content = *widget();
        setMinimumWidth(std::max(content.minimumWidth(), content.minimumSizeHint().width()) +
                        verticalScrollBar()->sizeHint().width());
        if (!isLow_)
            return;
        const int height = content.hasHeightForWidth() ? content.heightForWidth(viewport()->width())
                                                       : content.sizeHint().height();
        setMaximumHeight(std::max(height, 1));
    }

    bool isLow_;
};

} // namespace

QWidget* scrolled(QWidget* content, bool isLow) { return new ScrolledContent(content, isLow); }

Panes::Panes(QMainWindow& window) : QObject(&window), window_(window) {
    window_.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks |
                           QMainWindow::AllowTabbedDocks);
    window_.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    // The sides reach down to the window's edge.
    window_.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window_.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
}

void Panes::add(Pane pane) {
    auto* dock = new QDockWidget(plain::ours(pane.title), &window_);
    dock->setObjectName(QStringLiteral("pane.") + pane.name);
    dock->setAccessibleName(pane.title);
    dock->toggleViewAction()->setShortcut(pane.key);
    panes_.push_back({std::move(pane), dock});
    put(panes_.back());
    const QString name = panes_.back().pane.name;
    connect(dock->toggleViewAction(), &QAction::triggered, this, [this, name](bool on) {
        if (on)
            show(name);
    });
    connect(dock, &QDockWidget::visibilityChanged, this, [this, name](bool on) {
        if (on)
            made(name);
    });
}

void Panes::put(const Placed& placed) {
    placed.dock->setFloating(false);
    window_.addDockWidget(placed.pane.side, placed.dock);
    if (const Placed* before = find(placed.pane.behind))
        window_.tabifyDockWidget(before->dock, placed.dock);
    placed.dock->hide();
}

void Panes::beginAnew() {
    for (Placed& one : panes_) {
        put(one);
        one.wasEmpty = true;
    }
    for (const Placed& one : panes_)
        if (one.pane.isEmpty)
            update(one.pane.name);
}

const Panes::Placed* Panes::find(const QString& name) const {
    for (const Placed& one : panes_)
        if (one.pane.name == name)
            return &one;
    return nullptr;
}

Panes::Placed* Panes::find(const QString& name) {
    return const_cast<Placed*>(std::as_const(*this).find(name));
}

QWidget* Panes::contentOf(const Placed& placed) {
    if (QWidget* known = placed.dock->widget())
        return known;
    QWidget* content = placed.pane.make();
    placed.dock->setWidget(content);
    Q_EMIT contentMade(placed.pane.name, content);
    return content;
}

QWidget* Panes::made(const QString& name) {
    const Placed* placed = find(name);
    return placed ? contentOf(*placed) : nullptr;
}

void Panes::show(const QString& name) {
    const Placed* placed = find(name);
    if (!placed)
        return;
    contentOf(*placed);
    const QSize before = window_.size();
    placed->dock->show();
    if (outgrowsScreen())
        putBeside(*placed, before);
    placed->dock->raise();
}

bool Panes::outgrowsScreen() const {
    const int frame = window_.frameGeometry().height() - window_.height();
    return window_.minimumSizeHint().height() + frame >
           window_.screen()->availableGeometry().height();
}

// A pane below the picture that has no room there comes in front of one beside it.
void Panes::putBeside(const Placed& placed, const QSize& size) {
    const auto isBelow = [&](const Placed& one) {
        return window_.dockWidgetArea(one.dock) == Qt::BottomDockWidgetArea;
    };
    const auto other = std::ranges::find_if(panes_, [&](const Placed& one) {
        return one.dock->isVisible() && !one.dock->isFloating() && !isBelow(one);
    });
    if (placed.dock->isFloating() || !isBelow(placed) || other == panes_.end())
        return;
    window_.tabifyDockWidget(other->dock, placed.dock);
    window_.layout()->activate(); // it may be lower now
    if (!window_.isMaximized() && !window_.isFullScreen())
        window_.resize(size);
}

void Panes::hide(const QString& name) {
    if (const Placed* placed = find(name))
        placed->dock->hide();
}

void Panes::update(const QString& name) {
    Placed* placed = find(name);
    const bool isEmpty = placed->pane.isEmpty();
    placed->dock->toggleViewAction()->setEnabled(!isEmpty);
    if (std::exchange(placed->wasEmpty, isEmpty) == isEmpty)
        return;
    if (isEmpty)
        return hide(name);
    show(name);
    window_.resizeDocks({placed->dock}, {placed->dock->sizeHint().height()}, Qt::Vertical);
}

void Panes::setTitle(const QString& name, const QString& title) {
    if (const Placed* placed = find(name))
        placed->dock->setWindowTitle(plain::ours(title));
}

bool Panes::isShown(const QString& name) const {
    const Placed* placed = find(name);
    return placed && !placed->dock->isHidden();
}

QWidget* Panes::content(const QString& name) const {
    const Placed* placed = find(name);
    return placed ? placed->dock->widget() : nullptr;
}

void Panes::fillMenu(QMenu& menu) const {
    for (const Placed& one : panes_)
        menu.addAction(one.dock->toggleViewAction());
}

QByteArray Panes::arrangement() const { return window_.saveState(version); }

bool Panes::restore(const QByteArray& arrangement, const QSize& room) {
    if (!window_.restoreState(arrangement, version))
        return false;
    for (const Placed& one : panes_) {
        if (one.pane.isEmpty)
            one.dock->setVisible(!one.pane.isEmpty());
        if (!one.dock->isHidden())
            contentOf(one);
    }
    const QSize least = window_.minimumSizeHint();
    if (least.boundedTo(room) != least) {
        beginAnew();
        return false;
    }
    return true;
}

} // namespace views
