// The outline of a document beside its pages: headings, or figures, or tables. A click goes there;
// the entry that one reads is the current one. In a writing view the headings move their sections.
#pragma once

#include "authoring/authoring.h"
#include "excerpts/outline.h"
#include "view/document_view.h"

#include <QDockWidget>
#include <QTimer>

class QComboBox;

namespace panes {

class OutlineList;

class OutlinePane : public QDockWidget {
    Q_OBJECT

public:
    OutlinePane(view::DocumentView& view, QWidget* parent);

    [[nodiscard]] OutlineList& list() const { return *list_; }
    [[nodiscard]] const model::Outline& outline() const { return outline_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void followSoon();
    void follow();
    void fill();
    void mark();
    [[nodiscard]] sgml::NodeId entryAt(std::size_t place) const;
    void goTo(sgml::NodeId element, bool toWrite);
    // A command that moves a section, whose entry is the current one then.
    using Command = std::function<authoring::Result(const authoring::Manuscript&)>;
    void move(const Command& command);

    view::DocumentView& view_;
    OutlineList* list_;
    QComboBox* kind_;
    model::Outline outline_;
    QTimer timer_;
};

} // namespace panes
