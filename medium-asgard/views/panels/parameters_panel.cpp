#include "panels/parameters_panel.h"

#include "plain/plain.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace views {

namespace {

constexpr int positions = 1000; // of a slider

// What two neighbouring positions differ by, as a power of ten.
double resolutionOf(double least, double most) {
    return most > least ? std::pow(10, std::floor(std::log10((most - least) / positions) + 1e-9))
                        : 0;
}

QString shortest(double value, double resolution) {
    const int digits =
        resolution > 0 ? std::clamp(static_cast<int>(std::lround(-std::log10(resolution))), 0, 9)
                       : 6;
    QString text = QString::number(value, 'f', digits);
    while (text.contains('.') && (text.endsWith('0') || text.endsWith('.')))
        if (text.back() == '.') {
            text.chop(1);
            break;
        } else {
            text.chop(1);
        }
    return text;
}

// Of an expression that is one.
std::optional<double> numberOf(const std::string& expression) {
    const QString text = QString::fromStdString(expression).trimmed();
    bool isNumber = false;
    const double value = text.toDouble(&isNumber);
    return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// For the longest that a drag can show: then the name beside it breaks its lines once for all.
void reserveWidth(QLabel& label, const std::function<QString(double)>& text, double least,
                  double most) {
    int width = 0;
    constexpr int tries = 97; // of the thousand positions
    for (int i = 0; i <= tries; ++i)
        width = std::max(
            width, label.fontMetrics().horizontalAdvance(text(least + (most - least) * i / tries)));
    label.setMinimumWidth(width + 2);
}

} // namespace

ParametersPanel::ParametersPanel(SceneDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(8, 4, 8, 6);
    connect(&document_, &SceneDocument::sceneChanged, this, &ParametersPanel::refresh);
    refresh();
}

QSlider* ParametersPanel::slider(const QString& name) const {
    for (const Row& row : rows_)
        if (row.of.name == name.toStdString())
            return row.slider;
    return nullptr;
}

std::vector<ParametersPanel::Control> ParametersPanel::controlsOf(const scene::Scene& scene) {
    std::vector<Control> controls;
    for (std::size_t i = 0; i < scene.parameters.size(); ++i) {
        const scene::Parameter& one = scene.parameters[i];
        controls.push_back(
            {one.name,
             QString::fromStdString(one.label.empty() ? one.name : one.label),
             one.unit,
             {editing::Kind::parameter, i},
             "-value",
             one.value,
             one.minimum.value_or(std::min(0.0, 2 * one.value)),
             one.maximum.value_or(one.value == 0 ? 1 : std::max(0.0, 2 * one.value))});
    }
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
        const scene::Joint& joint = scene.joints[j];
        for (std::size_t k = 0; k < joint.coordinates.size(); ++k) {
            const std::string digit = joint.coordinates.size() > 1 ? std::to_string(k + 1) : "";
            const auto add = [&](const std::optional<scene::Expression>& text,
                                 const std::string& option, const QString& label) {
                const auto value = text ? numberOf(*text) : std::nullopt;
                if (!value)
                    return;
                const double most = *value == 0 ? 1 : 2 * std::abs(*value);
                controls.push_back({joint.name + " " + option + digit,
                                    label.arg(QString::fromStdString(joint.name)),
                                    {},
                                    {editing::Kind::joint, j},
                                    option + digit,
                                    *value,
                                    -most,
                                    most,
                                    true});
            };
            add(joint.coordinates[k].motor, "-motor", tr("Motor of %1"));
            add(joint.coordinates[k].speed, "-speed", tr("Speed of %1"));
        }
    }
    return controls;
}

void ParametersPanel::rebuild(const std::vector<Control>& controls) {
    delete content_;
    rows_.clear();
    drag_.reset();
    content_ = new QWidget;
    auto* column = new QVBoxLayout(content_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    for (const Control& control : controls) {
        const std::size_t index = rows_.size();
        auto* head = new QHBoxLayout;
        auto* name = plain::label(control.label);
        name->setWordWrap(true);
        name->setToolTip(plain::tip(QString::fromStdString(control.name)));
        auto* value = plain::label();
        value->setAlignment(Qt::AlignRight | Qt::AlignBottom);
        auto* slider = new QSlider(Qt::Horizontal);
        slider->setRange(0, positions);
        slider->setPageStep(positions / 20);
        slider->setSingleStep(positions / 100);
        slider->setAccessibleName(control.label);
        slider->setFocusPolicy(Qt::TabFocus); // a drag leaves the keys to the picture
        slider->installEventFilter(this);
        head->addWidget(name, 1);
        head->addWidget(value);
        column->addLayout(head);
        column->addWidget(slider);
        rows_.push_back({control, value, slider});
        connect(slider, &QSlider::sliderPressed, this, &ParametersPanel::begin);
        connect(slider, &QSlider::valueChanged, this,
                [this, index](int position) { moved(index, position); });
        connect(slider, &QSlider::sliderReleased, this, [this, index] { finish(index); });
    }
    column_->addWidget(content_);
    Q_EMIT rebuilt();
}

QString ParametersPanel::title() const {
    const auto isMotor = [](const Row& row) { return row.of.element.kind == editing::Kind::joint; };
    if (std::ranges::none_of(rows_, isMotor))
        return tr("Parameters");
    return std::ranges::all_of(rows_, isMotor) ? tr("Motors") : tr("Parameters and Motors");
}

void ParametersPanel::refresh() {
    const std::vector<Control> controls = controlsOf(*document_.shown().scene);
    const bool same = content_ && std::ranges::equal(controls, rows_, {}, &Control::name,
                                                     [](const Row& row) { return row.of.name; });
    if (!same)
        rebuild(controls);
    refreshing_ = true;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        Row& row = rows_[i];
        if (!row.slider->isSliderDown()) { // the ends stay while one drags
            const Control before = std::exchange(row.of, controls[i]);
            if (row.of.isWide) { // a motor that was dragged to 0 finds its way back
                row.of.least = std::min(row.of.least, before.least);
                row.of.most = std::max(row.of.most, before.most);
            }
            row.slider->setValue(positionOf(row, row.of.value));
            reserveWidth(
                *row.value, [&row](double any) { return valueText(row, any); }, row.of.least,
                row.of.most);
        }
        show(row, controls[i].value);
    }
    refreshing_ = false;
    if (drag_ || !document_.sceneIsCurrent())
        return;
    const editing::Mapper now(document_.text(), document_.shown().scene);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const auto answer = asked(now, i, (rows_[i].of.least + rows_[i].of.most) / 2);
        rows_[i].slider->setEnabled(answer.possible());
        rows_[i].slider->setToolTip(plain::tip(QString::fromStdString(answer.reason)));
    }
    // What keys asked for while the scene was being read.
    if (const auto wanted = std::exchange(wanted_, std::nullopt)) {
        const auto row = std::ranges::find_if(
            rows_, [&](const Row& one) { return one.of.name == wanted->first; });
        if (row != rows_.end())
            row->slider->setValue(positionOf(*row, wanted->second));
    }
}

int ParametersPanel::positionOf(const Row& row, double value) {
    const auto& [least, most] = std::pair(row.of.least, row.of.most);
    const double share = most > least ? (value - least) / (most - least) : 0;
    return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * positions));
}

double ParametersPanel::valueOf(const Row& row, int position) {
    return row.of.least + (row.of.most - row.of.least) * position / positions;
}

QString ParametersPanel::valueText(const Row& row, double value) {
    const QString unit =
        row.of.unit.empty() ? QString() : " " + QString::fromStdString(row.of.unit);
    return shortest(value, resolutionOf(row.of.least, row.of.most)) + unit;
}

void ParametersPanel::show(Row& row, double value) { row.value->setText(valueText(row, value)); }

editing::Answer ParametersPanel::asked(const editing::Mapper& mapper, std::size_t row,
                                       double value) const {
    editing::Wish wish;
    const Control& of = rows_[row].of;
    wish.element = of.element;
    wish.option = of.option;
    wish.values = {value};
    wish.absent = {0};
    wish.resolution = resolutionOf(of.least, of.most);
    return mapper.answer(wish);
}

// The keys of a slider are no shortcuts of the window.
bool ParametersPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Home ||
            key == Qt::Key_End) {
            event->accept();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void ParametersPanel::begin() {
    drag_.reset();
    if (document_.sceneIsCurrent())
        drag_.reset(new Drag{document_.revision(),
                             document_.text(),
                             document_.shown().scene,
                             {document_.text(), document_.shown().scene},
                             {}});
}

void ParametersPanel::moved(std::size_t index, int position) {
    if (refreshing_)
        return;
    Row& row = rows_[index];
    const bool dragged = row.slider->isSliderDown();
    // A key or the wheel; or the scene was not the text's when it was pressed, or the text was
    // changed elsewhere since: then it goes on from there.
    if (!dragged || !drag_ || !document_.mayGoOn(drag_->since))
        begin();
    if (!drag_ && document_.work() == Work::none) {
        QToolTip::showText(row.slider->mapToGlobal(row.slider->rect().bottomLeft()),
                           plain::tip(document_.whyNotCurrent()));
        return refresh();
    }
    if (!drag_) {
        if (!dragged)
            wanted_ = {row.of.name, valueOf(row, position)};
        return;
    }
    const double value = valueOf(row, position);
    const editing::Answer answer = asked(drag_->mapper, index, value);
    if (answer.possible()) {
        show(row, value);
        drag_->last = answer;
        document_.preview(drag_->wanted(), drag_->since, this);
    }
    if (!dragged)
        finish(index);
}

std::optional<Asked> ParametersPanel::asked() const {
    return drag_ ? std::optional(Asked{drag_->since, drag_->last}) : std::nullopt;
}

void ParametersPanel::finish(std::size_t index) {
    if (!drag_)
        return;
    const std::unique_ptr<Drag> drag = std::move(drag_);
    document_.finishPreview(drag->wanted(),
                            tr("Change %1").arg(QString::fromStdString(rows_[index].of.name)),
                            drag->since, this);
}

} // namespace views
