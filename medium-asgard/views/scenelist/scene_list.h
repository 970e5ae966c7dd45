// The elements of a scene as a list, in step with the selection of all views.
//
// By kind, or as the text has them. A field narrows the list; F2 or a slow second click renames an
// element wherever the text mentions it; a double click asks for its values; the right button has
// the menu of the picture. Nothing is done while it is hidden.
#pragma once

#include "properties/element_commands.h"
#include "workbench/scene_document.h"

#include <QTimer>
#include <QTreeWidget>
#include <QWidget>

#include <functional>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;

namespace views {

struct SceneListActions {
    std::function<void(const editing::Element&)> openValues;
    std::function<void(const editing::Element&, const QPoint& global)> showMenu;
    std::function<void(std::vector<editing::Element>)> remove; // after asking
    // Whether the picture shows a body; none: nothing can be hidden.
    std::function<bool(const editing::Element&)> isHidden = {};
    std::function<void(const editing::Element&, bool hidden)> hide = {};
};

class SceneList : public QWidget {
    Q_OBJECT
public:
    SceneList(SceneDocument& document, SceneListActions actions, QWidget* parent = nullptr);

    [[nodiscard]] QTreeWidget& tree() { return *tree_; }
    [[nodiscard]] QLineEdit& filter() { return *filter_; }
    [[nodiscard]] QComboBox& order() { return *order_; }
    [[nodiscard]] QTreeWidgetItem* itemOf(const editing::Element& element) const; // or null
    [[nodiscard]] QString fault() const;
    void showHidden(); // another body is hidden, or shown again

    [[nodiscard]] QSize sizeHint() const override { return {220, 400}; }

protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Entry {
        editing::Element element;
        QString label, group;
        QString tip;
        std::size_t place; // among the entries, as the text has them
        QRgb color;        // 0: none
        bool operator==(const Entry&) const = default;
    };
    void buildTree();
    [[nodiscard]] std::vector<Entry> entries() const;
    void refresh();
    void rebuild();
    QTreeWidgetItem* addEntry(const Entry& entry, QTreeWidgetItem* group);
    void narrow();
    void showSelection();
    void takeSelection();
    void rename(QTreeWidgetItem* item);
    void showEye(QTreeWidgetItem* item);
    void say(const QString& why);

    SceneDocument& document_;
    SceneListActions actions_;
    ElementCommands commands_;
    QTimer soon_;
    std::vector<Entry> entries_;
    bool isBuilding_ = false; // signals of the tree are not the user's
    QLineEdit* filter_;
    QComboBox* order_;
    QTreeWidget* tree_;
    QLabel* fault_;
};

} // namespace views
