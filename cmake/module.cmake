# asgard_module(NAME
#     FILES   sources of the library (headers need no listing)
#     USES    modules of ours that it may include and link
#     LINKS   libraries of others
#     ALONE   those of FILES that tell the compiler another processor: never compiled together with others
#     TESTS   GoogleTest sources; they may also use TEST_USES
#     PLACED  those of TESTS that know where the project lies (SOURCE_DIR, a string): they alone are compiled anew
#             in another clone, where the rest comes from the compiler's cache
#     SHARDS  so many tests of ctest run its tests in turn: NAME.1, NAME.2, ..., for a program that takes long
#     PCH     core: the standard library's and Eigen's heavy headers; qt: those of QtCore that most sources include; widgets: Qt's widgets too,
#             for the tests as well
#     QT)     the sources have Q_OBJECT in them
#
# Declares a folder as a module: a static library of that name, linked with what it USES and nothing
# else, a test program NAME_test, and a test `layering.NAME` that fails when a file of the folder
# includes a module of ours that USES does not list.
#
# Includes are written from the folder that holds the module: #include "expression/expression.h".

# The headers that two or more sources with windows include. All of QtWidgets would take half as much memory again,
# and 10 % more of the compiler's time for each source.
set(asgard_widget_headers
    <QAbstractButton> <QAbstractItemView> <QAccessible> <QAction> <QActionGroup> <QApplication> <QCheckBox>
    <QCloseEvent> <QColor> <QComboBox> <QDateTime> <QDialog> <QDialogButtonBox> <QDir> <QDoubleSpinBox>
    <QElapsedTimer> <QEvent> <QFile> <QFileDialog> <QFileInfo> <QFontDatabase> <QFormLayout> <QFrame> <QGridLayout>
    <QGroupBox> <QGuiApplication> <QHBoxLayout> <QIcon> <QIconEngine> <QImage> <QInputDialog> <QInputMethodEvent>
    <QKeyEvent> <QLabel> <QLineEdit> <QListWidget> <QLocale> <QMainWindow> <QMenu> <QMenuBar> <QMessageBox>
    <QMouseEvent> <QObject> <QPainter> <QPainterPath> <QPalette> <QPointF> <QPointer> <QProgressBar>
    <QProgressDialog> <QPushButton> <QRegularExpression> <QSaveFile> <QScreen> <QScrollArea> <QScrollBar>
    <QSettings> <QSlider> <QSpinBox> <QSplitter> <QStatusBar> <QString> <QStringList> <QStyle> <QTemporaryDir>
    <QTextBlock> <QTextBrowser> <QThreadPool> <QTimer> <QToolButton> <QToolTip> <QVBoxLayout> <QWheelEvent>
    <QWidget>)

function(asgard_precompile target kind)
    # The protocol has a field `slots`, which is a macro of Qt unless it is told not to.
    if(kind MATCHES "qt|widgets")
        target_compile_definitions(${target} PUBLIC QT_NO_KEYWORDS)
    endif()
    if(PRECOMPILED_HEADERS AND kind)
        if(NOT TARGET pch_${kind})
            file(WRITE ${CMAKE_BINARY_DIR}/pch_${kind}.cpp "\n")
            add_library(pch_${kind} STATIC ${CMAKE_BINARY_DIR}/pch_${kind}.cpp)
            target_link_libraries(pch_${kind} PRIVATE Eigen3::Eigen Threads::Threads)
            set(headers <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory> <optional> <set> <span> <string>
                <string_view> <unordered_map> <utility> <variant> <vector> <Eigen/Core> <Eigen/Geometry>)
            if(kind MATCHES "qt|widgets")
                target_compile_definitions(pch_${kind} PRIVATE QT_NO_KEYWORDS)
            endif()
            if(kind STREQUAL qt)
                target_link_libraries(pch_qt PRIVATE Qt6::Core)
                list(APPEND headers <QByteArray> <QDir> <QFile> <QFileInfo> <QHash> <QList> <QObject> <QPointer> <QRect>
                    <QString> <QStringList> <QTimer> <QVariant>)
            elseif(kind STREQUAL widgets)
                target_link_libraries(pch_widgets PRIVATE Qt6::Widgets)
                list(APPEND headers ${asgard_widget_headers})
            elseif(kind STREQUAL test)
                target_link_libraries(pch_test PRIVATE GTest::gtest GTest::gmock)
                list(APPEND headers <gtest/gtest.h> <gmock/gmock.h>)
            elseif(kind STREQUAL widgets_test)
                target_link_libraries(pch_widgets_test PRIVATE Qt6::Widgets GTest::gtest GTest::gmock)
                list(APPEND headers ${asgard_widget_headers} <gtest/gtest.h> <gmock/gmock.h>)
            endif()
            target_precompile_headers(pch_${kind} PRIVATE ${headers})
        endif()
        target_precompile_headers(${target} REUSE_FROM pch_${kind})
    endif()
endfunction()

function(asgard_module name)
    cmake_parse_arguments(PARSE_ARGV 1 M "QT" "PCH;SHARDS" "FILES;USES;LINKS;ALONE;TESTS;PLACED;TEST_USES;TEST_LINKS")
    get_filename_component(parent ${CMAKE_CURRENT_SOURCE_DIR} DIRECTORY)

    if(M_FILES)
        add_library(${name} STATIC ${M_FILES})
        set(scope PUBLIC)
        asgard_precompile(${name} "${M_PCH}")
        if(M_QT)
            set_target_properties(${name} PROPERTIES AUTOMOC ON)
        endif()
        set_target_properties(${name} PROPERTIES UNITY_BUILD ${SOURCES_TOGETHER} UNITY_BUILD_BATCH_SIZE 8)
        set_source_files_properties(${M_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    else()
        add_library(${name} INTERFACE)
        set(scope INTERFACE)
    endif()
    target_include_directories(${name} ${scope} ${parent})
    target_link_libraries(${name} ${scope} ${M_USES} ${M_LINKS})

    string(REPLACE ";" "," uses "${name};${M_USES}")
    add_test(NAME layering.${name}
        COMMAND python3 ${CMAKE_SOURCE_DIR}/tests/layering/check_includes.py
                ${CMAKE_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR} ${uses})
    set_tests_properties(layering.${name} PROPERTIES LABELS layering)

    if(M_TESTS)
        add_executable(${name}_test ${M_TESTS})
        set_target_properties(${name}_test PROPERTIES UNITY_BUILD ${SOURCES_TOGETHER} UNITY_BUILD_BATCH_SIZE 8)
        target_link_libraries(${name}_test PRIVATE ${name} ${M_TEST_USES} ${M_TEST_LINKS} GTest::gtest GTest::gmock GTest::gtest_main)
        if(M_QT)
            set_target_properties(${name}_test PROPERTIES AUTOMOC ON)
        endif()
        if(M_PCH STREQUAL "widgets")
            asgard_precompile(${name}_test widgets_test)
        elseif(NOT M_QT) # position-independent, as Qt wants it: this header is not
            asgard_precompile(${name}_test test)
        endif()
        if(M_PLACED)
            set_source_files_properties(${M_PLACED} PROPERTIES COMPILE_DEFINITIONS SOURCE_DIR="${CMAKE_SOURCE_DIR}")
        endif()
        if(NOT M_SHARDS)
            set(M_SHARDS 1)
        endif()
        foreach(shard RANGE 1 ${M_SHARDS})
            set(test ${name})
            if(M_SHARDS GREATER 1)
                string(APPEND test .${shard})
            endif()
            math(EXPR index "${shard} - 1")
            add_test(NAME ${test} COMMAND ${name}_test)
            set_tests_properties(${test} PROPERTIES LABELS unit TIMEOUT 900
                ENVIRONMENT "QT_QPA_PLATFORM=offscreen;LC_NUMERIC=C;GTEST_TOTAL_SHARDS=${M_SHARDS};GTEST_SHARD_INDEX=${index}")
        endforeach()
    endif()
endfunction()
