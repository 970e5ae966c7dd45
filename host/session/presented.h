// A document by one of its presentations: the model and the pages of it, once for all views and for
// paper (OpenDocument::presented), in step with the document.
//
// A short document is there at once. A long one is made in slices between other events: its first
// pages are there early, and the window lives meanwhile. After an edit, or when a figure has
// another size, model and pages follow in the same way: first the pages that have changed, then
// those behind them, which are the old ones until then.
#pragma once

#include "layout/pages.h"
#include "model/model_builder.h"
#include "session/open_document.h"

#include <QElapsedTimer>
#include <QTimer>
#include <limits>

namespace session {

class Presented : public QObject {
    Q_OBJECT

public:
    Presented(OpenDocument& document, QString presentation);
    ~Presented() override;

    [[nodiscard]] bool isComplete() const { return !timer_.isActive(); }
    // So far. Those who show them keep what they show until they are told.
    [[nodiscard]] const layout::Pages& pages() const { return pages_; }
    [[nodiscard]] const schemas::PageStyle& page() const { return by_->page(); }
    [[nodiscard]] const QString& title() const { return title_; } // when it is complete

    // The last that was complete; null before the first.
    [[nodiscard]] const std::shared_ptr<const model::Model>& model() const {
        return builder_->model();
    }
    // Goes on until all is there, and tells so; or so long, where it takes longer.
    void settle(int mostMs = std::numeric_limits<int>::max());

    // Steps that are taken before the document is shown: what some 50 pages need.
    static constexpr int firstSteps = 4000;

Q_SIGNALS:
    void grown();    // there are more pages, or newer ones, and more to come
    void complete(); // all are there

private:
    enum class Due { nothing, layout, model };
    void begin();
    void follow(const sgml::Change& change);
    void require(Due due);
    bool step();
    void slice();
    void finish();
    void tell();
    [[nodiscard]] layout::Objects objects();
    [[nodiscard]] QSize imageSize(const std::string& source);

    OpenDocument& document_;
    QString presentation_;
    std::string className_;
    const schemas::Presentation* by_ = nullptr; // of that class
    std::unique_ptr<model::ModelBuilder> builder_;
    std::unique_ptr<layout::Pagination> pagination_;
    Due due_ = Due::nothing;
    std::size_t told_ = 0; // pages
    layout::Pages base_;   // the last that were complete
    layout::Pages pages_;
    QString title_;
    QTimer timer_;
    std::map<std::string, QSize> imageSizes_; // as the files said lately
    QElapsedTimer imagesAsked_;
};

} // namespace session
