// Pictures of scenes that are not open: drawn one after another by processes of their own, and kept
// in a folder.
#pragma once

#include "start/samples.h"

#include <QColor>
#include <QImage>
#include <QObject>
#include <QProcess>
#include <QSize>

namespace views {

class SamplePictures : public QObject {
    Q_OBJECT
public:
    // `program` draws with the arguments of `asgard render`. `folder` is made when it is needed.
    SamplePictures(QString program, QString folder, QObject* parent = nullptr);
    ~SamplePictures() override; // ends what is being drawn

    // The kept ones come at once, in the order of the list; the others as they are drawn. What was
    // asked for before is forgotten; the one that is being drawn is kept in the folder.
    void ask(QList<Sample> samples, const QSize& pixels, const QColor& background);

Q_SIGNALS:
    void drawn(const views::Sample& sample, const QImage& image);
    void failed(const views::Sample& sample);

private:
    void next();
    void take();
    [[nodiscard]] QString pathOf(const Sample& sample, const QSize& pixels,
                                 const QColor& background) const;

    struct Wish {
        Sample sample;
        QSize pixels;
        QColor background;
        QString path;         // of its picture
        bool isWanted = true; // another look was asked for since
    };
    QString program_, folder_;
    QList<Wish> waiting_; // the first is being drawn
    QProcess process_;
};

} // namespace views
