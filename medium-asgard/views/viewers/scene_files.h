// The file of a stand-alone session: opened, saved, exported, and never lost unasked.
#pragma once

#include "viewers/exports.h"
#include "workbench/scene_document.h"

#include <QObject>
#include <QPointer>

#include <functional>

class QWidget;

namespace views {

class SceneFiles : public QObject {
    Q_OBJECT
public:
    // `settleDrafts` asks about each draft of the text; `takeDrafts` makes them the text without
    // asking. Both give false when the user has to choose first.
    struct Drafts {
        std::function<bool()> settleDrafts, takeDrafts;
    };
    SceneFiles(SceneDocument& document, Drafts drafts, QObject* parent = nullptr);

    // Another scene in place of the present one; asks first when that would lose changes. All
    // dialogs belong to the active window, which has the keyboard afterwards. False: it stays.
    bool newScene(const std::string& text = {}, const QString& name = {});
    bool open();
    bool open(const QString& path);
    bool save(); // what is typed, too
    bool saveAs();
    // Nothing would be lost, or the user agreed to what is. False, too, while one is asked that.
    bool mayLeave();
    [[nodiscard]] Exports& exports() { return *exports_; }

private:
    bool saveTo(const QString& path, QPointer<QWidget> from);

    SceneDocument& document_;
    Drafts drafts_;
    Exports* exports_;
    bool isLeaving_ = false;
};

} // namespace views
