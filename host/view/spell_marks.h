// Wavy lines under the words of a writing view that are not spelled right.
//
// The words that are seen are checked a little at a time between other events, once the view has
// rested; no key waits for it. Answers are kept by paragraph, so a letter costs the words of its
// paragraph. The word at the caret is not marked while it is typed.
#pragma once

#include "layout/pages.h"
#include "spelling/speller.h"
#include "text/edit.h"

#include <QPainter>
#include <QTimer>

#include <map>

namespace view {

class DocumentView;

class SpellMarks : public QObject {
    Q_OBJECT

public:
    // The view outlives it.
    explicit SpellMarks(DocumentView& view);

    // Null: nothing is checked.
    void use(std::shared_ptr<spelling::Speller> speller);
    [[nodiscard]] spelling::Speller* speller() const { return speller_.get(); }

    struct Wrong {
        QString word;
        text::Range place; // in the document
    };
    // At a point of the viewport.
    [[nodiscard]] std::optional<Wrong> wrongAt(QPointF point) const;
    // Another word is right from now on.
    void checkAnew();
    // Words that are marked on the pages that are seen, for tests.
    [[nodiscard]] std::size_t count() const;

private:
    struct Checked {
        std::shared_ptr<const paragraphs::Paragraph> paragraph;
        std::vector<spelling::Word> wrong;
    };
    using Paragraphs = std::map<const paragraphs::Paragraph*, Checked>;
    void paint(QPainter& painter, std::size_t page) const;
    void checkSoon();
    void checkSome();
    [[nodiscard]] std::pair<std::size_t, std::size_t> seen() const; // pages [first, second)
    [[nodiscard]] std::vector<spelling::Word> wrongOf(const paragraphs::Paragraph& paragraph) const;
    [[nodiscard]] std::optional<text::Range> placeOf(const paragraphs::Paragraph& paragraph,
                                                     spelling::Word word) const;
    [[nodiscard]] bool isBeingTyped(const paragraphs::Paragraph& paragraph,
                                    spelling::Word word) const;

    DocumentView& view_;
    std::shared_ptr<spelling::Speller> speller_;
    Paragraphs checked_;
    QTimer timer_;
};

} // namespace view
