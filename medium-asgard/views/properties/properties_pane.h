// The values of what is selected: each option of each kind of element, as the language has them.
//
// The rows come from the language's table of options (element_edits/options.h). A field's change is
// one step of undo and goes the way of a gesture: the number at its place, through a variable, or
// offers where a loop makes it; an empty field removes its option. A value that the reader refuses
// leaves the text as it is, and says why below its field. Of several elements it shows what they
// share. Nothing is done while it is hidden.
#pragma once

#include "element_edits/property_edit.h"
#include "geometry/pose.h"
#include "properties/element_commands.h"
#include "properties/property_head.h"
#include "properties/property_row.h"
#include "properties/trial.h"
#include "workbench/scene_document.h"
#include "workbench/when_read.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QGridLayout;
class QPushButton;
class QVBoxLayout;

namespace views {

struct PropertyActions {
    std::function<void()> showText; // the command of what is selected
    std::function<void(const QString& shape)> openShape;
    std::function<void(std::vector<editing::Element>)> remove; // after asking
};

class PropertiesPane : public QWidget {
    Q_OBJECT
public:
    PropertiesPane(SceneDocument& document, const PropertyActions& actions,
                   QWidget* parent = nullptr);
    ~PropertiesPane() override;

    [[nodiscard]] PropertyRow* row(const std::string& option) const; // null: there is none
    [[nodiscard]] PropertyRow* turn() const { return turn_; }
    [[nodiscard]] PropertyRow* sizeRow() const {
        return size_;
    } // hidden: its shape has no one size
    [[nodiscard]] QLineEdit& name() { return head_->name(); }
    [[nodiscard]] QString title() const { return head_->title(); }
    void begin(); // the keyboard goes to the first value
    // Of the name, or why nothing can be changed.
    [[nodiscard]] QString fault() const { return head_->fault(); }
    // A body without a turn turns about this axis, unless another one is typed: the axis that
    // points at the viewer most, so that the turn is seen in the picture.
    void setUsualAxis(const geometry::Vector& axis);

    [[nodiscard]] QSize sizeHint() const override { return {usualWidth_, 480}; }

Q_SIGNALS:
    void added(const std::vector<editing::Element>& elements); // copies, by its button

protected:
    void showEvent(QShowEvent* event) override;

private:
    [[nodiscard]] const std::vector<editing::Element>& elements() const {
        return document_.selected();
    }
    void buildButtons(QVBoxLayout& column, const PropertyActions& actions);
    [[nodiscard]] QString refusal() const;
    void refresh();
    void rebuild(); // other rows
    void reserveWidth();
    void addTurn(const editing::OptionHint& option);
    [[nodiscard]] bool isOfOneShape() const; // what is selected
    void showHead();
    void showRow(PropertyRow& row);
    [[nodiscard]] QString unitOf(const PropertyRow& row) const;
    void showTurn();
    void addSize(QGridLayout& grid);
    void showSize();
    // Of those parts that are none.
    [[nodiscard]] std::vector<DifferingPart> differingIn(const PropertyRow& row,
                                                         const PropertyParts& shared) const;
    [[nodiscard]] QString faultsAt(const PropertyRow& row) const;
    [[nodiscard]] QString masses() const;
    [[nodiscard]] bool hasMass() const;
    [[nodiscard]] QString absentOf(const editing::OptionHint& option) const;
    [[nodiscard]] QStringList namesFor(editing::Wants wants) const;
    [[nodiscard]] geometry::Vector axisNow() const; // of a turn that is not there yet
    [[nodiscard]] PropertyParts turnParts(const std::vector<editing::Element>& elements,
                                          const editing::OptionHint& option) const;

    struct Entered {
        QPointer<PropertyRow> row; // none: it is gone by now
        const editing::OptionHint* option;
        std::vector<editing::Element> elements;
        PropertyParts parts;
        QString name; // of the one element; "": there are several
    };
    using Enter = void (PropertiesPane::*)(const Entered& entered);
    void listen(PropertyRow& row, Enter enter);
    void take(Entered entered, const Follow& now, Enter enter);
    void set(const Entered& entered);
    void setTurn(const Entered& entered);
    void setSize(const Entered& entered);
    void write(const Entered& entered, const PropertyParts& parts);
    void tryEdits(const Entered& entered, const editing::Answer& found, const QString& label);
    void tryText(const Entered& entered, const text::Edits& edits, const QString& label);
    void answer(const Entered& entered, const QString& why); // "": it is taken

    SceneDocument& document_;
    ElementCommands commands_;
    Trial trial_;
    WhenRead later_;
    QTimer soon_;
    std::unique_ptr<editing::Properties> properties_; // of the scene that is shown
    std::vector<const editing::OptionHint*> options_;
    std::vector<PropertyRow*> rows_;
    PropertyRow* turn_ = nullptr; // the attitude in degrees
    struct Axis {
        geometry::Vector usual = geometry::Vector::UnitZ();
        std::optional<geometry::Vector> typed; // before its degrees
    };
    Axis axis_;
    PropertyRow* size_ = nullptr; // of the shape
    QWidget* form_ = nullptr;
    int usualWidth_ = 300;
    std::vector<editing::Element> shown_;
    PropertyHead* head_ = nullptr;
    QWidget* buttons_ = nullptr;
    QPushButton* shape_ = nullptr;
};

} // namespace views
