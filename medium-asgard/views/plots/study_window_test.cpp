#include "plots/study_window.h"

#include "views/test_workshop.h"

#include <gmock/gmock.h>

#include <QFile>
#include <QTemporaryDir>

namespace views {
namespace {

using ::testing::Each;
using ::testing::Field;
using ::testing::StartsWith;

const std::string springScene = "simulator -finish 1\n"
                                "shape_set ball -desc {-sub {-sphere 0.1}}\n"
                                "body b1 ball -mass 1 -init_pos {1 0 0}\n"
                                "force -body b1 -x {-10*sin(b1.x)} -y 0 -z 0\n";

class StudyWindowTest : public ::testing::Test {
protected:
    StudyWindowTest() {
        theApplication();
        scene_ = std::make_shared<const scene::Scene>(theReader().read(springScene).scene);
        plan_.methods = {"auto", "rk4", "dopri5"};
        plan_.accuracies = {1e-3, 1e-5};
        plan_.steps = {0.01};
    }
    QByteArray contents(const QString& name) const {
        QFile file(folder_.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    std::shared_ptr<const scene::Scene> scene_;
    simulation::StudyPlan plan_;
    QTemporaryDir folder_;
};

TEST_F(StudyWindowTest, MeasuresAllAndSavesChartsAndNumbers) {
    StudyWindow window(scene_, plan_, "spring.al");
    window.show();
    ASSERT_TRUE(waitFor([&] { return !window.isMeasuring(); }));
    EXPECT_EQ(window.result().rows.size(), 8U);
    EXPECT_THAT(window.result().rows,
                Each(Field(&simulation::StudyRow::status, simulation::Status::ok)));
    for (const auto& [name, start] : {std::pair("c.svg", "<?xml"), std::pair("c.pdf", "%PDF"),
                                      std::pair("c.csv", "method,accuracy")}) {
        EXPECT_EQ(window.save(folder_.filePath(name)), "");
        EXPECT_THAT(contents(name).toStdString(), StartsWith(start));
    }
    EXPECT_EQ(contents("c.csv").count('\n'), 9);
    EXPECT_THAT(window.save(folder_.filePath("no/c.csv")).toStdString(),
                StartsWith("Cannot write"));
}

TEST_F(StudyWindowTest, StopKeepsWhatIsMeasured) {
    plan_.accuracies.assign(1000, 1e-9);
    StudyWindow window(scene_, plan_, "spring.al");
    ASSERT_TRUE(waitFor([&] { return !window.result().rows.empty(); }));
    for (auto* button : window.findChildren<QPushButton*>())
        if (button->text() == "S&top")
            button->click();
    ASSERT_TRUE(waitFor([&] { return !window.isMeasuring(); }));
    EXPECT_GT(window.result().rows.size(), 0U);
    EXPECT_LT(window.result().rows.size(), 1000U);
}

TEST_F(StudyWindowTest, ClosingEndsTheStudy) {
    // So many that the test would not end.
    plan_.accuracies.assign(100'000, 1e-9);
    StudyWindow window(scene_, plan_, "spring.al");
    ASSERT_TRUE(waitFor([&] { return !window.result().rows.empty(); }));
    EXPECT_TRUE(window.isMeasuring());
}

} // namespace
} // namespace views
