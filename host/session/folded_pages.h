// The pages of one view: those of its presentation, without the sections that the view folds.
//
// The view alone knows what is folded: neither the document nor other views do. While nothing is,
// the pages are those that all views share, and cost nothing. Folded pages have the same model less
// some blocks, and begin with the shared pages: what both have is laid out once.
//
// A section is known by a place in its heading, which follows the edits of the document. LIMIT: a
// section that is moved, or whose heading is replaced, unfolds.
#pragma once

#include "document/tracker.h"
#include "excerpts/folding.h"
#include "session/presented.h"

namespace session {

class FoldedPages : public GrowingPages {
    Q_OBJECT

public:
    // The document outlives it. There are no pages before present().
    explicit FoldedPages(OpenDocument& document);
    ~FoldedPages() override;

    // By that presentation from now on; what is folded stays so.
    void present(const QString& presentation);
    [[nodiscard]] const Presented& whole() const { return *whole_; }

    [[nodiscard]] bool isComplete() const override;
    [[nodiscard]] const layout::Pages& pages() const override;
    void settle(int mostMs = std::numeric_limits<int>::max()) override;

Q_SIGNALS:
    // The pages of all views are new, while these are others.
    void wholeChanged();

public:
    // --- what is folded
    // The headings of the sections that a place of the document is in, outer ones first; those that
    // have something under them.
    [[nodiscard]] std::vector<sgml::NodeId> headingsAround(std::size_t place);
    [[nodiscard]] bool isFoldable(sgml::NodeId heading) { return sectionOf(heading) != nullptr; }
    [[nodiscard]] bool isFolded(sgml::NodeId heading) const;
    [[nodiscard]] bool foldsAny() const { return !folds_.empty(); }
    // The range under a heading that is folded.
    [[nodiscard]] model::SectionCounts counts(sgml::NodeId heading);
    // The outermost heading that hides a place of the document; noNode: none does.
    [[nodiscard]] sgml::NodeId hiding(std::size_t place);
    void setFolded(sgml::NodeId heading, bool isFolded);
    void foldAll();
    void unfoldAll();
    // Unfolds the sections that hide a place of the document, or what has that ID; false: none
    // does.
    bool reveal(std::size_t place);
    bool reveal(const std::string& anchor);
    // Unfolds the sections that edits change where nobody sees it: in what is hidden, or in the
    // tags of its heading. True: of some a part would change. One that is selected with its heading
    // is a unit, which is changed knowingly; one that goes or moves as a whole stays folded.
    bool revealTouched(const text::Edits& edits, text::Range selected);

    // Places in the headings that are folded, to be kept and brought back.
    [[nodiscard]] std::vector<std::size_t> places() const;
    void restore(const std::vector<std::size_t>& places);

private:
    using Fold = std::shared_ptr<const document::Tracker::Place>;
    using Sections = std::vector<model::Section>;
    enum class Touched { no, partly, selected };
    [[nodiscard]] Touched isTouched(const model::Section& section, const text::Edits& edits,
                                    text::Range selected) const;
    [[nodiscard]] bool hides() const { return !folds_.empty(); }
    [[nodiscard]] bool step() override;
    void forgetOthers(const Sections& folded);
    void followPages();
    void change(std::vector<Fold> folds);
    void update();
    [[nodiscard]] const Sections& sections();
    [[nodiscard]] Sections foldedSections();
    [[nodiscard]] const model::Section* sectionOf(sgml::NodeId heading);
    [[nodiscard]] sgml::NodeId elementOf(std::size_t block) const;
    [[nodiscard]] Fold foldIn(sgml::NodeId heading) const; // null: there is none
    [[nodiscard]] text::Range bytesUnder(const model::Section& section) const;
    template <class Holds> bool revealWhere(Holds holds);

    OpenDocument& document_;
    document::Tracker tracker_;
    std::shared_ptr<Presented> whole_;
    std::vector<Fold> folds_; // in order of place
    bool isOwn_ = false;      // the pages are not the shared ones
    bool isDue_ = false;      // they are of an older state
    model::Folding folding_;
    std::shared_ptr<const model::Model> read_; // what the sections are of
    Sections sections_;
};

} // namespace session
