// The shape editor (dissertation 4.1.1, Figure 4.3): the parts of a shape set, whose points are
// dragged, added and deleted. One for each scene; the text follows, each gesture one step of undo.
//
// The hulls of the parts are made as they change; vertices inside are white, and leave the text
// with the button, and when this window leaves a shape that was edited here.
#pragma once

#include "shapes/shape_display.h"
#include "shapes/shape_gesture.h"

#include <QMainWindow>

#include <memory>
#include <set>

class QAction;
class QComboBox;

namespace views {

class HintLine;
class ShapeFields;
class ShapePanel;

class ShapeEditor : public QMainWindow {
    Q_OBJECT
public:
    ShapeEditor(SceneDocument& document, std::shared_ptr<PictureThread> pictures);

    void showShape(const QString& name);
    void askForNewShape();
    void askToImport(); // a file, shown as what it becomes
    // A shape set of that name with one polyhedron; "" or the sentence that says why not.
    QString newShape(const QString& name);
    QString renameShape(const QString& name); // the shown one, in the text and where it is used
    void addParts(const std::vector<scene::Part>& parts, const QString& label);
    void setColour(std::size_t part, std::optional<scene::Color> color);

    void settle(); // as when the shape is left: inner vertices go, if it was edited here
    [[nodiscard]] QString shape() const;
    [[nodiscard]] ShapeDisplay& display() { return *display_; }
    [[nodiscard]] const std::vector<editing::DraftPart>& draft() const { return draft_; }
    [[nodiscard]] QString words() const;
    [[nodiscard]] std::optional<Asked> asked() const; // by what is dragged

protected:
    void closeEvent(QCloseEvent* event) override; // inner vertices go
    void showEvent(QShowEvent* event) override;

private:
    using Change = std::function<void()>; // of draft_; shape_changes.cpp has these

    void buildTools();
    void buildMenus();
    void connectDisplay();
    void connectPanel();
    void followScene();
    void fillNames();
    void showDraft(bool another = false);
    void showFields();
    void choose(std::optional<std::size_t> part, std::optional<std::size_t> point = {});
    [[nodiscard]] std::optional<std::size_t> index() const;
    [[nodiscard]] std::vector<scene::Part> parts() const;
    [[nodiscard]] bool isBegun() const; // with nothing but the part that a new shape begins with
    [[nodiscard]] bool begin();
    void preview();
    void finish(const QString& label);
    void cancel();
    bool change(const QString& label, const Change& how); // at once
    void drag(const geometry::Vector& place);
    void movePoint(const geometry::Vector& place);
    void resizePart(const std::vector<double>& sizes);
    void addPoint(const geometry::Vector& place);
    void addPointByKey();
    void removePart();
    void removePoint(std::size_t part, std::size_t point);
    void dropInnerPoints(bool ofAll);
    void leaveShape(const QString& name);
    void chooseNext(int direction);
    void nudge(const geometry::Vector& direction);
    void makeNudges();
    void askForColour();
    void askForName();
    void offer(const editing::Answer& answer, const QString& label);
    void tell(const QString& words, bool isFault = false);
    bool eventFilter(QObject* watched, QEvent* event) override;

    SceneDocument& document_;
    QComboBox* names_;
    ShapeDisplay* display_;
    ShapePanel* panel_;
    ShapeFields* fields_;
    HintLine* words_;
    struct Actions { // of what is chosen
        QAction *rename = nullptr, *removePart = nullptr, *removePoint = nullptr;
    };
    Actions actions_;
    std::vector<editing::DraftPart> draft_;
    std::unique_ptr<ShapeGesture> gesture_;
    struct Names {                // of shapes
        QString shown, wanted;    // wanted: on its way through the text
        QString begun;            // made here last: the part that it begins with gives way
        std::set<QString> edited; // here, and not left since
    };
    Names shapes_;
    std::optional<std::size_t> wantedPart_;
    struct Nudge { // by keys, while the text is read
        std::size_t part, point;
        geometry::Vector direction;
    };
    std::vector<Nudge> nudges_;
    bool closing_ = false;
    bool untilCurrent_ = false; // what is said holds only while the text is not the scene's
};

} // namespace views
