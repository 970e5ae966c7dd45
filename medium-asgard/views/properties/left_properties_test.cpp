// The pane of values, when something else is selected or it goes with its window.
#include "properties/properties_pane.h"
#include "views/test_workshop.h"

#include <gmock/gmock.h>

#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include <memory>
#include <tuple>

namespace views {
namespace {

using editing::Kind;
using ::testing::HasSubstr;

const std::string twoBalls = "shape_set s -desc {-sub {-sphere 0.5}}\n"
                             "body a s -init_pos {1 2 0}\nbody b s -init_pos {4 2 0}\n";

class LeftPropertiesTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void SetUp() override {
        document.setText(twoBalls, "Edit");
        ASSERT_TRUE(settle(document));
        document.select({{Kind::body, 0}});
    }
    TestWorkshop made;
    SceneDocument document{made.workshop()};
};

// The buttons follow a little later than the selection.
TEST_F(LeftPropertiesTest, ButtonsOfWhatIsNoLongerSelectedDoNothing) {
    int opened = 0;
    PropertiesPane pane{document, {[] {}, [&](const QString&) { ++opened; }, [](const auto&) {}}};
    pane.show();
    auto* shape = pane.findChild<QPushButton*>("shape");
    ASSERT_TRUE(shape && shape->isVisible());
    shape->click();
    EXPECT_EQ(opened, 1);
    document.select({});
    shape->click();
    pane.findChild<QPushButton*>("duplicate")->click();
    EXPECT_EQ(opened, 1);
    EXPECT_EQ(document.text(), twoBalls);
}

// A name that was typed belongs to nobody then.
TEST_F(LeftPropertiesTest, APaneIsDestroyedWithANameThatIsTyped) {
    auto pane = std::make_unique<PropertiesPane>(document, PropertyActions{});
    pane->show();
    pane->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(pane.get(), longestWait));
    pane->name().setFocus();
    QTest::keyClicks(&pane->name(), "other");
    pane.reset();
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.text(), twoBalls);
}

TEST_F(LeftPropertiesTest, ARefusedValueIsToldThoughOthersAreSelected) {
    PropertiesPane pane{document, PropertyActions{}};
    pane.show();
    auto* mass = pane.findChild<QLineEdit*>("-mass");
    ASSERT_NE(mass, nullptr);
    mass->setFocus();
    QTest::keyClicks(mass, "-3");
    QTest::keyClick(mass, Qt::Key_Return);
    document.select({{Kind::body, 1}});
    EXPECT_TRUE(waitFor([&] { return pane.fault().contains("a, Mass: "); }))
        << pane.fault().toStdString();
    EXPECT_TRUE(settle(document));
    EXPECT_EQ(document.text(), twoBalls);
}

TEST_F(LeftPropertiesTest, ARefusedSizeOrNameIsToldToo) {
    PropertiesPane pane{document, PropertyActions{}};
    pane.show();
    ASSERT_TRUE(pane.sizeRow());
    QLineEdit* size = pane.sizeRow()->fields()[0];
    const std::tuple<QLineEdit*, const char*, const char*, bool> typed[] = {
        {size, "-3", "a, Radius: ", false},
        {&pane.name(), "b", "a, Name: ", false},
        {&pane.name(), "b", "a, Name: ", true}};
    for (const auto& [field, value, told, isReadFirst] : typed) {
        document.select({{Kind::body, 0}});
        QTest::qWait(120);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, value);
        QTest::keyClick(field, Qt::Key_Return);
        EXPECT_TRUE(!isReadFirst || settle(document)); // then the pane shows the first one still
        document.select({{Kind::body, 1}});
        EXPECT_TRUE(settle(document));
        QTest::qWait(120);
        EXPECT_THAT(pane.fault().toStdString(), HasSubstr(told)) << value;
        EXPECT_EQ(document.text(), twoBalls) << value;
    }
}

TEST_F(LeftPropertiesTest, EscapeBringsANameBack) {
    PropertiesPane pane{document, PropertyActions{}};
    pane.show();
    pane.name().setFocus();
    pane.name().selectAll();
    QTest::keyClicks(&pane.name(), "other");
    QTest::keyClick(&pane.name(), Qt::Key_Escape);
    EXPECT_EQ(pane.name().text(), "a");
    EXPECT_FALSE(pane.name().isModified());
}

} // namespace
} // namespace views
