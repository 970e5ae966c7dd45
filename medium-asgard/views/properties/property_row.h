// One option of the selected elements as a row of a form: its caption, a field of the right kind,
// and below it why a value was not taken, with what can be done instead.
//
// A field gives its value as frame/typed_field.h says. Each has a state of its own: what somebody
// types in one stays while another is answered.
#pragma once

#include "editing/value_edit.h"
#include "element_edits/options.h"
#include "workbench/scene_document.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class QComboBox;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QToolButton;
class QVBoxLayout;
class QWidget;

namespace views {

using PropertyParts = std::vector<std::optional<std::string>>;

// A part that differs between the elements: in a few signs, and in a line for each of them.
struct DifferingPart {
    QString brief, each;
};

class PropertyRow : public QObject {
    Q_OBJECT
public:
    // In the next lines of a grid with two columns. `most` parts at once.
    PropertyRow(const SceneDocument& document, const editing::OptionHint& option,
                const QString& caption, std::size_t most, QGridLayout& grid, QObject* parent);

    // That three numbers take side by side, as a rule or at least.
    [[nodiscard]] static int widthOfFields(const QWidget& form, bool atLeast);

    [[nodiscard]] const editing::OptionHint& option() const { return option_; }
    // Parts that are none differ between the elements. `absent`: shown in place of empty ones.
    // A text that somebody is typing stays.
    void show(const PropertyParts& parts, const QString& absent, const QString& source,
              const std::vector<DifferingPart>& differing = {});
    [[nodiscard]] const PropertyParts& shown() const { return shown_; }
    void setChoices(const QStringList& choices); // of names
    void setNames(const QStringList& names);     // of its parts, in place of x, y and z
    void setUnit(const QString& unit);           // beside its caption; "": none
    void setVisible(bool visible);
    void setEnabled(bool enabled);
    void setNote(const QString& note);     // about the value that stands there; "": none
    void setRemark(const QString& remark); // below it while there is no fault; "": none
    void setOffers(const std::string& text, const std::vector<editing::Offer>& offers,
                   const std::function<void(const text::Edits& edits)>& take);
    // The answers to entered(): the parts are the value now, or why they are not.
    void taken(const PropertyParts& entered);
    void refuse(const PropertyParts& entered, const QString& why);
    void forget();                       // what was typed was meant for others
    [[nodiscard]] QString fault() const; // or the note
    // The caption and why the value that was typed is none; "": nobody refused one.
    [[nodiscard]] QString refusal() const {
        return refused_.empty() ? QString() : name_ + QStringLiteral(": ") + why_;
    }

    [[nodiscard]] const std::vector<QLineEdit*>& fields() const { return fields_; }
    [[nodiscard]] QComboBox* box() const { return box_; }

Q_SIGNALS:
    void entered(const views::PropertyParts& parts); // those that were changed

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addFields(const SceneDocument& document, QHBoxLayout& line, const QString& caption,
                   std::size_t most);
    void addBox(QHBoxLayout& line, const QString& caption);
    void addColorButton(QHBoxLayout& line);
    void chooseColor();
    void showColor();
    void finish(bool asked);
    void setFault(const QString& why);
    void showFault();
    void bringBack(QLineEdit& field);

    const editing::OptionHint& option_;
    PropertyParts shown_;
    PropertyParts entered_; // and not answered
    PropertyParts refused_;
    QString name_; // its caption without the unit
    QString why_, note_, remark_;
    std::vector<QLineEdit*> fields_;
    QComboBox* box_ = nullptr;
    QToolButton* color_ = nullptr;
    QLabel *caption_, *fault_;
    QVBoxLayout* offers_;
};

} // namespace views
