#include "app/jobs/job_command.h"
#include "app/kit/command.h"
#include "app/kit/commit.h"
#include "app/kit/number_option.h"
#include "app/kit/say.h"
#include "app/kit/stop_signal.h"
#include "app/kit/usage_error.h"
#include "app/queue/shard.h"
#include "render/failure.h"
#include "render/measure/memory.h"
#include "render/version.h"
#include "ui/kit/language.h"

#include <CLI/CLI.hpp>

#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
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

/// Runs a command line of the program in place of the process's own.
int runWords(const std::vector<std::string>& words)
{
    std::vector<std::string> all{"vitrine"};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> pointers;
    for (std::string& word : all) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return parseAndRun(static_cast<int>(all.size()), pointers.data());
}

CLI::Option* addLanguage(CLI::App& command, std::string& language)
{
    std::vector<std::string> codes;
    for (const QString& code : vitrine::ui::languages()) codes.push_back(code.toStdString());
    return vitrine::app::addChoice(command, "--language", language, codes, "");
}

/// Adds --language to every command. Only the program's own help describes it.
void takeLanguageEverywhere(CLI::App& command, std::string& language)
{
    for (CLI::App* below : command.get_subcommands([](CLI::App*) { return true; })) {
        addLanguage(*below, language)->group("");
        takeLanguageEverywhere(*below, language);
    }
}

int parseAndRun(int argc, char** argv)
{
    CLI::App parser(about, "vitrine");
    parser.set_version_flag("--version", "vitrine " + vitrine::render::programVersion());
    parser.set_help_flag("-h,--help", "Print this help and exit");
    std::string language;
    addLanguage(parser, language)
        ->description("Language of the window and of plaques in pictures: en or de. Default: the desktop's in the "
                      "window, en in pictures");
    parser.require_subcommand(0, 1);
    vitrine::app::Action chosen;
    vitrine::app::addOpenCommand(parser, chosen, argc, argv);
    vitrine::app::addListCommand(parser, chosen);
    vitrine::app::addTourCommand(parser, chosen);
    vitrine::app::addPresetCommand(parser, chosen);
    vitrine::app::addLessonCommand(parser, chosen);
    vitrine::app::addCompareCommand(parser, chosen);
    vitrine::app::addCompareStudiesCommand(parser, chosen);
    vitrine::app::addShaderCommand(parser, chosen);
    vitrine::app::addJobCommands(parser, chosen);
    vitrine::app::addMergeCommand(parser, chosen, runWords);
    vitrine::app::addSceneCommand(parser, chosen);
    vitrine::app::addServeCommand(parser, chosen);
    vitrine::app::addDoctorCommand(parser, chosen);
    takeLanguageEverywhere(parser, language);
    const auto applyLanguage = [&language] {
        if (!language.empty()) vitrine::ui::setLanguage(QString::fromStdString(language));
    };
    try {
        parser.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return parser.exit(error);  // Help, or the version.
        applyLanguage();
        throw vitrine::Failure(vitrine::ErrorKind::usage, vitrine::app::usageError(parser, error));
    } catch (const vitrine::Failure&) {
        applyLanguage();
        vitrine::app::throwFirstTyped(parser, {argv + 1, argv + argc});
        throw;
    }
    applyLanguage();
    vitrine::app::refuseWindowOptions(parser);
    // The window installs no handler: it has a journal, and starts other programs.
    if (!parser.get_subcommands().empty() && !parser.got_subcommand("open")) vitrine::app::endOnStopSignals();
    return chosen();
}

/// Ends the program if an exception has no handler, for example on a thread. Allocates nothing, because the cause may
/// be a lack of memory.
[[noreturn]] void endWithoutHandler()
{
    if (!std::current_exception()) std::abort();
    try {
        throw;
    } catch (const std::bad_alloc&) {
        vitrine::app::sayInEnglish(vitrine::app::noMemory);
        std::_Exit(static_cast<int>(vitrine::ErrorKind::usage));
    } catch (const std::exception& error) {
        vitrine::app::sayInEnglish(error.what());
        std::abort();
    } catch (...) {
        std::abort();
    }
}

}  // namespace

int main(int argc, char** argv)
{
    std::set_terminate(endWithoutHandler);
    // A full disk or a file size limit must fail the write, and not end the program.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
    std::setlocale(LC_NUMERIC, "C");
    vitrine::render::setProgramCommit(vitrine::app::commit);
    vitrine::render::returnFreedMemory();
    vitrine::app::commandLine().assign(argv + 1, argv + argc);
    try {
        return parseAndRun(argc, argv);
    } catch (const vitrine::Failure& failure) {
        vitrine::app::say(failure);
        return failure.exitCode();
    } catch (const std::bad_alloc&) {
        vitrine::app::say(vitrine::app::noMemory);
        return static_cast<int>(vitrine::ErrorKind::usage);
    } catch (const std::exception& error) {
        vitrine::app::say(error.what());
        return static_cast<int>(vitrine::ErrorKind::file);
    }
}
