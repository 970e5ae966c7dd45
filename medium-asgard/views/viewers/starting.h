// How a stand-alone session begins: the first page, a sample, the tour.
#pragma once

#include "start/sample_pictures.h"

#include <QObject>
#include <QPointer>

#include <memory>

namespace views {

class Editor;
class FirstPage;
class GraphicalViewer;
class SceneFiles;

class Starting : public QObject {
    Q_OBJECT
public:
    // Both outlive it.
    Starting(Editor& editor, SceneFiles& files);
    ~Starting() override;

    // In place of no window, or over those that are open; one at a time.
    FirstPage* showFirstPage();
    void closeFirstPage();
    // A scene that is nobody's file yet, with the sample's text.
    void openSample(const Sample& sample);
    // An empty scene, and the pane that tells the steps.
    void startTour();

private:
    GraphicalViewer* showWindow(); // the one that is open, or the first

    Editor& editor_;
    SceneFiles& files_;
    QPointer<FirstPage> page_;
    std::unique_ptr<SamplePictures> pictures_;
};

} // namespace views
