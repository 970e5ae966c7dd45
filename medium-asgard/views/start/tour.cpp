#include "start/tour.h"

#include "plain/plain.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace views {

namespace {

struct Step {
    QString title, what;
};

const std::array<Step, Tour::steps>& tourSteps() {
    static const std::array<Step, Tour::steps> all{{
        {Tour::tr("A rod"),
         Tour::tr(
             "Choose Create > Body > New from the Library > Rod, and click into the middle of "
             "the picture.\n\nA banner at the top of the picture says what a click does. The text "
             "at the left has a new line: it is the same rod.")},
        {Tour::tr("Hang it up"),
         Tour::tr(
             "Choose Create > Joint > Hinge. Click the rod near its left end, then click the "
             "same place again: where there is no second body, the hinge holds to the ground.")},
        {Tour::tr("A second rod"),
         Tour::tr(
             "Choose Create > Body > rod1, and click right of the first rod, so that their ends "
             "meet. Then choose Create > Joint > Hinge, click the second rod, and click the "
             "place on the first where the two meet.")},
        {Tour::tr("Weight"),
         Tour::tr("Choose Create > Force > Gravity for All Bodies. Both rods get their weight, "
                  "9.81 m/s² downwards.")},
        {Tour::tr("Let it swing"),
         Tour::tr("Press Space, or the button with the triangle. Escape goes back to the start; "
                  "while something is selected, press it twice: the first deselects it.")},
    }};
    return all;
}

bool moves(const scene::Body& body) { return !body.fixed; }

// A joint that holds a body to the ground, or to another.
bool holds(const scene::Scene& scene, bool toGround) {
    return std::ranges::any_of(scene.joints, [&](const scene::Joint& joint) {
        return joint.body2.has_value() != toGround;
    });
}

bool isHeld(const scene::Scene& scene, const scene::Body& body) {
    return std::ranges::any_of(scene.joints, [&](const scene::Joint& joint) {
        return joint.body1 == body.name || joint.body2 == body.name;
    });
}

bool hasWeight(const scene::Scene& scene, const scene::Body& body) {
    return std::ranges::any_of(scene.forces, [&](const scene::Force& force) {
        return force.body == body.name && !force.couple &&
               std::holds_alternative<scene::GravitationalForce>(force.kind);
    });
}

} // namespace

int stepsDone(const scene::Scene& scene) {
    const auto rods = std::ranges::count_if(scene.bodies, moves);
    if (rods < 1)
        return 0;
    if (!holds(scene, true))
        return 1;
    if (rods < 2 || !holds(scene, false))
        return 2;
    // A body that is pasted later, without a weight, undoes no step.
    const bool heavy = std::ranges::all_of(scene.bodies, [&](const scene::Body& body) {
        return !moves(body) || !isHeld(scene, body) || hasWeight(scene, body);
    });
    return heavy ? 4 : 3;
}

QString whyNotDone(const scene::Scene& scene) {
    const int done = stepsDone(scene);
    const auto name = [](const std::string& text) { return QString::fromStdString(text); };
    if (done == 1 && !scene.joints.empty())
        return Tour::tr("%1 holds two bodies, and nothing holds them to the ground. Undo it "
                        "(Ctrl+Z), and click the rod twice in the same place.")
            .arg(name(scene.joints.back().name));
    if (done != 2 || scene.joints.size() < 2)
        return {};
    const scene::Joint &first = scene.joints.front(), &last = scene.joints.back();
    if (last.body1 == first.body1)
        return Tour::tr("%1 holds %2 to the ground, which %3 does already. Undo it (Ctrl+Z); its "
                        "first click belongs on the second rod.")
            .arg(name(last.name), name(last.body1), name(first.name));
    return Tour::tr("%1 holds %2 to the ground. Undo it (Ctrl+Z); its second click belongs on %3, "
                    "not beside it.")
        .arg(name(last.name), name(last.body1), name(first.body1));
}

Tour::Tour(SceneDocument& document, QWidget* parent) : QWidget(parent), document_(document) {
    setObjectName("tour");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 10);
    column->setSpacing(6);
    for (int i = 0; i < steps; ++i) {
        lines_.push_back(plain::label());
        column->addWidget(lines_.back());
    }
    auto* line = new QFrame;
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Sunken);
    column->addWidget(line);
    what_ = plain::label();
    what_->setObjectName("tourStep");
    what_->setAccessibleName(tr("The next step"));
    what_->setWordWrap(true);
    what_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    column->addWidget(what_, 1);
    end_ = new QPushButton;
    end_->setObjectName("endTour");
    connect(end_, &QPushButton::clicked, this, &Tour::ended);
    column->addWidget(end_);
    setMinimumSize(250, 330); // of the longest step
    for (const auto signal :
         {&SceneDocument::sceneChanged, &SceneDocument::motionChanged, &SceneDocument::workChanged})
        connect(&document_, signal, this, &Tour::look);
    connect(&document_, &SceneDocument::opened, this, &Tour::ended);
    look();
}

void Tour::played() {
    played_ = true;
    look();
}

// A step that was undone is to be done again.
void Tour::look() {
    done_ = stepsDone(*document_.shown().scene);
    if (done_ < steps - 1)
        played_ = isBuilt_ = false;
    else if (played_)
        done_ = steps;
    showSteps();
    const bool isKnown = document_.work() == Work::none && !document_.motionIsStale();
    if (done_ >= steps - 1 && isKnown && isVisible() && !std::exchange(isBuilt_, true))
        Q_EMIT built();
}

void Tour::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    look();
}

void Tour::showSteps() {
    for (int i = 0; i < steps; ++i) {
        QLabel* line = lines_[i];
        const QString mark = i < done_ ? QStringLiteral("✓") : QString::number(i + 1);
        line->setText(
            QStringLiteral("%1  %2").arg(mark, tourSteps()[static_cast<std::size_t>(i)].title));
        QFont font = line->font();
        font.setBold(i == done_);
        line->setFont(font);
        line->setForegroundRole(i == done_ ? QPalette::WindowText : QPalette::PlaceholderText);
    }
    const QString fault = whyNotDone(*document_.shown().scene);
    what_->setText(
        done_ < steps ? fault + (fault.isEmpty() ? "" : "\n\n") +
                            tourSteps()[static_cast<std::size_t>(done_)].what
                      : tr("It swings: the double pendulum of the dissertation. F frames the whole "
                           "motion.\n\nGo on: click on a rod and drag it, at the start or while it "
                           "swings, and look at its numbers in the text. F1 tells about the thing "
                           "under the pointer."));
    end_->setText(done_ < steps ? tr("&End the Tour") : tr("&Finish"));
}

} // namespace views
