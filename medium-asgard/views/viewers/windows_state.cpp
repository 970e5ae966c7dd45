// An Editor's windows as text, for another process: what that process opens again.
#include "language/scene_editor.h"
#include "shapes/shape_editor.h"
#include "trajectories/trajectory_editor.h"
#include "viewers/editor.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace views {

namespace {

constexpr const char* format = "asgard-windows-1";
constexpr qsizetype longest = 8 << 20; // bytes of all of it, as the protocol says

using Numbers = std::vector<double*>;

Numbers numbersOf(render::Camera& camera) {
    auto& q = camera.rotation.coeffs();
    Numbers numbers{&camera.scale, &q[0], &q[1], &q[2], &q[3]};
    for (auto* vector : {&camera.center, &camera.position})
        for (double& component : *vector)
            numbers.push_back(&component);
    return numbers;
}

QJsonArray written(render::Camera camera) {
    QJsonArray numbers;
    for (const double* number : numbersOf(camera))
        numbers.append(*number);
    return numbers;
}

std::optional<render::Camera> cameraOf(const QJsonArray& written) {
    render::Camera camera;
    const Numbers numbers = numbersOf(camera);
    if (written.size() != static_cast<qsizetype>(numbers.size()))
        return std::nullopt;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        *numbers[i] = written[static_cast<qsizetype>(i)].toDouble();
    return camera;
}

QJsonObject windowOf(const char* kind, const QWidget& window) {
    return {{"kind", kind}, {"place", QString::fromLatin1(window.saveGeometry().toBase64())}};
}

QJsonObject written(LanguageViewer& viewer, bool withDraft) {
    QJsonObject window = windowOf("text", viewer);
    window["caret"] = static_cast<qint64>(viewer.editor().caret());
    if (withDraft && viewer.hasDraft()) {
        window["base"] = QString::fromStdString(viewer.draftBase());
        window["draft"] = QString::fromStdString(viewer.draft());
    }
    return window;
}

QJsonObject written(GraphicalViewer& viewer, bool withDraft) {
    QJsonObject window = windowOf("picture", viewer);
    window["time"] = viewer.playback().time();
    if (!viewer.display().framesItself())
        window["camera"] = written(viewer.display().camera());
    window["orthographic"] = viewer.display().camera().orthographic;
    QJsonArray hidden;
    for (const std::string& name : viewer.display().hidden())
        hidden.append(QString::fromStdString(name));
    window["hidden"] = hidden;
    window["shown"] = QJsonArray::fromStringList(viewer.switches().shown());
    QJsonArray meters;
    for (const auto& [name, look] : viewer.display().meters().looks())
        meters.append(QJsonObject{{"plot", QString::fromStdString(name.plot)},
                                  {"value", static_cast<qint64>(name.value)},
                                  {"right", look.aside.x()},
                                  {"down", look.aside.y()},
                                  {"chart", look.isChart}});
    window["meters"] = meters;
    window["view"] = viewer.display().followedView();
    window["panes"] = QString::fromLatin1(viewer.panes().arrangement().toBase64());
    if (LanguageViewer* text = viewer.text())
        window["text"] = written(*text, withDraft);
    return window;
}

QByteArray written(const QJsonArray& windows) {
    return windows.isEmpty() ? QByteArray()
                             : QJsonDocument(QJsonObject{{"format", format}, {"windows", windows}})
                                   .toJson(QJsonDocument::Compact);
}

void place(QWidget& window, const QJsonObject& as) {
    window.restoreGeometry(QByteArray::fromBase64(as["place"].toString().toLatin1()));
}

void restore(LanguageViewer& viewer, const QJsonObject& as) {
    if (as.contains("draft"))
        viewer.restoreDraft(as["base"].toString().toStdString(),
                            as["draft"].toString().toStdString());
    const auto caret = static_cast<std::size_t>(std::max<qint64>(0, as["caret"].toInteger()));
    const std::size_t at = std::min(caret, viewer.draft().size());
    viewer.select(at, at);
}

void restore(GraphicalViewer& viewer, const QJsonObject& as) {
    if (const QString view = as["view"].toString(); !view.isEmpty())
        viewer.display().followView(view);
    else if (const auto camera = cameraOf(as["camera"].toArray()))
        viewer.display().setCamera(*camera);
    if (as["orthographic"].toBool())
        viewer.display().setOrthographic(true);
    std::set<std::string> hidden;
    for (const auto& name : as["hidden"].toArray())
        hidden.insert(name.toString().toStdString());
    viewer.display().setHidden(std::move(hidden));
    if (as.contains("shown"))
        viewer.switches().setShown(as["shown"].toVariant().toStringList());
    MeterLooks meters;
    for (const auto& each : as["meters"].toArray()) {
        const QJsonObject one = each.toObject();
        const auto value = static_cast<std::size_t>(std::max<qint64>(0, one["value"].toInteger()));
        meters[{one["plot"].toString().toStdString(), value}] = {
            {one["right"].toDouble(), one["down"].toDouble()}, one["chart"].toBool()};
    }
    viewer.display().meters().setLooks(std::move(meters));
    viewer.playback().seek(as["time"].toDouble());
    if (const QString panes = as["panes"].toString(); !panes.isEmpty())
        viewer.arrange(QByteArray::fromBase64(panes.toLatin1()));
    if (as.contains("text"))
        restore(static_cast<LanguageViewer&>(*viewer.panes().made("text")), as["text"].toObject());
}

} // namespace

std::string Editor::windowsState() const {
    const auto all = [this](bool withDrafts) {
        QJsonArray windows;
        for (GraphicalViewer* viewer : graphicalViewers())
            windows.append(written(*viewer, withDrafts));
        for (LanguageViewer* viewer : languageViewers())
            if (!viewer->isPane())
                windows.append(written(*viewer, withDrafts));
        if (trajectoryEditor_ && trajectoryEditor_->isVisible())
            windows.append(windowOf("trajectories", *trajectoryEditor_));
        if (shapeEditor_ && shapeEditor_->isVisible()) {
            QJsonObject shape = windowOf("shapes", *shapeEditor_);
            shape["shape"] = shapeEditor_->shape();
            windows.append(shape);
        }
        return written(windows);
    };
    const QByteArray state = all(true);
    return (state.size() <= longest ? state : all(false)).toStdString();
}

void Editor::restoreWindows(const std::string& state, const QString& notice) {
    const QJsonObject whole = QJsonDocument::fromJson(QByteArray::fromStdString(state)).object();
    if (whole["format"] != format)
        return;
    const QJsonArray windows = whole["windows"].toArray();
    for (const auto& value : windows) {
        const QJsonObject window = value.toObject();
        const QString kind = window["kind"].toString();
        if (kind == "picture") {
            GraphicalViewer* viewer = openGraphicalViewer();
            place(*viewer, window);
            restore(*viewer, window);
            viewer->tell(notice);
        } else if (kind == "text") {
            LanguageViewer* viewer = openLanguageViewer();
            place(*viewer, window);
            restore(*viewer, window);
            viewer->tell(notice);
        } else if (kind == "trajectories") {
            place(*openTrajectoryEditor(), window);
        } else if (kind == "shapes") {
            place(*openShapeEditor(window["shape"].toString()), window);
        }
    }
}

} // namespace views
