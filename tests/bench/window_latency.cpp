// Response time of the window to input, and its processor time while idle. Starts the program on a display, sends real
// events (XTEST), and reads the screen until it shows the response. A display without a window manager gets openbox.
// Another build can be measured beside this one:
//   xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" benchmarks window_latency [--program NAME=PATH]...

#include "tests/bench/bench.h"

#include "render/measure/clock.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/window_manager.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

#include <dlfcn.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace vitrine::bench {
namespace {

constexpr double longestAnswer = 20;  ///< Seconds; longer responses count as this long.

void wait(double seconds)
{
    ::usleep(static_cast<useconds_t>(seconds * 1e6));
}

struct Rect {
    int x, y, width, height;
};

// Positions in a window of 1600 x 1000 pixels with its initial layout, at 96 dpi.
constexpr Rect menuTitle{8, 4, 24, 16};
constexpr Rect menuArea{10, 34, 60, 40};

/// Input to the display. The XTEST library is installed with xdotool, without headers.
class Hands {
public:
    Hands() : display_(XOpenDisplay(nullptr))
    {
        void* library = ::dlopen("libXtst.so.6", RTLD_NOW);
        if (!display_ || !library) return;
        motion_ = reinterpret_cast<Motion>(::dlsym(library, "XTestFakeMotionEvent"));
        button_ = reinterpret_cast<Button>(::dlsym(library, "XTestFakeButtonEvent"));
        key_ = reinterpret_cast<Key>(::dlsym(library, "XTestFakeKeyEvent"));
    }
    [[nodiscard]] bool ready() const { return motion_ && button_ && key_; }
    [[nodiscard]] Display* display() const { return display_; }
    void move(int x, int y) const
    {
        motion_(display_, -1, x, y, 0);
        XFlush(display_);
    }
    void button(bool down) const
    {
        button_(display_, 1, down ? True : False, 0);
        XFlush(display_);
    }
    void click(int x, int y) const
    {
        move(x, y);
        button(true);
        button(false);
    }
    /// Presses and releases a key, and waits some seconds.
    void key(KeySym symbol, std::vector<KeySym> held = {}, double then = 0) const
    {
        for (const KeySym each : held) key_(display_, XKeysymToKeycode(display_, each), True, 0);
        key_(display_, XKeysymToKeycode(display_, symbol), True, 0);
        key_(display_, XKeysymToKeycode(display_, symbol), False, 0);
        for (const KeySym each : held) key_(display_, XKeysymToKeycode(display_, each), False, 0);
        XFlush(display_);
        wait(then);
    }
    void type(const char* letters) const
    {
        for (const char* c = letters; *c; ++c) key(static_cast<KeySym>(*c));
    }
    /// Returns the bytes of this part of the screen.
    [[nodiscard]] std::string look(const Rect& at) const
    {
        XImage* image = XGetImage(display_, DefaultRootWindow(display_), at.x, at.y, static_cast<unsigned>(at.width),
                                  static_cast<unsigned>(at.height), AllPlanes, ZPixmap);
        if (!image) return {};
        std::string bytes(image->data,
                          static_cast<std::size_t>(image->bytes_per_line) * static_cast<std::size_t>(image->height));
        XDestroyImage(image);
        return bytes;
    }
    /// Returns the milliseconds from `act` until this part of the screen changes.
    [[nodiscard]] double answer(const Rect& at, const std::function<void()>& act) const
    {
        const std::string before = look(at);
        const double start = render::wallSeconds();
        act();
        while (render::wallSeconds() - start < longestAnswer) {
            if (look(at) != before) return 1e3 * (render::wallSeconds() - start);
            wait(0.0005);
        }
        return 1e3 * longestAnswer;
    }

private:
    using Motion = int (*)(Display*, int, int, int, unsigned long);
    using Button = int (*)(Display*, unsigned, int, unsigned long);
    using Key = int (*)(Display*, unsigned, int, unsigned long);
    Display* display_;
    Motion motion_ = nullptr;
    Button button_ = nullptr;
    Key key_ = nullptr;
};

/// Running program whose window fills the screen, with its own settings folders.
class Program {
public:
    Program(const Hands& hands, const test::WindowManager& windows, const std::string& path, const std::string& cache)
        : hands_(hands), windows_(windows)
    {
        child_ = ::fork();
        if (child_ == 0) {
            const std::map<std::string, std::string> changes{
                {"QT_QPA_PLATFORM", "xcb"},          {"QT_FONT_DPI", "96"},
                {"XDG_CACHE_HOME", cache},           {"HOME", home_ / "home"},
                {"XDG_STATE_HOME", home_ / "state"}, {"XDG_CONFIG_HOME", home_ / "config"},
                {"XDG_DATA_HOME", home_ / "data"}};
            for (const auto& [name, value] : changes) ::setenv(name.c_str(), value.c_str(), 1);
            ::execl(path.c_str(), path.c_str(), nullptr);
            ::_exit(127);
        }
    }
    ~Program()
    {
        ::kill(child_, SIGTERM);
        ::waitpid(child_, nullptr, 0);
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// Finds the window, and gives it the screen and the keyboard. Returns false if there is none within a minute.
    [[nodiscard]] bool open() const
    {
        for (int i = 0; i < 600; ++i, wait(0.1)) {
            const std::optional<Window> window = largest();
            if (!window) continue;
            windows_.fill(*window);
            focus();
            return true;
        }
        return false;
    }
    /// Gives the keyboard to the main window, even if a dialog is open.
    void focus() const
    {
        if (const std::optional<Window> window = largest()) windows_.activate(*window);
    }
    /// Returns the processor time of all its threads.
    [[nodiscard]] double cpuSeconds() const
    {
        std::ifstream stat("/proc/" + std::to_string(child_) + "/stat");
        std::string text((std::istreambuf_iterator<char>(stat)), {});
        std::istringstream rest(text.substr(text.rfind(')') + 2));
        std::string word;
        double ticks = 0;
        for (int field = 3; rest >> word && field <= 15; ++field)
            if (field >= 14) ticks += std::stod(word);
        return ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
    }
    /// Waits until it uses less than a twentieth of a processor, at most `longest` seconds.
    void rest(double longest) const
    {
        for (const double start = render::wallSeconds(); render::wallSeconds() - start < longest;) {
            const double before = cpuSeconds();
            wait(1);
            if (cpuSeconds() - before < 0.05) return;
        }
    }

private:
    [[nodiscard]] std::optional<Window> largest() const
    {
        std::optional<Window> found;
        int area = 400 * 300;
        for (const Window window : windows_.windows()) {
            XWindowAttributes about;
            if (!XGetWindowAttributes(hands_.display(), window, &about) || about.map_state != IsViewable ||
                about.width * about.height <= area)
                continue;
            area = about.width * about.height;
            found = window;
        }
        return found;
    }

    const Hands& hands_;
    const test::WindowManager& windows_;
    test::TemporaryFolder home_;
    pid_t child_;
};

std::string spread(std::vector<double> times)
{
    if (times.empty()) return "–";
    std::sort(times.begin(), times.end());
    char text[64];
    std::snprintf(text, sizeof text, "%.0f (to %.0f)", times[times.size() / 2], times.back());
    return text;
}

constexpr Rect otherTab{1308, 58, 48, 20};
constexpr Rect typed{560, 78, 80, 16};  // Part of the words that an empty search shows, which a typed letter removes.
constexpr Rect slider{1393, 124, 97, 12};
constexpr Rect number{1520, 121, 44, 16};
constexpr Rect measure{455, 757, 58, 18};
constexpr Rect exportButton{1262, 764, 60, 16};

struct Answers {
    std::vector<double> menu, key, number;
};

void clickOn(const Hands& hands, const Rect& at)
{
    hands.click(at.x + at.width / 2, at.y + at.height / 2);
}

/// Moves the slider's handle to and fro and releases it, so that refinement starts again.
double drag(const Hands& hands, int step)
{
    const int middle = slider.x + slider.width / 2, y = slider.y + slider.height / 2;
    hands.move(middle, y);
    hands.button(true);
    wait(0.3);
    const double answer = hands.answer(number, [&] { hands.move(middle + step, y); });
    hands.move(middle, y);
    wait(0.3);
    hands.button(false);
    return answer;
}

/// Measures all responses. `again` restores the state before each run.
Answers probe(const Hands& hands, const Program& program, int runs, const std::function<void()>& again)
{
    Answers answers;
    for (int run = 0; run < runs; ++run) {
        program.focus();
        again();
        wait(0.3 + 0.037 * run);
        answers.menu.push_back(hands.answer(menuArea, [&] { clickOn(hands, menuTitle); }));
        wait(0.3);
        (void)hands.answer(menuArea, [&] { hands.key(XK_Escape); });
        again();
        hands.key(XK_f, {XK_Control_L}, 1.5 + 0.041 * run);
        answers.key.push_back(hands.answer(typed, [&] { hands.key(XK_w); }));
        wait(0.3);
        hands.key(XK_Escape, {}, 0.7);
        answers.number.push_back(drag(hands, run % 2 == 0 ? 9 : -9));
        wait(0.3);
    }
    return answers;
}

void printRow(const std::string& program, const char* state, const Answers& answers)
{
    std::printf("| %s | %s | %s | %s | %s |\n", program.c_str(), state, spread(answers.menu).c_str(),
                spread(answers.key).c_str(), spread(answers.number).c_str());
    std::fflush(stdout);
}

/// Opens the program at the mug, idle, with a slider of the hall in the panel.
bool openAtTheMug(const Hands& hands, const Program& program)
{
    if (!program.open()) return false;
    wait(3);
    hands.key(XK_1, {XK_Alt_L}, 3);
    clickOn(hands, otherTab);
    wait(2);
    return true;
}

bool measureAnswers(const Hands& hands, const test::WindowManager& windows, const std::string& name,
                    const std::string& path, const std::string& cache, int runs)
{
    const auto nothing = [] {};
    const auto afresh = [&] {
        (void)drag(hands, 9);
        wait(0.6);
    };  // Refinement begins after a moment without a change.
    struct State {
        const char* name;
        std::function<void(const Program&)> enter;
        std::function<void()> again;
    };
    const auto move = [&](const Program&) {
        hands.key(XK_2, {XK_Alt_L}, 2);
        clickOn(hands, otherTab);
    };
    const auto study = [&](const Program& p) {
        hands.key(XK_k, {XK_Control_L}, 1.5);
        hands.type("Study");
        wait(1);
        hands.key(XK_Return, {}, 2);
        p.focus();
        clickOn(hands, measure);
        wait(2);
    };
    const auto beginExport = [&](KeySym key, std::vector<KeySym> held) {
        hands.key(key, std::move(held), 6);
        clickOn(hands, exportButton);
        wait(1);
    };
    const auto exporting = [&](const Program&) { beginExport(XK_e, {XK_Control_L, XK_Shift_L}); };
    const auto studyAndRecord = [&](const Program& p) {
        study(p);
        beginExport(XK_F12, {XK_Shift_L});
    };
    const auto afterManySteps = [&] {
        for (int i = 0; i < 30; ++i) hands.key(XK_z, {XK_Control_L});
        for (int i = 0; i < 20; ++i) hands.key(XK_z, {XK_Control_L, XK_Shift_L});
        for (int i = 0; i < 10; ++i) hands.key(i % 2 == 0 ? XK_1 : XK_2, {XK_Alt_L});
    };
    const std::vector<State> states{
        {"still", [](const Program& p) { p.rest(90); }, nothing},
        {"moving", move, nothing},
        {"refining", [](const Program&) {}, afresh},
        {"studying", study, nothing},
        {"studying and refining", study, afresh},
        {"studying and recording", studyAndRecord, nothing},
        {"exporting a picture", exporting, nothing},
        {"after 30 undos, 20 redos and ten visits", [](const Program&) {}, afterManySteps},
        {"rendering a print's views", [&](const Program&) { hands.key(XK_p, {XK_Control_L}, 4); }, nothing},
    };
    for (const State& state : states) {
        const Program program(hands, windows, path, cache);
        if (!openAtTheMug(hands, program)) return false;
        state.enter(program);
        printRow(name, state.name, probe(hands, program, runs, state.again));
    }
    return true;
}

bool measureIdle(const Hands& hands, const test::WindowManager& windows, const std::string& name,
                 const std::string& path, const std::string& cache, double settle)
{
    std::printf("| %s |", name.c_str());
    for (const KeySym key : {KeySym{0}, KeySym{XK_1}, KeySym{XK_2}, KeySym{XK_3}, KeySym{XK_4}}) {
        const Program program(hands, windows, path, cache);
        if (!program.open()) return false;
        wait(3);
        if (key != 0) hands.key(key, {XK_Alt_L});
        program.rest(settle);
        const double before = program.cpuSeconds();
        wait(10);
        std::printf(" %.1f |", program.cpuSeconds() - before);
        std::fflush(stdout);
    }
    std::printf("\n");
    return true;
}

}  // namespace

bool windowLatency(const Options& options)
{
    const int runs = options.runsOr(6);
    constexpr double settle = 60;
    std::vector<std::pair<std::string, std::string>> programs{{"this commit", VITRINE_PROGRAM}};
    programs.insert(programs.end(), options.programs.begin(), options.programs.end());
    const Hands hands;
    if (!hands.ready()) {
        std::fprintf(stderr, "benchmarks: needs a display and libXtst.so.6 (Debian: libxtst6).\n");
        return false;
    }
    const test::WindowManager windows(*hands.display());
    if (!windows.problem().empty()) {
        std::fprintf(stderr, "benchmarks: %s\n", windows.problem().c_str());
        return false;
    }
    const test::TemporaryFolder cache;
    bool shown = true;
    std::printf("Milliseconds from an event to its answer on the screen, window of 1600 x 1000 pixels: median (to "
                "the longest) of %d. Goal: 100.\n\n",
                runs);
    std::printf("| program | while | click on File to its menu | key to the search | slider to its number "
                "|\n|---|---|---|---|---|\n");
    for (const auto& [name, path] : programs)
        shown = shown && measureAnswers(hands, windows, name, path, cache / "cache", runs);
    std::printf("\nSeconds of processor time in ten seconds in which nobody touches the window, by default values, "
                "after %.0f s at most.\n\n",
                settle);
    std::printf("| program | entrance | place 1 | place 2 | place 3 | place 4 |\n|---|---|---|---|---|---|\n");
    for (const auto& [name, path] : programs)
        shown = shown && measureIdle(hands, windows, name, path, cache / "cache", settle);
    if (!shown) std::fprintf(stderr, "benchmarks: no window came.\n");
    return shown;
}

}  // namespace vitrine::bench
