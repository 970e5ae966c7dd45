// A language viewer in a test, and what is done with it.
#pragma once

#include "language/number_drag.h"
#include "language/scene_editor.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QPushButton>
#include <QTest>

namespace views {

class LanguageViewerTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    LanguageViewer* open(const std::string& text) {
        editor.document().setText(text, "Edit");
        EXPECT_TRUE(settle(editor.document()));
        viewer = editor.openLanguageViewer();
        EXPECT_TRUE(QTest::qWaitForWindowActive(viewer, longestWait));
        return viewer;
    }
    SceneEditor& text() { return viewer->editor(); }
    const std::string& scene() { return editor.document().text(); }
    static void type(LanguageViewer& into, const std::string& text) {
        into.editor().setText(QString::fromStdString(text));
    }
    std::size_t place(const std::string& what) { return viewer->draft().find(what); }
    void caretAt(std::size_t byte) {
        text().setFocus();
        text().SendScintilla(QsciScintillaBase::SCI_SETEMPTYSELECTION, byte);
        QCoreApplication::processEvents();
    }
    void act(const QString& name) {
        for (QAction* action : viewer->findChildren<QAction*>())
            if (action->text().remove('&') == name)
                return action->trigger();
        FAIL() << name.toStdString();
    }
    QPushButton* button(const QString& name) {
        for (auto* one : viewer->findChildren<QPushButton*>())
            if (one->text().remove('&') == name)
                return one;
        return nullptr;
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&text(), key, modifiers);
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
    LanguageViewer* viewer = nullptr;
};

} // namespace views
