// A window with documents of a scripted medium, and what tests ask of it.
#pragma once

#include "controls/icons.h"
#include "controls/play_bar.h"
#include "panes/faults_pane.h"
#include "panes/find_bar.h"
#include "window/application.h"
#include "window/document_window.h"
#include "window/medium_commands.h"

#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QTimer>
#include <csignal>
#include <random>
#include <utility>

namespace window {

inline bool waitFor(const std::function<bool()>& done, int ms = 120'000) {
    return QTest::qWaitFor(done, ms);
}

inline QByteArray scripted(const QByteArray& text, const QByteArray& attributes = {}) {
    return "<PARAGRAPH><DOCUMENT>\nDOCUMENT SCRIPTED\n<SCRIPTED WIDTH=\"300\" HEIGHT=\"200\" " +
           attributes + "><SCRIPT>{" + text + "}</SCRIPT></SCRIPTED>\n</DOCUMENT></PARAGRAPH>\n";
}

inline QByteArray paragraph(const QByteArray& text) {
    return "<PARAGRAPH><TEXT>{" + text + "}</TEXT></PARAGRAPH>\n";
}

inline QByteArray memo(const QByteArray& paragraphs) {
    return "DOCUMENT CMEMO\n<CMEMO>\n<SUBJECT>{Test}</SUBJECT>\n<BODY>\n" + paragraphs +
           "</BODY>\n</CMEMO>\n";
}

inline QByteArray report(const QByteArray& body) {
    return "DOCUMENT REPORT\n<REPORT>\n<TITLE>{T}</TITLE>\n" + body + "</REPORT>\n";
}

inline QByteArray section(const QByteArray& name, const QByteArray& inside = {}) {
    return "<SECTION ID=\"" + name + "\">\n<HEADING>{" + name + "}</HEADING>\n" +
           paragraph("Text of " + name) + inside + "</SECTION>\n";
}

// How long the event loop let its timers wait, from here on.
class Heartbeat {
public:
    Heartbeat() {
        since_.start();
        QObject::connect(&timer_, &QTimer::timeout, [this] {
            longest_ = std::max(longest_, since_.restart());
            ++count_;
        });
        timer_.start(1);
    }
    [[nodiscard]] qint64 longest() const { return longest_; } // ms
    [[nodiscard]] int count() const { return count_; }        // how often it came to its timers

private:
    QElapsedTimer since_;
    QTimer timer_;
    qint64 longest_ = 0;
    int count_ = 0;
};

// The processes that this one has started.
inline std::vector<pid_t> children() {
    std::vector<pid_t> result;
    for (const QString& task :
         QDir("/proc/self/task").entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile file("/proc/self/task/" + task + "/children");
        if (file.open(QIODevice::ReadOnly))
            for (const QByteArray& pid : file.readAll().split(' '))
                if (!pid.trimmed().isEmpty())
                    result.push_back(pid.toInt());
    }
    return result;
}

class WindowTest : public ::testing::Test {
protected:
    DocumentWindow* open(const QByteArray& bytes, QSize size = {900, 1000}) {
        const QString name = folder_.filePath(QStringLiteral("%1.ens").arg(++files_));
        QFile file(name);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        DocumentWindow* window = application_.open(name);
        EXPECT_TRUE(window);
        window->resize(size);
        window->view().setZoom(1); // it begins as wide as fits
        return window;
    }
    static document::SubdocumentId nth(const DocumentWindow& window, std::size_t n) {
        return window.document().document().subdocuments().at(n);
    }
    static media::LiveSubdocument& live(const DocumentWindow& window, std::size_t n) {
        return *window.document().live(nth(window, n));
    }
    static QImage picture(const DocumentWindow& window, std::size_t n) {
        const media::Rendition* rendition = window.view().rendition(nth(window, n));
        return rendition ? rendition->picture() : QImage();
    }
    static bool hasPicture(const DocumentWindow& window, std::size_t n) {
        return !picture(window, n).isNull();
    }
    static QColor colourShown(DocumentWindow& window, std::size_t n) {
        const QRectF place = window.view().placeOf(nth(window, n));
        return window.view().viewport()->grab().toImage().pixelColor(
            (place.topLeft() + QPointF(60, 60)).toPoint());
    }
    static void click(DocumentWindow& window, std::size_t n) {
        const QRectF place = window.view().placeOf(nth(window, n));
        QTest::mouseClick(window.view().viewport(), Qt::LeftButton, {},
                          (place.topLeft() + QPointF(60, 60)).toPoint());
    }

    static void writeIn(DocumentWindow& window) {
        window.activateWindow();
        window.view().setFocus();
        ASSERT_TRUE(waitFor([&] { return window.view().hasFocus(); }));
        window.findChild<QAction*>("write")->trigger();
    }

    QTemporaryDir folder_;
    int files_ = 0;
    Application application_{{.initialize = 120'000,
                              .quiet = 300,
                              .hung = 5000,
                              .shutdown = 500,
                              .pingEvery = 50,
                              .restartsPerMinute = 0}};
};

} // namespace window
