// The parts of a shape in a shape editor: bodies of a picture as any scene's, the chosen part in
// colour with its edges, the others grey (dissertation 4.1.1), and balls at their points. Draws and
// takes gestures; what they change is the editor's.
//
// The left button drags the point under it; a click chooses the part there, a further one that
// behind it. Other drags move the view. With Shift: middle adds a point to the chosen part, right
// deletes the one under the pointer; z and x push what is dragged away and towards the viewer.
#pragma once

#include "gestures/picking.h"
#include "painting/window_picture.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace views {

class ShapeDisplay : public QWidget {
    Q_OBJECT
public:
    explicit ShapeDisplay(std::shared_ptr<PictureThread> pictures, QWidget* parent = nullptr);

    // `another`: of another shape than before.
    void setParts(std::vector<scene::Part> parts, bool another = false);
    // All parts in colours of their own, balls and gestures left away: to be looked at only.
    void setForLooking();
    // None: all parts are in colour.
    void choose(std::optional<std::size_t> part, std::optional<std::size_t> point = {});
    [[nodiscard]] std::optional<std::size_t> chosenPart() const { return part_; }
    [[nodiscard]] std::optional<std::size_t> chosenPoint() const { return point_; }
    void setGrid(double step); // 0: none; else places are its multiples
    [[nodiscard]] double grid() const { return grid_; }
    void frame(); // all of it
    void lookAlong(const geometry::Vector& toward);
    // The shape's axis that is seen best to the right (0), upwards (1), and the third (2).
    [[nodiscard]] geometry::Vector screenAxis(int which) const;
    // Where the chosen point is: a sphere's surface is taken hold of where it was dragged to.
    [[nodiscard]] std::optional<geometry::Vector> chosenPlace() const;

    // The position in this widget of a place of the shape, and the length of a pixel in its middle.
    [[nodiscard]] QPointF position(const geometry::Vector& place) const;
    [[nodiscard]] double pixelLength() const;
    [[nodiscard]] const WindowPicture& picture() const { return picture_; }
    // The place under the pointer, as deep in the picture as `like`; on the grid.
    [[nodiscard]] geometry::Vector placeAt(const QPointF& position,
                                           const geometry::Vector& like) const;

    [[nodiscard]] QSize sizeHint() const override { return {560, 480}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 200}; }

Q_SIGNALS:
    void chosen(std::size_t part, std::size_t point);
    void clicked(std::optional<std::size_t> part); // none: nothing is there
    void dragged(const geometry::Vector& place);   // of the chosen point
    void released();
    void cancelled();
    void addWanted(const geometry::Vector& place);
    void removeWanted(std::size_t part, std::size_t point);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Drawn { // a part as it is drawn
        std::vector<geometry::Vector> points;
        std::vector<bool> inner;
        std::vector<std::vector<geometry::Vector>> edges;
        std::optional<double> radius; // of a sphere
    };
    struct Hit {
        std::size_t part, point;
    };
    struct Press {
        QPointF at;
        bool isClick = false; // unless the pointer leaves that place
    };
    [[nodiscard]] static Drawn drawn(const scene::Part& part);
    [[nodiscard]] gestures::Sight sight() const {
        return {control_.camera(), picture_.pixelSize()};
    }
    [[nodiscard]] PictureWish wish();
    [[nodiscard]] render::Drawing drawing();
    void makeScene(); // a body for each part
    void redraw(bool changed);
    [[nodiscard]] std::optional<Hit> pointAt(const QPointF& position) const;
    [[nodiscard]] QColor colourOf(std::size_t part) const;
    [[nodiscard]] bool isColoured(std::size_t part) const {
        return forLooking_ || !part_ || part_ == part;
    }
    bool clickTriad(const QMouseEvent& event);
    void pressPoint(const QMouseEvent& event, const std::optional<Hit>& hit);
    void click(const QPointF& position);
    void dragTo(const QPointF& position);
    void paintLines(QPainter& painter) const;
    void paintEdges(QPainter& painter) const;
    void paintPoints(QPainter& painter) const;

    std::vector<scene::Part> parts_;
    std::vector<Drawn> drawn_;
    std::vector<geometry::Vector> surface_; // of spheres: the direction of the point on them
    std::optional<std::size_t> part_, point_;
    double grid_ = 0;
    bool forLooking_ = false;
    std::shared_ptr<const scene::Scene> scene_; // null: to be made of the parts
    WindowPicture picture_;
    render::CameraControl control_;
    Press press_;
    std::optional<QPointF> clicked_;       // where the last click was
    std::optional<geometry::Vector> grip_; // the place that is dragged
    QPointF offset_, pointer_;
};

} // namespace views
