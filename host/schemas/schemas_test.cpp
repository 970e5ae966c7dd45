#include "schemas/schemas.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>

#include <ctime>
#include <fstream>

namespace schemas {

namespace {

std::string faultsOf(const std::vector<sgml::Fault>& faults) {
    std::string lines;
    for (const sgml::Fault& fault : faults)
        lines += std::to_string(fault.position.line) + ": " + fault.message + "\n";
    return lines;
}

std::string structureFaultsOf(const std::string& schema) {
    std::vector<sgml::Fault> faults;
    (void)StructureSchema::parse(schema, faults);
    return faultsOf(faults);
}

std::string presentationFaultsOf(const std::string& text) {
    std::vector<sgml::Fault> faults;
    (void)Presentation::parse(text, faults);
    return faultsOf(faults);
}

std::string check(const std::string& schema, const std::string& body) {
    std::vector<sgml::Fault> faults;
    const StructureSchema structure = StructureSchema::parse(schema, faults);
    EXPECT_EQ(faultsOf(faults), "");
    const sgml::Tree tree = sgml::Tree::parse("DOCUMENT A\n" + body);
    std::string messages;
    for (const sgml::Fault& fault : structure.check(tree, tree.root()))
        messages += fault.message + "\n";
    return messages;
}

} // namespace

TEST(Structure, ChecksContentAgainstRules) {
    const std::string schema =
        "A = B C? (D | E)* TEXT?\nB = TEXT\nC [X] =\nD = ANY\nE = B+\nTEXT = TEXT\n";
    struct {
        std::string body, messages;
    } cases[] = {
        {"<A><B>{x}</B></A>", ""},
        {"<A><B><TEXT>{x}</TEXT></B><C></C><E><B>{}</B></E><D><C></C></D><TEXT>{x}</TEXT></A>", ""},
        {"<A></A>", "<A> ends too early; expected B\n"},
        {"<A><C></C></A>", "<C> does not belong here in <A>; expected B\n"},
        {"<A><B>{x}</B><C></C><C></C></A>",
         "<C> does not belong here in <A>; expected D, E, text or the end\n"},
        {"<A><B>{x}</B><C>{x}</C></A>", "text does not belong here in <C>; expected the end\n"},
        {"<A><B>{x}</B><Q>{x}</Q></A>", "<Q> is not known to this class of documents\n"},
        {"<A><B>{x}</B><C X=\"1\" ID=\"2\" Y=\"3\"></C></A>", "attribute Y is not known for <C>\n"},
        {"<A WIDTH=\"3\"><B>{x}</B></A>", ""},
        {"<A><B>{x}</B><E></E></A>", "<E> ends too early; expected B\n"},
    };
    for (const auto& [body, messages] : cases)
        EXPECT_EQ(check(schema, body), messages) << body;
}

TEST(Structure, FaultsOfAFileAreGivenByLine) {
    EXPECT_EQ(structureFaultsOf("# fine\nA = (B | C\nB\nC = |\n\nD = $x\nA = B\nA =\n$p = B**\n1 = "
                                "B\nE = B )\nF [X = B\n"),
              "2: \")\" is missing\n"
              "3: a rule is NAME = what it may hold\n"
              "4: a name is missing\n"
              "6: $x is not defined before this line\n"
              "8: a second rule for A\n"
              "10: \"1\" is not a name\n"
              "11: \")\" is not expected here\n"
              "12: \"]\" is missing behind the attributes\n");
    EXPECT_EQ(structureFaultsOf("A = " + std::string(60, '(') + "B" + std::string(60, ')')),
              "1: parentheses are nested deeper than 50\n");
}

TEST(Structure, SaysWhatMayComeInBetween) {
    std::string fault;
    const ContentModel model = ContentModel::parse("A B? (C | TEXT)* D", fault);
    using Names = std::vector<std::string>;
    EXPECT_EQ(model.allowedAt({"A", "D"}, 1), (Names{"B", "C", "TEXT"}));
    EXPECT_EQ(model.allowedAt({"A", "C", "", "D"}, 2), (Names{"C", "TEXT"}));
    EXPECT_EQ(model.allowedAt({"A", "C", "D"}, 1), (Names{"B", "C", "TEXT"}));
    EXPECT_EQ(model.allowedAt({"A", "D"}, 2), Names{});
    EXPECT_EQ(model.allowedAt({"D"}, 0), Names{"A"});
    EXPECT_EQ(model.allowedAt({"B", "D"}, 2), Names{}); // what is before does not belong
}

TEST(Presentation, SaysWhatAnElementIsWhereverItStands) {
    std::vector<sgml::Fault> faults;
    const Presentation presentation = Presentation::parse(
        "B C { role: figure; display: verbatim }\nC { display: block; role: paragraph }\n"
        "A D { display: cell }\nL[K=n] D { show: no }\nL[K=a]:first { show: no }\n",
        faults);
    EXPECT_EQ(presentation.variantsOf("L"),
              (std::vector<Presentation::Variant>{{"K", "a"}, {"K", "n"}}));
    EXPECT_EQ(presentation.styleNamed("C").display, Display::block);
    EXPECT_EQ(presentation.styleNamed("C").role, ContainerRole::paragraph);
    EXPECT_EQ(presentation.styleNamed("D").display, Display::cell);
    EXPECT_EQ(presentation.styleNamed("E").display, Display::unknown);
}

// A backtracking matcher would need 2^n steps for (B? B?)... ; a set of positions does not.
TEST(Structure, NoRuleIsExponential) {
    std::string rule = "A =", body = "<A>";
    for (int i = 0; i < 60; ++i)
        rule += " (B* B*)*";
    for (int i = 0; i < 200; ++i)
        body += "<B></B>";
    const std::clock_t start = std::clock(); // of the processor, not of the wall
    EXPECT_EQ(check(rule + " C\nB =\nC =\n", body + "</A>"),
              "<A> ends too early; expected B or C\n");
    EXPECT_LT(std::clock() - start, 3 * CLOCKS_PER_SEC);
}

TEST(Presentation, FaultsOfAFileAreGivenByLine) {
    EXPECT_EQ(presentationFaultsOf("/* fine */\nA { font: 12pt bold \"Gentium\" }\nB { size: 3 "
                                   "}\nC { font: huge; color: #12; }\n"
                                   "D { space-before: 3 }\nE { show: maybe }\n<F> { show: no "
                                   "}\nPAGE { size: B9 }\nG { number: 1 }\nH { x\n"),
              "3: size: no such property\n"
              "4: font: \"huge\" is no size (1pt to 500pt, or %), family, bold, regular, italic, "
              "upright or underline\n"
              "4: color: wants a colour: #rrggbb, black, white, grey, red, green or blue\n"
              "5: space-before: wants a length of at least 0 (pt, mm, cm, in, px)\n"
              "6: show: wants yes or no\n"
              "7: \"<F> \" does not name elements\n"
              "8: size: wants A3, A4, A5, letter, legal or slide, or two lengths of at least 1in\n"
              "9: number: wants a string in quotes, or none\n"
              "10: a property is NAME: value;\n"
              "10: this \"{\" is not closed with \"}\"\n");
    EXPECT_EQ(presentationFaultsOf("A { font: 12pt }\n}\nB {"),
              "2: \"}\" closes nothing\n3: this \"{\" is not closed with \"}\"\n");
    EXPECT_EQ(presentationFaultsOf("/* never"), "1: a comment is not closed with \"*/\"\n");
}

TEST(Presentation, MoreNamesWinThenTheLaterBlock) {
    std::vector<sgml::Fault> faults;
    const Presentation base = Presentation::parse("H { font: 9pt } S S H { font: 8pt }", faults);
    const Presentation own =
        Presentation::parse("S H { font: 14pt bold; number: \"1\" } H { font: 10pt; color: #f00 }\n"
                            "H:first { align: right } S[KIND=x] { show: no }",
                            faults, &base);
    ASSERT_TRUE(faults.empty());
    const sgml::Tree tree = sgml::Tree::parse("DOCUMENT S\n<S KIND=\"x\"><S><H></H></S></S>");
    Presentation::Progress progress = own.start();
    const sgml::NodeId s = tree.classElement(tree.root());
    const ElementStyle first = own.style({"S", true, &tree, s}, own.rootStyle(), progress);
    EXPECT_FALSE(first.show);
    const ElementStyle second =
        own.style({"S", true, &tree, tree.childElement(s)}, first, progress);
    EXPECT_TRUE(second.show);
    const ElementStyle heading = own.style({.name = "H", .first = true}, second, progress);
    EXPECT_EQ(heading.text.size, 14);
    EXPECT_TRUE(heading.text.bold);
    EXPECT_EQ(heading.text.color, (Color{255, 0, 0}));
    EXPECT_EQ(heading.block.align, Align::right);
    EXPECT_EQ(heading.number, "1");
}

TEST(Presentation, AnOuterElementIsOfTheKindThatTheNearestOfItsNameHas) {
    std::vector<sgml::Fault> faults;
    const Presentation own =
        Presentation::parse("L I { number: none } L[KIND=n] I { number: \"1.\" }", faults, nullptr);
    ASSERT_TRUE(faults.empty());
    const std::string numbered = " KIND=\"n\"";
    const auto numberOfInner = [&](const std::vector<std::string>& lists) {
        std::string begin, end;
        for (const std::string& kind : lists) {
            begin += "<L" + kind + "><I>";
            end.insert(0, "</I></L>");
        }
        const sgml::Tree tree = sgml::Tree::parse("DOCUMENT D\n<D>" + begin + end + "</D>");
        Presentation::Progress progress = own.start();
        ElementStyle style = own.rootStyle();
        for (sgml::NodeId at = tree.classElement(tree.root()); at != sgml::noNode;
             at = tree.node(at).firstChild)
            style = own.style({tree.name(at), true, &tree, at}, style, progress);
        return style.number;
    };
    EXPECT_EQ(numberOfInner({numbered}), "1.");
    EXPECT_EQ(numberOfInner({""}), "");
    EXPECT_EQ(numberOfInner({"", numbered}), "1.");
    EXPECT_EQ(numberOfInner({numbered, ""}), "");
    EXPECT_EQ(numberOfInner({numbered, "", numbered}), "1.");
    EXPECT_EQ(numberOfInner({"", numbered, ""}), "");
}

TEST(Schemas, BuiltInOnesAreSoundAndBoth) {
    const Schemas schemas = Schemas::builtIn();
    std::string faults;
    for (const Schemas::FileFault& fault : schemas.faults())
        faults += sgml::formatted(fault.fault, fault.file.toStdString()) + "\n";
    EXPECT_EQ(faults, "");
    EXPECT_EQ(schemas.presentations("CMEMO"),
              (QStringList{"default", "handout", "print", "slides"}));
    EXPECT_EQ(schemas.presentations("REPORT"),
              (QStringList{"default", "handout", "outline", "print", "slides"}));
    EXPECT_TRUE(schemas.isText("REPORT"));
    EXPECT_FALSE(schemas.isText("ANIMATION"));
    EXPECT_NE(schemas.structure("CMEMO"), nullptr);
    EXPECT_EQ(schemas.presentation("REPORT", "outline").page().marginTop,
              schemas.presentation("CMEMO").page().marginTop);
}

// A user's file comes before the built-in one, unless it is faulty; then it is reported.
TEST(Schemas, FilesOfUsersComeFirstUnlessFaulty) {
    QTemporaryDir folder;
    const auto put = [&](const std::string& name, const std::string& text) {
        std::ofstream(folder.filePath(QString::fromStdString(name)).toStdString()) << text;
    };
    put("CMEMO.default.presentation", "PAGE { margin: 50pt }");
    put("CMEMO.mine.presentation", "PAGE { margin: 60pt }");
    put("REPORT.default.presentation", "PAGE { margin: wide }\n");
    put("LETTER.structure", "LETTER = ANY\n");
    const Schemas schemas = Schemas::load({folder.path()});
    EXPECT_EQ(schemas.presentation("CMEMO").page().marginLeft, 50);
    EXPECT_EQ(schemas.presentations("CMEMO"),
              (QStringList{"default", "handout", "mine", "print", "slides"}));
    EXPECT_NE(schemas.structure("LETTER"), nullptr);
    ASSERT_EQ(schemas.faults().size(), 1u);
    EXPECT_TRUE(schemas.faults()[0].file.endsWith("REPORT.default.presentation"));
    EXPECT_EQ(schemas.faults()[0].fault.position.line, 1);
    EXPECT_EQ(schemas.presentation("REPORT").page().marginLeft,
              Schemas::builtIn().presentation("REPORT").page().marginLeft);
}

TEST(Schemas, WhatIsFaultyIsLeftOutAndTheRestCounts) {
    QTemporaryDir folder;
    const auto put = [&](const std::string& name, const std::string& text) {
        std::ofstream(folder.filePath(QString::fromStdString(name)).toStdString()) << text;
    };
    put("CMEMO.default.presentation",
        "PAGE { margin: 50pt; wobble: 3 }\nTO { flavour: sweet; indent: 7pt }");
    put("LETTER.structure", "LETTER = ANY\nBAD = (\n");
    put("EMPTY.default.presentation", "nothing at all");
    const Schemas schemas = Schemas::load({folder.path()});
    EXPECT_EQ(schemas.presentation("CMEMO").page().marginLeft, 50);
    EXPECT_NE(schemas.structure("LETTER"), nullptr);
    EXPECT_FALSE(schemas.isText("EMPTY"));
    ASSERT_EQ(schemas.faults().size(), 4u);
    for (const Schemas::FileFault& fault : schemas.faults())
        EXPECT_EQ(fault.fault.severity, sgml::Severity::warning);
    Presentation::Progress progress = schemas.presentation("CMEMO").start();
    const ElementStyle to = schemas.presentation("CMEMO").style(
        {.name = "TO"}, schemas.presentation("CMEMO").rootStyle(), progress);
    EXPECT_EQ(to.block.indentLeft, 7);
}

TEST(Schemas, APresentationInheritsFromItsClassesDefaultOne) {
    QTemporaryDir folder;
    const auto put = [&](const std::string& name, const std::string& text) {
        std::ofstream(folder.filePath(QString::fromStdString(name)).toStdString()) << text;
    };
    put("LETTER.default.presentation",
        "PAGE { margin: 50pt; footer-left: \"f\" }\nA B { indent: 7pt; font: 20pt }\n");
    put("LETTER.another.presentation", "PAGE { margin: 60pt }\nB { font: 9pt }\n"); // read after it
    const Schemas schemas = Schemas::load({folder.path()});
    const Presentation& another = schemas.presentation("LETTER", "another");
    EXPECT_EQ(another.page().marginLeft, 60);
    EXPECT_EQ(another.page().footerLeft, "f");
    Presentation::Progress progress = another.start();
    const ElementStyle a = another.style({.name = "A"}, another.rootStyle(), progress);
    const ElementStyle b = another.style({.name = "B"}, a, progress);
    EXPECT_EQ(b.block.indentLeft, 7); // of the class's
    EXPECT_EQ(b.text.size, 9);        // its own counts more, though it names less
    const ElementStyle emph = another.style({.name = "EMPH"}, b, progress);
    EXPECT_TRUE(emph.text.italic); // of COMMON.base
}

// The heirs of an edited file follow, in their place; the file's faults are those of its text.
TEST(Schemas, AnotherTextCountsInTheMidstOfEditing) {
    Schemas schemas = Schemas::builtIn();
    const Presentation& slides = schemas.presentation("REPORT", "slides");
    const Schemas::File file = schemas.fileOf("REPORT", "");
    EXPECT_EQ(file.name, "REPORT.default.presentation");
    EXPECT_EQ(schemas.fileOf("REPORT", "slides").name, "REPORT.slides.presentation");
    EXPECT_EQ(schemas.fileOf("UNKNOWN", "").name, "COMMON.base.presentation");
    const PageStyle before = slides.page();
    schemas.setText(file.name, "own", file.text + "PAGE { header-left: \"new\"; size: A9 }\n");
    EXPECT_EQ(slides.page().headerLeft, "new");
    ASSERT_EQ(schemas.faults().size(), 1u);
    EXPECT_EQ(schemas.faults()[0].file, "own");
    EXPECT_EQ(schemas.faults()[0].fault.message.substr(0, 5), "size:");
    schemas.setText(file.name, "own", file.text + "PAGE { size: A9 }\n"); // in the same place
    EXPECT_EQ(schemas.faults().size(), 1u);
    schemas.setText(file.name, "own", "");
    EXPECT_EQ(schemas.presentation("REPORT").page(), schemas.presentation("UNKNOWN").page());
    schemas.setText(file.name, file.path, file.text);
    EXPECT_EQ(slides.page(), before);
    EXPECT_TRUE(schemas.faults().empty());
    EXPECT_EQ(&slides, &schemas.presentation("REPORT", "slides"));
}

} // namespace schemas
