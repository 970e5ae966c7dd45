// The page that the program opens with when it was given no file: samples as pictures, the files
// that were opened last, a new scene, the tour.
#pragma once

#include "start/sample_pictures.h"
#include "start/samples.h"

#include <QColor>
#include <QMainWindow>
#include <QPointer>
#include <QSize>

#include <utility>

class QLabel;
class QListWidget;
class QListWidgetItem;

namespace views {

class FirstPage : public QMainWindow {
    Q_OBJECT
public:
    // `pictures` draws the samples; nullptr: they are named only.
    FirstPage(QList<Sample> samples, const QStringList& recent, SamplePictures* pictures,
              QWidget* parent = nullptr);

Q_SIGNALS:
    void newWanted();
    void openWanted();
    void tourWanted();
    void quitWanted(); // of all windows
    void fileWanted(const QString& path);
    void sampleWanted(const views::Sample& sample);

protected:
    void keyPressEvent(QKeyEvent* event) override; // Escape closes
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* buildLeft(const QStringList& recent);
    QWidget* buildSamples();
    void addSample(const Sample& sample);
    void showGroup(const QString& group);
    void showPicture(const Sample& sample, const QImage& image);
    void colourCards();
    void fitCards();
    void askForPictures(); // as the screen and the colours are now
    [[nodiscard]] const Sample* sampleOf(const QListWidgetItem& item) const;

    QList<Sample> samples_;
    QPointer<SamplePictures> pictures_;
    std::pair<QSize, QColor> asked_; // of them
    QListWidget *list_ = nullptr, *recent_ = nullptr;
    QLabel* about_ = nullptr;
};

} // namespace views
