// Pages that are made a little at a time between other events, so that the window lives meanwhile:
// first those that have changed, then those behind them, which are the old ones until then.
#pragma once

#include "layout/pages.h"

#include <QObject>
#include <QTimer>
#include <limits>

namespace session {

class GrowingPages : public QObject {
    Q_OBJECT

public:
    ~GrowingPages() override;

    [[nodiscard]] virtual bool isComplete() const { return !timer_.isActive(); }
    // So far. Those who show them keep what they show until they are told.
    [[nodiscard]] virtual const layout::Pages& pages() const { return pages_; }
    // Goes on until all is there, and tells so; or so long, where it takes longer.
    virtual void settle(int mostMs = std::numeric_limits<int>::max());

Q_SIGNALS:
    void grown();    // there are more pages, or newer ones, and more to come
    void complete(); // all are there

protected:
    GrowingPages();
    // Some work; false: all is made.
    [[nodiscard]] virtual bool step();
    // The pages that are being made are of an older state; steps are taken from now on.
    void startAnew();
    void stop(); // nothing is being made
    // The pages that those to come follow, and that are shown until then.
    void setBase(const layout::Pages& base);
    // The next steps make these pages.
    void layOut(const layout::ModelPointer& model, const paragraphs::Objects& objects);
    void goOn(); // in slices; those who show the pages are told of those that are there

private:
    void slice();

    std::unique_ptr<layout::Pagination> pagination_;
    std::size_t told_ = 0; // pages
    layout::Pages base_;   // the last that were complete
    layout::Pages pages_;
    QTimer timer_;
};

} // namespace session
