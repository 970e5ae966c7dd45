// A change of the text about which the reader has the last word.
//
// The text is shown and read as a gesture's is. Read well, it becomes one step of undo; with
// errors, the text is again as it was, and the first error is told where the change was asked for.
// A change from elsewhere that comes before it is read takes it back.
#pragma once

#include "workbench/scene_document.h"

#include <QObject>

#include <functional>
#include <memory>
#include <string>

namespace views {

class Trial : public QObject {
    Q_OBJECT
public:
    explicit Trial(SceneDocument& document, QObject* parent = nullptr);
    ~Trial() override; // the text is as it was, once nobody is being destroyed any more

    using Told = std::function<void(const QString& why)>; // "": it is a step of undo
    // One at a time: another that has not been read yet is given up.
    void start(const std::string& text, const QString& label, Told told);
    [[nodiscard]] bool isOn() const { return static_cast<bool>(told_); }

private:
    [[nodiscard]] static QString overtaken();
    void look(bool isRead);
    void end(const std::string& text, const QString& why);

    SceneDocument& document_;
    std::string before_, text_;
    QString label_;
    int since_ = 0;
    std::shared_ptr<const char> hand_; // another for each change
    Told told_;
};

} // namespace views
