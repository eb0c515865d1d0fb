#include "exhibits/jobs/kit/command_line.h"

#include "exhibits/framework/table/value_text.h"
#include "exhibits/jobs/kit/given_values.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/museum/render_command.h"
#include "render/files/number_text.h"

namespace vitrine::jobs {
namespace {

/// Formats a value as `--set` reads it: numbers in SI units.
std::string settingText(const ParameterInfo& parameter, const Value& value)
{
    const auto* number = std::get_if<double>(&value);
    return number && parameter.isNumeric() ? render::shortestNumber(*number) : formatValue(parameter, value);
}

}  // namespace

std::vector<std::string> commandOf(const Job& job, const JobOrder& order)
{
    const std::string_view command = job.command();
    const std::size_t blank = command.find(' ');
    std::vector<std::string> words{std::string(command.substr(0, blank))};
    if (blank != std::string_view::npos) words.emplace_back(command.substr(blank + 1));
    const auto exhibitAt = static_cast<std::ptrdiff_t>(words.size());
    for (std::string& word : wordsOf(order.values)) words.push_back(std::move(word));
    const JobScene& scene = order.scene;
    if (scene.museum && job.needs().anyScene) {
        const std::string option = job.needs().sceneByOption ? "--exhibit=" : "";
        words.insert(words.begin() + exhibitAt, option + std::string(scene.museum->subject(scene.subject).name()));
        if (scene.frame.alone) words.emplace_back("--alone");
        if (scene.frame.transparent && !job.parameters().find("transparent")) words.emplace_back("--transparent");
        for (std::string& word :
             sceneWords(*scene.museum, scene.state, scene.frame, job.usesCamera(order.values, scene)))
            words.push_back(std::move(word));
    } else if (scene.museum && job.needs().twoSettings) {
        words.push_back("--like=" + documentFile(order.out).string());  // It has both settings.
    } else if (scene.museum) {
        const bool any = job.needs().anySettings;
        if (any) words.insert(words.begin() + exhibitAt, std::string(scene.museum->subject(scene.subject).name()));
        for (std::size_t subject = 0; subject < scene.state.values.size(); ++subject) {
            if (!any && subject != scene.subject) continue;
            const ParameterValues& values = scene.state.values[subject];
            const std::string of = any ? std::string(scene.museum->subject(subject).name()) + '.' : "";
            for (std::size_t i = 0; i < values.rows().size(); ++i)
                if (!values.isInitial(i))
                    words.push_back("--set=" + of + std::string(values.rows()[i].name) + '=' +
                                    settingText(values.rows()[i], values.row(i)));
        }
    }
    words.push_back("--out=" + order.out.string());
    return words;
}

}  // namespace vitrine::jobs
