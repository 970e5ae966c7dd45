// Sliders for the scene's parameters and for the motors of its joints: what one drags is the number
// in the text.
//
// A drag is one step of undo, a press of a key another. A parameter without -min and -max goes from
// 0 to twice its value, a -motor or -speed that is a number as far backwards as forwards. One whose
// number cannot be rewritten says why.
#pragma once

#include "editing/value_edit.h"
#include "workbench/scene_document.h"

#include <QLabel>
#include <QSlider>
#include <QWidget>

#include <memory>

class QVBoxLayout;

namespace views {

class ParametersPanel : public QWidget {
    Q_OBJECT
public:
    explicit ParametersPanel(SceneDocument& document, QWidget* parent = nullptr);

    [[nodiscard]] bool isEmpty() const { return rows_.empty(); }
    [[nodiscard]] QString title() const; // by what its sliders set
    // Of a parameter; of a joint's option by "pin -speed". Null: there is none.
    [[nodiscard]] QSlider* slider(const QString& name) const;
    [[nodiscard]] std::optional<Asked> asked() const; // by the slider that is dragged

Q_SIGNALS:
    void rebuilt(); // other sliders

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    // What a slider sets.
    struct Control {
        std::string name; // of the parameter; "pin -speed"
        QString label;
        std::string unit;
        editing::Element element;
        std::string option;
        double value = 0;
        double least = 0, most = 1;
        bool isWide = false; // the ends are ours: they stay as wide as they were
    };
    struct Row {
        Control of;
        QLabel* value;
        QSlider* slider;
    };
    [[nodiscard]] static std::vector<Control> controlsOf(const scene::Scene& scene);
    struct Drag { // of the text as it was when it began
        int since;
        std::string text;
        std::shared_ptr<const scene::Scene> scene;
        editing::Mapper mapper;
        editing::Answer last; // that was possible
        [[nodiscard]] std::string wanted() const { return text::applied(text, last.edits); }
    };
    void refresh();
    void rebuild(const std::vector<Control>& controls);
    void show(Row& row, double value);
    [[nodiscard]] static QString valueText(const Row& row, double value);
    [[nodiscard]] static int positionOf(const Row& row, double value);
    [[nodiscard]] static double valueOf(const Row& row, int position);
    void moved(std::size_t row, int position);
    void begin();
    void finish(std::size_t row);
    [[nodiscard]] editing::Answer asked(const editing::Mapper& mapper, std::size_t row,
                                        double value) const;

    SceneDocument& document_;
    QVBoxLayout* column_;
    QWidget* content_ = nullptr;
    std::vector<Row> rows_;
    std::unique_ptr<Drag> drag_;
    bool refreshing_ = false;
    // Name and value, once the scene is read.
    std::optional<std::pair<std::string, double>> wanted_;
};

} // namespace views
