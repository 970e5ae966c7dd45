#include "shapes/shape_fields.h"

#include "plain/plain.h"
#include "point_edits/shape_points.h"
#include "script/numbers.h"

#include <QHBoxLayout>
#include <QLineEdit>

#include <algorithm>

namespace views {

using geometry::Vector;

namespace {

QString plain(double value) { return QString::fromStdString(script::numberText(value, true)); }

// The first `count`, or nothing when one is no number.
std::optional<std::vector<double>> numbersOf(const std::array<QLineEdit*, 3>& fields,
                                             std::size_t count) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i) {
        fields[i]->setModified(false);
        const auto number = script::decimalNumber(fields[i]->text().toStdString());
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

void fill(const std::array<QLineEdit*, 3>& fields, const std::vector<double>& values) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
        fields[i]->setEnabled(i < values.size());
        const QString text = i < values.size() ? plain(values[i]) : QString();
        // The same text again would take away what is selected to be typed over.
        if ((!fields[i]->isModified() || !fields[i]->hasFocus()) && fields[i]->text() != text)
            fields[i]->setText(text);
    }
}

} // namespace

ShapeFields::ShapeFields(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    const QString axes[] = {tr("x"), tr("y"), tr("z")};
    row->addWidget(plain::label(tr("Vertex")));
    for (std::size_t i = 0; i < 3; ++i) {
        place_[i] = field(row, plain::label(axes[i]), tr("%1 of the vertex").arg(axes[i]));
        place_[i]->setObjectName(QStringLiteral("vertex%1").arg(i + 1));
        connect(place_[i], &QLineEdit::editingFinished, this, [this, i] {
            if (place_[i]->isModified())
                takePlace();
        });
    }
    row->addSpacing(16);
    for (std::size_t i = 0; i < 3; ++i) {
        sizeNames_[i] = plain::label(QStringLiteral("×"));
        sizes_[i] = field(row, sizeNames_[i], tr("Size"));
        sizes_[i]->setObjectName(QStringLiteral("size%1").arg(i + 1));
        connect(sizes_[i], &QLineEdit::editingFinished, this, [this, i] {
            if (sizes_[i]->isModified())
                takeSizes();
        });
    }
    row->addStretch();
    showNumbers(nullptr, std::nullopt);
}

QLineEdit* ShapeFields::field(QHBoxLayout* row, QLabel* label, const QString& accessible) {
    auto* edit = new QLineEdit;
    edit->setAccessibleName(accessible);
    edit->setMaximumWidth(100);
    label->setBuddy(edit);
    row->addWidget(label);
    row->addWidget(edit);
    return edit;
}

void ShapeFields::showNumbers(const scene::Part* part, const std::optional<Vector>& place) {
    fill(place_,
         place ? std::vector<double>{place->x(), place->y(), place->z()} : std::vector<double>());
    const auto sizes = part ? editing::sizesOf(*part) : std::vector<double>();
    const auto names = part ? editing::sizeNames(*part) : std::vector<std::string>();
    sizeCount_ = sizes.size();
    fill(sizes_, sizes);
    for (std::size_t i = 0; i < 3; ++i) {
        if (i < sizeCount_) {
            const QString name = QString::fromStdString(names[i]);
            sizeNames_[i]->setText(plain::ours(name));
            sizes_[i]->setAccessibleName(name);
        }
        sizeNames_[i]->setVisible(i < sizeCount_);
        sizes_[i]->setVisible(i < sizeCount_);
    }
}

void ShapeFields::takePlace() {
    if (const auto place = numbersOf(place_, 3))
        Q_EMIT placeTaken(Vector(place->data()));
    else
        Q_EMIT refused(tr("A place is three numbers."));
}

void ShapeFields::takeSizes() {
    const auto sizes = numbersOf(sizes_, sizeCount_);
    if (sizes && std::ranges::all_of(*sizes, [](double x) { return x > 0; }))
        Q_EMIT sizesTaken(*sizes);
    else
        Q_EMIT refused(tr("A size is a number above 0."));
}

} // namespace views
