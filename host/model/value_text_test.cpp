// Values of subdocuments in a model: how their numbers are written, and which blocks follow them.
#include "exports/text_export.h"
#include "model/model_builder.h"
#include "model/value_text.h"

#include <gmock/gmock.h>

#include <map>

namespace model {

using exports::exportText;
namespace {

using document::Digits;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class KnownValues : public ValueSource {
public:
    [[nodiscard]] ValueNow valueNow(const document::ValueUse& use) const override {
        const auto found = now.find(use.of + "." + use.expression);
        return found == now.end() ? ValueNow{} : found->second;
    }
    std::map<std::string, ValueNow> now;
};

TEST(ValueText, NumbersAreWrittenAsTheirAuthorsWantThem) {
    EXPECT_EQ(written(3.14159, {3, false}, ""), "3.14");
    EXPECT_EQ(written(3.14159, {2, true}, "en-GB"), "3.14");
    EXPECT_EQ(written(3.14159, {2, true}, "de"), "3,14");
    EXPECT_EQ(written(-9.81, {1, true}, ""), "\u22129.8");
    EXPECT_EQ(written(-0.004, {2, true}, ""), "0.00"); // nothing is not negative
    EXPECT_EQ(written(0, {3, false}, ""), "0.00");
    EXPECT_EQ(written(9.996, {3, false}, ""), "10.0");
    EXPECT_EQ(written(123456, {3, false}, ""), "123456");
    EXPECT_EQ(written(0.000123, {2, false}, ""), "0.00012");
    EXPECT_EQ(written(1.5e-7, {2, false}, ""), "1.5\u00D710\u207B\u2077");
    EXPECT_EQ(written(-6.02214e23, {3, false}, "de"), "\u22126,02\u00B710\u00B2\u00B3");
    EXPECT_EQ(written(2e300, {1, true}, ""), "2.0\u00D710\u00B3\u2070\u2070");
    EXPECT_EQ(written(1e14, {0, true}, ""), "100000000000000");
}

TEST(ValueText, InAFormulaTheyAreItsSource) {
    EXPECT_EQ(asFormula(-9.81, {1, true}, ""), "-9.8");
    EXPECT_EQ(asFormula(3.14159, {2, true}, "de"), "3{,}14");
    EXPECT_EQ(asFormula(1.5e-7, {2, false}, ""), "1.5\\times 10^{-7}");
    EXPECT_EQ(asFormula(1.5e-7, {2, false}, "fr"), "1{,}5\\cdot 10^{-7}");
}

class ValuesInModelTest : public ::testing::Test {
protected:
    ModelBuilder& built(const std::string& inside) {
        document_ = std::make_unique<document::Document>("DOCUMENT REPORT\n<REPORT><BODY>" +
                                                         inside + "</BODY></REPORT>");
        builder_ =
            std::make_unique<ModelBuilder>(*document_, schemas_.presentation("REPORT"), schemas_);
        builder_->setValues(&values_);
        complete();
        return *builder_;
    }
    void complete() {
        while (builder_->step(1000))
            continue;
    }
    std::string text() { return exportText(*document_, *builder_->model()); }
    const model::Run& runOf(std::size_t block, std::size_t run) {
        return builder_->model()->blocks[block]->runs[run];
    }
    // How many blocks a change of values made.
    std::size_t following() {
        const std::size_t before = builder_->work().blocks;
        const bool changed = builder_->followValues();
        EXPECT_EQ(changed, builder_->work().blocks > before);
        return builder_->work().blocks - before;
    }

    schemas::Schemas schemas_ = schemas::Schemas::builtIn();
    KnownValues values_;
    std::unique_ptr<document::Document> document_;
    std::unique_ptr<ModelBuilder> builder_;
};

constexpr const char* landing =
    "<PARAGRAPH><TEXT>{It lands at }</TEXT><VALUE OF=\"ball\" EXPRESSION=\"t\" FORMAT=\"2 "
    "decimals\">"
    "</VALUE><TEXT>{ s.}</TEXT></PARAGRAPH><PARAGRAPH>{Another one.}</PARAGRAPH>"
    "<PARAGRAPH><TEXT>{So }</TEXT><FORMULA>{E = \\value[1 decimal]{ball}{E}}</FORMULA>"
    "</PARAGRAPH>";

TEST_F(ValuesInModelTest, ANumberStandsInTheTextAndInAFormula) {
    values_.now = {{"ball.t", {.number = 0.4515}}, {"ball.E", {.number = -1.25}}};
    built(landing);
    EXPECT_EQ(text(), "It lands at 0.45 s.\n\nAnother one.\n\nSo E = \u22121.2\n");
    EXPECT_EQ(runOf(2, 1).formula->spoken, "E equals minus 1.2");
    EXPECT_EQ(runOf(0, 1).content, sgml::noNode); // it is one unit for a caret
}

TEST_F(ValuesInModelTest, AChangeMakesTheBlocksWithThatValueAnewAndNoOthers) {
    built(landing);
    EXPECT_THAT(text(), HasSubstr("at \u2026 s")); // not known yet
    const auto before = builder_->model();
    values_.now = {{"ball.t", {.number = 0.4515}}};
    EXPECT_EQ(following(), 1u);
    EXPECT_THAT(text(), HasSubstr("at 0.45 s"));
    EXPECT_NE(builder_->model()->blocks[0], before->blocks[0]);
    EXPECT_EQ(builder_->model()->blocks[1], before->blocks[1]);
    EXPECT_EQ(builder_->model()->blocks[2], before->blocks[2]);
    values_.now["ball.t"].number = 0.4521; // the same digits
    EXPECT_EQ(following(), 0u);
    values_.now["ball.E"].number = 3;
    EXPECT_EQ(following(), 1u);
    EXPECT_THAT(text(), HasSubstr("E = 3.0"));
}

TEST_F(ValuesInModelTest, WhatHasNoValueIsMarkedAndSoIsWhatIsOutOfDate) {
    values_.now = {{"ball.t", {.fault = "no t"}}, {"ball.E", {.number = 1, .isOutdated = true}}};
    built(landing);
    EXPECT_THAT(text(), HasSubstr("at [t] s"));
    const model::Run& faulty = runOf(0, 1);
    EXPECT_EQ(faulty.style, faulty.value->looks.faulty);
    EXPECT_NE(faulty.style, faulty.value->looks.usual);
    EXPECT_EQ(runOf(2, 1).style, runOf(2, 1).formula->looks.outdated);
    values_.now["ball.E"] = {.fault = "no E"};
    EXPECT_EQ(following(), 1u);
    EXPECT_THAT(text(), HasSubstr("E = [E]"));
    values_.now["ball.t"] = {.number = 1, .isOutdated = true};
    EXPECT_EQ(following(), 1u);
    EXPECT_EQ(runOf(0, 1).style, runOf(0, 1).value->looks.outdated);
    EXPECT_THAT(text(), HasSubstr("at 1.00 (out of date) s"));
    values_.now["ball.t"].isOutdated = false;
    EXPECT_EQ(following(), 1u);
    EXPECT_EQ(runOf(0, 1).style, runOf(0, 1).value->looks.usual);
}

TEST_F(ValuesInModelTest, WhileItPlaysANumberKeepsItsRoom) {
    values_.now = {{"ball.t", {.number = -12.5, .moves = true}}};
    built(landing);
    EXPECT_EQ(runOf(0, 1).text, "\u2007\u221212.50");
    EXPECT_EQ(runOf(0, 1).value->room, "\u221200.00");
    values_.now["ball.t"].number = 7;
    EXPECT_EQ(following(), 1u);
    EXPECT_EQ(runOf(0, 1).text, "\u20077.00");
    EXPECT_EQ(runOf(0, 1).value->room, "\u221200.00");
    EXPECT_EQ(plainText(runOf(0, 1)), "7.00");
    EXPECT_THAT(text(), HasSubstr("at 7.00 s"));
    values_.now["ball.t"].moves = false; // at rest it is set as it is
    EXPECT_EQ(following(), 1u);
    EXPECT_EQ(runOf(0, 1).text, "7.00");
    EXPECT_EQ(runOf(0, 1).value->room, "");
}

TEST_F(ValuesInModelTest, WhileItPlaysANumberInAFormulaKeepsItsRoom) {
    values_.now = {{"ball.E", {.number = -9.5, .moves = true}}};
    built(landing);
    const auto room = [this] { return runOf(2, 1).formula->values.front().room; };
    EXPECT_EQ(room(), "-0.0");
    values_.now["ball.E"].number = 10.5; // a digit more, but no minus sign
    EXPECT_EQ(following(), 1u);
    EXPECT_EQ(room(), "-0.0");
    EXPECT_THAT(text(), HasSubstr("E = 10.5"));
    EXPECT_EQ(runOf(2, 1).formula->spoken, "E equals 10.5");
    values_.now["ball.E"].number = -10.5;
    EXPECT_EQ(following(), 1u);
    EXPECT_EQ(room(), "-00.0");
    values_.now["ball.E"].moves = false;
    EXPECT_EQ(following(), 1u);
    EXPECT_EQ(room(), "");
    values_.now["ball.E"] = {.number = 1.2, .moves = true}; // begins with the room it had at rest
    EXPECT_EQ(following(), 1u);
    EXPECT_EQ(room(), "-00.0");
}

TEST_F(ValuesInModelTest, ValuesInTablesFootnotesAndHeadingsFollow) {
    values_.now = {{"a.x", {.number = 1}}};
    built("<CONTENTS></CONTENTS><SECTION><HEADING><TEXT>{At }</TEXT>"
          "<VALUE OF=\"a\" EXPRESSION=\"x\"></VALUE></HEADING>"
          "<TABLE><ROW><CELL><VALUE OF=\"a\" EXPRESSION=\"x\"></VALUE></CELL></ROW></TABLE>"
          "<PARAGRAPH><TEXT>{a}</TEXT><FOOTNOTE><VALUE OF=\"a\" EXPRESSION=\"x\"></VALUE>"
          "</FOOTNOTE></PARAGRAPH></SECTION>");
    values_.now["a.x"].number = 2;
    EXPECT_EQ(following(), 4u); // the contents list the heading
    const Model& model = *builder_->model();
    ModelBuilder anew(*document_, schemas_.presentation("REPORT"), schemas_);
    anew.setValues(&values_);
    while (anew.step(1000))
        continue;
    EXPECT_EQ(printed(model), printed(*anew.model()));
    EXPECT_EQ(model.footnotes.front()->blocks.front()->runs.front().text, "2.00");
}

TEST_F(ValuesInModelTest, AnEditElsewhereLeavesABlockWithAValueAsItIs) {
    values_.now = {{"ball.t", {.number = 1}}};
    built(landing);
    QObject::connect(document_.get(), &document::Document::edited, document_.get(),
                     [this](const sgml::Change& change) { builder_->follow(change); });
    const auto before = builder_->model();
    const std::size_t at = document_->bytes().find("Another");
    EXPECT_EQ(document_->edit({{{at, at}, "Yet "}}, "test"), document::EditResult::applied);
    EXPECT_FALSE(builder_->followValues()); // the walk takes them
    complete();
    EXPECT_EQ(builder_->model()->blocks[0], before->blocks[0]);
    EXPECT_EQ(builder_->model()->blocks[2], before->blocks[2]);
}

} // namespace
} // namespace model
