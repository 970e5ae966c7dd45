#include "picture/creating.h"

#include "picture/scene_display.h"
#include "recipes/recipe_words.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>

namespace views {

namespace {

bool isBody(const editing::NewElement& one) { return one.kind == editing::Kind::body; }

// New bodies fall as all others do, if they do.
void addWeightAsOthersHaveIt(std::vector<editing::NewElement>& made, const scene::Scene& scene) {
    const auto acceleration = commonGravity(scene);
    if (!acceleration)
        return;
    std::vector<editing::NewElement> weights;
    for (const editing::NewElement& one : made)
        if (isBody(one) && std::ranges::find(one.words, "-fixed") == one.words.end())
            weights.push_back({editing::Kind::force,
                               "",
                               {"-body", one.name, "-gravitational", listed(*acceleration, 0)},
                               {}});
    made.insert(made.end(), weights.begin(), weights.end());
}

// The element that is marked then: of several new ones the first body, and a body that the recipe
// changes before forces on it.
editing::Element markedOf(const scene::Scene& scene, const std::vector<editing::NewElement>& made,
                          const std::vector<editing::Wish>& changed) {
    const bool isBodyMade = std::ranges::any_of(made, isBody);
    if (!isBodyMade && !changed.empty())
        return changed.front().element;
    editing::Element element{isBodyMade ? editing::Kind::body : made.back().kind, 0};
    while (editing::sourceOf(scene, element))
        ++element.index;
    return element;
}

// Those that the scene before has not.
std::vector<editing::Element> newBodies(const scene::Scene& before, const scene::Scene& now) {
    std::set<std::string_view> known;
    for (const scene::Body& body : before.bodies)
        known.insert(body.name);
    std::vector<editing::Element> all;
    for (std::size_t i = 0; i < now.bodies.size(); ++i)
        if (!known.contains(now.bodies[i].name))
            all.push_back({editing::Kind::body, i});
    return all;
}

} // namespace

Creating::Creating(SceneDocument& document, SceneDisplay& display)
    : document_(document), display_(display), later_(document), indicating_(document, display) {
    // A thing that was clicked on may be gone, or another one.
    connect(&document_, &SceneDocument::textChanged, this, [this] {
        forgetMeasured();
        if (!active())
            return;
        cancel();
        Q_EMIT refused(tr("The text was changed meanwhile."));
    });
    connect(&display_, &SceneDisplay::pictured, this, &Creating::stopWaiting);
    connect(&display_, &SceneDisplay::pictured, this, &Creating::takeInputs);
}

void Creating::start(Recipe recipe) {
    start([recipe = std::move(recipe)] { return recipe; });
}

void Creating::start(std::function<Recipe()> recipe, std::optional<Aim> aim) {
    if (begun_ && !inputs_.empty()) { // a click comes first whose picture is not there
        inputs_.emplace_back(Command{std::move(recipe), std::move(aim)});
        return;
    }
    cancel();
    forgetMeasured();
    display_.editing().say({}); // it was about what was done before
    waiting_.emplace(Waiting{std::move(recipe), std::move(aim), {}});
    later_.take(this, [this] { stopWaiting(); });
    if (!waiting_)
        return;
    display_.setFocus();
    Q_EMIT changed();
}

// Keys act on what is seen.
void Creating::stopWaiting() {
    if (!waiting_ || document_.isAwaited())
        return;
    if (!document_.sceneIsCurrent()) {
        cancel();
        Q_EMIT refused(document_.whyNotCurrent());
        return;
    }
    if (!waiting_->keys.empty()) {
        display_.bringUpToDate();
        if (!display_.showsScene())
            return;
    }
    const Waiting waited = *std::exchange(waiting_, std::nullopt);
    begin(waited.recipe());
    if (waited.aim && begun_)
        takeAim(*waited.aim);
    for (const std::unique_ptr<QKeyEvent>& typed : waited.keys)
        if (!key(*typed))
            handBack(*typed);
}

void Creating::takeInputs() {
    std::vector<Input> all = std::exchange(inputs_, {});
    for (auto one = all.begin(); one != all.end(); ++one) {
        if (begun_ && !display_.showsScene()) {
            inputs_.assign(std::move_iterator(one), std::move_iterator(all.end()));
            return;
        }
        if (const auto* typed = std::get_if<std::unique_ptr<QKeyEvent>>(&*one)) {
            if (!key(**typed))
                handBack(**typed);
        } else if (auto* command = std::get_if<Command>(&*one)) {
            start(std::move(command->recipe), std::move(command->aim));
        } else if (begun_) {
            const Click& click = std::get<Click>(*one);
            fault_.clear();
            if (const auto found = indicated(click.position, click.holdsOff))
                take(*found);
            Q_EMIT changed();
        } else if (waiting_) {
            refuseEarlyClick();
        }
    }
}

std::optional<Indicated> Creating::indicated(const QPointF& position, bool holdsOff) {
    auto found = indicating_.at(*begun_, position, holdsOff);
    if (const auto* fault = std::get_if<QString>(&found)) {
        fault_ = *fault;
        return std::nullopt;
    }
    return std::get<Indicated>(std::move(found));
}

Creating::Aim Creating::aimAt(const editing::Element& body, const QPointF& position) const {
    const render::Drawing drawing = display_.drawing();
    Aim aim{following(document_, {body}), std::nullopt};
    const auto picked = gestures::bodyAt(drawing, display_.sight(), display_.inPixels(position));
    if (picked && picked->body == body.index)
        aim.place = render::poseOf(*drawing.scene, drawing.motion.get(), body.index, drawing.time)
                        .toLocal(picked->point);
    return aim;
}

void Creating::takeAim(const Aim& aim) {
    const auto body = aim.body();
    if (!body) {
        cancel();
        Q_EMIT refused(tr("The body is gone."));
        return;
    }
    const std::size_t index = body->front().index;
    const render::Drawing drawing = display_.drawing();
    take(aim.place ? indicating_.onSurface(
                         begun_->step(), index,
                         render::poseOf(*drawing.scene, drawing.motion.get(), index, drawing.time)
                             .toWorld(*aim.place))
                   : indicating_.centerOf(index));
    Q_EMIT changed();
}

void Creating::begin(Recipe recipe) {
    fault_.clear();
    begun_.emplace(std::move(recipe));
    if (!begun_->hasSteps())
        return finish();
    begun_->offerBody(*document_.shown().scene, document_.selected());
    display_.keepCamera(); // what is clicked is where it stands
    display_.setFocus();
    for (const Step& one : begun_->recipe().steps)
        if (one.wanted == Wanted::trajectory)
            Q_EMIT needs(&render::Display::trajectories);
    Q_EMIT changed();
}

void Creating::cancel() {
    waiting_.reset();
    begun_.reset();
    next_.reset();
    fault_.clear();
    cross_.reset();
    inputs_.clear();
    typed_.clear();
    indicating_.forget();
    Q_EMIT changed();
}

void Creating::hover(const QPointF& position, bool holdsOff) {
    const QString fault = fault_;
    const auto isShown = [&](const Step& step) {
        return (step.wanted == Wanted::hold && !begun_->shown().empty()) || step.snaps ||
               step.judge;
    };
    const bool shows = begun_ && begun_->hasSteps() && isShown(begun_->step());
    if (shows)
        display_.bringUpToDate();
    if (typed_.isEmpty())
        next_ = shows && display_.showsScene() ? indicated(position, holdsOff) : std::nullopt;
    fault_ = fault;
    if (active())
        Q_EMIT changed();
}

std::optional<Judged> Creating::judge(const Indicated& next) const {
    return begun_->judge(*document_.shown().scene, next);
}

void Creating::refuseEarlyClick() {
    fault_ = tr("The click came before the scene.");
    Q_EMIT changed();
}

void Creating::click(const QPointF& position, bool holdsOff) {
    display_.bringUpToDate();
    if (waiting_) { // what will stand there is not seen yet
        refuseEarlyClick();
        return;
    }
    inputs_.emplace_back(Click{position, holdsOff});
    takeInputs();
}

void Creating::take(const Indicated& found) {
    if (const auto judged = judge(found); judged && !judged->isTaken) {
        fault_ = judged->words;
        return;
    }
    next_.reset();
    typed_.clear();
    if (begun_->take(found))
        finish();
}

void Creating::otherwise() {
    fault_.clear();
    if (!typed_.isEmpty()) {
        if (const auto place = indicating_.typed(*begun_, typed_)) {
            take(*place);
        } else {
            fault_ = tr("\"%1\" is no place: numbers for x, y and z are.").arg(typed_);
        }
        Q_EMIT changed();
        return;
    }
    const Step& step = begun_->step();
    if (step.repeats)
        return finish();
    if (step.offered) {
        take(indicating_.centerOf(*step.offered));
    } else if (!step.otherwise.isEmpty()) {
        take(indicating_.atOrigin(*begun_));
    } else {
        fault_ = tr("Click, or go there with the arrow keys.");
    }
    Q_EMIT changed();
}

void Creating::finish() {
    const Recipe recipe = begun_->recipe();
    const std::vector<Indicated>& shown = begun_->shown();
    const auto before = document_.shown().scene;
    const scene::Scene& scene = *before;
    auto made = recipe.make(document_.text(), scene, shown);
    const auto moved = recipe.moves ? recipe.moves(scene, shown) : std::vector<editing::Wish>();
    const QString answer = recipe.tells ? recipe.tells(shown) : QString();
    if (!answer.isEmpty())
        measured_ = {shown.front().point, shown.back().point, answer};
    cancel();
    if (!answer.isEmpty())
        Q_EMIT told(answer);
    const editing::Answer changes = answerTo(moved);
    if (!changes.possible()) {
        Q_EMIT refused(QString::fromStdString(changes.reason));
        return;
    }
    if (made.empty() && changes.edits.empty()) {
        if (!recipe.otherwise.isEmpty())
            Q_EMIT refused(recipe.otherwise);
        return;
    }
    const auto marked =
        recipe.keepsSelection ? std::nullopt : std::optional(markedOf(scene, made, moved));
    addWeightAsOthersHaveIt(made, scene);
    text::Edits edits = editing::created(document_.text(), scene, made);
    edits.insert(edits.end(), changes.edits.begin(), changes.edits.end());
    text::putInOrder(edits);
    // LIMIT: a new element that is not the last of its kind is not the one that is marked.
    Q_EMIT created(marked, recipe.handles);
    document_.setText(text::applied(document_.text(), edits), recipe.label);
    if (std::ranges::any_of(made, isBody))
        connect(
            &document_, &SceneDocument::sceneChanged, this,
            [this, before, revision = document_.revision()] {
                if (document_.revision() == revision)
                    display_.showWhole(newBodies(*before, *document_.shown().scene));
            },
            Qt::SingleShotConnection);
}

// The edit of the text that changes bodies which are there already.
editing::Answer Creating::answerTo(const std::vector<editing::Wish>& wishes) const {
    return wishes.empty()
               ? editing::Answer()
               : editing::Mapper(document_.text(), document_.shown().scene).answer(wishes);
}

bool Creating::forgetMeasured() {
    const bool was = measured_.has_value();
    measured_.reset();
    if (was)
        Q_EMIT changed();
    return was;
}

QString Creating::prompt() const {
    if (waiting_)
        return fault_ + (fault_.isEmpty() ? "" : " ") +
               tr("A moment: the text is being read. Keys that are typed now count then.");
    if (!begun_ || !begun_->hasSteps())
        return {};
    const QString& label = begun_->recipe().label;
    const Step& step = begun_->step();
    QString text = tr("%1: %2").arg(label, step.prompt);
    if (!step.otherwise.isEmpty())
        text += " " + step.otherwise;
    if (!typed_.isEmpty())
        text = tr("%1: x y z = %2_  Return takes it.").arg(label, typed_);
    return fault_.isEmpty() ? text : fault_ + " " + text;
}

} // namespace views
