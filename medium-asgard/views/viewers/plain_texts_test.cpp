// Texts of a scene are shown as they are written, in every window: no label, tip or caption takes
// them for markup, whose pictures Qt would read from any file.
#include "plots/plots_panel.h"
#include "plots/study_window.h"
#include "shapes/shape_editor.h"
#include "trajectories/trajectory_editor.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QMainWindow>
#include <QSlider>

namespace views {
namespace {

// Reading this file never ends.
const std::string hostile = "<img src=\\\"/dev/zero\\\">";
const QString shown = "<img src=\"/dev/zero\">";

std::string scene() {
    return ballScene + "parameter p -value 1 -min 0 -max 2 -label \"" + hostile +
           " & more\" -unit \"<b>m</b>\"\n"
           "plot q -values {b1.x} -labels [list \"" +
           hostile + "\"] -title \"" + hostile +
           "\"\n"
           "trajectory way -points {{0 0 0 0} {1 1 0 0}}\n"
           "error \"" +
           hostile + "\"\n";
}

// Its format is set, and markup of our own has no picture.
void expectPlain(const QWidget& window) {
    const std::string where = window.metaObject()->className();
    for (const QLabel* label : window.findChildren<QLabel*>()) {
        EXPECT_TRUE(label->text().isEmpty() || label->textFormat() != Qt::AutoText)
            << where << ": " << label->text().toStdString();
        EXPECT_FALSE(label->textFormat() == Qt::RichText && label->text().contains("<img"))
            << where << ": " << label->text().toStdString();
    }
    const auto expectTip = [&](const QString& tip) {
        EXPECT_FALSE(Qt::mightBeRichText(tip) && tip.contains("<img"))
            << where << ": " << tip.toStdString();
    };
    for (const QWidget* widget : window.findChildren<QWidget*>())
        expectTip(widget->toolTip());
    for (const QAction* action : window.findChildren<QAction*>())
        expectTip(action->toolTip());
}

TEST(PlainTexts, OfASceneInEveryWindow) {
    theApplication();
    TestWorkshop made;
    Editor editor{made.workshop()};
    QMainWindow* const windows[] = {editor.openGraphicalViewer(), editor.openLanguageViewer(),
                                    editor.openTrajectoryEditor(), editor.openShapeEditor(),
                                    editor.openStudy()};
    editor.openPlots();
    // First one that can be shown, then one with an error.
    const std::string all = scene();
    for (const std::string& text : {all.substr(0, all.rfind("error")), all}) {
        editor.document().setText(text, QString::fromStdString("Edit <b>"));
        ASSERT_TRUE(settle(editor.document()));
        QCoreApplication::processEvents();
        for (const QMainWindow* window : windows)
            expectPlain(*window);
    }
    // It is there to be seen, as it was written.
    const auto* slider = windows[0]->findChild<QSlider*>();
    bool isShown = false;
    for (const QLabel* label : windows[0]->findChildren<QLabel*>())
        isShown |= label->text() == shown + " & more" && label->textFormat() == Qt::PlainText;
    EXPECT_TRUE(slider);
    EXPECT_TRUE(isShown);
}

} // namespace
} // namespace views
