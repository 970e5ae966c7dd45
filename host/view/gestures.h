// Gestures of the left button on the pages of a writing view beside selecting text: it takes a part
// of them, such as the corner of a picture or the border of a column, and moves it. The dragged
// part shows at once; the document changes once, when the button is let go.
#pragma once

#include <QCursor>
#include <QPainter>
#include <QPointF>

#include <memory>
#include <optional>
#include <vector>

namespace view {

class DocumentView;

// One of them. Points are in the viewport.
class Gesture {
public:
    Gesture() = default;
    virtual ~Gesture() = default;
    Gesture(const Gesture&) = delete;
    Gesture& operator=(const Gesture&) = delete;

    // How the pointer looks over what can be taken; nothing: there is nothing to take.
    [[nodiscard]] virtual std::optional<Qt::CursorShape> cursorAt(QPointF point) = 0;
    virtual void take(QPointF point) = 0; // where cursorAt() has one
    virtual void takeTwice(QPointF) {}    // a double click there
    virtual void drag(QPointF point) = 0;
    virtual void finish() = 0; // the button is let go
    virtual void cancel() = 0;
    virtual void paint(QPainter&) const {} // over the pages
    virtual void selectionChanged() {}     // or what is chosen
};

// All of them; one is in the hand at a time.
class Gestures {
public:
    // The view outlives it.
    explicit Gestures(DocumentView& view);
    ~Gestures();
    void add(std::unique_ptr<Gesture> gesture) { all_.push_back(std::move(gesture)); }

    // Each says whether the event was for one of them.
    bool press(QPointF point);
    bool pressTwice(QPointF point);
    bool drag(QPointF point);
    bool release();
    bool cancel();
    [[nodiscard]] std::optional<Qt::CursorShape> cursorAt(QPointF point) const;
    void paint(QPainter& painter) const;
    void selectionChanged();

private:
    [[nodiscard]] Gesture* at(QPointF point) const;

    DocumentView& view_;
    std::vector<std::unique_ptr<Gesture>> all_; // the first that can take something does
    Gesture* taken_ = nullptr;
};

} // namespace view
