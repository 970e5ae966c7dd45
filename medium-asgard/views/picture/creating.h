// A Create command on its way: it asks for clicks, one step after another, and then writes the new
// element into the text as one step of undo.
//
// A click is the left button, shifted or not, let go where it was pressed; dragging turns the view
// meanwhile, so that what is to be clicked on can be brought to the front. With the keys: the
// arrows move a cross through the picture, Return takes what is under it - or, before it was moved,
// what the step offers instead. Escape gives up.
#pragma once

#include "gestures/picking.h"
#include "picture/recipes.h"
#include "workbench/scene_document.h"

#include <QObject>
#include <QPointF>

class QKeyEvent;
class QPainter;

namespace views {

class SceneDisplay;

class Creating : public QObject {
    Q_OBJECT
public:
    Creating(SceneDocument& document, SceneDisplay& display);

    void start(Recipe recipe);
    [[nodiscard]] bool active() const { return recipe_.has_value(); }
    void cancel();
    void click(const QPointF& position);
    void hover(const QPointF& position); // shows what a click there would make
    bool key(const QKeyEvent& event);    // false: not theirs
    // The step that is asked for, and the fault of the last click.
    [[nodiscard]] QString prompt() const;
    void paint(QPainter& painter) const;

Q_SIGNALS:
    void changed();
    // It is in the text: what it is, and whose handles to show.
    void created(editing::Element element, HandleSwitch handles);
    // To be shown before one can click on it.
    void needs(HandleSwitch what);
    void refused(const QString& why);

private:
    [[nodiscard]] const Step& step() const;
    void offerBody();
    [[nodiscard]] std::optional<Indicated> indicated(const QPointF& position);
    [[nodiscard]] Indicated held(const Eigen::Vector2d& pixels) const;
    [[nodiscard]] Indicated onBody(std::size_t body, const Vector& point) const;
    [[nodiscard]] Vector onAxes(std::size_t body, const Vector& onBody, double near) const;
    [[nodiscard]] Indicated centerOf(std::size_t body) const;
    void take(const Indicated& indicated);
    void otherwise();
    void finish();

    SceneDocument& document_;
    SceneDisplay& display_;
    std::optional<Recipe> recipe_;
    std::vector<Indicated> shown_;
    std::optional<Indicated> next_; // under the pointer
    QString fault_;
    std::optional<QPointF> cross_; // moved by the keys
};

} // namespace views
