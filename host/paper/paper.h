// The pages of a document as they are printed: laid out once, with still pictures of its
// subdocuments. A subdocument without a picture is a box that says why; the rest of the page does
// not care.
#pragma once

#include "layout/paint.h"
#include "session/pictures.h"
#include "session/presented.h"

class QPdfWriter;
class QPrinter;
class QIODevice;

namespace paper {

class Paper : public QObject {
    Q_OBJECT

public:
    // `dpi`: of the pictures. `posters`: at their POSTER times, else as they stand.
    Paper(session::OpenDocument& document, const QString& presentation, double dpi, bool posters,
          QObject* parent = nullptr);

    // Emits ready() when all pictures and values are there and the pages are laid out.
    void prepare();

    // --- when ready
    [[nodiscard]] int pageCount() const { return static_cast<int>(pages_.pages.size()); }
    [[nodiscard]] const layout::Pages& pages() const { return pages_; }
    [[nodiscard]] const QStringList& failures() const { return failures_; }
    [[nodiscard]] const QString& title() const { return presented_->title(); }
    [[nodiscard]] QString writePdf(QIODevice& file) const; // what failed; empty: nothing
    [[nodiscard]] QImage image(int page, double dpi) const;
    void print(QPrinter& printer) const;

Q_SIGNALS:
    void progressed(int done, int all);
    void ready();

private:
    void askForValues();
    void present();
    void lookAtPages();
    void askForImages();
    void becomeReady();
    [[nodiscard]] QImage imageOf(const layout::ImagePiece& piece) const;
    void paint(QPainter& painter, int page) const;
    void paintSubdocument(QPainter& painter, const layout::SubdocumentPiece& piece) const;

    session::OpenDocument& document_;
    QString presentation_;
    double dpi_ = 0;
    session::Pictures pictures_;
    std::shared_ptr<session::Presented> presented_; // once the pictures are there
    layout::Pages pages_;                           // that are printed, whatever changes meanwhile
    std::map<std::string, QSize> imageSizes_;       // in pixels, of the largest place of each
    bool laidOut_ = false, ready_ = false;
    QStringList failures_;
};

// A box with a sentence in it, instead of a picture; the painter's units are twips.
void paintBox(QPainter& painter, const QRectF& rect, const QString& title, const QString& text);

} // namespace paper
