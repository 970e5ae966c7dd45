// The body that is selected, beside the picture: whether it is fixed, and the ways to its size,
// shape and surface.
//
// Always as high, so that what is below stays where it is.
#pragma once

#include "workbench/scene_document.h"

#include <QCheckBox>
#include <QGroupBox>
#include <QPushButton>

class QLabel;

namespace views {

class BodyPanel : public QGroupBox {
    Q_OBJECT
public:
    explicit BodyPanel(SceneDocument& document, QWidget* parent = nullptr);

    [[nodiscard]] QCheckBox& fixed() { return *fixed_; }
    [[nodiscard]] QPushButton& size() { return *size_; }
    [[nodiscard]] QPushButton& surface() { return *surface_; }

Q_SIGNALS:
    void fixWanted(std::size_t body, bool fixed);
    void sizeWanted(std::size_t body);
    void surfaceWanted(std::size_t body);
    void shapeWanted(const QString& name);

private:
    void refresh();
    [[nodiscard]] std::optional<std::size_t> body() const; // the one that is selected

    SceneDocument& document_;
    QLabel* name_;
    QCheckBox* fixed_;
    QPushButton *size_, *shape_, *surface_;
};

} // namespace views
