#include "shapes/shape_panel.h"

#include "plain/plain.h"
#include "point_edits/shape_library.h"
#include "point_edits/shape_points.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace views {

namespace {

QString kindOf(const scene::Part& part) {
    const QString names[] = {ShapePanel::tr("Sphere"),     ShapePanel::tr("Box"),
                             ShapePanel::tr("Polyhedron"), ShapePanel::tr("Cylinder"),
                             ShapePanel::tr("Cone"),       ShapePanel::tr("Capsule"),
                             ShapePanel::tr("Ellipsoid"),  ShapePanel::tr("Floor"),
                             ShapePanel::tr("Tube"),       ShapePanel::tr("Bowl")};
    if (std::holds_alternative<scene::HullShape>(part.shape))
        return ShapePanel::tr("Polyhedron, %1 vertices").arg(editing::pointsOf(part).size());
    return names[part.shape.index()]; // in the order of the variant
}

// A part's own colour; a hollow square where it has none.
QIcon swatch(const std::optional<scene::Color>& color, const QColor& frame) {
    QPixmap image(14, 14);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setPen(frame);
    if (color)
        painter.setBrush(QColor::fromRgbF(static_cast<float>(color->red),
                                          static_cast<float>(color->green),
                                          static_cast<float>(color->blue)));
    painter.drawRect(1, 1, 11, 11);
    return image;
}

} // namespace

ShapePanel::ShapePanel(QWidget* parent) : QWidget(parent), parts_(new QListWidget) {
    setFixedWidth(232);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 0, 0, 0);
    auto* title = plain::label(tr("P&arts"));
    title->setBuddy(parts_);
    column->addWidget(title);
    parts_->setObjectName("parts");
    parts_->setAccessibleName(tr("Parts"));
    column->addWidget(parts_, 1);
    auto* row = new QHBoxLayout;
    ofChosen_ = {button("colour", tr("C&olour…"), tr("The colour of the chosen part"),
                        [this] { Q_EMIT colourWanted(); }),
                 button("deletePart", tr("&Delete"), tr("Deletes the chosen part (Shift+Delete)"),
                        [this] { Q_EMIT removeWanted(); })};
    for (QPushButton* one : ofChosen_)
        row->addWidget(one);
    column->addLayout(row);
    ofChosen_.push_back(button("convexHull", tr("Convex &Hull"),
                               tr("Removes the vertices that lie inside the part, the white ones "
                                  "(Ctrl+Shift+H)"),
                               [this] { Q_EMIT hullWanted(); }));
    column->addWidget(ofChosen_.back());
    column->addSpacing(8);
    buildNewParts(column);
    column->addSpacing(8);
    buildGrid(column);
    connect(parts_, &QListWidget::currentRowChanged, this, [this](int now) {
        if (now >= 0)
            Q_EMIT chosen(static_cast<std::size_t>(now));
    });
}

QPushButton* ShapePanel::button(const char* name, const QString& text, const QString& tip,
                                std::function<void()> action) {
    auto* made = new QPushButton(plain::ours(text));
    made->setObjectName(name);
    made->setToolTip(plain::tip(tip));
    connect(made, &QPushButton::clicked, this, std::move(action));
    return made;
}

void ShapePanel::buildNewParts(QVBoxLayout* column) {
    column->addWidget(plain::label(tr("New part")));
    auto* grid = new QGridLayout;
    const std::tuple<const char*, QString, scene::Part> kinds[] = {
        {"addSphere", tr("&Sphere"), editing::sphere(0.5)},
        {"addBox", tr("&Box"), editing::box({1, 1, 1})},
        {"addPolyhedron", tr("Polyhed&ron"), editing::tetrahedron(1)},
        {"addCylinder", tr("C&ylinder"), editing::cylinder(0.5, 1)},
        {"addCone", tr("Co&ne"), editing::cone(0.5, 1)},
        {"addCapsule", tr("Ca&psule"), editing::capsule(0.3, 1)},
        {"addEllipsoid", tr("&Ellipsoid"), editing::ellipsoid({0.6, 0.4, 0.4})},
        {"addTube", tr("&Tube"), editing::tube(0.4, 0.5, 1)},
        {"addBowl", tr("Bo&wl"), editing::bowl(0.4, 0.5)},
    };
    int place = 0;
    for (const auto& [name, text, part] : kinds) {
        const QString label = tr("Add %1").arg(QString(text).remove('&'));
        auto* one =
            button(name, text, tr("Adds one of size 1 about the origin; its sizes stand below"),
                   [this, label, what = part] { Q_EMIT addWanted({what}, label); });
        grid->addWidget(one, place / 2, place % 2);
        ++place;
    }
    auto* library = new QPushButton(tr("&Library"));
    library->setObjectName("library");
    auto* menu = new QMenu(library);
    for (const editing::LibraryShape& shape : editing::shapeLibrary()) {
        const QString name = QString::fromStdString(shape.name);
        menu->addAction(plain::caption(name), this, [this, &shape, name] {
            Q_EMIT addWanted(shape.parts, tr("Add %1").arg(name));
        });
    }
    library->setMenu(menu);
    grid->addWidget(library, place / 2, place % 2);
    column->addLayout(grid);
}

void ShapePanel::buildGrid(QVBoxLayout* column) {
    auto* row = new QHBoxLayout;
    auto* grid = new QCheckBox(tr("&Grid"));
    grid->setObjectName("grid");
    grid->setToolTip(tr("Vertices that are dragged stay on multiples of the step"));
    auto* step = new QDoubleSpinBox;
    step->setObjectName("gridStep");
    step->setDecimals(3);
    step->setRange(0.001, 1000);
    step->setValue(0.1);
    step->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    step->setAccessibleName(tr("Step of the grid"));
    step->setEnabled(false);
    const auto set = [this, grid, step] {
        step->setEnabled(grid->isChecked());
        Q_EMIT gridChanged(grid->isChecked() ? step->value() : 0);
    };
    connect(grid, &QCheckBox::toggled, this, set);
    connect(step, &QDoubleSpinBox::valueChanged, this, set);
    row->addWidget(grid);
    row->addWidget(step, 1);
    column->addLayout(row);
}

void ShapePanel::setParts(const std::vector<scene::Part>& parts,
                          std::optional<std::size_t> chosen) {
    const QSignalBlocker quiet(parts_);
    const auto count = static_cast<int>(parts.size());
    while (parts_->count() > count)
        delete parts_->takeItem(parts_->count() - 1);
    while (parts_->count() < count)
        parts_->addItem(QString());
    for (int i = 0; i < count; ++i) {
        const scene::Part& part = parts[static_cast<std::size_t>(i)];
        parts_->item(i)->setText(tr("%1: %2").arg(i + 1).arg(kindOf(part)));
        parts_->item(i)->setIcon(
            swatch(part.appearance.color, palette().color(QPalette::WindowText)));
    }
    choose(chosen);
}

void ShapePanel::choose(std::optional<std::size_t> part) {
    const QSignalBlocker quiet(parts_);
    parts_->setCurrentRow(part ? static_cast<int>(*part) : -1);
    for (QPushButton* one : ofChosen_)
        one->setEnabled(part.has_value());
}

} // namespace views
