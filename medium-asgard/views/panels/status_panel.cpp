#include "panels/status_panel.h"

#include "commands/closing.h"
#include "faults/close_joints.h"
#include "handles/handles.h"
#include "motion/known_span.h"
#include "plain/plain.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace views {

QString timeText(double time, double length) {
    // A thousandth of the motion is worth a digit, and never less than a millisecond of a second.
    const int digits =
        length > 0 ? std::clamp(static_cast<int>(3 - std::floor(std::log10(length))), 0, 9) : 3;
    return QString::number(time, 'f', digits) + QStringLiteral(" s");
}

namespace {

QLabel* addRow(QFormLayout* form, const QString& label, const QString& tip) {
    auto* value = plain::label();
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setToolTip(plain::tip(tip));
    value->setAccessibleName(label);
    auto* before = plain::label(label);
    before->setForegroundRole(QPalette::PlaceholderText);
    before->setToolTip(plain::tip(tip));
    form->addRow(before, value);
    return value;
}

// The handle as it looks in the picture.
QIcon iconOf(render::HandleKind kind) {
    const scene::Color color = render::colorOf(kind);
    QPixmap pixmap(28, 28);
    pixmap.setDevicePixelRatio(2);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor c = QColor::fromRgbF(color.red, color.green, color.blue);
    const bool isTarget = render::isTarget(kind);
    painter.setPen(isTarget ? QPen(c, 1.8) : QPen(c.darker(150)));
    painter.setBrush(isTarget ? QBrush() : QBrush(c));
    painter.drawEllipse(QRectF(2, 2, 10, 10));
    if (isTarget) {
        painter.setBrush(c);
        painter.drawEllipse(QRectF(6.3, 6.3, 1.4, 1.4));
    }
    return pixmap;
}

} // namespace

StatusPanel::StatusPanel(SceneDocument& document, Playback& playback,
                         const render::Display& display, QWidget* parent)
    : QWidget(parent), document_(document), playback_(playback), display_(display) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 2, 6, 4);
    column->setSpacing(8);
    auto* status = new QGroupBox(tr("Motion"));
    auto* form = new QFormLayout(status);
    form->setContentsMargins(10, 6, 10, 8);
    form->setVerticalSpacing(4);
    time_ = addRow(form, tr("Time"), tr("The moment that is shown"));
    computed_ = addRow(form, tr("Computed"), tr("How far the motion is computed"));
    accuracy_ = addRow(form, tr("Error"),
                       tr("The largest error in position that the computation estimates, over the "
                          "size of the scene"));
    predictable_ =
        addRow(form, tr("Reliable"),
               tr("How far the motion is one that can be foretold: beyond that moment the smallest "
                  "disturbance changes it wholly, or a body has stopped"));
    impacts_ = addRow(form, tr("Collisions"), tr("How many so far"));
    state_ = plain::label();
    state_->setWordWrap(true);
    state_->setMinimumHeight(2 * state_->fontMetrics().height()); // what is below stays
    state_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    state_->setAccessibleName(tr("State"));
    form->addRow(state_);
    auto* close = new CloseJoints(document_, this);
    form->addRow(close);
    column->addWidget(status);
    addSwitches(display);
    column->addStretch();
    setMinimumWidth(190);
    connect(&playback_, &Playback::timeChanged, this, &StatusPanel::showTime);
    connect(&playback_, &Playback::stateChanged, this, &StatusPanel::showMotion);
    connect(&document_, &SceneDocument::motionChanged, this, &StatusPanel::showMotion);
    connect(&document_, &SceneDocument::workChanged, this, &StatusPanel::showMotion);
    connect(&document_, &SceneDocument::diagnosticsChanged, this, &StatusPanel::showMotion);
    showMotion();
}

void StatusPanel::addSwitches(const render::Display& display) {
    auto* group = new QGroupBox(tr("Show"));
    auto* grid = new QGridLayout(group); // two beside each other
    grid->setContentsMargins(10, 6, 10, 8);
    grid->setVerticalSpacing(3);
    QVBoxLayout* column = nullptr;
    bool areHandles = false;
    const auto add = [&](const char* name, const QString& label, const QString& tip,
                         bool render::Display::*what) {
        auto* box = new QCheckBox(plain::ours(label));
        box->setObjectName(name);
        box->setToolTip(plain::tip(tip));
        box->setChecked(display.*what);
        box->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the picture
        const int place = static_cast<int>(switches_.size());
        if (column)
            column->addWidget(box);
        else
            grid->addWidget(box, place / 2, place % 2);
        switches_.push_back({box, what, areHandles, box->isChecked(), box->isChecked()});
        connect(box, &QCheckBox::toggled, this, [this, place, what](bool on) {
            display_.*what = on;
            if (!isCommanded_)
                switches_[static_cast<std::size_t>(place)].isChosen = on;
            Q_EMIT displayChanged(display_);
        });
    };
    using render::Display;
    add("trails", tr("&Trails"), tr("The paths of the centres of mass up to now"),
        &Display::trails);
    add("joints", tr("Joints"), tr("Hinges, sliders and the like, with their range"),
        &Display::joints);
    add("grid", tr("&Grid"), tr("On the ground, at round coordinates of the world"),
        &Display::grid);
    add("shadows", tr("S&hadows"),
        tr("Bodies shade the ground and each other; while a large scene moves they are left out"),
        &Display::shadows);
    add("axes", tr("&Axes"), tr("The world's axes: x red, y green, z blue"), &Display::axes);
    add("wireframe", tr("&Wireframe"), tr("Edges only"), &Display::wireframe);
    add("contactForces", tr("Contact Forces"),
        tr("The forces with which bodies press on each other"), &Display::contactForces);
    add("frictionCones", tr("Friction Cones"),
        tr("Friction cones: while the force is inside, the contact sticks"),
        &Display::frictionCones);
    layout()->addWidget(group);
    group = new QGroupBox(tr("Handles"));
    areHandles = true;
    group->setToolTip(tr("Discs that are dragged with Shift and the left button; a double click "
                         "asks for the exact value"));
    column = new QVBoxLayout(group);
    column->setContentsMargins(10, 6, 10, 8);
    column->setSpacing(2);
    using render::HandleKind;
    const struct {
        const char* name;
        QString label, tip;
        bool Display::*what;
        HandleKind kind;
    } kinds[] = {
        {"positionHandles", tr("&Positions"), tr("Where bodies start"), &Display::positionHandles,
         HandleKind::position},
        {"orientationHandles", tr("Ori&entations"), tr("How bodies are turned at the start"),
         &Display::orientationHandles, HandleKind::orientation},
        {"velocityHandles", tr("Ve&locities"), tr("Velocities at the start"),
         &Display::velocityHandles, HandleKind::velocity},
        {"spinHandles", tr("Angular velocities"),
         tr("Turning at the start: about the arrow, by the right hand"), &Display::spinHandles,
         HandleKind::spin},
        {"forceHandles", tr("F&orces"), tr("As they are now"), &Display::forceHandles,
         HandleKind::forceHead},
        {"torqueHandles", tr("Tor&ques"), tr("About the arrow, by the right hand"),
         &Display::torqueHandles, HandleKind::torqueHead},
        {"linkHandles", tr("Lin&ks"), tr("Their two ends, and how long ropes are"),
         &Display::linkHandles, HandleKind::linkEnd},
        {"jointHandles", tr("Joints"), tr("Their points and axes"), &Display::jointHandles,
         HandleKind::jointPoint},
        {"lightHandles", tr("L&ights"), tr("Where they stand and shine"), &Display::lightHandles,
         HandleKind::lightPlace},
        {"trajectories", tr("Tra&jectories"), tr("Their paths and points"), &Display::trajectories,
         HandleKind::trajectoryPoint},
    };
    for (const auto& kind : kinds) {
        add(kind.name, kind.label, kind.tip, kind.what);
        switches_.back().box->setIcon(iconOf(kind.kind));
    }
    layout()->addWidget(group);
}

void StatusPanel::show(bool render::Display::*what) {
    isCommanded_ = true;
    for (const Switch& one : switches_)
        if (one.what == what)
            one.box->setChecked(true);
    isCommanded_ = false;
}

QStringList StatusPanel::unusual(bool (*isOn)(const Switch& one)) const {
    QStringList names;
    for (const Switch& one : switches_)
        if (isOn(one) != one.isUsual)
            names << (isOn(one) ? '+' : '-') + one.box->objectName();
    return names;
}

QStringList StatusPanel::shown() const {
    return unusual([](const Switch& one) { return one.box->isChecked(); });
}

QStringList StatusPanel::chosen() const {
    return unusual([](const Switch& one) { return one.isChosen; });
}

void StatusPanel::setShown(const QStringList& names) {
    for (const Switch& one : switches_) {
        const QString& name = one.box->objectName();
        one.box->setChecked(names.contains('+' + name) ||
                            (one.isUsual && !names.contains('-' + name)));
    }
}

void StatusPanel::showTime() {
    time_->setText(timeText(playback_.time(), playback_.finish() - playback_.start()));
    std::size_t count = 0;
    if (const auto& motion = document_.shown().motion)
        for (const simulation::Impact& impact : motion->impacts())
            count += impact.time <= playback_.time() ? 1 : 0;
    impacts_->setText(QString::number(count));
}

void StatusPanel::showMotion() {
    showTime();
    const auto& motion = document_.shown().motion;
    const double finish = motion ? motion->finish() : playback_.finish();
    const double length = finish - playback_.start();
    const simulation::KnownSpan known = motion ? simulation::knownSpan(*motion)
                                               : simulation::KnownSpan{playback_.computed(), {}, 0};
    const bool whole = known.stopped == 0 && known.computed >= finish;
    computed_->setText(whole ? tr("all %1").arg(timeText(length, length))
                             : tr("to %1").arg(timeText(known.computed, length)));
    computed_->setToolTip(plain::tip(
        known.stopped > 0 ? tr("Bodies that stop before the end: %1. The first of them stops "
                               "there; the text says why")
                                .arg(known.stopped)
                          : tr("How far the motion is computed")));
    const auto error = motion ? motion->errorEstimate() : std::nullopt;
    accuracy_->setText(error ? QStringLiteral("≤ ") + QString::number(*error, 'g', 2)
                             : QStringLiteral("–"));
    predictable_->setText(!motion ? QStringLiteral("–")
                          : known.reliableUntil
                              ? tr("to %1").arg(timeText(*known.reliableUntil, length))
                              : tr("throughout"));
    if (document_.work() == Work::reading)
        state_->setText(tr("Reading the scene…"));
    else if (document_.work() == Work::simulating)
        state_->setText(document_.motionIsStale()
                            ? tr("Computing the motion… what is shown is stale.")
                            : tr("Computing the motion…"));
    else if (document_.hasErrors())
        state_->setText(document_.sceneIsCurrent() &&
                                commands::misplacedIn(document_.diagnostics()).openJoints > 0
                            ? tr("The bodies of a joint do not meet at the start.")
                        : document_.sceneIsCurrent()
                            ? tr("The motion has faults: see the text.")
                            : tr("The text has errors. This is the last good scene."));
    else if (document_.waitsToBeAsked())
        state_->setText(tr("The motion is stale: it is that of an older scene. F5 computes it."));
    else if (document_.computingWasStopped())
        state_->setText(tr("Computing was stopped. F5 computes it again."));
    else
        state_->setText({});
}

} // namespace views
