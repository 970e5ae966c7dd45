#include "viewers/body_panel.h"

#include "picture/asked_value.h"
#include "plain/plain.h"

#include <QGridLayout>
#include <QVBoxLayout>

namespace views {

BodyPanel::BodyPanel(SceneDocument& document, QWidget* parent)
    : QGroupBox(tr("Body"), parent), document_(document), name_(plain::label()),
      fixed_(new QCheckBox(tr("Fi&xed"))), size_(new QPushButton(tr("Si&ze…"))),
      shape_(new QPushButton(tr("S&hape…"))), surface_(new QPushButton(tr("S&urface…"))) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 6, 10, 8);
    column->setSpacing(4);
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    column->addWidget(name_);
    column->addLayout(grid);
    grid->addWidget(fixed_, 0, 0);
    grid->addWidget(surface_, 0, 1);
    grid->addWidget(size_, 1, 0);
    grid->addWidget(shape_, 1, 1);
    name_->setObjectName("bodyName");
    fixed_->setObjectName("fixed");
    size_->setObjectName("size");
    shape_->setObjectName("bodyShape");
    surface_->setObjectName("bodySurface");
    fixed_->setToolTip(tr("It never moves, whatever hits it: a floor, a wall"));
    size_->setToolTip(tr("The radius or the edges of its shape (double click on the body)"));
    shape_->setToolTip(tr("Its shape, in the shape editor"));
    surface_->setToolTip(tr("How it bounces, slides and rolls: restitution and friction"));
    for (QWidget* one : std::initializer_list<QWidget*>{fixed_, size_, shape_, surface_})
        one->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the picture
    connect(fixed_, &QCheckBox::clicked, this, [this](bool on) {
        if (const auto now = body())
            Q_EMIT fixWanted(*now, on);
        refresh(); // as the text has it
    });
    connect(size_, &QPushButton::clicked, this, [this] {
        if (const auto now = body())
            Q_EMIT sizeWanted(*now);
    });
    connect(surface_, &QPushButton::clicked, this, [this] {
        if (const auto now = body())
            Q_EMIT surfaceWanted(*now);
    });
    connect(shape_, &QPushButton::clicked, this, [this] {
        if (const auto now = body())
            Q_EMIT shapeWanted(QString::fromStdString(document_.shown().scene->bodies[*now].shape));
    });
    connect(&document_, &SceneDocument::sceneChanged, this, &BodyPanel::refresh);
    connect(&document_, &SceneDocument::selectionChanged, this, &BodyPanel::refresh);
    refresh();
}

std::optional<std::size_t> BodyPanel::body() const {
    const auto& selected = document_.selected();
    const auto& bodies = document_.shown().scene->bodies;
    if (selected.size() == 1 && selected.front().kind == editing::Kind::body &&
        selected.front().index < bodies.size())
        return selected.front().index;
    return std::nullopt;
}

void BodyPanel::refresh() {
    const auto now = body();
    const scene::Body* one = now ? &document_.shown().scene->bodies[*now] : nullptr;
    name_->setText(one ? QString::fromStdString(one->name) : tr("None is selected"));
    name_->setToolTip(tr("A click in the picture selects a body"));
    name_->setForegroundRole(one ? QPalette::WindowText : QPalette::PlaceholderText);
    fixed_->setChecked(one && one->fixed);
    for (QWidget* each : std::initializer_list<QWidget*>{fixed_, size_, shape_, surface_})
        each->setEnabled(one != nullptr);
}

} // namespace views
