// Hosts that are killed, and hosts that write one file: is anything lost?
//
//     hosts kills COUNT SEED        so many hosts are killed while somebody types and saves in them
//     hosts conflicts COUNT SEED    two hosts and another program write one file so many times
//
// Each prints every fault with its number, then a line of figures, and exits 1 after a fault.
#include "files/journal.h"
#include "view/text_hand.h"
#include "view/writing.h"
#include "window/application.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <thread>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using Random = std::mt19937_64;

int faults = 0;

void fault(int number, const std::string& what) {
    ++faults;
    std::printf("%d: %s\n", number, what.c_str());
    std::fflush(stdout);
}

std::int64_t nowMs() {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

int upTo(Random& random, int most) { return std::uniform_int_distribution<int>(0, most)(random); }

std::string bytesOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

std::string memo(const std::string& paragraphs) {
    return "DOCUMENT CMEMO\n<CMEMO>\n<SUBJECT>{Endurance}</SUBJECT>\n<BODY>\n" + paragraphs +
           "</BODY>\n</CMEMO>\n";
}

std::size_t anyText(Random& random, const std::string& bytes) {
    static const std::string begin = "<TEXT>{";
    std::vector<std::size_t> places;
    for (std::size_t at = bytes.find(begin); at != std::string::npos;
         at = bytes.find(begin, at + 1))
        places.push_back(at + begin.size());
    return places.at(static_cast<std::size_t>(upTo(random, static_cast<int>(places.size()) - 1)));
}

// A folder for the file and the journal.
class Folder {
public:
    Folder() {
        if (::mkdtemp(path_.data()) == nullptr)
            std::exit(2);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::string file() const { return path_ + "/memo.ens"; }
    [[nodiscard]] std::string journal(const std::string& of = {}) const {
        return path_ + "/unsaved" + of;
    }

private:
    std::string path_ = (std::filesystem::temp_directory_path() / "hosts.XXXXXX").string();
};

// Memory that a host shares with the program that kills it.
template <class T> T* shared() {
    void* memory =
        ::mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
        std::exit(2);
    return new (memory) T;
}

// Answers the questions of a host: `answer` gets each, once.
class Answers {
public:
    explicit Answers(std::function<void(QMessageBox&)> answer) {
        QObject::connect(&timer_, &QTimer::timeout, [answer = std::move(answer)] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
                answer(*box);
        });
        timer_.start(1);
    }

private:
    QTimer timer_;
};

void click(QMessageBox& box, const QString& text) {
    for (QAbstractButton* button : box.buttons())
        if (QString(button->text()).remove('&') == text)
            return button->click();
    std::printf("no button %s in: %s\n", qPrintable(text), qPrintable(box.text()));
    std::fflush(stdout);
    std::_Exit(3);
}

// Runs in a process of its own, which has no other threads than it makes.
pid_t inAnotherProcess(const std::function<void(QApplication&)>& act) {
    std::fflush(stdout);
    const pid_t child = ::fork();
    if (child != 0)
        return child;
    int count = 1;
    char name[] = "hosts";
    char* arguments[] = {name, nullptr};
    QApplication app(count, arguments);
    act(app);
    std::fflush(stdout);
    std::_Exit(0);
}

window::DocumentWindow* openToWrite(window::Application& host, const std::string& path) {
    window::DocumentWindow* window = host.open(QString::fromStdString(path));
    while (!window->view().isLaidOut())
        QCoreApplication::processEvents();
    window->view().setFocus();
    window->view().setWriting(true);
    return window;
}

void goTo(window::DocumentWindow& window, std::size_t place) {
    window.view().text().cursor().set({place, place});
}

// --- killed hosts -----------------------------------------------------------------------------

// What a host tells of itself as it goes: each state of the text, and which one is on its way into
// the file.
struct Told {
    static constexpr std::size_t most = 1 << 14;
    struct State {
        std::int64_t at = 0; // ms
        std::uint64_t hash = 0;
        std::size_t size = 0;
    };
    State states[most];
    std::atomic<std::size_t> count = 0;
    std::atomic<std::uint64_t> saving = 0; // 0: nothing
    std::atomic<std::uint64_t> saved = 0;
    std::atomic<int> offered = 0;
};

void typeUntilKilled(const Folder& folder, std::uint64_t seed, Told& told) {
    Random random(seed);
    window::Application host({}, folder.journal());
    window::DocumentWindow* window = openToWrite(host, folder.file());
    {
        const Answers answers([&](QMessageBox& box) {
            ++told.offered;
            click(box, "Recover");
        });
        host.offerRecovered();
    }
    document::Document& document = window->document().document();
    std::uint64_t last = 0;
    const auto tell = [&] {
        const std::uint64_t hash = files::hashOf(document.bytes());
        const std::size_t n = told.count;
        if (hash == last || n == Told::most)
            return;
        told.states[n] = {nowMs(), last = hash, document.bytes().size()};
        told.count = n + 1;
    };
    // Before anything is kept of a change, it is told.
    QObject::connect(&document, &document::Document::edited, window, tell, Qt::DirectConnection);
    tell();
    const auto press = [&](int key, const QString& text = {}) {
        QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier, text);
        QApplication::sendEvent(&window->view(), &event);
    };
    for (;;) {
        const int what = upTo(random, 99);
        const bool isLong = document.bytes().size() > 20'000;
        if (what < (isLong ? 20 : 60))
            press(Qt::Key_A, QString(QChar(what % 7 == 0 ? ' ' : 'a' + what % 26)));
        else if (what < 80)
            press(Qt::Key_Backspace);
        else if (what < 85)
            press(Qt::Key_Return);
        else if (what < 92)
            document.undo();
        else if (what < 98)
            goTo(*window, anyText(random, document.bytes()));
        else {
            told.saving = files::hashOf(document.bytes());
            if (window->save())
                told.saved = told.saving.load();
            told.saving = 0;
        }
        tell();
        QElapsedTimer pause;
        pause.start();
        const int ms = upTo(random, 20);
        do
            QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
        while (pause.elapsed() < ms);
    }
}

class Kills {
public:
    explicit Kills(std::uint64_t seed) : random_(seed) {
        const std::string first = memo("<PARAGRAPH><TEXT>{One}</TEXT></PARAGRAPH>\n");
        std::ofstream(folder_.file(), std::ios::binary) << first;
        told_.saved = files::hashOf(first);
    }

    void run(int number) {
        const std::size_t expected = left_;
        const std::uint64_t seed = random_();
        told_.count = 0;
        told_.saving = 0;
        told_.offered = 0;
        const pid_t host =
            inAnotherProcess([&](QApplication&) { typeUntilKilled(folder_, seed, told_); });
        std::this_thread::sleep_for(std::chrono::milliseconds(upTo(random_, 2000)));
        ::kill(host, SIGKILL);
        const std::int64_t killed = nowMs();
        int status = 0;
        ::waitpid(host, &status, 0);
        if (!WIFSIGNALED(status) || WTERMSIG(status) != SIGKILL)
            fault(number, "the host ended by itself, with status " + std::to_string(status));
        if (told_.count > 0 && static_cast<std::size_t>(told_.offered) != expected)
            fault(number, "recovery was offered " + std::to_string(told_.offered) + " times, not " +
                              std::to_string(expected));
        look(number, killed);
    }

    void print(int count) const {
        std::printf("%d hosts killed, %d with unsaved text: %d faults; lost at most %lld ms, in "
                    "the middle %lld ms; killed while saving: %d\n",
                    count, withText_, faults, static_cast<long long>(mostLost_),
                    static_cast<long long>(middle()), whileSaving_);
    }

private:
    // Where the text is in what was told, the last time; nothing: it was not.
    [[nodiscard]] std::optional<std::size_t> placeOf(std::uint64_t hash) const {
        for (std::size_t i = told_.count; i-- > 0;)
            if (told_.states[i].hash == hash)
                return i;
        return std::nullopt;
    }

    void look(int number, std::int64_t killed) {
        const std::uint64_t file = files::hashOf(bytesOf(folder_.file()));
        const bool isNew = told_.saving != 0 && file == told_.saving;
        if (file != told_.saved && !isNew)
            fault(number, "the file is neither the old one nor the new one");
        whileSaving_ += told_.saving != 0 ? 1 : 0;
        told_.saved = file;
        files::AllLeft all = files::leftBehind(files::FileSystem::real(), folder_.journal());
        for (const std::string& sentence : all.faults)
            fault(number, sentence);
        left_ = all.texts.size();
        if (left_ > 1)
            fault(number, std::to_string(left_) + " texts of one file");
        if (told_.count == 0)
            return; // killed before it had a text: what was kept before is still there
        std::optional<std::size_t> kept = placeOf(file);
        if (left_ > 0) {
            ++withText_;
            const std::optional<std::size_t> text =
                placeOf(files::hashOf(all.texts.front().kept.text));
            if (!text)
                fault(number, "the journal has a text that the document never had");
            kept = std::max(kept, text);
        }
        const std::size_t last = told_.count - 1;
        const std::int64_t lost = kept == last ? 0 : killed - told_.states[kept ? *kept + 1 : 0].at;
        lost_.push_back(lost);
        mostLost_ = std::max(mostLost_, lost);
        if (lost > 2000)
            fault(number, "the last " + std::to_string(lost) + " ms are lost");
    }

    [[nodiscard]] std::int64_t middle() const {
        std::vector<std::int64_t> sorted = lost_;
        std::ranges::sort(sorted);
        return sorted.empty() ? 0 : sorted[sorted.size() / 2];
    }

    Folder folder_;
    Random random_;
    Told& told_ = *shared<Told>();
    std::size_t left_ = 0; // texts in the journal
    std::vector<std::int64_t> lost_;
    std::int64_t mostLost_ = 0;
    int withText_ = 0, whileSaving_ = 0;
};

// --- several writers --------------------------------------------------------------------------

// Each writer adds words that nobody else writes, and saves. A word that was saved stays in the
// file, unless a question about it was answered so.
struct Writers {
    static constexpr int most = 1 << 16;
    std::atomic<int> next = 0; // the number of the next word
    std::atomic<int> refused = 0, disputed = 0, merged = 0;
    std::atomic<bool> isSaved[most], mayBeGone[most];
};

std::string wordOf(int number) { return "w" + std::to_string(number) + "w"; }

std::set<int> wordsIn(const std::string& bytes) {
    std::set<int> numbers;
    for (std::size_t at = bytes.find('w'); at != std::string::npos; at = bytes.find('w', at + 1)) {
        const std::size_t digits = bytes.find_first_not_of("0123456789", at + 1);
        if (digits != std::string::npos && digits > at + 1 && bytes[digits] == 'w')
            numbers.insert(std::atoi(bytes.c_str() + at + 1));
    }
    return numbers;
}

void settle(Random& random, session::OpenDocument& open, Writers& writers) {
    session::FileFollower& file = open.followFile();
    if (file.state() != session::FileFollower::State::disputed)
        return;
    ++writers.disputed;
    std::set<int> there = wordsIn(open.document().readFile().bytes);
    there.merge(wordsIn(open.document().bytes()));
    if (upTo(random, 1) == 0)
        file.keepMine();
    else
        file.takeTheirs();
    const std::set<int> left = wordsIn(open.document().bytes());
    for (const int word : there)
        if (!left.contains(word))
            writers.mayBeGone[word] = true;
}

void typeWords(const Folder& folder, const std::string& name, std::uint64_t seed, int count,
               Writers& writers) {
    Random random(seed);
    window::Application host({}, folder.journal(name));
    window::DocumentWindow* window = openToWrite(host, folder.file());
    session::OpenDocument& open = window->document();
    QObject::connect(&open.followFile(), &session::FileFollower::told,
                     [&](const QString&) { ++writers.merged; });
    const Answers answers([&](QMessageBox& box) {
        ++writers.refused;
        click(box, "No");
    });
    for (int number = writers.next++; number < count; number = writers.next++) {
        const std::size_t at = anyText(random, open.document().bytes());
        goTo(*window, at);
        for (const char letter : wordOf(number) + " ") {
            QKeyEvent event(QEvent::KeyPress, Qt::Key_A, Qt::NoModifier, QString(QChar(letter)));
            QApplication::sendEvent(&window->view(), &event);
        }
        int tries = 0;
        while (!window->save()) {
            if (++tries == 400) {
                std::printf("word %d was not saved in 400 tries\n", number);
                std::fflush(stdout);
                std::_Exit(4);
            }
            QElapsedTimer pause;
            pause.start();
            while (pause.elapsed() < 50)
                QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
            settle(random, open, writers);
        }
        if (wordsIn(open.document().bytes()).contains(number))
            writers.isSaved[number] = true;
        QCoreApplication::processEvents();
        settle(random, open, writers);
    }
}

// Reads, adds a paragraph, and saves as our programs save; tries again when the file is another.
void addParagraph(Random& random, const std::string& path, int number) {
    files::FileSystem& system = files::FileSystem::real();
    for (;;) {
        const files::ReadFile file = files::readFile(system, path, std::size_t{1} << 26);
        files::KnownFile known{path, file.stamp};
        std::string bytes = file.bytes;
        const std::size_t at = bytes.rfind("<PARAGRAPH>", anyText(random, bytes));
        bytes.insert(at, "<PARAGRAPH><TEXT>{" + wordOf(number) + "}</TEXT></PARAGRAPH>\n");
        std::this_thread::sleep_for(std::chrono::milliseconds(upTo(random, 5)));
        if (files::saveFile(system, path, bytes, known))
            return;
    }
}

int conflicts(int count, std::uint64_t seed) {
    const Folder folder;
    auto& writers = *shared<Writers>();
    std::string paragraphs;
    for (int i = 0; i < 5; ++i)
        paragraphs += "<PARAGRAPH><TEXT>{Text}</TEXT></PARAGRAPH>\n";
    std::ofstream(folder.file(), std::ios::binary) << memo(paragraphs);
    count = std::min(count, Writers::most);
    std::vector<pid_t> hosts;
    for (const char* name : {"-a", "-b"})
        hosts.push_back(inAnotherProcess([&, name](QApplication&) {
            typeWords(folder, name, seed + static_cast<std::uint64_t>(name[1]), count, writers);
        }));
    Random random(seed);
    for (int number = writers.next++; number < count; number = writers.next++) {
        addParagraph(random, folder.file(), number);
        writers.isSaved[number] = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(upTo(random, 200)));
    }
    for (const pid_t host : hosts) {
        int status = 0;
        ::waitpid(host, &status, 0);
        if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
            fault(0, "a host ended with status " + std::to_string(status));
    }
    const std::set<int> there = wordsIn(bytesOf(folder.file()));
    int saved = 0, given = 0;
    for (int number = 0; number < count; ++number) {
        saved += writers.isSaved[number] ? 1 : 0;
        given += writers.mayBeGone[number] ? 1 : 0;
        if (writers.isSaved[number] && !writers.mayBeGone[number] && !there.contains(number))
            fault(number, "a saved word is gone, and nobody was asked");
    }
    std::printf("%d words of three writers, %d saved: %d faults; %d saves refused, %d changes of "
                "others taken in, %d questions about the same place, %d words given up there\n",
                count, saved, faults, writers.refused.load(), writers.merged.load(),
                writers.disputed.load(), given);
    return faults > 0 ? 1 : 0;
}

} // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    const int count = argc > 2 ? std::atoi(argv[2]) : 10;
    const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
    qputenv("QT_QPA_PLATFORM", "offscreen");
    if (what == "kills") {
        Kills kills(seed);
        for (int i = 1; i <= count; ++i)
            kills.run(i);
        kills.print(count);
        return faults > 0 ? 1 : 0;
    }
    if (what == "conflicts")
        return conflicts(count, seed);
    std::fprintf(stderr, "usage: hosts kills|conflicts COUNT SEED\n");
    return 2;
}
