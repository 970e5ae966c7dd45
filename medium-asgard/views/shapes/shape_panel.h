// The right side of a shape editor: the parts of the shape, buttons for new ones, and the grid.
#pragma once

#include "scene/scene.h"

#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QGridLayout;
class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace views {

class ShapePanel : public QWidget {
    Q_OBJECT
public:
    explicit ShapePanel(QWidget* parent = nullptr);

    void setParts(const std::vector<scene::Part>& parts, std::optional<std::size_t> chosen);
    void choose(std::optional<std::size_t> part);

Q_SIGNALS:
    void chosen(std::size_t part);
    void addWanted(const std::vector<scene::Part>& parts, const QString& label);
    void hullWanted();
    void colourWanted();
    void removeWanted();
    void gridChanged(double step); // 0: none

private:
    void buildNewParts(QVBoxLayout* column);
    void buildGrid(QVBoxLayout* column);
    QPushButton* button(const char* name, const QString& text, const QString& tip,
                        std::function<void()> action);

    QListWidget* parts_;
    std::vector<QPushButton*> ofChosen_; // enabled while a part is chosen
};

} // namespace views
