// The subdocuments on the pages of a view: a rendition of each that is near, the one that is
// chosen, those that are seen, and the play bar over the one below the pointer.
#pragma once

#include "layout/pages.h"
#include "onpage/shown.h"

#include <QCursor>
#include <QMouseEvent>
#include <QTimer>

#include <map>
#include <optional>
#include <vector>

namespace controls {
class PlayBar;
}

namespace view {

class DocumentView;

class Figures : public QObject {
    Q_OBJECT

public:
    // The view outlives it. Points and places are in its viewport.
    explicit Figures(DocumentView& view);
    ~Figures() override; // the view needs no medium any more

    [[nodiscard]] document::SubdocumentId chosen() const { return chosen_; }
    void choose(document::SubdocumentId id);
    // In the order of their places.
    [[nodiscard]] const std::vector<document::SubdocumentId>& visible() const { return visible_; }
    [[nodiscard]] media::Rendition* rendition(document::SubdocumentId id) const;
    [[nodiscard]] QRectF placeOf(document::SubdocumentId id) const;
    [[nodiscard]] bool isAt(QPointF point) const { return at(point) != nullptr; }

    void takePlaces(); // that the pages have for them now
    void follow();     // the places in the viewport are others, or the view was shown or hidden
    void fit();        // renditions are as large as their places
    void fitSoon();
    void paint(QPainter& painter, const QRect& area);

    // --- pointer and keys
    bool press(const QMouseEvent& event); // chooses what is there; false: nothing is
    void move(const QMouseEvent& event);
    // The one that had the button; none: noSubdocument. It has it until letGo().
    document::SubdocumentId release(const QMouseEvent& event);
    void letGo() { grabbed_ = document::noSubdocument; }
    [[nodiscard]] bool isHeld() const { return grabbed_ != document::noSubdocument; }
    bool turnWheel(const QWheelEvent& event); // false: it is for the view
    void leave();
    // Of the medium; nothing: the pointer is not the medium's.
    [[nodiscard]] std::optional<QCursor> cursorAt(QPointF point) const;

Q_SIGNALS:
    void chosenChanged();
    void visibleChanged();
    void cursorChanged();                                     // of the one below the pointer
    void unusedKey(int key, Qt::KeyboardModifiers modifiers); // by the medium

private:
    [[nodiscard]] const Shown* at(QPointF point) const;
    [[nodiscard]] QRectF placeOf(const Shown& shown) const;
    [[nodiscard]] QPointF pixelsIn(const Shown& shown, QPointF point) const;
    void connectShown(Shown& shown);
    void connectPlayBar();
    void updateNearness();
    void fitOne(Shown& shown);
    void paintAgain(document::SubdocumentId id);
    void updatePlayBar();

    DocumentView& view_;
    session::OpenDocument& document_;
    std::map<document::SubdocumentId, Shown> shown_;
    document::SubdocumentId chosen_ = document::noSubdocument;
    document::SubdocumentId grabbed_ = document::noSubdocument; // has a button held down
    document::SubdocumentId hovered_ = document::noSubdocument;
    std::vector<document::SubdocumentId> visible_;
    controls::PlayBar* playBar_;
    QTimer fitting_;
};

} // namespace view
