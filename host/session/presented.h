// A document by one of its presentations: the model and the pages of it, made a little at a time.
//
// A short document is there at once. A long one is made in slices between other events: its first
// pages are there early, and the window lives meanwhile. A new begin gives up unfinished
// work.
#pragma once

#include "layout/pages.h"
#include "session/open_document.h"

#include <QTimer>

namespace document {
class ModelBuilder;
}

namespace session {

class Presented : public QObject {
    Q_OBJECT

public:
    explicit Presented(OpenDocument& document, QObject* parent = nullptr);
    ~Presented() override;

    // Begins anew. While the same presentation is made again its pages so far stay; those of
    // another one are shown as they come.
    void begin(const QString& presentation);
    [[nodiscard]] bool isComplete() const { return making_ == nullptr; }

    [[nodiscard]] const layout::Pages& pages() const { return pages_; }
    [[nodiscard]] const document::PageStyle& page() const { return page_; }
    [[nodiscard]] const QString& title() const { return title_; } // when it is complete

    // Steps that begin() takes before it returns: what some 50 pages need.
    static constexpr int firstSteps = 4000;

Q_SIGNALS:
    void grown();    // there are more pages, and more to come
    void complete(); // all are there

private:
    struct Making;
    bool step();
    void slice();
    void finish();
    void tell();

    OpenDocument& document_;
    QString presentation_;
    bool begun_ = false;
    bool fresh_ = true; // what is being made is shown
    std::unique_ptr<Making> making_;
    std::size_t told_ = 0; // pages
    document::PageStyle page_;
    layout::Pages pages_;
    QString title_;
    QTimer timer_;
};

} // namespace session
