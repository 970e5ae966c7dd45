// Commands for the selected elements as a whole: copies, other names.
#pragma once

#include "properties/trial.h"

#include <optional>
#include <string>

namespace views {

class ElementCommands : public QObject {
    Q_OBJECT
public:
    explicit ElementCommands(SceneDocument& document, QObject* parent = nullptr);

    bool copy();      // their commands as text, to the clipboard; false: why not was told
    void paste();     // from it; what is new is selected
    void duplicate(); // beside them; the clipboard stays as it is
    // `told` hears why not, or "".
    void rename(const editing::Element& element, const QString& name, Trial::Told told);

Q_SIGNALS:
    void refused(const QString& why);
    void added(const std::vector<editing::Element>& elements); // of a paste; they are selected

private:
    // The commands of the selected elements; none: why not was told.
    [[nodiscard]] std::optional<std::string> copied(const QString& nothing);
    void put(const std::string& commands, const QString& label);

    SceneDocument& document_;
    Trial trial_;
};

} // namespace views
