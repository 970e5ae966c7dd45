#include "panels/motion_notice.h"

#include "faults/close_joints.h"
#include "gestures/unsupported.h"
#include "motion/known_span.h"
#include "panels/status_panel.h"
#include "plain/plain.h"
#include "surroundings/triad.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

namespace {

// What is quick is not worth a word: it would flicker while one drags.
constexpr int untilProgress = 1000, untilStale = 250; // ms

// Of the bodies, the first that stops before the end.
std::optional<simulation::Stop> firstStop(const simulation::Motion& motion) {
    std::optional<simulation::Stop> first;
    for (std::size_t body = 0; body < motion.bodies(); ++body)
        if (auto stop = motion.stop(body); stop && (!first || stop->time < first->time))
            first = std::move(stop);
    return first;
}

void follow(QElapsedTimer& since, bool is) {
    if (is && !since.isValid())
        since.start();
    else if (!is)
        since.invalidate();
}

bool lasts(const QElapsedTimer& since, int milliseconds) {
    return since.isValid() && since.hasExpired(milliseconds);
}

} // namespace

MotionNotice::MotionNotice(SceneDocument& document, Playback& playback, QWidget& picture)
    : QFrame(&picture), document_(document), playback_(playback), words_(plain::label()) {
    setObjectName("motionNotice");
    setAutoFillBackground(true);
    words_->setWordWrap(true);
    words_->setAccessibleName(tr("State of the motion"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    row->addWidget(words_, 1);
    makeButton(Offer::stop, "stopComputing", tr("Stop"),
               tr("Ends computing, and keeps the motion that there is (Escape)"));
    makeButton(Offer::compute, "compute", tr("Compute"),
               tr("Computes the motion of the scene as it is (F5)"));
    makeButton(Offer::floor, "addFloor", tr("Add a Floor"),
               tr("A fixed plane below all bodies, as Create > Body > New Floor Below All"));
    makeButton(Offer::gravity, "addGravity", tr("Add Gravity"),
               tr("A weight for each body, also for those that come later, as Create > Force > "
                  "Gravity for All Bodies"));
    makeButton(Offer::undo, "undoNewStart", tr("Undo"),
               tr("The motion begins again where it did before (Ctrl+Z)"));
    auto* part = new CloseJoints(document_, this);
    part->setObjectName("moveApart");
    part->setFocusPolicy(Qt::NoFocus);
    layout()->addWidget(part);
    buttons_.push_back({Offer::part, part});
    tick_.setInterval(250);
    connect(&tick_, &QTimer::timeout, this, &MotionNotice::follow);
    connect(&document_, &SceneDocument::textChanged, this, [this] { worksSince_.invalidate(); });
    connect(&document_, &SceneDocument::workChanged, this, &MotionNotice::follow);
    connect(&document_, &SceneDocument::sceneChanged, this, &MotionNotice::follow);
    connect(&document_, &SceneDocument::motionChanged, this, &MotionNotice::follow);
    connect(&document_, &SceneDocument::diagnosticsChanged, this, &MotionNotice::follow);
    connect(&playback_, &Playback::timeChanged, this, &MotionNotice::follow);
    connect(&playback_, &Playback::stateChanged, this, &MotionNotice::follow);
    picture.installEventFilter(this);
    hide();
    follow();
}

void MotionNotice::makeButton(Offer offer, const QString& name, const QString& words,
                              const QString& tip) {
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setText(plain::ours(words));
    button->setToolTip(plain::tip(tip));
    button->setFocusPolicy(Qt::NoFocus); // the keys stay with the picture
    connect(button, &QToolButton::clicked, this, [this, offer] { take(offer); });
    layout()->addWidget(button);
    buttons_.push_back({offer, button});
}

QAbstractButton* MotionNotice::buttonOf(Offer offer) const {
    const auto found = std::ranges::find(buttons_, offer, &Button::offer);
    return found == buttons_.end() ? nullptr : found->widget;
}

void MotionNotice::take(Offer offer) {
    switch (offer) {
    case Offer::stop:
        return Q_EMIT stopWanted();
    case Offer::compute:
        return document_.recompute();
    case Offer::floor:
        return Q_EMIT floorWanted();
    case Offer::gravity:
        return Q_EMIT gravityWanted();
    case Offer::undo:
        return document_.undo();
    case Offer::part: // the button does it
    case Offer::none:
        return;
    }
}

QString MotionNotice::words() const { return isHidden() ? QString() : words_->text(); }

QString MotionNotice::progress() const {
    const auto seconds = worksSince_.elapsed() / 1000;
    const Shown& shown = document_.shown();
    if (document_.work() == Work::reading || !shown.motion)
        return document_.work() == Work::reading
                   ? tr("Reading the text, %1 s so far.").arg(seconds)
                   : tr("Computing the motion, %1 s so far.").arg(seconds);
    if (document_.motionIsStale())
        return tr("Computing the motion, %1 s so far; what is shown is stale, an older scene's.")
            .arg(seconds);
    const double length = shown.motion->finish() - shown.motion->start();
    const double known = simulation::knownSpan(*shown.motion).computed;
    if (known >= shown.motion->finish())
        return tr("All %1 can be played. Checking how exact the motion is, %2 s so far.")
            .arg(timeText(length, length))
            .arg(seconds);
    return tr("Computing: at t = %1 of %2, %3 s so far.")
        .arg(timeText(known, length), timeText(shown.motion->finish(), length))
        .arg(seconds);
}

// The text has errors.
QString MotionNotice::unread() const {
    const auto& faults = document_.diagnostics();
    const auto error =
        std::ranges::find(faults, scene::Severity::error, &scene::Diagnostic::severity);
    const QString words = QString::fromStdString(error->message);
    const QString place =
        error->line > 0 ? tr("Line %1 of the text: %2").arg(error->line).arg(words) : words;
    return document_.shown().scene->bodies.empty()
               ? place
               : tr("%1\nThe picture shows the last good scene. Mend the text there, or take back "
                    "what "
                    "was changed (Ctrl+Z).")
                     .arg(place);
}

MotionNotice::Said MotionNotice::said() {
    Said said = saidOfMotion();
    if (said.words.isEmpty())
        said = saidOfStart();
    if (said.words.isEmpty())
        said = saidOfNewStart();
    return said.words.isEmpty() ? saidOfForces() : said;
}

void MotionNotice::tellNewStart() {
    newStart_ = document_.revision();
    follow();
}

MotionNotice::Said MotionNotice::saidOfNewStart() const {
    if (newStart_ != document_.revision() || !document_.sceneIsCurrent())
        return {};
    return {tr("The motion begins at %1 s now, where you let go.")
                .arg(document_.shown().scene->simulator.start),
            false, Offer::undo};
}

// Bodies begin where they cannot be.
MotionNotice::Said MotionNotice::saidOfStart() const {
    if (!document_.sceneIsCurrent())
        return {};
    const auto misplaced = commands::misplacedIn(document_.diagnostics());
    if (misplaced.openJoints > 0)
        return {
            misplaced.openJoints == 1
                ? tr("The bodies of a joint do not meet at the start.")
                : tr("The bodies of %1 joints do not meet at the start.").arg(misplaced.openJoints),
            true, Offer::part};
    if (misplaced.overlaps > 0)
        return {tr("Bodies overlap at the start."), false, Offer::part};
    return {};
}

// Nothing falls of itself, or the grid holds nothing.
MotionNotice::Said MotionNotice::saidOfForces() {
    if (!document_.sceneIsCurrent())
        return {};
    const auto& [scene, motion] = document_.shown();
    if (gestures::nothingMoves(*scene))
        return {tr("Nothing moves: no force acts."), false, Offer::gravity};
    if (falls_.of.scene != scene || falls_.of.motion != motion)
        falls_ = {document_.shown(), gestures::lacksWeight(*scene),
                  gestures::unsupported(*scene, motion.get())};
    if (falls_.lacksWeight)
        return {tr("Bodies move straight on: no force acts."), false, Offer::gravity};
    const auto& bodies = falls_.bodies;
    if (bodies.empty())
        return {};
    const QString first = QString::fromStdString(scene->bodies[bodies.front()].name);
    const QString who = bodies.size() == 1
                            ? tr("%1 falls").arg(first)
                            : tr("%1 and %2 more fall").arg(first).arg(bodies.size() - 1);
    return {tr("The grid holds nothing: %1 through it.").arg(who), false, Offer::floor};
}

MotionNotice::Said MotionNotice::saidOfMotion() const {
    const bool works = document_.work() != Work::none;
    const auto& motion = document_.shown().motion;
    if (!works && !document_.sceneIsCurrent() && document_.hasErrors())
        return {unread(), true};
    if (works && lasts(worksSince_, untilProgress))
        return {progress(), false, Offer::stop};
    if (motion && lasts(staleSince_, untilStale))
        return works ? Said{tr("Stale motion: computing…")}
                     : Said{tr("Stale motion: Play or F5 computes that of the scene as it is."),
                            false, Offer::compute};
    if (works)
        return {};
    if (document_.computingWasStopped())
        return {tr("Computing was stopped at t = %1. Play or F5 computes it again.")
                    .arg(timeText(playback_.computed(), playback_.finish() - playback_.start())),
                false, Offer::compute};
    if (!motion || playback_.time() < playback_.finish())
        return {};
    if (const auto stop = firstStop(*motion))
        return {QString::fromStdString(stop->sentence), true};
    const auto& faults = document_.diagnostics();
    const auto error =
        std::ranges::find(faults, scene::Severity::error, &scene::Diagnostic::severity);
    if (motion->computed() < motion->finish() && error != faults.end())
        return {QString::fromStdString(error->message), true};
    return {};
}

void MotionNotice::follow() {
    const bool works = document_.work() != Work::none;
    views::follow(worksSince_, works);
    views::follow(staleSince_, document_.motionIsStale());
    if (works || document_.motionIsStale())
        tick_.start();
    else
        tick_.stop();
    show(said());
}

void MotionNotice::show(const Said& said) {
    setVisible(!said.words.isEmpty());
    for (const Button& button : buttons_)
        button.widget->setVisible(button.offer == said.offer);
    if (said == std::exchange(shown_, said) || said.words.isEmpty())
        return;
    const bool dark = parentWidget()->palette().color(QPalette::Base).lightness() < 128;
    QColor paper = said.isFault ? QColor(255, 222, 216) : QColor(255, 236, 190);
    QColor ink = said.isFault ? QColor(130, 20, 10) : QColor(90, 60, 0);
    if (dark) {
        paper = said.isFault ? QColor(92, 34, 28) : QColor(84, 66, 22);
        ink = said.isFault ? QColor(255, 214, 206) : QColor(255, 236, 190);
    }
    QPalette colors = palette();
    colors.setColor(QPalette::Window, paper);
    colors.setColor(QPalette::WindowText, ink);
    setPalette(colors);
    words_->setText(said.words);
    place();
}

// Beside the triad, which has the lower left corner, or above it in a narrow picture.
void MotionNotice::place() {
    constexpr int margin = 12;
    const QWidget& picture = *parentWidget();
    const double scale = picture.devicePixelRatioF();
    const render::Size size{static_cast<int>(picture.width() * scale),
                            static_cast<int>(picture.height() * scale), scale};
    const int triad = static_cast<int>(
        std::ceil((render::triadMiddle(size).x() + render::triadReach(size)) / scale));
    const bool isWide = picture.width() > 4 * triad;
    const int left = isWide ? triad + margin : margin;
    const int below = isWide ? margin : triad + margin;
    const int most = std::max(picture.width() - left - margin, 1);
    const QMargins around = layout()->contentsMargins();
    int beside = around.left() + around.right() + 4;
    if (const QAbstractButton* button = buttonOf(shown_.offer))
        beside += button->sizeHint().width() + layout()->spacing();
    const int line = words_->fontMetrics().horizontalAdvance(words_->text()) + beside;
    const int width = std::min(line, most);
    const int height =
        std::max(words_->heightForWidth(width - beside) + around.top() + around.bottom(),
                 layout()->minimumSize().height());
    setGeometry(left, std::max(picture.height() - height - below, 0), width, height);
}

// A button may get other words, and so another width.
bool MotionNotice::event(QEvent* event) {
    const bool isDone = QFrame::event(event);
    if (event->type() == QEvent::LayoutRequest && !isHidden())
        place();
    return isDone;
}

bool MotionNotice::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && !isHidden())
        place();
    return QFrame::eventFilter(watched, event);
}

} // namespace views
