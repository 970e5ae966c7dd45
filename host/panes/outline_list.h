// The entries of an outline as a tree, by their levels. In a writing view headings are dragged, and
// go up, down, in and out by keys.
#pragma once

#include "authoring/authoring.h"
#include "excerpts/outline.h"

#include <QTreeWidget>

namespace panes {

class OutlineList : public QTreeWidget {
    Q_OBJECT

public:
    explicit OutlineList(QWidget* parent);

    // Those of one kind. The folds, and the current entry, stay.
    void show(const std::vector<model::Outline::Entry>& entries, model::Outline::Kind kind);
    // Headings may be moved.
    void setMovable(bool on);
    [[nodiscard]] sgml::NodeId current() const; // noNode: none
    // The entry becomes the current one, unless one goes through the list by keys.
    void mark(sgml::NodeId element);
    void select(sgml::NodeId element); // in any case
    // Rows that were made since the list was made, for tests.
    [[nodiscard]] int rowsMade() const { return rowsMade_; }

Q_SIGNALS:
    void wanted(sgml::NodeId element, bool toWrite); // toWrite: the keyboard goes there, too
    void moveWanted(sgml::NodeId heading, authoring::Direction direction);
    void levelWanted(sgml::NodeId heading, int by);
    void dropped(sgml::NodeId heading, sgml::NodeId other, authoring::Beside where);
    void left(); // by Escape

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    [[nodiscard]] static sgml::NodeId elementOf(const QTreeWidgetItem* item);
    [[nodiscard]] bool isSameShape(const std::vector<model::Outline::Entry>& entries) const;
    void fill(const std::vector<model::Outline::Entry>& entries);
    void setText(std::size_t index, const std::string& text);
    void command(const QKeyCombination& keys);

    std::vector<model::Outline::Entry> entries_;
    std::vector<QTreeWidgetItem*> items_; // of the entries
    bool isMovable_ = false;
    int rowsMade_ = 0;
};

} // namespace panes
