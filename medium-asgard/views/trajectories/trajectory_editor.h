// The trajectory editor (dissertation 4.1.4, Figure 4.4): three graphs of a trajectory's components
// against time, whose points and tangents are dragged, and the points as a table. One for each
// scene; the text follows.
#pragma once

#include "trajectories/trajectory_drag.h"
#include "trajectories/trajectory_graph.h"

#include <QMainWindow>

#include <array>
#include <memory>

class QAction;
class QComboBox;
class QLabel;

namespace views {

class HintLine;
class PointTable;

class TrajectoryEditor : public QMainWindow {
    Q_OBJECT
public:
    explicit TrajectoryEditor(SceneDocument& document);

    void showTrajectory(const QString& name); // and not another
    void setNow(std::optional<double> time);

    [[nodiscard]] QString trajectory() const;
    [[nodiscard]] TrajectoryGraph& graph(int component) { return *graphs_[at(component)]; }
    [[nodiscard]] PointTable& points() { return *table_; }
    [[nodiscard]] std::optional<std::size_t> chosen() const { return chosen_; }
    [[nodiscard]] QString words() const;              // of the line below the graphs
    [[nodiscard]] std::optional<Asked> asked() const; // by what is dragged

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    using Place = geometry::Vector;
    static std::size_t at(int component) { return static_cast<std::size_t>(component); }

    void buildMenus();
    void buildTools();
    QWidget* buildTable();
    void connectGraph(TrajectoryGraph* graph);
    void followScene(); // another text or another scene
    void showCurves();  // and the points of the present gesture
    void fitTimes();
    void zoomTimes(double factor);
    void setTimes(double from, double to);
    void choose(std::optional<std::size_t> point);
    void chooseNext(int direction);
    [[nodiscard]] std::optional<std::size_t> index() const; // of the trajectory in the scene
    void finishGesture();
    [[nodiscard]] bool begin(); // a gesture; false: the scene is not the text's
    void drag(int component, double time, double value, Qt::KeyboardModifiers modifiers);
    void nudge(int component, double times, double values);
    void setFromCell(std::size_t point, int column, const QString& text);
    void addAt(int component, double time, double value);
    void addAfterChosen();
    void removeChosen();
    void showMenu(int component, const QPoint& position, std::optional<std::size_t> point,
                  double time, double value);
    void tell(const QString& words, bool isFault = false);
    [[nodiscard]] QString roleOf(const scene::Trajectory& trajectory) const;
    [[nodiscard]] QString unitOf(const scene::Trajectory& trajectory) const;

    SceneDocument& document_;
    QComboBox* names_;
    QLabel* role_;
    HintLine* words_;
    std::array<TrajectoryGraph*, 3> graphs_{};
    PointTable* table_;
    QAction *add_ = nullptr, *remove_ = nullptr;
    std::unique_ptr<TrajectoryDrag> gesture_;
    std::optional<std::size_t> chosen_;
    std::optional<double> chooseAt_; // the time of a point that is on its way through the text
    QString shownName_;
    double from_ = 0, to_ = 1;
};

} // namespace views
