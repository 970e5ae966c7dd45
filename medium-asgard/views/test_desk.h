// Six windows of one scene, the hands that hold something in them, and the model of what they do.
//
// Pictures are made but for their pixels: handles are real.
#pragma once

#include "language/language_viewer.h"
#include "language/number_drag.h"
#include "panels/parameters_panel.h"
#include "script/evaluator.h"
#include "script/interpreter.h"
#include "script/verdict.h"
#include "shapes/shape_editor.h"
#include "text/characters.h"
#include "trajectories/trajectory_editor.h"
#include "viewers/graphical_viewer.h"
#include "views/test_undo_model.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QInputMethodEvent>
#include <QKeyEvent>
#include <QMouseEvent>

#include <cstdlib>
#include <random>
#include <unordered_map>

namespace views {

inline long setting(const char* name, long otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atol(text) : otherwise;
}

// The meaning of a text. These texts are ours: they are read in this process, and each only once.
inline std::shared_ptr<const script::ReadResult> meaningOf(const std::string& text) {
    static std::unordered_map<std::string, std::shared_ptr<const script::ReadResult>> known;
    if (const auto found = known.find(text); found != known.end())
        return found->second;
    script::Request request;
    request.commands = 20'000;
    request.text = text;
    script::Progress progress;
    script::Interpreter interpreter(progress);
    script::Answer answer;
    answer.bytes = interpreter.evaluate(request);
    if (known.size() > 5'000)
        known.clear();
    return known[text] = std::make_shared<const script::ReadResult>(
               script::judge(text, answer, script::Limits{}, {}));
}

inline void send(QWidget& to, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
                 Qt::KeyboardModifiers keys = Qt::ShiftModifier) {
    const bool moves = type == QEvent::MouseMove, ends = type == QEvent::MouseButtonRelease;
    QMouseEvent event(type, at, at, moves ? Qt::NoButton : button,
                      ends ? Qt::NoButton : Qt::MouseButtons(button), keys);
    QApplication::sendEvent(&to, &event);
}

inline void press(QWidget& to, int key, Qt::KeyboardModifiers keys = {}, const QString& text = {}) {
    QKeyEvent event(QEvent::KeyPress, key, keys, text);
    QApplication::sendEvent(&to, &event);
}

inline void letGo(QWidget& to, int key) {
    QKeyEvent event(QEvent::KeyRelease, key, Qt::NoModifier);
    QApplication::sendEvent(&to, &event);
}

inline QAction& actionOf(QWidget& window, const QKeySequence& keys) {
    for (QAction* action : window.findChildren<QAction*>())
        if (action->shortcuts().contains(keys))
            return *action;
    throw std::runtime_error("no such action: " + keys.toString().toStdString());
}

class Desk {
protected:
    struct Text {
        std::unique_ptr<LanguageViewer> viewer;
        QAction *undo, *redo, *keepMine;
        std::string counted; // its text when a number began to be counted
        bool countsInDraft = false;
    };
    struct Seen {
        std::unique_ptr<GraphicalViewer> viewer;
        Qt::MouseButton button = Qt::NoButton; // that is down
        bool byKeys = false;
        QPointF at;
        std::string slider; // that is held
        ParametersPanel* sliders = nullptr;
        QAction *undo, *redo;
        SceneDisplay& display() { return viewer->display(); }
    };

    Desk() {
        model.drafts.resize(texts.size());
        Windows windows;
        windows.save = [] {};
        for (Text& text : texts) {
            text.viewer = std::make_unique<LanguageViewer>(document, windows, 1);
            text.undo = &actionOf(*text.viewer, QKeySequence::Undo);
            text.redo = &actionOf(*text.viewer, QKeySequence::Redo);
            text.keepMine = &actionOf(*text.viewer, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_M));
        }
        render::Display all;
        for (bool render::Display::*kind :
             {&render::Display::positionHandles, &render::Display::orientationHandles,
              &render::Display::velocityHandles, &render::Display::spinHandles,
              &render::Display::forceHandles, &render::Display::linkHandles,
              &render::Display::lightHandles, &render::Display::trajectories})
            all.*kind = true;
        for (Seen& seen : scenes) {
            seen.viewer = std::make_unique<GraphicalViewer>(document, pictures, windows, 1);
            seen.sliders = seen.viewer->findChild<ParametersPanel*>();
            seen.undo = &actionOf(*seen.viewer, QKeySequence::Undo);
            seen.redo = &actionOf(*seen.viewer, QKeySequence::Redo);
            seen.display().resize(640, 480);
            seen.display().setDisplay(all);
            seen.display().editing().setConfirm([](const QString&) { return true; });
        }
        scenes[1].display().lookAlong({1, 0.3, 0.2});
    }

    std::size_t below(std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    }
    double number(double size) {
        return std::uniform_real_distribution<double>(-size, size)(random);
    }
    QPointF nearby(const QPointF& at) { return at + QPointF(number(80), number(80)); }

    // --- the model, and what is compared with it
    void compare() {
        ASSERT_EQ(document.text(), model.text());
        ASSERT_EQ(document.revision(), model.revision());
        ASSERT_EQ(document.canUndo(), model.canUndo());
        ASSERT_EQ(document.canRedo(), model.canRedo());
        for (std::size_t i = 0; i < texts.size(); ++i) {
            ASSERT_EQ(texts[i].viewer->draft(), model.drafts[i].text);
            ASSERT_EQ(texts[i].viewer->hasDraft(), model.drafts[i].edited());
        }
    }
    std::string wanted(const Asked& asked) const {
        const std::string& start = model.textAt(asked.since);
        return asked.answer.possible() ? text::applied(start, asked.answer.edits) : start;
    }
    void previewed(const void* hand, const std::optional<Asked>& asked) {
        if (asked && asked->answer.possible())
            model.preview(wanted(*asked), asked->since, hand);
    }
    void finished(const void* hand, const std::optional<Asked>& asked) {
        if (asked)
            model.finish(wanted(*asked), asked->since, hand);
    }
    void cancelled(const void* hand, const std::optional<Asked>& asked) {
        if (asked)
            model.finish(model.textAt(asked->since), asked->since, hand);
    }

    // The scene of the text as it is, or was a moment ago; a good text's only.
    void arrive(bool late = false) {
        const std::string& text =
            late ? model.textAt(std::max(model.revision() - 2, firstRevision)) : model.text();
        const auto read = meaningOf(text);
        Computed computed;
        computed.current = read->usable && text == model.text();
        computed.shown = document.shown();
        computed.text = document.shownText();
        if (read->usable && document.shownText() != text) {
            computed.shown.scene = std::make_shared<const scene::Scene>(read->scene);
            computed.shown.motion = flight(*computed.shown.scene);
            computed.text = text;
        }
        computed.diagnostics = read->diagnostics;
        document.setComputed(computed);
    }
    [[nodiscard]] const scene::Scene& scene() const { return *document.shown().scene; }

    // --- language viewers
    void select(Text& text, scene::Range range) { text.viewer->select(range.from, range.to); }
    static std::size_t atCharacter(const std::string& text, std::size_t place) {
        while (
            place > 0 && place < text.size() &&
            (text::isContinuation(text[place]) || (text[place - 1] == '\r' && text[place] == '\n')))
            --place;
        return place;
    }
    // Mostly what leaves the text readable: without a scene nothing can be dragged.
    void type(std::size_t i) {
        endCounting(i);
        std::string& text = model.drafts[i].text;
        SceneEditor& editor = texts[i].viewer->editor();
        const bool careful = below(8) > 0;
        std::size_t from = atCharacter(text, below(text.size() + 1)), to = from;
        if (careful)
            from = to = from == 0 ? 0 : text.rfind('\n', from - 1) + 1; // none: the first line's
        else if (below(3) == 0)
            to = atCharacter(text, std::min(text.size(), from + below(4)));
        const scene::Range range{std::min(from, to), std::max(from, to)};
        const auto put = [&](const std::string& piece) {
            text = text.substr(0, range.from) + piece + text.substr(range.to);
        };
        switch (below(5)) {
        case 0: { // as Replace does
            static const std::vector<std::string> pieces = {
                "# \xc3\xa4\n", "\n", "set q 3\n", "# {n}\n", "1", ";", "2.5"};
            const std::string& piece = pieces[below(careful ? 4 : pieces.size())];
            editor.replace(range, piece);
            return put(piece);
        }
        case 1: {
            const std::string piece = careful ? "# \xc3\xb6;" : "\xc3\xb6";
            select(texts[i], range);
            QInputMethodEvent event;
            event.setCommitString(QString::fromStdString(piece));
            QApplication::sendEvent(&editor, &event);
            return put(piece);
        }
        case 2:
            return backspace(i, range);
        default: {
            const char key = careful ? ' ' : " 17;x"[below(5)];
            select(texts[i], range);
            press(editor, key, {}, QString(QChar(key)));
            editor.cancelList();
            return put(std::string(1, key));
        }
        }
    }
    void backspace(std::size_t i, scene::Range range) {
        std::string& text = model.drafts[i].text;
        SceneEditor& editor = texts[i].viewer->editor();
        select(texts[i], range);
        // Beside points that are not shown it selects them.
        const bool selects =
            !range.known() && range.from > 0 && editor.isMarked(Mark::elided, range.from - 1);
        press(editor, Qt::Key_Backspace);
        if (selects)
            return;
        if (!range.known() && range.from > 0)
            range.from = atCharacter(text, range.from - 1);
        // A break of two bytes goes as one.
        if (range.to - range.from == 1 && range.from > 0 && text[range.from - 1] == '\r' &&
            text[range.from] == '\n')
            --range.from;
        text.erase(range.from, range.to - range.from);
    }
    // Places that others changed too have to be chosen first.
    void update(std::size_t i) {
        endCounting(i);
        const bool disputed = !texts[i].viewer->editor().marks(Mark::conflict).empty();
        texts[i].viewer->updateDocument();
        if (!disputed && model.drafts[i].edited())
            model.submit(model.drafts[i]);
        if (disputed && below(2) == 0)
            texts[i].keepMine->trigger();
    }
    void drop(std::size_t i) {
        endCounting(i);
        texts[i].viewer->dropDraft();
        if (i < model.drafts.size())
            model.drafts[i].text = model.drafts[i].base;
    }
    // Back to where nothing was typed, and forth again: the draft is as it was.
    void undoTyping(std::size_t i) {
        endCounting(i);
        LanguageViewer& viewer = *texts[i].viewer;
        // Of a step that others have done too nothing is seen; redo has it all the same.
        int steps = 0;
        for (; viewer.hasDraft() && steps < 20; ++steps)
            texts[i].undo->trigger();
        while (steps-- > 0)
            texts[i].redo->trigger();
    }
    void count(std::size_t i) {
        Text& text = texts[i];
        NumberDrag& numbers = text.viewer->numbers();
        UndoModel::Draft& draft = model.drafts[i];
        if (numbers.active() && below(4) == 0) {
            const auto asked = numbers.asked();
            press(text.viewer->editor(), Qt::Key_Escape);
            if (text.countsInDraft)
                draft.text = text.counted;
            else
                cancelled(&text, asked);
            return;
        }
        if (!numbers.active()) {
            const std::size_t place =
                draft.text.find_first_of("0123456789", below(draft.text.size() + 1));
            if (place == std::string::npos)
                return;
            select(text, {place, place});
            text.counted = draft.text;
            text.countsInDraft = draft.edited();
        }
        press(text.viewer->editor(), below(2) == 0 ? Qt::Key_Up : Qt::Key_Down, Qt::AltModifier);
        const auto asked = numbers.asked();
        if (asked && text.countsInDraft)
            draft.text = text::applied(text.counted, asked->answer.edits);
        else
            previewed(&text, asked);
    }
    void endCounting(std::size_t i) {
        NumberDrag& numbers = texts[i].viewer->numbers();
        if (!numbers.active())
            return;
        const auto asked = numbers.asked();
        letGo(texts[i].viewer->editor(), Qt::Key_Alt);
        if (!texts[i].countsInDraft)
            finished(&texts[i], asked);
    }

    std::mt19937_64 random{static_cast<std::uint64_t>(setting("ASGARD_SEED", 1))};
    SceneDocument document{Workshop{}};
    std::shared_ptr<PictureThread> pictures = std::make_shared<PictureThread>(false);
    UndoModel model;
    int firstRevision = 0;
    std::array<Text, 2> texts;
    std::array<Seen, 2> scenes;
    TrajectoryEditor curves{document};
    ShapeEditor shapes{document, pictures};
    TrajectoryGraph* graph = nullptr; // that is held
    QPointF graphAt, shapeAt;
    bool shapeHeld = false;
};

} // namespace views
