// A plugin of Qt's for tests: it tells what the windows of a program show, and where.
//
// Qt loads it into any program by QT_QPA_GENERIC_PLUGINS=places:FOLDER. So the programs under test
// are those that users run, and the media that a host starts have it, too. Each process listens at
// FOLDER/PID. A request is a line of JSON, {} or {"points": [[x, y, z], ...]}; the answer is one
// document (README.md). It is given when the process has handled all that the display sent it
// before the request: a test that has pressed a key needs no sleep before it asks.
#include <QAbstractItemView>
#include <QAbstractNativeEventFilter>
#include <QApplication>
#include <QGenericPlugin>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocalServer>
#include <QLocalSocket>
#include <QMenu>
#include <QMenuBar>
#include <QMetaMethod>
#include <QPointer>
#include <QWindow>

#include <xcb/xcb.h>

#include <deque>
#include <functional>
#include <utility>

namespace {

// In device pixels from the top left of the window.
QJsonArray inPixels(const QWidget& window, const QPointF& at) {
    const double ratio = window.devicePixelRatioF();
    return {at.x() * ratio, at.y() * ratio};
}

QJsonArray inPixels(const QWidget& window, const QRect& rect) {
    const double ratio = window.devicePixelRatioF();
    return {rect.x() * ratio, rect.y() * ratio, rect.width() * ratio, rect.height() * ratio};
}

// The part of a rectangle of a widget that the widgets around it leave to be seen, in the window.
QRect seen(const QWidget& widget, QRect part) {
    part &= widget.rect();
    for (const QWidget* inner = &widget; !inner->isWindow(); inner = inner->parentWidget())
        part = part.translated(inner->pos()) & inner->parentWidget()->rect();
    return part;
}

// Without the marks of keys.
QString unmarked(QString text) {
    text = text.section(u'\t', 0, 0);
    for (qsizetype i = 0; (i = text.indexOf(u'&', i)) >= 0; ++i)
        text.remove(i, 1);
    return text;
}

using Geometry = std::function<QRect(QAction*)>;

QJsonArray actionsOf(const QWidget& of, const Geometry& geometry) {
    QJsonArray all;
    for (QAction* action : of.actions()) {
        if (action->isSeparator() || !action->isVisible())
            continue;
        QJsonObject one{{"text", unmarked(action->text())},
                        {"name", action->objectName()},
                        {"enabled", action->isEnabled()},
                        {"checked", action->isChecked()}};
        if (geometry)
            one["rect"] = inPixels(*of.window(), seen(of, geometry(action)));
        if (const QMenu* menu = action->menu())
            one["actions"] = actionsOf(*menu, nullptr);
        all.append(one);
    }
    return all;
}

QJsonArray rowsOf(const QAbstractItemView& view) {
    constexpr int most = 1000;
    QJsonArray all;
    const QAbstractItemModel* model = view.model();
    for (int row = 0; model && row < std::min(most, model->rowCount(view.rootIndex())); ++row) {
        const QModelIndex index = model->index(row, 0, view.rootIndex());
        all.append(QJsonObject{
            {"text", index.data().toString()},
            {"rect", inPixels(*view.window(), seen(*view.viewport(), view.visualRect(index)))}});
    }
    return all;
}

// The places of points of its scene, for a widget that has placeOf().
void addPoints(QJsonObject& to, QWidget& widget, const QJsonArray& points) {
    if (widget.metaObject()->indexOfMethod("placeOf(double,double,double)") < 0)
        return;
    QJsonArray all;
    for (const QJsonValue& point : points) {
        QPointF place;
        QMetaObject::invokeMethod(&widget, "placeOf", Qt::DirectConnection,
                                  Q_RETURN_ARG(QPointF, place), Q_ARG(double, point[0].toDouble()),
                                  Q_ARG(double, point[1].toDouble()),
                                  Q_ARG(double, point[2].toDouble()));
        all.append(
            inPixels(*widget.window(), QPointF(widget.mapTo(widget.window(), QPoint())) + place));
    }
    to["points"] = all;
}

QJsonObject describe(QWidget& widget, const QJsonArray& points) {
    QJsonObject one{{"name", widget.objectName()},
                    {"type", widget.metaObject()->className()},
                    {"spoken", widget.accessibleName()},
                    {"enabled", widget.isEnabled()},
                    {"focus", widget.hasFocus()},
                    {"rect", inPixels(*widget.window(), seen(widget, widget.rect()))}};
    for (const char* property : {"text", "currentText", "title", "checked", "value"})
        if (const QVariant value = widget.property(property); value.isValid())
            one[property] = value.metaType() == QMetaType::fromType<QString>()
                                ? QJsonValue(unmarked(value.toString()))
                                : QJsonValue::fromVariant(value);
    if (auto* bar = qobject_cast<QMenuBar*>(&widget))
        one["actions"] = actionsOf(*bar, [bar](QAction* a) { return bar->actionGeometry(a); });
    else if (auto* menu = qobject_cast<QMenu*>(&widget))
        one["actions"] = actionsOf(*menu, [menu](QAction* a) { return menu->actionGeometry(a); });
    else if (auto* view = qobject_cast<QAbstractItemView*>(&widget))
        one["rows"] = rowsOf(*view);
    addPoints(one, widget, points);
    return one;
}

QJsonObject describeWindow(QWidget& window, const QJsonArray& points) {
    QJsonArray widgets;
    widgets.append(describe(window, points));
    for (QWidget* widget : window.findChildren<QWidget*>())
        if (widget->window() == &window && widget->isVisible() &&
            !seen(*widget, widget->rect()).isEmpty())
            widgets.append(describe(*widget, points));
    return {{"id", static_cast<qint64>(window.winId())},
            {"name", window.objectName()},
            {"type", window.metaObject()->className()},
            {"title", window.windowTitle()},
            {"modified", window.isWindowModified()},
            {"active", window.isActiveWindow()},
            {"modal", window.isModal()},
            {"widgets", widgets}};
}

QByteArray describeAll(const QJsonArray& points) {
    QJsonArray windows;
    for (QWidget* window : QApplication::topLevelWidgets())
        if (window->isVisible() && window->windowHandle() && window->windowHandle()->isExposed())
            windows.append(describeWindow(*window, points));
    return QJsonDocument(
               QJsonObject{{"pid", QCoreApplication::applicationPid()}, {"windows", windows}})
        .toJson(QJsonDocument::Compact);
}

// Answers those who ask. Before each answer a message goes to the display and comes back, behind
// all that the display had for this process.
class Places : public QObject, public QAbstractNativeEventFilter {
public:
    explicit Places(const QString& folder) {
        qApp->installNativeEventFilter(this);
        connect(&server_, &QLocalServer::newConnection, this, [this] {
            while (QLocalSocket* from = server_.nextPendingConnection()) {
                connect(from, &QLocalSocket::readyRead, this, [this, from] { hear(*from); });
                connect(from, &QLocalSocket::disconnected, from, &QObject::deleteLater);
                hear(*from);
            }
        });
        const QString name = folder + '/' + QString::number(QCoreApplication::applicationPid());
        if (!server_.listen(name))
            qFatal("places: %s: %s", qPrintable(name), qPrintable(server_.errorString()));
    }

    bool nativeEventFilter(const QByteArray& type, void* message, qintptr* /*result*/) override {
        if (window_ == XCB_NONE || type != "xcb_generic_event_t")
            return false;
        const auto* event = static_cast<const xcb_client_message_event_t*>(message);
        if ((event->response_type & 0x7f) != XCB_CLIENT_MESSAGE || event->window != window_)
            return false;
        finish();
        return true;
    }

protected:
    void customEvent(QEvent* /*event*/) override {
        const Request request = std::move(requests_.front());
        requests_.pop_front();
        if (!request.from)
            return;
        request.from->write(describeAll(request.points));
        request.from->disconnectFromServer();
    }

private:
    struct Request {
        QPointer<QLocalSocket> from;
        QJsonArray points;
    };

    void hear(QLocalSocket& from) {
        if (!from.canReadLine())
            return;
        requests_.push_back({&from, QJsonDocument::fromJson(from.readLine())["points"].toArray()});
        if (auto* x11 = qApp->nativeInterface<QNativeInterface::QX11Application>())
            sendThere(x11->connection());
        else
            finish();
    }

    void sendThere(xcb_connection_t* display) {
        if (window_ == XCB_NONE) {
            window_ = xcb_generate_id(display);
            const xcb_window_t root = xcb_setup_roots_iterator(xcb_get_setup(display)).data->root;
            xcb_create_window(display, 0, window_, root, 0, 0, 1, 1, 0, XCB_WINDOW_CLASS_INPUT_ONLY,
                              XCB_COPY_FROM_PARENT, 0, nullptr);
        }
        xcb_client_message_event_t event{};
        event.response_type = XCB_CLIENT_MESSAGE;
        event.format = 32;
        event.window = window_;
        event.type = XCB_ATOM_INTEGER;
        xcb_send_event(display, 0, window_, XCB_EVENT_MASK_NO_EVENT,
                       reinterpret_cast<const char*>(&event));
        xcb_flush(display);
    }

    // Behind what is posted already, and what that posts.
    void finish() {
        QCoreApplication::postEvent(this, new QEvent(QEvent::User), Qt::LowEventPriority);
    }

    QLocalServer server_;
    std::deque<Request> requests_;
    xcb_window_t window_ = XCB_NONE; // never shown
};

} // namespace

class PlacesPlugin : public QGenericPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID QGenericPluginFactoryInterface_iid FILE "places.json")
public:
    QObject* create(const QString& /*name*/, const QString& folder) override {
        return new Places(folder);
    }
};

#include "places.moc"
