// What can be read: words stand out from what is behind them, in light and in dark colours, and a
// screen reader is told the values that have a name.
#include "frame/manual_window.h"
#include "frame/readable.h"
#include "language/scene_editor.h"
#include "plots/study_window.h"
#include "shapes/shape_editor.h"
#include "trajectories/trajectory_editor.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPaintEngine>

#include <map>

namespace views {
namespace {

// --- what a widget writes, and where -----------------------------------------------------------

struct Written {
    QString text;
    QColor ink;
    QRectF place; // of the widget
};

class Recorder : public QPaintEngine {
public:
    Recorder() : QPaintEngine(AllFeatures) {}
    std::vector<Written> all;

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState&) override {}
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawPath(const QPainterPath&) override {}
    void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        const QRectF place(at.x(), at.y() - item.ascent(), item.width(),
                           item.ascent() + item.descent());
        QRectF seen = painter()->transform().mapRect(place);
        if (painter()->hasClipping())
            seen &= painter()->transform().mapRect(painter()->clipBoundingRect());
        QColor ink = painter()->pen().color();
        ink.setAlphaF(ink.alphaF() * static_cast<float>(painter()->opacity()));
        if (!item.text().trimmed().isEmpty() && seen.width() > 2 && seen.height() > 4)
            all.push_back({item.text(), ink, seen});
    }
    [[nodiscard]] Type type() const override { return User; }
};

class Record : public QPaintDevice {
public:
    explicit Record(QSize size) : size_(size) {}
    Recorder engine;
    [[nodiscard]] QPaintEngine* paintEngine() const override {
        return const_cast<Recorder*>(&engine);
    }

protected:
    [[nodiscard]] int metric(PaintDeviceMetric which) const override {
        switch (which) {
        case PdmWidth:
            return size_.width();
        case PdmHeight:
            return size_.height();
        case PdmDepth:
            return 32;
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return static_cast<int>(devicePixelRatioFScale());
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return 96;
        default:
            return 0;
        }
    }

private:
    QSize size_;
};

// The colour that most of a place has: what is behind the words.
QColor paperAt(const QImage& image, const QRect& place) {
    std::map<QRgb, int> counts;
    const QRect inside = place & image.rect();
    for (int y = inside.top(); y <= inside.bottom(); ++y)
        for (int x = inside.left(); x <= inside.right(); ++x)
            ++counts[image.pixel(x, y)];
    if (counts.empty())
        return {};
    return QColor(
        std::ranges::max_element(counts, {}, [](const auto& one) { return one.second; })->first);
}

class ReadingAloudTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void TearDown() override { QApplication::setPalette(before_); }

    static QPalette dark() {
        QPalette palette(QColor(0x35, 0x38, 0x3C), QColor(0x2B, 0x2D, 0x30));
        palette.setColor(QPalette::Base, QColor(0x1E, 0x1F, 0x22));
        palette.setColor(QPalette::Highlight, QColor(0x2F, 0x65, 0xCA));
        palette.setColor(QPalette::PlaceholderText, QColor(0xFF, 0xFF, 0xFF, 0x60));
        palette.setColor(QPalette::Link, QColor(0x20, 0x30, 0xD0));
        return palette;
    }

    // Everything that has words, opened; also what is wrong, dragged, selected and found.
    void openAll(Editor& editor) {
        editor.document().setText(text, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        ASSERT_FALSE(editor.document().hasErrors());
        LanguageViewer* language = editor.openLanguageViewer();
        GraphicalViewer* graphical = editor.openGraphicalViewer();
        graphical->showUsualPanes();
        graphical->panes().show("plots");
        language->tell("What happened.");
        graphical->tell("What happened.");
        manual = std::make_unique<ManualWindow>(
            "# One\n\nWords, `code` and a [link](a.md).\n\n| a | b |\n|---|---|\n| c | d |\n");
        windows = {language,
                   graphical,
                   editor.openTrajectoryEditor(),
                   editor.openShapeEditor("tip"),
                   editor.openStudy(),
                   manual.get()};
        manual->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(language, longestWait));
        // Pictures and charts show the last good scene; the text says what is wrong.
        editor.document().setText(text + "body b9 nothing\n", "Edit");
        ASSERT_TRUE(settle(editor.document()));
        const std::size_t body = text.find("b1");
        language->select(body, body + 2);
        QApplication::processEvents();
    }

    static void lookAt(QWidget& window, std::vector<std::string>& faults, std::size_t& looked) {
        const QImage seen = window.grab().toImage();
        for (QWidget* one : window.findChildren<QWidget*>()) {
            if (!one->isVisible() || !one->isEnabled() || one->visibleRegion().isEmpty())
                continue;
            Record record(one->size());
            one->render(&record, {}, {}, QWidget::DrawWindowBackground);
            for (const Written& written : record.engine.all) {
                const QPointF at = one->mapTo(&window, QPoint());
                const QRect place = written.place.translated(at).toAlignedRect();
                if (!place.intersects(one->visibleRegion().boundingRect().translated(at.toPoint())))
                    continue;
                // A letter alone fills its place; round it is what it stands on.
                const QColor paper = paperAt(seen, place.adjusted(-6, -3, 6, 3));
                if (!paper.isValid())
                    continue;
                const float a = written.ink.alphaF();
                const QColor ink =
                    QColor::fromRgbF(a * written.ink.redF() + (1 - a) * paper.redF(),
                                     a * written.ink.greenF() + (1 - a) * paper.greenF(),
                                     a * written.ink.blueF() + (1 - a) * paper.blueF());
                ++looked;
                if (const double is = contrast(ink, paper); is < readableContrast - 0.05)
                    faults.push_back(std::string(one->metaObject()->className()) + ": \"" +
                                     written.text.toStdString() + "\" " + ink.name().toStdString() +
                                     " on " + paper.name().toStdString() + ": " +
                                     std::to_string(is));
            }
        }
    }
    void everyWordIsRead() {
        Editor editor{made.workshop()};
        openAll(editor);
        std::vector<std::string> faults;
        for (QWidget* window : windows) {
            std::size_t looked = 0;
            lookAt(*window, faults, looked);
            EXPECT_GT(looked, 3U) << window->metaObject()->className();
        }
        std::ranges::sort(faults);
        const auto twice = std::ranges::unique(faults);
        faults.erase(twice.begin(), twice.end());
        for (const std::string& fault : faults)
            ADD_FAILURE() << fault;
    }

    const std::string text =
        "# a comment\nsimulator -finish 2\nshape_set s -desc {-sub {-sphere 1}}\n"
        "shape_set tip -desc {-sub {-points {{0 0 0} {2 0 0} {0 2 0} {0 0 2}}}}\n"
        "parameter g -value 2 -min 0 -max 9 ;# pull\nset x \"quoted words\"\n"
        "body b1 s -init_pos {-5 0 0} -mass 3 ;# $x\nbody b2 tip -init_pos {1.5 2 3} \n"
        "body b3 s -init_pos {-5 0 0}\n"
        "trajectory T -points {{0 1 2 3} {1 4 5 6} {2 7 8 9}}\nplot p -values {b3.x}\n";
    QPalette before_ = QApplication::palette();
    TestWorkshop made;
    std::unique_ptr<ManualWindow> manual;
    std::vector<QWidget*> windows;
};

TEST_F(ReadingAloudTest, EveryWordStandsOutInLightColours) { everyWordIsRead(); }

TEST_F(ReadingAloudTest, EveryWordStandsOutInDarkColours) {
    QApplication::setPalette(dark());
    everyWordIsRead();
}

TEST_F(ReadingAloudTest, ColoursThatChangeWhileWindowsAreOpenAreFollowed) {
    Editor editor{made.workshop()};
    openAll(editor);
    QApplication::setPalette(dark());
    QApplication::processEvents();
    std::vector<std::string> faults;
    std::size_t looked = 0;
    for (QWidget* window : windows)
        lookAt(*window, faults, looked);
    EXPECT_GT(looked, 20U);
    for (const std::string& fault : faults)
        ADD_FAILURE() << fault;
}

TEST_F(ReadingAloudTest, AnInkIsMovedNoFartherThanItMustBe) {
    EXPECT_EQ(readable(Qt::black, Qt::white), QColor(Qt::black));
    EXPECT_NEAR(contrast(Qt::black, Qt::white), 21, 0.01);
    for (const QColor paper : {QColor(Qt::white), QColor(Qt::black), QColor(0x80, 0x80, 0x80),
                               QColor(0x34, 0x56, 0x80), QColor(0xFF, 0xE0, 0x40)})
        for (const QColor ink : {QColor(Qt::white), QColor(0xE0, 0xB0, 0x60),
                                 QColor(0x80, 0x80, 0x80), QColor(0x10, 0x10, 0x40, 0x80)}) {
            const QColor moved = readable(ink, paper);
            EXPECT_GE(contrast(moved, paper), readableContrast);
            EXPECT_LT(contrast(moved, paper),
                      std::max(readableContrast + 1.5, contrast(ink, paper) + 0.1));
        }
}

// --- what is told ----------------------------------------------------------------------------

QString nameOf(QWidget& widget) {
    return QAccessible::queryAccessibleInterface(&widget)->text(QAccessible::Name);
}

TEST_F(ReadingAloudTest, ANamedFieldTellsItsValueToo) {
    Editor editor{made.workshop()};
    openAll(editor);
    int named = 0;
    for (QWidget* window : windows)
        for (auto* label : window->findChildren<QLabel*>()) {
            if (label->accessibleName().isEmpty() || label->text().isEmpty())
                continue;
            ++named;
            const QString name = nameOf(*label);
            EXPECT_TRUE(name.contains(label->accessibleName())) << name.toStdString();
            EXPECT_TRUE(name.contains(label->text())) << name.toStdString();
            EXPECT_EQ(QAccessible::queryAccessibleInterface(label)->text(QAccessible::Value),
                      label->text());
        }
    EXPECT_GT(named, 8);
    const auto labels = windows[1]->findChildren<QLabel*>();
    const auto time = std::ranges::find(labels, "Time", &QLabel::accessibleName);
    ASSERT_NE(time, labels.end());
    EXPECT_EQ(nameOf(**time), "Time: 0.000 s");
}

} // namespace
} // namespace views
