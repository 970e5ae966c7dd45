// Every text of the host's windows can be read, under a light and a dark palette, and by a screen
// reader as well.
#include "window/window_testing.h"

#include "onpage/shown.h"
#include "plain/plain.h"
#include "plain/test_contrast.h"
#include "window/manual.h"

#include <QAccessible>
#include <QCheckBox>
#include <QRadioButton>
#include <QSlider>
#include <QStatusBar>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace window {
namespace {

QPalette darkPalette() {
    QPalette palette(QColor(53, 53, 53), QColor(45, 45, 48));
    palette.setColor(QPalette::Base, QColor(30, 30, 32));
    palette.setColor(QPalette::AlternateBase, QColor(40, 40, 43));
    palette.setColor(QPalette::WindowText, QColor(230, 230, 230));
    palette.setColor(QPalette::Text, QColor(230, 230, 230));
    palette.setColor(QPalette::ButtonText, QColor(230, 230, 230));
    palette.setColor(QPalette::Highlight, QColor(42, 110, 200));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    return palette;
}

void expectReadable(QWidget& window, const std::string& where, std::size_t least) {
    const std::vector<plain::PaintedText> texts = plain::textsOf(window);
    EXPECT_GE(texts.size(), least) << where;
    for (const plain::PaintedText& one : texts)
        EXPECT_GE(one.contrast, plain::leastContrast) << where << ": " << one.text;
}

class ReadableTest : public WindowTest, public ::testing::WithParamInterface<bool> {
protected:
    void SetUp() override {
        qApp->setStyleSheet({});
        QApplication::setPalette(GetParam() ? darkPalette()
                                            : QApplication::style()->standardPalette());
        dress();
    }
    void TearDown() override {
        qApp->setStyleSheet({});
        QApplication::setPalette(QApplication::style()->standardPalette());
        dress();
    }
};

TEST_P(ReadableTest, EveryTextOfAWindow) {
    DocumentWindow* window =
        open(memo(scripted("duration 5\nmenu Refresh\nfault 1 1 Something is wrong") +
                  scripted("duration 5")) +
             "<BROKEN>");
    auto* list = window->findChild<QTreeWidget*>();
    ASSERT_TRUE(waitFor([&] {
        return hasPicture(*window, 1) && live(*window, 1).time() && list->topLevelItemCount() > 0;
    }));
    window->findChild<panes::FaultsPane*>()->show();
    window->findChild<panes::FindBar*>()->open();
    window->findChild<panes::FindBar*>()->findChild<QLineEdit*>()->setText("Test");
    window->statusBar()->showMessage("Saved");
    ASSERT_TRUE(waitFor([&] {
        return window->findChild<QToolBar*>("tools")->findChild<controls::PlayBar*>()->isVisible();
    }));
    expectReadable(*window, "window", 12);
    for (QMenu* menu : window->findChildren<QMenu*>()) {
        Q_EMIT menu->aboutToShow();
        menu->ensurePolished();
        menu->resize(menu->sizeHint());
        expectReadable(*menu, "menu " + menu->title().toStdString(), 0);
    }
}

// WCAG 2.1, 1.4.11.
TEST_P(ReadableTest, TheMarksOfRadioButtonsAndCheckBoxes) {
    QWidget window;
    QVBoxLayout column(&window);
    QRadioButton radio(&window);
    QCheckBox box(&window);
    for (QAbstractButton* one :
         {static_cast<QAbstractButton*>(&radio), static_cast<QAbstractButton*>(&box)}) {
        one->setAutoExclusive(false);
        column.addWidget(one);
    }
    window.show();
    constexpr double least = 3;
    for (const bool isChecked : {false, true}) {
        radio.setChecked(isChecked);
        box.setChecked(isChecked);
        const QImage image = plain::enlarged(window);
        const double factor = image.devicePixelRatio();
        for (const QWidget* one : {static_cast<QWidget*>(&radio), static_cast<QWidget*>(&box)})
            EXPECT_GE(plain::contrastIn(image, QRect(one->pos() * factor, one->size() * factor)),
                      least)
                << one->metaObject()->className() << isChecked;
    }
}

// Such as KDE's colours: they have none for it.
TEST_P(ReadableTest, TheHintOfAnEmptyField) {
    QPalette palette = QApplication::palette();
    palette.setColor(QPalette::PlaceholderText,
                     GetParam() ? QColor(0, 0, 0, 128) : QColor(255, 255, 255, 128));
    QApplication::setPalette(palette);
    dress();
    QWidget window;
    auto* field = new QLineEdit(&window);
    field->setPlaceholderText("Words of a caption");
    field->resize(300, field->sizeHint().height());
    window.resize(320, 60);
    window.show();
    expectReadable(window, "field", 1);
}

TEST_P(ReadableTest, EveryTextOfAMessage) {
    plain::Message box(QMessageBox::Question, "Save", "The document has changes.",
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, nullptr);
    box.setSecondText("They would be lost.");
    box.show();
    expectReadable(box, "message", 5);
}

TEST_P(ReadableTest, TheManual) {
    QWidget parent;
    showManual(&parent);
    auto* text = parent.findChild<QTextBrowser*>("manual");
    ASSERT_TRUE(text);
    EXPECT_GE(plain::contrast(text->palette().color(QPalette::Text).rgb(),
                              text->palette().color(QPalette::Base).rgb()),
              plain::leastContrast);
}

TEST_P(ReadableTest, WhatIsPaintedOverFigures) {
    using Kind = view::Notice::Kind;
    for (const QColor& picture : {QColor(Qt::white), QColor(128, 128, 128), QColor(Qt::black)})
        for (const Kind kind : {Kind::waiting, Kind::note, Kind::box, Kind::stopped})
            for (const bool isTitle : {true, false}) {
                if (kind == Kind::note && !isTitle)
                    continue; // a note is a title alone
                constexpr int factor = 4;
                QImage image(QSize(400, 200) * factor, QImage::Format_RGB32);
                image.setDevicePixelRatio(factor);
                image.fill(picture);
                QPainter painter(&image);
                view::Notice notice{kind, isTitle ? "Asgard was ended" : "",
                                    isTitle ? "" : "It was ended"};
                view::paintShown(painter, QRectF(0, 0, 400, 200), view::Shown{}, notice, false);
                painter.end();
                // The background of the letters: the whole of a panel, else a pill or a strip.
                const QRect place = kind == Kind::note      ? QRect(60, 60, 300, 60)
                                    : kind == Kind::stopped ? QRect(60, 700, 1480, 90)
                                                            : QRect(8, 8, 1584, 784);
                EXPECT_GE(plain::contrastIn(image, place), plain::leastContrast)
                    << static_cast<int>(kind) << (isTitle ? " title on " : " text on ")
                    << picture.name().toStdString();
            }
}

TEST_P(ReadableTest, ThePlayBarOverAnyPicture) {
    for (const QColor& picture : {QColor(Qt::white), QColor(128, 128, 128), QColor(Qt::black)}) {
        QWidget under;
        QPalette colours = under.palette();
        colours.setColor(QPalette::Window, picture);
        under.setPalette(colours);
        under.resize(400, 60);
        controls::PlayBar bar(true, &under);
        bar.setGeometry(0, 0, 400, controls::PlayBar::barHeight);
        ipc::TimeChanged time;
        time.finish = 3;
        bar.setTime(time);
        under.show();
        expectReadable(under, "play bar over " + picture.name().toStdString(), 1);
    }
}

INSTANTIATE_TEST_SUITE_P(Palettes, ReadableTest, ::testing::Bool(),
                         [](const auto& dark) { return dark.param ? "Dark" : "Light"; });

// --- by a screen reader ------------------------------------------------------------------------

// Everything that it can say of a widget.
QString said(QWidget* widget) {
    QString all;
    if (QAccessibleInterface* of = QAccessible::queryAccessibleInterface(widget))
        for (const auto text : {QAccessible::Name, QAccessible::Description, QAccessible::Value})
            all += of->text(text) + '\n';
    return all;
}

TEST_F(WindowTest, AScreenReaderGetsEveryNameAndEveryValue) {
    DocumentWindow* window = open(memo(scripted("duration 5\nmenu Refresh\nfault 1 1 wrong")));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 0) && live(*window, 0).time(); }));
    window->findChild<panes::FaultsPane*>()->show();
    window->findChild<panes::FindBar*>()->open();
    auto* bar = window->findChild<QToolBar*>("tools")->findChild<controls::PlayBar*>();
    ASSERT_TRUE(waitFor([&] { return bar->isVisible(); }));
    for (QWidget* widget : window->findChildren<QWidget*>()) {
        if (!widget->isVisible())
            continue;
        QAccessibleInterface* of = QAccessible::queryAccessibleInterface(widget);
        if (const auto* label = qobject_cast<QLabel*>(widget)) {
            EXPECT_TRUE(said(widget).contains(label->text())) << label->text().toStdString();
        }
        if (of && of->state().focusable && widget->focusPolicy() != Qt::NoFocus) {
            EXPECT_FALSE(of->text(QAccessible::Name).isEmpty())
                << widget->metaObject()->className() << " " << widget->objectName().toStdString();
        }
    }
    // A slider counts its own steps; what it stands at is a time.
    live(*window, 0).seek(2.5);
    ASSERT_TRUE(waitFor([&] { return live(*window, 0).time()->time == 2.5; }));
    auto* slider = bar->findChild<QSlider*>();
    QAccessibleInterface* of = QAccessible::queryAccessibleInterface(slider);
    ASSERT_TRUE(of);
    EXPECT_EQ(of->text(QAccessible::Name), "Time");
    EXPECT_EQ(of->text(QAccessible::Description), "2.50 / 5.00 s");
}

} // namespace
} // namespace window
