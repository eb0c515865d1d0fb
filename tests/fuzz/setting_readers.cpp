#include "exhibits/exhibits.h"
#include "exhibits/framework/files/lesson.h"
#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/table/value_text.h"
#include "exhibits/framework/time/animation.h"
#include "exhibits/framework/time/motion_json.h"
#include "exhibits/hall/hall_table.h"
#include "exhibits/recording/tour.h"
#include "tests/exhibits/framework/table/every_kind.h"
#include "tests/fuzz/promises.h"
#include "tests/fuzz/readers.h"

#include <string>

namespace vitrine::fuzz {
namespace {

/// Returns the initial values of all exhibits.
const NamedValues& initialValues()
{
    static const hall::HallTable hall;
    static const auto exhibits = allExhibits();
    static const NamedValues values = [] {
        NamedValues all{{"hall", hall.initial()}};
        for (const auto& exhibit : exhibits)
            all.emplace_back(std::string(exhibit->name()), exhibit->parameters().initial());
        return all;
    }();
    return values;
}

}  // namespace

bool readPreset(std::string_view bytes)
{
    static const test::EveryKind table;
    return accepts([&] {
        const Preset preset = parsePreset(std::string(bytes), "fuzz.json", "everything", table);
        requireLegal(preset.values);
        if (preset.camera) requireFiniteView(*preset.camera);
        const std::string text = presetText(preset);
        require(presetText(parsePreset(text, "again.json", "everything", table)) == text,
                "a preset reads back as it was written");
    });
}

bool readExhibition(std::string_view bytes)
{
    return accepts([&] {
        const Exhibition exhibition = parseExhibition(std::string(bytes), "fuzz.json", initialValues());
        for (const auto& [name, values] : exhibition.values) requireLegal(values);
        requireFiniteView(exhibition.camera);
        const std::string text = exhibitionText(exhibition);
        require(exhibitionText(parseExhibition(text, "again.json", initialValues())) == text,
                "an exhibition reads back as it was written");
    });
}

bool readLesson(std::string_view bytes)
{
    return accepts([&] {
        const Lesson lesson = parseLesson(std::string(bytes), "fuzz.md", initialValues());
        require(!lesson.steps.empty(), "a lesson has steps");
        for (const LessonStep& step : lesson.steps) {
            require(!step.text.empty() && step.line >= 1, "a step has a text and a place");
            require(step.question.empty() == step.answer.empty(), "a question has an answer");
            requireLegal(step.values);
            if (step.camera) requireFiniteView(*step.camera);
            require(!withLabels(step.text, lesson.exhibit, initialValues(), "<b>", "</b>").empty(),
                    "a text can be shown");
        }
        require(!lessonText(lesson, initialValues()).empty(), "a lesson can be printed");
    });
}

bool readTour(std::string_view bytes)
{
    return accepts([&] {
        const recording::Tour tour = recording::parseTour(std::string(bytes), "fuzz.json");
        require(!tour.bookmarks.empty(), "a tour has bookmarks");
        std::vector<render::Camera> cameras;
        for (const recording::Bookmark& bookmark : tour.bookmarks) {
            requireFiniteView(bookmark.camera);
            cameras.push_back(bookmark.camera);
        }
        const recording::CameraPath path(cameras, tour.closed);
        for (const double part : {0.0, 0.3, 1.0}) requireFiniteView(path.at(part));
        const std::string text = recording::tourText(tour);
        require(recording::tourText(recording::parseTour(text, "again.json")) == text,
                "a tour reads back as it was written");
    });
}

bool readTyped(std::string_view bytes)
{
    static const test::EveryKind table;
    const std::string text(bytes);
    bool any = false;
    for (const ParameterInfo& parameter : table.rows()) {
        if (const std::optional<Value> value = parseValue(parameter, text)) {
            const std::optional<Value> legal = nearestLegal(parameter, *value);
            if (!legal) continue;
            require(nearestLegal(parameter, *legal) == legal, "the nearest legal value is legal");
            require(parseValue(parameter, formatValue(parameter, *legal)) == legal,
                    "a value reads back as it was written");
            any = any || !parameter.isWritten();
        }
        any |= accepts([&] {
            const auto parse = [&](const std::string& typed) { return parseValue(parameter, typed); };
            const Motion motion = typedMotion(parameter, "--animate", text, parse);
            for (const double time : {0.0, -3.0, 1e9}) {
                const Value moved = valueOf(parameter, motion, {time, time});
                require(nearestLegal(parameter, moved) == moved, "a motion stays legal");
            }
            require(!describe(parameter, motion).empty(), "a motion can be described");
        });
    }
    return any;
}

}  // namespace vitrine::fuzz
