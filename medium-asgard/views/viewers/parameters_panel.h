// Sliders for the scene's parameters: what one drags is the number in the text.
//
// A drag is one step of undo, a press of a key another. A parameter without -min and -max goes from
// 0 to twice its value. One whose number cannot be rewritten says why.
#pragma once

#include "editing/value_edit.h"
#include "workbench/scene_document.h"

#include <QGroupBox>
#include <QLabel>
#include <QSlider>

#include <memory>

class QVBoxLayout;

namespace views {

class ParametersPanel : public QGroupBox {
    Q_OBJECT
public:
    explicit ParametersPanel(SceneDocument& document, QWidget* parent = nullptr);

    [[nodiscard]] QSlider* slider(const QString& parameter) const; // null: there is none
    [[nodiscard]] std::optional<Asked> asked() const;              // by the slider that is dragged

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Row {
        std::string name;
        QLabel* value;
        QSlider* slider;
        double least = 0, most = 1;
        std::string unit;
    };
    struct Drag { // of the text as it was when it began
        int since;
        std::string text;
        std::shared_ptr<const scene::Scene> scene;
        editing::Mapper mapper;
        editing::Answer last; // that was possible
        [[nodiscard]] std::string wanted() const { return text::applied(text, last.edits); }
    };
    void refresh();
    void rebuild();
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
    // Parameter and value, once the scene is read.
    std::optional<std::pair<std::string, double>> wanted_;
};

} // namespace views
