// A text to be typed in, and below it a line: where the caret is, and what is wrong there, or
// elsewhere in the text; above that line, when it is asked for, one to find words.
#pragma once

#include "source/find_line.h"
#include "source/source_edit.h"

#include <QLabel>

namespace source {

class EditFrame : public QWidget {
    Q_OBJECT

public:
    // `name`: of the objects, NAMEText and NAMEPlace.
    EditFrame(const QString& name, const QString& accessibleName, QWidget* parent);

    [[nodiscard]] SourceEdit& edit() const { return *edit_; }
    void setFaults(const std::vector<LineFault>& faults);
    // The message while nothing is wrong at the caret; "": nothing.
    void setNote(const QString& note);
    // The caret, with the keyboard.
    void goTo(const text::Position& place);

private:
    void tell();

    SourceEdit* edit_;
    FindLine* find_;
    QLabel* place_;
    QString note_;
};

} // namespace source
