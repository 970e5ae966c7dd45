#include "viewers/parameters_panel.h"

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

constexpr int whole = 1000; // slider positions

// What two neighbouring positions differ by, as a power of ten.
double resolutionOf(double least, double most) {
    return most > least ? std::pow(10, std::floor(std::log10((most - least) / whole) + 1e-9)) : 0;
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
    : QGroupBox(tr("Parameters"), parent), document_(document), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(10, 6, 10, 8);
    connect(&document_, &SceneDocument::sceneChanged, this, &ParametersPanel::refresh);
    refresh();
}

QSlider* ParametersPanel::slider(const QString& parameter) const {
    for (const Row& row : rows_)
        if (row.name == parameter.toStdString())
            return row.slider;
    return nullptr;
}

void ParametersPanel::rebuild() {
    delete content_;
    rows_.clear();
    drag_.reset();
    content_ = new QWidget;
    auto* column = new QVBoxLayout(content_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    for (const scene::Parameter& parameter : document_.shown().scene->parameters) {
        const std::size_t index = rows_.size();
        auto* head = new QHBoxLayout;
        const QString label =
            QString::fromStdString(parameter.label.empty() ? parameter.name : parameter.label);
        auto* name = plain::label(label);
        name->setWordWrap(true);
        name->setToolTip(plain::tip(QString::fromStdString(parameter.name)));
        auto* value = plain::label();
        value->setAlignment(Qt::AlignRight | Qt::AlignBottom);
        auto* slider = new QSlider(Qt::Horizontal);
        slider->setRange(0, whole);
        slider->setPageStep(whole / 20);
        slider->setSingleStep(whole / 100);
        slider->setAccessibleName(label);
        slider->setFocusPolicy(Qt::TabFocus); // a drag leaves the keys to the picture
        slider->installEventFilter(this);
        head->addWidget(name, 1);
        head->addWidget(value);
        column->addLayout(head);
        column->addWidget(slider);
        rows_.push_back({parameter.name, value, slider, 0, 1, parameter.unit});
        connect(slider, &QSlider::sliderPressed, this, &ParametersPanel::begin);
        connect(slider, &QSlider::valueChanged, this,
                [this, index](int position) { moved(index, position); });
        connect(slider, &QSlider::sliderReleased, this, [this, index] { finish(index); });
    }
    column_->addWidget(content_);
}

void ParametersPanel::refresh() {
    const auto& parameters = document_.shown().scene->parameters;
    const bool same =
        content_ && std::ranges::equal(parameters, rows_, {}, &scene::Parameter::name, &Row::name);
    if (!same)
        rebuild();
    setVisible(!parameters.empty());
    refreshing_ = true;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        Row& row = rows_[i];
        const scene::Parameter& parameter = parameters[i];
        const double value = parameter.value;
        if (!row.slider->isSliderDown()) { // the ends stay while one drags
            row.least = parameter.minimum.value_or(std::min(0.0, 2 * value));
            row.most = parameter.maximum.value_or(value == 0 ? 1 : std::max(0.0, 2 * value));
            row.slider->setValue(positionOf(row, value));
            reserveWidth(
                *row.value, [&row](double any) { return valueText(row, any); }, row.least,
                row.most);
        }
        show(row, value);
    }
    refreshing_ = false;
    if (drag_ || !document_.sceneIsCurrent())
        return;
    const editing::Mapper now(document_.text(), document_.shown().scene);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const auto answer = asked(now, i, (rows_[i].least + rows_[i].most) / 2);
        rows_[i].slider->setEnabled(answer.possible());
        rows_[i].slider->setToolTip(plain::tip(QString::fromStdString(answer.reason)));
    }
    // What keys asked for while the scene was being read.
    if (const auto wanted = std::exchange(wanted_, std::nullopt)) {
        const auto row = std::ranges::find(rows_, wanted->first, &Row::name);
        if (row != rows_.end())
            row->slider->setValue(positionOf(*row, wanted->second));
    }
}

int ParametersPanel::positionOf(const Row& row, double value) {
    const double share = row.most > row.least ? (value - row.least) / (row.most - row.least) : 0;
    return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * whole));
}

double ParametersPanel::valueOf(const Row& row, int position) {
    return row.least + (row.most - row.least) * position / whole;
}

QString ParametersPanel::valueText(const Row& row, double value) {
    const QString unit = row.unit.empty() ? QString() : " " + QString::fromStdString(row.unit);
    return shortest(value, resolutionOf(row.least, row.most)) + unit;
}

void ParametersPanel::show(Row& row, double value) { row.value->setText(valueText(row, value)); }

editing::Answer ParametersPanel::asked(const editing::Mapper& mapper, std::size_t row,
                                       double value) const {
    editing::Wish wish;
    wish.element = {editing::Kind::parameter, row};
    wish.option = "-value";
    wish.values = {value};
    wish.absent = {0};
    wish.resolution = resolutionOf(rows_[row].least, rows_[row].most);
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
    return QGroupBox::eventFilter(watched, event);
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
            wanted_ = {row.name, valueOf(row, position)};
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
                            tr("Change %1").arg(QString::fromStdString(rows_[index].name)),
                            drag->since, this);
}

} // namespace views
