// A document by one of its presentations: the model and the pages of it, once for all views and for
// paper (OpenDocument::presented), in step with the document.
//
// A short document is there at once, a long one in slices. After an edit, or when a figure has
// another size, model and pages follow in the same way, and when a value of a figure is another.
#pragma once

#include "model/model_builder.h"
#include "session/growing_pages.h"
#include "session/open_document.h"

#include <QElapsedTimer>

namespace session {

class Presented : public GrowingPages {
    Q_OBJECT

public:
    Presented(OpenDocument& document, QString presentation);
    ~Presented() override;

    [[nodiscard]] const schemas::PageStyle& page() const { return by_->page(); }
    [[nodiscard]] const QString& title() const { return title_; } // when it is complete

    // The last that was complete; null before the first.
    [[nodiscard]] const std::shared_ptr<const model::Model>& model() const {
        return builder_->model();
    }
    // It is the document's, and pages are being made of it.
    [[nodiscard]] bool isModelled() const { return due_ == Due::nothing; }
    // All pages are there, with the values of figures that are known.
    [[nodiscard]] bool isUpToDate() const { return isComplete() && !areValuesDue_; }
    // Goes on until it is, or so long.
    void settleModel(int mostMs = std::numeric_limits<int>::max());
    // The materials of its pages. To be used as long as this lives.
    [[nodiscard]] paragraphs::Objects objects();

    // Steps that are taken before the document is shown: what some 50 pages need.
    static constexpr int firstSteps = 4000;

Q_SIGNALS:
    void modelled(); // isModelled(): there is another model, or objects have other sizes

private:
    enum class Due { nothing, layout, model };
    void begin();
    void readAnew();
    void follow(const sgml::Change& change);
    void require(Due due);
    void followValues();
    [[nodiscard]] bool step() override;
    [[nodiscard]] QSize imageSize(const std::string& source);

    OpenDocument& document_;
    QString presentation_;
    std::string className_;
    const schemas::Presentation* by_ = nullptr; // of that class
    std::unique_ptr<model::ModelBuilder> builder_;
    Due due_ = Due::nothing;
    bool areValuesDue_ = false;
    QString title_;
    std::map<std::string, QSize> imageSizes_; // as the files said lately
    QElapsedTimer imagesAsked_;
};

} // namespace session
