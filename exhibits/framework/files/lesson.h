#pragma once

#include "exhibits/framework/files/preset.h"

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine {

/// Version that is written; others are refused.
inline constexpr int lessonVersion = 1;

/// Limits of a lesson: a page of text, of which the strip over the picture shows a few sentences at a time.
inline constexpr std::uint64_t lessonBytes = 256U << 10U;
inline constexpr std::size_t mostLessonSteps = 24;
inline constexpr std::size_t mostLessonLetters = 700;  ///< Bytes of the text of one step; the same for an answer.
inline constexpr std::size_t mostTaskLetters = 400;    ///< Bytes of a task or of a question.

/// Number that a step asks the reader to look up.
struct LessonNumber {
    enum class Of { row, counter, milliseconds };
    Of of = Of::milliseconds;
    std::string name;  ///< Name of the parameter or counter ("marchSteps"); empty for milliseconds.
};

/// One step: settings, and what they show.
struct LessonStep {
    std::string title;
    std::string text;        ///< Markdown as written, with `[row:...]`; blocks of shaders are filled.
    std::string task;        ///< Task of the reader in this step, in the format of `text`; may be empty.
    std::string question;    ///< Question to think about, in the format of `text`; empty if and only if `answer` is.
    std::string answer;      ///< Answer, hidden until the reader asks for it.
    ParameterValues values;  ///< All values of the exhibit.
    std::vector<std::pair<std::size_t, Value>> hall;  ///< Parameters of the hall that it sets; others are unchanged.
    std::optional<render::Camera> camera;             ///< Nothing: the camera is unchanged.
    bool bestView = false;                            ///< Uses the exhibit's best view instead of a camera.
    std::optional<LessonNumber> read;
    int line = 1;  ///< Line of its heading.
};

/// Guided tour of one exhibit. As a file (Markdown):
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
///     Sentences. [row:kind] becomes the label of that parameter, [row:hall.exposure] that of one of the hall.
///
///     ### Try
///
///     Task of the reader.
///
///     ### Question
///
///     Question to think about.
///
///     ### Answer
///
///     Answer, shown when the reader asks for it.
///
///     ```json
///     {"values": {"work": "field"}, "hall": {}, "camera": "best", "read": "milliseconds"}
///     ```
///
/// Texts are Markdown (`lessonHtml`): lists, links, pictures in the lesson's folder, blocks of code, and formulas
/// between $ signs. An empty block "```glsl FILE LINES" shows a part of one of the program's shaders (`shaderPart`),
/// and is filled when the lesson is read.
///
/// The `###` headings are the same in all languages, and may be left out; a question needs an answer.
/// Each step is complete: parameters that its `values` do not name have initial values, regardless of the previous
/// step. Values and cameras are written as in presets; the camera may also be "best". `read` is "milliseconds",
/// "row:NAME" or "counter:NAME". If `values` name a file that adds parameters, unknown names may be among those; they
/// stay pending (`ParameterValues::pending`).
struct Lesson {
    std::string title;
    std::string exhibit;
    std::filesystem::path folder;  ///< Folder of the file, in which its pictures are.
    std::string intro;             ///< Text in the format of a step's.
    std::vector<LessonStep> steps;
    std::set<std::string> pictures;  ///< Files in `folder` that its texts show.
    /// Values that reading changed ("exposure 99 -> 16 (allowed -16 to 16)"), for people.
    std::vector<std::string> notes;
};

/// Parses a lesson. `tables` gives the subjects' names and parameters. Throws Failure naming file, line, the error and
/// what to do. Errors are: no title, an unknown exhibit or parameter, broken JSON, an unknown key or heading, no steps.
/// A bad link, picture or formula, a step without block or text, a question without an answer, a text that is too long,
/// and a newer version are errors, too.
[[nodiscard]] Lesson parseLesson(const std::string& text, const std::string& fileName, const NamedValues& tables);

/// The same for a file. Throws Failure as `render::readFile`, too.
[[nodiscard]] Lesson readLesson(const std::filesystem::path&, const NamedValues& tables);

/// Replaces the `[row:...]` in a lesson's text by the parameters' labels, between the marks `before` and `after` ("<b>"
/// and "</b>").
[[nodiscard]] std::string withLabels(std::string_view text, std::string_view exhibit, const NamedValues& tables,
                                     std::string_view before, std::string_view after);

/// Returns the lesson as Markdown to read: title, introduction, and the texts of all steps, without their settings.
/// The words "Try", "Question" and "Answer" are in the program's language.
[[nodiscard]] std::string lessonText(const Lesson&, const NamedValues& tables);

/// Returns the path of the lesson that comes with the program: assets/lessons/LANGUAGE/EXHIBIT.md if it exists in the
/// program's language, else assets/lessons/EXHIBIT.md. The file need not exist.
[[nodiscard]] std::filesystem::path shippedLesson(std::string_view exhibit);

}  // namespace vitrine
