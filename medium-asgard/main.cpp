// asgard: the animation medium. Serves a document host, opens its stand-alone editor, or works
// without a window on one scene (docs/command-line.md).
#include "batch/command.h"
#include "edit_mode.h"
#include "medium_process.h"
#include "screen/display.h"
#include "screen/numbers.h"
#include "terminal/terminal.h"
#include "viewers/run_editor.h"
#include "wrong_usage.h"

#include <CLI/CLI.hpp>

#include <span>

namespace {

constexpr const char* summary =
    "Asgard computes and shows the motion of bodies in space as their equations say.\n"
    "A scene is a text in the language of docs/scene-language.md.";

int notInThisVersion(const std::string& what) {
    terminal::complain("asgard: this version does not have " + what);
    return batch::wrongUsage;
}

void addSimulate(CLI::App& app, batch::SimulateArguments& a) {
    CLI::App& c =
        *app.add_subcommand("simulate", "Compute the motion of a scene and write it as a table");
    c.add_option("SCENE", a.scene, "the scene's file, - for standard input")->required();
    c.add_option("--csv", a.csv, "file of the table, - for standard output");
    c.add_option("--at", a.at, "times T0:DT:T1");
    c.add_option("--times", a.times, "file with times");
    c.add_option("--quantities", a.quantities, "expressions to add, with commas between them");
    c.add_flag("--only", a.only, "write t and the quantities only");
    c.add_option("--accuracy", a.accuracy, "largest position error over the size of the scene");
    c.add_option("--finish", a.finish, "time at which the motion ends");
    CLI::Option* method = c.add_option("--method", a.method, "integration method instead of auto");
    c.add_option("--fixed-step", a.fixedStep, "steps of exactly this length")->needs(method);
    c.add_flag("--whole", a.whole, "solve the scene as one component");
    c.add_flag("--no-events", a.noEvents, "finish each component before the next");
    c.add_option("--threads", a.threads,
                 "how many components are computed at a time; from 2 on, two runs");
    c.add_flag("--verbose", a.verbose, "say how accurate the motion is, as is always done");
    c.add_option("--memory", a.memory,
                 "MB of history that each of the compared runs may keep (80)");
    c.add_option("--set", a.set, "NAME=VALUE of a parameter")->take_all()->allow_extra_args(false);
    c.add_option("--stats", a.stats, "file for the work done, as JSON");
    c.add_option("--events", a.events,
                 "file for the list of impacts, contacts, stops, releases, as CSV");
}

void addExplain(CLI::App& app, batch::ExplainArguments& a) {
    CLI::App& c =
        *app.add_subcommand("explain", "Tell which parts of a scene are modelled, how, and why");
    c.add_option("SCENE", a.scene, "the scene's file, - for standard input")->required();
    c.add_option("--json", a.json, "file for the explanation as JSON, - for standard output");
    c.add_flag("--all", a.all, "cut no equation and no list");
    c.add_option(
        "--expressions", a.expressions,
        "BODY or BODY.QUANTITY: instead, its equations in every form, down to machine code");
    c.add_option("--set", a.set, "NAME=VALUE of a parameter")->take_all()->allow_extra_args(false);
}

void addStudy(CLI::App& app, batch::StudyArguments& a) {
    CLI::App& c = *app.add_subcommand("study", "Compare methods and accuracies on a scene");
    c.add_option("SCENE", a.scene, "the scene's file, - for standard input")->required();
    c.add_option("--methods", a.methods, "methods, with commas between them, instead of all");
    c.add_option("--accuracies", a.accuracies, "accuracies to ask for, with commas between them");
    c.add_option("--steps", a.steps, "fixed steps in seconds, with commas between them");
    c.add_option("--reference", a.reference, "table of true places, instead of a run at 1e-12");
    c.add_option("--limit", a.limit, "processor seconds after which a run is stopped (2)");
    c.add_option("--csv", a.csv, "file of the table, - for standard output");
    c.add_option("--output", a.output, "chart, CHART.svg, CHART.png or CHART.pdf");
    c.add_option("--set", a.set, "NAME=VALUE of a parameter")->take_all()->allow_extra_args(false);
}

void addRender(CLI::App& app, batch::RenderArguments& a) {
    CLI::App& c = *app.add_subcommand("render", "Draw a scene into picture files");
    c.add_option("SCENE", a.scene, "the scene's file, - for standard input")->required();
    c.add_option("--time", a.time, "time of the picture, instead of the start");
    c.add_option("--from", a.from, "first time of numbered pictures");
    c.add_option("--to", a.to, "last time of numbered pictures");
    c.add_option("--fps", a.fps, "pictures per second (25)");
    c.add_option("--size", a.size, "WIDTHxHEIGHT in pixels (640x480)");
    c.add_option("--view", a.view, "name of the scene's view, instead of its first");
    c.add_flag("--wireframe", a.wireframe, "edges instead of faces");
    c.add_option("--background", a.background, "#rrggbb or a colour's name (white)");
    c.add_option("--output", a.output, "FRAME.png, FRAME.ppm or DIR/")->required();
}

void addAssemble(CLI::App& app, batch::AssembleArguments& a) {
    CLI::App& c = *app.add_subcommand(
        "assemble",
        "Move bodies so that joints close and none overlap, and write it into the scene's text");
    c.add_option("SCENE", a.scene, "the scene's file, - for standard input")->required();
    c.add_option("--output", a.output, "file for the new text, - for standard output");
}

// Named in the contract, part of a later version: whatever follows them is taken and not looked at.
CLI::App* addLater(CLI::App& app, const std::string& name, const std::string& what) {
    CLI::App* c = app.add_subcommand(name, what + " (not in this version)");
    c->allow_extras();
    return c;
}

int run(int argc, char** argv, script::Reader& reader) {
    CLI::App app(summary, "asgard");
    app.set_version_flag("--version", std::string("asgard ") + ASGARD_VERSION);
    app.require_subcommand(0, 1);
    std::string scene;
    bool medium = false;
    app.add_flag("--medium", medium, "serve a document host over standard input and output");
    app.add_option("SCENE", scene, "open this scene in the stand-alone editor");
    batch::SimulateArguments simulate;
    batch::ExplainArguments explain;
    batch::StudyArguments study;
    batch::CheckArguments check;
    batch::AssembleArguments assemble;
    batch::RenderArguments render;
    addSimulate(app, simulate);
    addStudy(app, study);
    app.add_subcommand("check", "Tell every fault of a scene")
        ->add_option("SCENE", check.scene, "the scene's file, - for standard input")
        ->required();
    addAssemble(app, assemble);
    addRender(app, render);
    addExplain(app, explain);
    const CLI::App* later[] = {addLater(app, "export", "Write a scene for other programs")};
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) // --help, --version
            return app.exit(error);
        const std::span<char* const> words(argv + 1, argv + argc);
        terminal::complain("asgard: " + asgard::wrongUsage(app, error, words));
        return batch::wrongUsage;
    }
    for (const CLI::App* command : later)
        if (*command)
            return notInThisVersion("\"asgard " + command->get_name() + "\"");
    if (app.got_subcommand("simulate"))
        return batch::simulateCommand(reader, simulate);
    if (app.got_subcommand("explain"))
        return batch::explainCommand(reader, explain);
    if (app.got_subcommand("study"))
        return batch::studyCommand(reader, study);
    if (app.got_subcommand("check"))
        return batch::checkCommand(reader, check);
    if (app.got_subcommand("assemble"))
        return batch::assembleCommand(reader, assemble);
    if (app.got_subcommand("render"))
        return batch::renderCommand(reader, render);
    if (medium)
        return asgard::serveAsMedium(reader);
    if (const std::string fault = asgard::misspeltCommand(app, scene); !fault.empty()) {
        terminal::complain("asgard: " + fault);
        return batch::wrongUsage;
    }
    if (const std::string fault = screen::displayFault(); !fault.empty()) {
        terminal::complain("asgard: " + fault + "; simulate, check and render need none");
        return batch::failure;
    }
    return views::runEditor(argc, argv, scene, reader);
}

} // namespace

int main(int argc, char** argv) {
    asgard::tieToTheHost(argc, argv);
    screen::keepNumbersC();
    // Before anything else: what it forks must not have seen a scene, a thread or a driver.
    script::Reader reader;
    return run(argc, argv, reader);
}
