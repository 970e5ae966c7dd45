// A part of a document for screen readers: what it is, its name, where it stands, what is in it.
#pragma once

#include "reading/reading_tree.h"

#include <QAccessible>

namespace accessibility {

class AccessibleView;

class AccessiblePart : public QAccessibleInterface {
public:
    // One for each part, made when it is asked for; gone with the part.
    [[nodiscard]] static QAccessibleInterface* of(AccessibleView& root, reading::Part& part);

    [[nodiscard]] reading::Part& part() const { return part_; }

    [[nodiscard]] bool isValid() const override { return true; }
    [[nodiscard]] QObject* object() const override { return nullptr; }
    [[nodiscard]] QWindow* window() const override;
    [[nodiscard]] QAccessibleInterface* parent() const override;
    [[nodiscard]] QAccessibleInterface* child(int index) const override;
    [[nodiscard]] int childCount() const override;
    [[nodiscard]] int indexOfChild(const QAccessibleInterface* child) const override;
    [[nodiscard]] QAccessibleInterface* childAt(int x, int y) const override;
    [[nodiscard]] QAccessible::Role role() const override;
    [[nodiscard]] QAccessible::State state() const override;
    [[nodiscard]] QString text(QAccessible::Text of) const override;
    void setText(QAccessible::Text, const QString&) override {}
    [[nodiscard]] QRect rect() const override; // of the screen

protected:
    AccessiblePart(AccessibleView& root, reading::Part& part) : root_(root), part_(part) {}
    [[nodiscard]] AccessibleView& root() const { return root_; }
    [[nodiscard]] const std::vector<std::unique_ptr<reading::Part>>& parts() const;
    [[nodiscard]] const document::Document& document() const;
    // Of the viewport to the screen.
    [[nodiscard]] QRect onScreen(const QRectF& rect) const;

private:
    [[nodiscard]] QString name() const;
    [[nodiscard]] document::SubdocumentId subdocument() const;
    [[nodiscard]] const model::Run* run() const; // of a part of a line

    AccessibleView& root_;
    reading::Part& part_;
};

// The action of Enter or a click: a link is followed, a figure becomes the active one.
class AccessibleActivePart : public AccessiblePart, public QAccessibleActionInterface {
public:
    AccessibleActivePart(AccessibleView& root, reading::Part& part) : AccessiblePart(root, part) {}

    [[nodiscard]] void* interface_cast(QAccessible::InterfaceType type) override;
    [[nodiscard]] QStringList actionNames() const override;
    void doAction(const QString& name) override;
    [[nodiscard]] QStringList keyBindingsForAction(const QString&) const override { return {}; }
};

} // namespace accessibility
