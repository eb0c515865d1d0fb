#include "app/queue/study_in_parts.h"

#include "render/failure.h"

namespace vitrine::app {

void StudyInParts::keep(const std::string& key, const study::StudyMeasure& measure)
{
    parts_.keep(key + ".picture", measure.picture,
                {{"counters", measure.counters},
                 {"milliseconds", measure.milliseconds},
                 {"clock", measure.clock},
                 {"trusted", measure.clockTrusted},
                 {"overhead", measure.overheadMilliseconds}});
}

std::optional<study::StudyMeasure> StudyInParts::find(const std::string& key) const
{
    render::Json about;
    std::optional<render::Image> picture = parts_.kept(key + ".picture", &about);
    if (!picture) return std::nullopt;
    try {
        return study::StudyMeasure{std::move(*picture),
                                   about.at("counters").get<std::map<std::string, std::int64_t>>(),
                                   about.at("milliseconds").get<std::vector<double>>(),
                                   about.at("clock").get<std::string>(),
                                   about.at("trusted").get<bool>(),
                                   about.at("overhead").get<double>()};
    } catch (const render::Json::exception&) {
        throw Failure(ErrorKind::check,
                      parts_.file(key + ".picture").string() + ": this is damaged; make its part again.");
    }
}

}  // namespace vitrine::app
