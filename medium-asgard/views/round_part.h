// Asks how large a new cylinder or capsule shall be: as polyhedra they have no radius later.
#pragma once

#include "scene/scene.h"

#include <QDialog>

class QDoubleSpinBox;
class QSpinBox;

namespace views {

enum class RoundPart { cylinder, capsule };

class RoundPartDialog : public QDialog {
    Q_OBJECT
public:
    RoundPartDialog(RoundPart kind, QWidget* parent);

    [[nodiscard]] QDoubleSpinBox& radius() { return *radius_; }
    [[nodiscard]] QDoubleSpinBox& length() { return *length_; }
    [[nodiscard]] QSpinBox& sides() { return *sides_; }
    [[nodiscard]] scene::Part part() const;

private:
    RoundPart kind_;
    QDoubleSpinBox *radius_, *length_;
    QSpinBox* sides_;
};

} // namespace views
