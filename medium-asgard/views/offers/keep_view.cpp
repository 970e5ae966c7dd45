#include "offers/keep_view.h"

#include "editing/number_text.h"
#include "offers/edit_preview.h"
#include "plain/plain.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace views {

namespace {

using editing::Wish;
using geometry::Vector;

Wish wish(std::size_t view, const char* option, const Vector& value, double resolution) {
    Wish one;
    one.element = {editing::Kind::view, view};
    one.option = option;
    one.values = {value.x(), value.y(), value.z()};
    one.resolution = editing::decimalStep(resolution);
    return one;
}

// The camera stands at eye and looks at look; there is no pan then.
std::vector<Wish> byEye(std::size_t index, const scene::View& view, const gestures::Sight& sight) {
    const render::Camera& c = sight.camera;
    const geometry::Quaternion back = c.rotation.conjugate();
    const Vector look = c.center - back * (c.position / c.scale);
    const Vector eye = look + back * Vector(0, 0, render::eyeDistance / c.scale);
    const double length = sight.pixelLength(look);
    std::vector<Wish> wishes = {wish(index, "-eye", eye, length),
                                wish(index, "-look", look, length),
                                wish(index, "-up", back * Vector::UnitY(), 1e-4)};
    if (view.position)
        wishes.push_back(wish(index, "-pos", Vector::Zero(), 1e-3));
    return wishes;
}

std::vector<Wish> byAttitude(std::size_t index, const gestures::Sight& sight, bool quaternion) {
    const render::Camera& c = sight.camera;
    Wish scale = wish(index, "-scale", Vector::Zero(), 1e-4 * c.scale);
    scale.values = {c.scale};
    Wish turn = wish(index, "-rot", geometry::toRotationVector(c.rotation), 1e-4);
    if (quaternion)
        turn.values = {c.rotation.w(), c.rotation.x(), c.rotation.y(), c.rotation.z()};
    return {wish(index, "-pos", c.position, 1e-3), turn, scale,
            wish(index, "-center", c.center, sight.pixelLength(c.center))};
}

} // namespace

editing::Answer changedView(const std::string& text,
                            const std::shared_ptr<const scene::Scene>& scene, std::size_t index,
                            const gestures::Sight& sight) {
    const editing::Mapper mapper(text, scene);
    const scene::View& view = scene->views[index];
    if (view.eye || view.look)
        return mapper.answer(byEye(index, view, sight));
    Wish turn;
    turn.element = {editing::Kind::view, index};
    turn.option = "-rot";
    turn.values = {0, 0, 0};
    return mapper.answer(byAttitude(index, sight, mapper.count(turn) == 4));
}

KeepViewDialog::KeepViewDialog(const SceneDocument& document, const gestures::Sight& sight,
                               const QString& preferred, QWidget* parent)
    : QDialog(parent), text_(document.text()), scene_(document.shown().scene), sight_(sight),
      views_(new QComboBox), says_(plain::markupLabel()) {
    setObjectName("keepView");
    setWindowTitle(tr("Keep This View"));
    setMinimumWidth(420);
    for (const scene::View& view : scene_->views)
        views_->addItem(view.name.empty() ? tr("the view without a name")
                                          : tr("View %1").arg(QString::fromStdString(view.name)),
                        QString::fromStdString(view.name));
    views_->addItem(tr("A new view"));
    views_->setAccessibleName(tr("Which view becomes this one"));
    const int at = views_->findData(preferred);
    views_->setCurrentIndex(at >= 0 ? at : 0);
    says_->setWordWrap(true);
    says_->setAccessibleName(tr("What changes in the text"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    take_ = buttons->button(QDialogButtonBox::Ok);
    take_->setText(tr("&Keep"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(views_);
    column->addWidget(says_);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(views_, &QComboBox::currentIndexChanged, this, [this] { follow(); });
    follow();
}

bool KeepViewDialog::wantsNew() const { return views_->currentIndex() == views_->count() - 1; }

QString KeepViewDialog::name() const { return views_->currentData().toString(); }

void KeepViewDialog::follow() {
    answer_ = {};
    if (!wantsNew())
        answer_ =
            changedView(text_, scene_, static_cast<std::size_t>(views_->currentIndex()), sight_);
    take_->setEnabled(answer_.possible());
    says_->setText(wantsNew()              ? tr("A new line is added to the text.")
                   : !answer_.possible()   ? QString::fromStdString(answer_.reason).toHtmlEscaped()
                   : answer_.edits.empty() ? tr("It is this view already.")
                                           : previewOf(text_, answer_.edits));
}

} // namespace views
