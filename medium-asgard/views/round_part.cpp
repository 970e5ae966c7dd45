#include "views/round_part.h"

#include "editing/shape_library.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSpinBox>

namespace views {

namespace {

QDoubleSpinBox* lengthField(double value) {
    auto* field = new QDoubleSpinBox;
    field->setDecimals(4);
    field->setRange(1e-4, 1e4);
    field->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    field->setValue(value);
    return field;
}

} // namespace

RoundPartDialog::RoundPartDialog(RoundPart kind, QWidget* parent)
    : QDialog(parent), kind_(kind), radius_(lengthField(kind == RoundPart::cylinder ? 0.5 : 0.3)),
      length_(lengthField(1)), sides_(new QSpinBox) {
    const bool isCylinder = kind == RoundPart::cylinder;
    setObjectName("roundPart");
    setWindowTitle(isCylinder ? tr("New Cylinder") : tr("New Capsule"));
    sides_->setRange(3, 48);
    sides_->setValue(isCylinder ? 16 : 12);
    sides_->setToolTip(tr("More are rounder, and slower where it is hit"));
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Radius"), radius_);
    form->addRow(isCylinder ? tr("&Length, along y") : tr("&Length between its ends, along y"),
                 length_);
    form->addRow(tr("&Sides"), sides_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

scene::Part RoundPartDialog::part() const {
    return kind_ == RoundPart::cylinder
               ? editing::cylinder(radius_->value(), length_->value(), sides_->value())
               : editing::capsule(radius_->value(), length_->value(), sides_->value());
}

} // namespace views
