// Exact numbers below a shape editor's picture: the place of the chosen point, the sizes of a
// sphere or a box.
#pragma once

#include "scene/scene.h"

#include <QWidget>

#include <array>
#include <optional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QLineEdit;

namespace views {

class ShapeFields : public QWidget {
    Q_OBJECT
public:
    explicit ShapeFields(QWidget* parent = nullptr);

    void showNumbers(const scene::Part* part, const std::optional<geometry::Vector>& place);

Q_SIGNALS:
    // Typed, and Return or another field after it.
    void placeTaken(const geometry::Vector& place);
    void sizesTaken(const std::vector<double>& sizes); // a radius, or three edges
    void refused(const QString& why);

private:
    using Fields = std::array<QLineEdit*, 3>;
    QLineEdit* field(QHBoxLayout* row, QLabel* label, const QString& accessible);
    void takePlace();
    void takeSizes();

    Fields place_{}, sizes_{};
    std::array<QLabel*, 3> sizeNames_{};
    std::size_t sizeCount_ = 0;
};

} // namespace views
