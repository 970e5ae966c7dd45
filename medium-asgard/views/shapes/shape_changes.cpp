// What the gestures of a shape editor change of its shape.
#include "editing/number_text.h"
#include "element_edits/preview.h"
#include "plain/plain.h"
#include "point_edits/shape_points.h"

#include "shapes/shape_editor.h"
#include "shapes/shape_fields.h"

#include <QPushButton>

#include <algorithm>

namespace views {

using editing::DraftPart;
using geometry::Vector;

namespace {

QString flatness() { return ShapeEditor::tr("There the part would be flat."); }

std::vector<DraftPart> withoutInner(std::vector<DraftPart> draft,
                                    const std::function<bool(std::size_t)>& which) {
    for (std::size_t i = 0; i < draft.size(); ++i)
        if (which(i))
            draft[i].part = editing::withoutInnerPoints(draft[i].part);
    return draft;
}

bool sameParts(const std::vector<DraftPart>& a, const std::vector<DraftPart>& b) {
    return std::ranges::equal(a, b, {}, &DraftPart::part, &DraftPart::part);
}

} // namespace

bool ShapeEditor::begin() {
    if (gesture_)
        return true;
    const auto here = index();
    if (const QString fault = document_.whyNotCurrent(); !here || !fault.isEmpty()) {
        if (!fault.isEmpty())
            tell(fault, true);
        untilCurrent_ = !fault.isEmpty();
        return false;
    }
    gesture_ = std::make_unique<ShapeGesture>(document_, *here);
    return true;
}

std::optional<Asked> ShapeEditor::asked() const {
    return gesture_ ? std::optional(gesture_->asked()) : std::nullopt;
}

void ShapeEditor::preview() {
    if (!gesture_->show(draft_))
        tell(QString::fromStdString(gesture_->answer().reason), true);
    showDraft();
}

void ShapeEditor::finish(const QString& label) {
    if (!gesture_)
        return;
    const auto gesture = std::exchange(gesture_, nullptr);
    const editing::Answer& answer = gesture->answer();
    if (answer.possible() && !answer.edits.empty())
        shapes_.edited.insert(shape());
    gesture->finish(tr("%1 of %2").arg(label, shape()));
    if (!answer.possible() && document_.text() != gesture->text())
        tell(SceneDocument::overtaken(), true); // what it offers is of an older text
    else if (!answer.possible())
        offer(answer, label);
    if (document_.sceneIsCurrent())
        followScene(); // it may have come before the gesture ended
}

void ShapeEditor::cancel() {
    if (!gesture_)
        return;
    std::exchange(gesture_, nullptr)->cancel();
    if (document_.sceneIsCurrent())
        followScene();
}

// What cannot be changed as it stands says why, and what could be done instead.
void ShapeEditor::offer(const editing::Answer& answer, const QString& label) {
    tell(QString::fromStdString(answer.reason), true);
    if (answer.offers.empty())
        return;
    const editing::Offer one = answer.offers.front();
    const std::string text = document_.text();
    QString changed;
    for (const editing::LineChange& line : editing::changedLines(text, one.edits))
        changed +=
            tr("Line %1:\n%2\nbecomes\n%3\n")
                .arg(line.line)
                .arg(QString::fromStdString(line.before), QString::fromStdString(line.after));
    auto* box =
        new plain::Message(QMessageBox::Question, tr("Shape Editor"),
                           QString::fromStdString(answer.reason), QMessageBox::Cancel, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setSecondText(changed.trimmed());
    QAbstractButton* accept =
        box->addButton(plain::caption(QString::fromStdString(one.label)), QMessageBox::AcceptRole);
    connect(box, &QMessageBox::buttonClicked, this, [=, this](QAbstractButton* button) {
        if (button == accept && document_.text() == text)
            document_.setText(text::applied(text, one.edits), tr("%1 of %2").arg(label, shape()));
    });
    box->open();
}

bool ShapeEditor::change(const QString& label, const Change& how) {
    if (!begin())
        return false;
    how();
    preview();
    const bool possible = gesture_->answer().possible();
    finish(label);
    return possible;
}

void ShapeEditor::drag(const Vector& place) {
    const auto part = display_->chosenPart(), point = display_->chosenPoint();
    if (!part || !point || !begin())
        return;
    // A drag is from where it began: what it has passed leaves no trace.
    const scene::Part& before = gesture_->before()[*part].part;
    const double length = display_->grid() > 0 ? 0 : display_->pixelLength();
    scene::Part moved = tidied(before, editing::withPoint(before, *point, decimal(place, length)),
                               display_->grid() > 0 ? display_->grid() / 1000 : length);
    if (!editing::isSolid(moved))
        return tell(flatness(), true);
    draft_[*part].part = std::move(moved);
    preview();
}

void ShapeEditor::movePoint(const Vector& place) {
    const auto part = display_->chosenPart(), point = display_->chosenPoint();
    if (!part || !point)
        return;
    const scene::Part& before = draft_[*part].part;
    const scene::Part moved =
        tidied(before, editing::withPoint(before, *point, place), display_->pixelLength() / 1000);
    if (!editing::isSolid(moved)) {
        tell(flatness(), true);
        return showFields();
    }
    if (moved != before)
        change(tr("Move Vertex"), [&] { draft_[*part].part = moved; });
}

void ShapeEditor::resizePart(const std::vector<double>& sizes) {
    if (const auto part = display_->chosenPart())
        change(tr("Resize Part"),
               [&] { draft_[*part].part = editing::withSizes(draft_[*part].part, sizes); });
}

// By keys: the grid's step, or some pixels' worth, each one step of undo. Those of a vertex that
// come while the text is being read are made together when it has been.
void ShapeEditor::nudge(const Vector& direction) {
    const auto part = display_->chosenPart(), point = display_->chosenPoint();
    const auto place = display_->chosenPlace();
    if (!place || !part || !point)
        return;
    if (!document_.sceneIsCurrent() && !document_.hasErrors()) {
        if (nudges_.empty() || nudges_.back().part != *part || nudges_.back().point != *point)
            nudges_.push_back({*part, *point, direction});
        else
            nudges_.back().direction += direction;
        return;
    }
    const double step = display_->grid() > 0 ? display_->grid()
                                             : editing::decimalStep(10 * display_->pixelLength());
    movePoint(decimal(Vector(*place + step * direction), step / 10));
}

// The vertex that they were of may not be the chosen one any more. One that changes something has
// the text read again, and those behind it wait for that.
void ShapeEditor::makeNudges() {
    const auto part = display_->chosenPart(), point = display_->chosenPoint();
    const int before = document_.revision();
    while (!nudges_.empty() && document_.revision() == before) {
        const Nudge next = nudges_.front();
        nudges_.erase(nudges_.begin());
        if (next.part >= draft_.size() ||
            next.point >= editing::pointsOf(draft_[next.part].part).size())
            continue;
        choose(next.part, next.point);
        nudge(next.direction);
    }
    if (part != display_->chosenPart() || point != display_->chosenPoint())
        choose(part, point);
}

void ShapeEditor::addPoint(const Vector& place) {
    const auto part = display_->chosenPart();
    if (!part)
        return tell(tr("Choose a part first, with a click."), true);
    const scene::Part& before = draft_[*part].part;
    if (!std::holds_alternative<scene::HullShape>(before.shape))
        return tell(tr("A box has its corners, and what is round the points that set its sizes; "
                       "Polyhedron adds a part that can have more."),
                    true);
    const double length = display_->grid() > 0 ? 0 : display_->pixelLength();
    const scene::Part more = editing::withNewPoint(before, decimal(place, length));
    const std::size_t count = editing::pointsOf(more).size();
    if (change(tr("Add Vertex"), [&] { draft_[*part].part = tidied(before, more, length); }))
        choose(part, count - 1);
}

// Outside of the part: beyond its vertex that is furthest from its middle.
void ShapeEditor::addPointByKey() {
    const auto part = display_->chosenPart();
    if (!part)
        return tell(tr("Choose a part first, with a click or Page Down."), true);
    const auto points = editing::pointsOf(draft_[*part].part);
    Vector middle = Vector::Zero(), far = Vector::Zero();
    for (const Vector& p : points)
        middle += p / static_cast<double>(points.size());
    for (const Vector& p : points)
        if ((p - middle).norm() > far.norm())
            far = p - middle;
    addPoint(middle + 1.25 * far);
}

void ShapeEditor::addParts(const std::vector<scene::Part>& parts, const QString& label) {
    const bool replaces = isBegun() && parts.front() != draft_.front().part;
    const std::size_t first = replaces ? 0 : draft_.size();
    if (!change(label, [&] {
            if (replaces)
                draft_.clear();
            for (const scene::Part& part : parts)
                draft_.push_back({part, std::nullopt});
        }))
        return;
    wantedPart_ = first;
    choose(first);
    display_->frame();
}

void ShapeEditor::setColour(std::size_t part, std::optional<scene::Color> color) {
    change(tr("Colour Part"), [&] { draft_[part].part.appearance.color = color; });
}

void ShapeEditor::removePart() {
    const auto part = display_->chosenPart();
    if (!part)
        return;
    if (draft_.size() == 1)
        return tell(tr("A shape has one part at least."), true);
    change(tr("Delete Part"), [&] {
        draft_.erase(draft_.begin() + static_cast<std::ptrdiff_t>(*part));
        choose(std::nullopt);
    });
}

void ShapeEditor::removePoint(std::size_t part, std::size_t point) {
    const scene::Part less = editing::withoutPoint(draft_[part].part, point);
    if (less == draft_[part].part)
        return tell(std::holds_alternative<scene::HullShape>(less.shape)
                        ? tr("A polyhedron needs four vertices that are not in one plane. Delete "
                             "Part deletes it.")
                        : tr("Only a polyhedron loses points. Delete Part deletes the part."),
                    true);
    change(tr("Delete Vertex"), [&] {
        draft_[part].part = less;
        choose(part);
    });
}

void ShapeEditor::dropInnerPoints(bool ofAll) {
    const auto part = display_->chosenPart();
    const auto outer = withoutInner(draft_, [&](std::size_t i) { return ofAll || part == i; });
    if (!sameParts(outer, draft_))
        change(tr("Convex Hull"), [&] { draft_ = outer; });
}

// The vertices inside its parts go, when it was edited here.
void ShapeEditor::leaveShape(const QString& name) {
    if (!shapes_.edited.contains(name) || !document_.sceneIsCurrent())
        return;
    shapes_.edited.erase(name);
    const auto& all = document_.shown().scene->shapeSets;
    const auto left = std::ranges::find(all, name.toStdString(), &scene::ShapeSet::name);
    if (left == all.end())
        return;
    ShapeGesture gesture(document_, static_cast<std::size_t>(left - all.begin()));
    const auto outer = withoutInner(gesture.before(), [](std::size_t) { return true; });
    if (!sameParts(outer, gesture.before()) && gesture.show(outer))
        gesture.finish(tr("%1 of %2").arg(tr("Convex Hull"), name));
}

} // namespace views
