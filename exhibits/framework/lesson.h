#pragma once

#include "exhibits/framework/preset.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine {

/// The version that is written; others are refused.
inline constexpr int lessonVersion = 1;

/// A lesson is a page of text, and a strip over the picture has room for a few sentences at a time.
inline constexpr std::uint64_t lessonBytes = 256U << 10U;
inline constexpr std::size_t mostLessonSteps = 24;
inline constexpr std::size_t mostLessonLetters = 700;  ///< Bytes of the text of one step.

/// What a step asks the reader to look up, beside the picture.
struct LessonNumber {
    enum class Of { row, counter, milliseconds };
    Of of = Of::milliseconds;
    std::string name;  ///< Of the row, or of the counter ("marchSteps"); empty for milliseconds.
};

/// One step: what to set, and what to see then.
struct LessonStep {
    std::string title;
    std::string text;        ///< Paragraphs with an empty line between; `**` and `[row:...]` are in it as written.
    ParameterValues values;  ///< Of the exhibit, all of them.
    std::vector<std::pair<std::size_t, Value>> hall;  ///< Rows of the hall that it sets; others stay as they are.
    std::optional<render::Camera> camera;             ///< Nothing: the visitor stays where he stands.
    bool bestView = false;                            ///< The exhibit's best view in place of a camera.
    std::optional<LessonNumber> read;
    int line = 1;  ///< Of its heading.
};

/// A walk through one exhibit. As a file (Markdown):
///
///     # What a bound promises
///
///     ```json
///     {"format": "vitrine-lesson", "version": 1, "exhibit": "noise"}
///     ```
///
///     A few sentences, and the paper.
///
///     ## One octave
///
///     Sentences. [row:kind] becomes the label of that row, [row:hall.exposure] that of one of the hall.
///
///     ```json
///     {"values": {"work": "field"}, "hall": {}, "camera": "best", "read": "milliseconds"}
///     ```
///
/// A step is complete: rows that its `values` do not name are initial, whatever the step before set. Values are written
/// as in presets, cameras too, or "best"; `read` is "milliseconds", "row:NAME" or "counter:NAME". Where `values` name a
/// file that gives rows, other names may be of those: they are pending (`ParameterValues::pending`).
struct Lesson {
    std::string title;
    std::string exhibit;
    std::string intro;  ///< As the text of a step.
    std::vector<LessonStep> steps;
    std::vector<std::string> notes;  ///< What reading changed ("exposure 99 -> 16 (allowed -16 to 16)"), for people.
};

/// Reads a lesson. `tables` names the subjects and gives their tables. Throws Failure naming file, line, what is wrong
/// there and what to do: no title, no such exhibit, a row that is not there, broken JSON, a key that means nothing, no
/// step, a step without its block or its text, text too long, a newer version.
[[nodiscard]] Lesson parseLesson(const std::string& text, const std::string& fileName, const NamedValues& tables);

/// The same of a file. Throws Failure as `render::readFile`, too.
[[nodiscard]] Lesson readLesson(const std::filesystem::path&, const NamedValues& tables);

/// What was written as text of a lesson, with the labels of its rows between these marks: "<b>" and "</b>".
[[nodiscard]] std::string withLabels(std::string_view text, std::string_view exhibit, const NamedValues& tables,
                                     std::string_view before, std::string_view after);

/// The lesson that comes with the program: assets/lessons/LANGUAGE/EXHIBIT.md where there is one in the language of the
/// program, else assets/lessons/EXHIBIT.md. There need be none.
[[nodiscard]] std::filesystem::path shippedLesson(std::string_view exhibit);

}  // namespace vitrine
