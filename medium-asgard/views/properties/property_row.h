// One option of the selected elements as a row of a form: its caption, a field of the right kind,
// and below it why a value was not taken, with what can be done instead.
//
// A field gives its value on Return, or when the keyboard leaves it; Escape brings back what was
// there.
#pragma once

#include "editing/options.h"
#include "editing/value_edit.h"

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

namespace views {

using PropertyParts = std::vector<std::optional<std::string>>;

class PropertyRow : public QObject {
    Q_OBJECT
public:
    // In the next lines of a grid with two columns. `most` parts at once.
    PropertyRow(const editing::OptionHint& option, const QString& caption, std::size_t most,
                QGridLayout& grid, QObject* parent);

    [[nodiscard]] const editing::OptionHint& option() const { return option_; }
    // Parts that are none differ between the elements. `absent`: shown in place of empty ones.
    // What somebody is typing stays.
    void show(const PropertyParts& parts, const QString& absent, const QString& source);
    void setChoices(const QStringList& choices); // of names
    void setNames(const QStringList& names);     // of its parts, in place of x, y and z
    void setVisible(bool visible);
    void setEnabled(bool enabled);
    void setFault(const QString& why);     // that what was entered is not taken; "": none
    void setNote(const QString& note);     // about the value that stands there; "": none
    void setRemark(const QString& remark); // below it while there is no fault; "": none
    void setOffers(const std::string& text, const std::vector<editing::Offer>& offers,
                   const std::function<void(const text::Edits& edits)>& take);
    void taken();                        // what was typed is the value now
    [[nodiscard]] QString fault() const; // or the note
    [[nodiscard]] bool isTyped() const;

    [[nodiscard]] const std::vector<QLineEdit*>& fields() const { return fields_; }
    [[nodiscard]] QComboBox* box() const { return box_; }

Q_SIGNALS:
    void entered(const views::PropertyParts& parts); // those that were changed

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addFields(QHBoxLayout& line, const QString& caption, std::size_t most);
    void addBox(QHBoxLayout& line, const QString& caption);
    void addColorButton(QHBoxLayout& line);
    void chooseColor();
    void showColor();
    void finish();
    void showFault();
    void bringBack();

    const editing::OptionHint& option_;
    PropertyParts shown_;
    PropertyParts refused_; // as it was entered
    QString why_, note_, remark_;
    std::vector<QLineEdit*> fields_;
    QComboBox* box_ = nullptr;
    QToolButton* color_ = nullptr;
    QLabel *caption_, *fault_;
    QVBoxLayout* offers_;
};

} // namespace views
