// The pages of a document on the screen, with live renditions on them.
//
// Text is painted at once; renditions appear when their media have drawn. A view has the pages of
// its presentation, which other views may have, too, and a zoom and renditions of its own; the
// medium's process is the document's; and it folds sections of its own. When pages change, the
// words at the top of the view stay there. Clicking a rendition chooses it: the wheel and the keys
// then belong to it, Escape gives them back.
#pragma once

#include "layout/paint.h"
#include "onpage/found_words.h"
#include "onpage/page_places.h"
#include "places/carets.h"
#include "places/spot.h"
#include "session/open_document.h"

#include <QAbstractScrollArea>
#include <QTimer>

namespace view {

class ChosenFigure;
class Figures;
class Folds;
class TextDrag;
class TextHand;
class Writing;

// The reader's place: a place of the document's bytes, and how far the top of its line is below the
// top of the view, in twips.
struct ReadingPlace {
    std::size_t place = 0;
    double below = 0;
};

class DocumentView : public QAbstractScrollArea {
    Q_OBJECT

public:
    DocumentView(session::OpenDocument& document, QWidget* parent = nullptr);
    ~DocumentView() override;

    [[nodiscard]] const QString& presentation() const { return presentation_; }
    void setPresentation(const QString& name);
    [[nodiscard]] double zoom() const { return zoom_; }
    // The middle of the view stays where it is, and at its top the top of the document.
    void setZoom(double zoom);
    void zoomBy(int steps);
    [[nodiscard]] double widthZoom() const; // at which a page is as wide as the view
    [[nodiscard]] double pageZoom() const;  // at which a page is seen whole
    [[nodiscard]] double usualZoom() const; // the presentation's, if that is no wider than the view
    [[nodiscard]] Spread spread() const { return spread_; }
    void setSpread(Spread spread); // the page at the top stays there

    [[nodiscard]] document::SubdocumentId chosen() const;
    void choose(document::SubdocumentId id);
    [[nodiscard]] std::vector<document::SubdocumentId> visibleSubdocuments() const;
    [[nodiscard]] media::Rendition* rendition(document::SubdocumentId id) const;
    [[nodiscard]] QRectF placeOf(document::SubdocumentId id) const; // in the viewport
    // As much of it as is seen; none: nothing is, or the window system does not tell where.
    [[nodiscard]] std::optional<ipc::ScreenArea> screenAreaOf(document::SubdocumentId id) const;
    // Of a formula; nothing: it is on no page. Takes a look at every page.
    [[nodiscard]] std::optional<QRectF> placeOfFormula(sgml::NodeId element) const;
    void scrollTo(document::SubdocumentId id);

    [[nodiscard]] session::OpenDocument& document() const { return document_; }
    // The page at or nearest to a height of the viewport, and that point on it in twips; there is
    // a page. And back.
    [[nodiscard]] std::pair<std::size_t, QPointF> pagePointAt(QPointF point) const;
    [[nodiscard]] QRectF inViewport(std::size_t page, const QRectF& twips) const;
    [[nodiscard]] const model::Run* runAt(QPointF point) const; // of the viewport; null: none
    // The first page that is seen, and the one behind the last.
    [[nodiscard]] std::pair<std::size_t, std::size_t> seenPages() const;
    // Shows the document as it is now, where edits came that are not laid out yet.
    void settle();
    void settleSoon(); // the same, for as long as nobody notices; the rest follows
    // As it was when the pages were made; null: they are being made.
    // All of it, with what is folded.
    [[nodiscard]] std::shared_ptr<const model::Model> model() const;
    [[nodiscard]] Folds& folds() const { return *folds_; }

    // --- the text that is selected
    [[nodiscard]] TextHand& text() const { return *text_; }
    [[nodiscard]] bool canCopy() const; // a figure that is chosen, else what is selected
    void copy();
    [[nodiscard]] ChosenFigure& chosenFigure() const;
    void selectAll();

    // --- writing: a matter of the view, not of the document
    [[nodiscard]] bool isWriting() const;
    void setWriting(bool on);
    [[nodiscard]] Writing& writing() const { return *writing_; }

    // Marks the words wherever they stand, also when the document changes, and shows the first of
    // them at or below what is seen; "": none any more.
    void find(const places::Search& search);
    void find(const QString& words) { find(places::Search{words}); }
    [[nodiscard]] const FoundWords& found() const { return found_; }
    [[nodiscard]] int foundCount() const { return static_cast<int>(found_.finder().count()); }
    [[nodiscard]] int shownFound() const { return static_cast<int>(found_.shown()); }
    void showFound(int which);             // around the ends
    void showFoundFrom(std::size_t place); // the first one at or behind a place of the document

    // --- where one reads
    // Nothing: no text is laid out.
    [[nodiscard]] std::optional<ReadingPlace> readingPlace() const;
    void show(const ReadingPlace& place);
    [[nodiscard]] std::size_t currentPage() const; // in the middle of the view
    // These tell that they jump.
    void goTo(std::size_t place); // to the top of the view, and the caret of a writing view
    void goToElement(sgml::NodeId element); // the same; of a figure its picture is seen, too
    void goToPage(std::size_t page);
    void follow(const QString& target); // of a link: "#" and an ID, or an address

    // So far: a long document is laid out while its first pages are shown.
    [[nodiscard]] const layout::Pages& pages() const { return pages_; }
    [[nodiscard]] bool isLaidOut() const;
    [[nodiscard]] const QString& title() const; // when it is
    // Pages that were painted since the view was made, for tests.
    [[nodiscard]] int pagesPainted() const { return pagesPainted_; }

    static constexpr double leastZoom = 0.25, mostZoom = 5;

Q_SIGNALS:
    void chosenChanged();
    void visibleChanged();
    void zoomChanged();
    void laidOut();
    void contextMenuWanted(document::SubdocumentId id, const QPoint& global);
    void textMenuWanted(const QPoint& global);
    void writingChanged(bool on);
    // By a letter, or by a double click in its text, while it is for reading.
    void triedToWrite();
    void selectionChanged(); // or what may be done with it
    void focusChanged();
    void linkActivated(const QString& target);
    // A formula, a value or a reference: by a double click, or by Return where it is selected
    // alone, while it is written.
    void elementActivated(sgml::NodeId element, schemas::Display as);
    void unhandledKey(int key, Qt::KeyboardModifiers modifiers);
    // Before the view goes far away from where one reads, and after it has.
    void jumping(bool isSearch);
    void jumped();
    // Its text is painted; in twips.
    void paintingPage(QPainter& painter, std::size_t page);

protected:
    bool event(QEvent* event) override;
    void inputMethodEvent(QInputMethodEvent* event) override;
    [[nodiscard]] QVariant inputMethodQuery(Qt::InputMethodQuery query) const override;
    bool viewportEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    [[nodiscard]] double scale() const; // logical pixels to a twip
    [[nodiscard]] PagePlaces places() const;
    [[nodiscard]] double topOf(sgml::NodeId element, const places::Caret& caret) const;
    void jumpTo(const places::Carets& carets, const places::Caret& caret, double top);
    void scrollBy(double pixels);
    [[nodiscard]] QSizeF pageSize() const;
    [[nodiscard]] QPointF pageTopLeft(std::size_t page) const;
    [[nodiscard]] const model::Run* linkAt(QPointF point) const;

    void present();
    void showPages();
    void showChanged(const layout::Pages& before);
    void setScrollBars();
    void paintPages(QPainter& painter, const QRect& area);
    [[nodiscard]] QImage imageOf(const layout::ImagePiece& piece);
    void followFound();
    void paintFound(QPainter& painter, std::size_t page) const;
    void useKey(int key, Qt::KeyboardModifiers modifiers);
    void pasteSelection(const QMouseEvent& event);
    void updateCursor(QPointF point);

    struct Press { // of a button, the last one
        QPointF at;
        bool wasDragged = false;
    };

    session::OpenDocument& document_;
    QString presentation_;
    double zoom_ = 1;
    std::unique_ptr<Folds> folds_;
    layout::Pages pages_; // that are shown
    int pagesPainted_ = 0;
    FoundWords found_;
    Spread spread_ = Spread::column;
    Press press_;
    bool wasShown_ = false;
    std::unique_ptr<Figures> figures_;
    std::unique_ptr<TextHand> text_;
    std::unique_ptr<Writing> writing_;
    std::unique_ptr<TextDrag> drag_;
    bool isBehind_ = false; // edits came that are not laid out
};

} // namespace view
