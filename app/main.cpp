#include "app/command.h"
#include "app/queue/shard.h"
#include "render/failure.h"
#include "render/measure/memory.h"
#include "ui/kit/language.h"

#include <CLI/CLI.hpp>

#include <clocale>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace {

constexpr const char* about = "Vitrine: a workbench for real-time rendering techniques, in a museum hall.\n"
                              "Without a command, the window opens.\n"
                              "Exit codes: 0 done, 1 check failed, 2 usage, 3 no OpenGL 4.5, 4 shader failed, 5 file "
                              "not read or not written, 130 stopped.";

int parseAndRun(int argc, char** argv);

/// The program's own command line in place of the one that it was started with.
int runWords(const std::vector<std::string>& words)
{
    std::vector<std::string> all{"vitrine"};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> pointers;
    for (std::string& word : all) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return parseAndRun(static_cast<int>(all.size()), pointers.data());
}

int parseAndRun(int argc, char** argv)
{
    CLI::App parser(about, "vitrine");
    parser.set_version_flag("--version", std::string("vitrine ") + VITRINE_VERSION);
    parser.set_help_flag("--help", "Print this help and exit");
    parser
        .add_option_function<std::string>(
            "--language", [](const std::string& code) { vitrine::ui::speak(QString::fromStdString(code)); },
            "The language of plaques in pictures, and of the window: en (in pictures, without this) or de")
        ->check(CLI::IsMember({"en", "de"}))
        ->type_name("CODE");
    parser.require_subcommand(0, 1);
    vitrine::app::Action chosen = [&] { return vitrine::app::openWindow(argc, argv, {}); };
    vitrine::app::addOpenCommand(parser, chosen, argc, argv);
    vitrine::app::addListCommand(parser, chosen);
    vitrine::app::addRenderCommand(parser, chosen);
    vitrine::app::addTourCommand(parser, chosen);
    vitrine::app::addRecordCommand(parser, chosen);
    vitrine::app::addPresetCommand(parser, chosen);
    vitrine::app::addLessonCommand(parser, chosen);
    vitrine::app::addCompareCommand(parser, chosen);
    vitrine::app::addCompareSettingsCommand(parser, chosen);
    vitrine::app::addStudyCommand(parser, chosen);
    vitrine::app::addCompareStudiesCommand(parser, chosen);
    vitrine::app::addPrintCommand(parser, chosen);
    vitrine::app::addProofCommand(parser, chosen);
    vitrine::app::addMergeCommand(parser, chosen, runWords);
    vitrine::app::addSceneCommand(parser, chosen);
    vitrine::app::addSpriteCommand(parser, chosen);
    vitrine::app::addServeCommand(parser, chosen);
    vitrine::app::addDoctorCommand(parser, chosen);
    try {
        parser.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return parser.exit(error) == 0 ? 0 : static_cast<int>(vitrine::Blame::usage);
    }
    return chosen();
}

}  // namespace

int main(int argc, char** argv)
{
    // A full disk or a size limit is an error of the write that meets it, not the end of the program.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
    std::setlocale(LC_NUMERIC, "C");
    vitrine::render::returnFreedMemory();
    vitrine::app::commandLine().assign(argv + 1, argv + argc);
    try {
        return parseAndRun(argc, argv);
    } catch (const vitrine::Failure& failure) {
        std::fprintf(stderr, "vitrine: %s\n", vitrine::ui::saidInLocale(failure.what()).c_str());
        return failure.exitCode();
    } catch (const std::bad_alloc&) {
        const std::string words = vitrine::ui::saidInLocale(
            "There was not enough memory for this; ask for a smaller size, or fewer samples or views.");
        std::fprintf(stderr, "vitrine: %s\n", words.c_str());
        return static_cast<int>(vitrine::Blame::usage);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "vitrine: %s\n", error.what());
        return static_cast<int>(vitrine::Blame::file);
    }
}
