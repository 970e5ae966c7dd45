// The picture of a formula that is being written.
#pragma once

#include "formulas/typeset.h"

#include <QWidget>

#include <optional>

namespace menus {

// How a formula looks, as large as its room allows, with a frame for each part that is empty.
class FormulaPreview : public QWidget {
    Q_OBJECT

public:
    explicit FormulaPreview(QWidget* parent = nullptr);

    void show(formulas::Formula formula, formulas::Style style);

    // The place of the part that waits to be written and begins there in the source; tests click
    // it.
    [[nodiscard]] std::optional<QPointF> frameAt(std::size_t place) const;

Q_SIGNALS:
    void wantsToWrite(std::size_t place); // a click in an empty part

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    struct Laid {
        formulas::Box box;
        QPointF at; // of its origin
    };
    [[nodiscard]] std::optional<Laid> laid() const; // nothing: no font, or nothing to show
    [[nodiscard]] std::optional<std::size_t> placeAt(QPointF point) const;

    formulas::Formula formula_;
    formulas::Style style_ = formulas::Style::text;
};

} // namespace menus
