// The pages of a document as they are printed: laid out once, with still pictures of its
// subdocuments. A subdocument without a picture is a box that says why; the rest of the page does
// not care.
#pragma once

#include "layout/paint.h"
#include "session/pictures.h"

class QPdfWriter;
class QPrinter;
class QIODevice;

namespace paper {

// What a document shows by a presentation, on paper as in a window.
[[nodiscard]] document::Model modelOf(const session::OpenDocument& document,
                                      const QString& presentation);
// The sizes of its subdocuments and its images, which come from files in its own folder or below
// and from nowhere else. It reads the document as long as it is used.
[[nodiscard]] layout::Objects objectsOf(const session::OpenDocument& document);

class Paper : public QObject {
    Q_OBJECT

public:
    // `dpi`: of the pictures. `posters`: at their POSTER times, else as they stand.
    Paper(session::OpenDocument& document, const QString& presentation, double dpi, bool posters,
          QObject* parent = nullptr);

    void prepare(); // emits ready() when all pictures are there

    // --- when ready
    [[nodiscard]] int pageCount() const { return static_cast<int>(pages_.pages.size()); }
    [[nodiscard]] const QStringList& failures() const { return failures_; }
    [[nodiscard]] const QString& title() const { return title_; }
    [[nodiscard]] QString writePdf(QIODevice& file) const; // what failed; empty: nothing
    [[nodiscard]] QImage image(int page, double dpi) const;
    void print(QPrinter& printer) const;

Q_SIGNALS:
    void progressed(int done, int all);
    void ready();

private:
    void layOut();
    void paint(QPainter& painter, int page) const;
    void paintSubdocument(QPainter& painter, const layout::SubdocumentPiece& piece) const;

    session::OpenDocument& document_;
    QString presentation_;
    session::Pictures pictures_;
    document::Model model_;
    layout::Pages pages_;
    QStringList failures_;
    QString title_;
};

// A box with a sentence in it, instead of a picture; the painter's units are twips.
void paintBox(QPainter& painter, const QRectF& rect, const QString& title, const QString& text);

} // namespace paper
