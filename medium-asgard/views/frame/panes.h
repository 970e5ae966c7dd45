// Panes beside a window's middle: they dock, stand behind each other, tear off and close, and their
// arrangement can be kept.
#pragma once

#include <QByteArray>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>

#include <functional>

class QDockWidget;
class QMainWindow;
class QMenu;
class QWidget;

namespace views {

struct Pane {
    QString name;  // of the object, by which an arrangement knows it
    QString title; // as the reader sees it
    Qt::DockWidgetArea side = Qt::RightDockWidgetArea;
    std::function<QWidget*()> make; // called when the pane is first shown
    QString behind = {};            // the name of a pane whose place it shares
    QKeySequence key = {};          // shows and closes it
    // Given: the pane is open while there is something in it (Panes::update()).
    std::function<bool()> isEmpty = {};
};

// A content that scrolls up and down where its pane is low. `isLow`: the pane is no higher than its
// content.
[[nodiscard]] QWidget* scrolled(QWidget* content, bool isLow = false);

class Panes : public QObject {
    Q_OBJECT
public:
    explicit Panes(QMainWindow& window);

    // Closed until show(). A name is used once.
    void add(Pane pane);
    void show(const QString& name); // made if need be, and in front
    void hide(const QString& name);
    // Shows a pane that is not empty any more, hides one that is empty now. In between the user's
    // choice counts.
    void update(const QString& name);
    void setTitle(const QString& name, const QString& title);
    [[nodiscard]] bool isShown(const QString& name) const;
    // nullptr: it was never shown, or there is no such pane.
    [[nodiscard]] QWidget* content(const QString& name) const;
    // As show(), without showing it.
    QWidget* made(const QString& name);
    // An entry for each pane, checked while the pane is shown.
    void fillMenu(QMenu& menu) const;

    // Sizes, places and which are shown; `restore` gives false for another program's arrangement,
    // and for one that takes more than that room, as on a smaller screen: then all are in their
    // places as after add(), and those that open by themselves are shown.
    [[nodiscard]] QByteArray arrangement() const;
    bool restore(const QByteArray& arrangement, const QSize& room);
    void beginAnew(); // all in their places; those that open by themselves are shown

Q_SIGNALS:
    void contentMade(const QString& name, QWidget* content);

private:
    struct Placed {
        Pane pane;
        QDockWidget* dock;
        bool wasEmpty = true;
    };
    [[nodiscard]] Placed* find(const QString& name);
    [[nodiscard]] const Placed* find(const QString& name) const;
    QWidget* contentOf(const Placed& placed);
    void put(const Placed& placed);                          // in its place, closed
    [[nodiscard]] bool outgrowsScreen() const;               // the window, as small as it gets
    void putBeside(const Placed& placed, const QSize& size); // of the window before

    QMainWindow& window_;
    QList<Placed> panes_;
};

} // namespace views
