// A Create command on its way: it asks for clicks, one step after another, and then writes the new
// element into the text as one step of undo. The menu of a body has made the first click already.
//
// A click is the left button, shifted or not, let go where it was pressed; dragging turns the view
// meanwhile, so that what is to be clicked on can be brought to the front. With the keys: the
// arrows move a cross through the picture, Return takes what is under it - or, before it was moved,
// what the step offers instead. Where a place is asked for, its numbers may be typed. Escape gives
// up. Every other key of a letter, a digit or a blank does nothing: a slip of the hand moves no
// body. Until the click the new thing is outlined where it would be, drawn to things and round
// numbers nearby (gestures/snapping.h) unless Ctrl is held.
//
// While a text is being read, a command waits for the scene, and its keys wait with it until the
// scene is seen; a command that needs none of them gives them to the window then. A click waits for
// the picture, too, with the keys behind it. A text with errors ends it, and so does another
// change.
#pragma once

#include "picture/indicating.h"
#include "recipes/recipes.h"
#include "workbench/when_read.h"

#include <QKeyEvent>
#include <QObject>
#include <QPointF>

#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

class QPainter;

namespace views {

class SceneDisplay;

class Creating : public QObject {
    Q_OBJECT
public:
    Creating(SceneDocument& document, SceneDisplay& display);

    // A place on a body, shown before the command began.
    struct Aim {
        Follow body;
        std::optional<Vector> place; // in the body's frame; none: its centre
    };
    void start(Recipe recipe);
    // The recipe is made of the scene that it is for.
    void start(std::function<Recipe()> recipe, std::optional<Aim> aim = std::nullopt);
    [[nodiscard]] Aim aimAt(const editing::Element& body, const QPointF& position) const;
    [[nodiscard]] bool active() const { return begun_ || waiting_; }
    void cancel();
    void click(const QPointF& position, bool holdsOff = false);
    // Shows what a click there would make. `holdsOff`: things nearby do not draw it to them.
    void hover(const QPointF& position, bool holdsOff = false);
    bool key(const QKeyEvent& event); // false: not theirs
    [[nodiscard]] bool uses(const QKeyEvent& event) const;
    // The step that is asked for, and the fault of the last click.
    [[nodiscard]] QString prompt() const;
    // The meaning of a click where the pointer is, beside which it stands; "": none.
    [[nodiscard]] QString pointedWords() const;
    void paint(QPainter& painter) const;
    // The measured distance is seen until the next command, a change of the text, or this. False:
    // there is none.
    bool forgetMeasured();

Q_SIGNALS:
    void changed();
    // It is in the text: what it is, where it is to be selected, and whose handles to show.
    void created(const std::optional<editing::Element>& element, HandleSwitch handles);
    // To be shown before one can click on it.
    void needs(HandleSwitch what);
    void refused(const QString& why);
    void told(const QString& answer); // of what makes nothing

private:
    struct Waiting { // for the scene of the text
        std::function<Recipe()> recipe;
        std::optional<Aim> aim;
        std::vector<std::unique_ptr<QKeyEvent>> keys; // that were typed meanwhile
    };

    void stopWaiting(); // if the scene is there, or will not come
    void refuseEarlyClick();
    void takeInputs(); // all clicks whose picture is there, and what came behind them
    void handBack(const QKeyEvent& event);
    void begin(Recipe recipe);
    void takeAim(const Aim& aim);
    [[nodiscard]] bool mayType() const;
    [[nodiscard]] bool types(const QKeyEvent& event) const;
    bool type(const QKeyEvent& event);
    void paintSteps(QPainter& painter) const;
    void paintMeasured(QPainter& painter) const;
    void paintOutline(QPainter& painter, const Outline& outline) const;
    void paintGhost(QPainter& painter, const Indicated& next) const;
    void paintHold(QPainter& painter, const Indicated& next) const;
    void paintWords(QPainter& painter, const QPointF& place, const QString& words) const;
    [[nodiscard]] QString wordsOf(const Indicated& next) const;
    [[nodiscard]] std::optional<Judged> judge(const Indicated& next) const;
    // None: nothing of what the step asks for is there, and that is the fault now.
    [[nodiscard]] std::optional<Indicated> indicated(const QPointF& position, bool holdsOff);
    void take(const Indicated& indicated);
    void otherwise();
    [[nodiscard]] editing::Answer answerTo(const std::vector<editing::Wish>& wishes) const;
    void finish();

    SceneDocument& document_;
    SceneDisplay& display_;
    WhenRead later_;
    std::optional<Waiting> waiting_;
    std::optional<BegunRecipe> begun_;
    Indicating indicating_;
    std::optional<Indicated> next_; // under the pointer
    QString fault_;
    std::optional<QPointF> cross_; // moved by the keys
    struct Click {
        QPointF position;
        bool holdsOff;
    };
    struct Command {
        std::function<Recipe()> recipe;
        std::optional<Aim> aim;
    };
    using Input = std::variant<Click, std::unique_ptr<QKeyEvent>, Command>;
    std::vector<Input> inputs_; // in their order: the picture of their scene is not there yet
    QString typed_;             // "1 2.5 0": where the point is to be
    struct Measured {
        Vector from, to; // world
        QString words;
    };
    std::optional<Measured> measured_;
};

} // namespace views
