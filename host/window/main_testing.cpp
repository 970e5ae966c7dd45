// Begins the tests of windows: with the media of the tests, and with settings of their own.
#include "window/application.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>

int main(int argc, char** argv) {
    QTemporaryDir settings;
    qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
    qputenv("XDG_STATE_HOME", settings.path().toUtf8()); // texts that tests leave unsaved
    qputenv("ENSEMBLE_MEDIA", SOURCE_DIR "/tests/media");
    QApplication application(argc, argv);
    QApplication::setOrganizationName("ensemble-test");
    QApplication::setApplicationName("ensemble-test");
    window::dress();
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
