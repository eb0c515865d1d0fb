#include "exhibits/framework/files/lesson.h"

#include "exhibits/framework/files/lesson_markup.h"
#include "exhibits/framework/table/preset_values.h"
#include "render/failure.h"
#include "render/files/assets.h"
#include "render/files/read_file.h"
#include "render/files/text_position.h"
#include "render/text/joined.h"
#include "render/text/translation.h"
#include "render/text/trimmed.h"

#include <algorithm>
#include <array>

namespace vitrine {
namespace {

using render::Json;
using render::JsonDocument;

constexpr std::string_view parameterMark = "[row:";
constexpr render::JsonLimits blockLimits{.bytes = 64U << 10U, .depth = 16, .nodes = 4'000, .stringBytes = 16U << 10U};

/// Text as written, line by line.
struct Prose {
    std::string text;
    std::vector<int> lines;  ///< Number in the file of each line of `text`.

    void add(std::string_view line, int number)
    {
        (text += line) += '\n';
        lines.push_back(number);
    }
};

/// Part of a step under a heading of its own: "### Answer".
struct Section {
    std::string name;
    Prose prose;
    int line = 0;
};

constexpr std::array<std::string_view, 3> sectionNames{"Try", "Question", "Answer"};

/// A heading and the text up to the next heading.
struct Part {
    std::string title;
    Prose prose;  ///< Text without the JSON block and without the sections.
    std::vector<Section> sections;
    std::string block;  ///< JSON text, preceded by enough newlines to have the same line numbers as in the file.
    int line = 0;       ///< Line of the heading.
    bool hasBlock = false;
};

std::string_view trimmed(std::string_view s)
{
    return render::trimmed(s, " \t\r\n");
}

/// Returns the line without blanks at its end.
std::string_view withoutEnd(std::string_view line)
{
    return line.substr(0, line.find_last_not_of(" \t\r") + 1);
}

Failure failureAt(const std::string& file, int line, const Message& problem)
{
    return {ErrorKind::file, message("{1}, line {2}: {3}", file, line, problem), {file, line}};
}

Failure failureAt(const std::string& file, int line, std::size_t column, const Message& problem)
{
    return {ErrorKind::file,
            message("{1}, line {2}, column {3}: {4}.", file, line, column, problem),
            {file, line, static_cast<int>(column)}};
}

/// Splits the file at its headings.
class Cutter {
public:
    Cutter(const std::string& text, const std::string& file) : file_(file)
    {
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            ++line_;
            take(std::string_view(text).substr(at, end - at));
            at = end + 1;
        }
        if (inBlock_ || inCode_)
            throw failureAt(file_, blockLine_, message("this block is not closed; end it with ```."));
        if (parts.empty()) throw failureAt(file_, 1, message("a lesson begins with its title; write \"# Title\"."));
    }

    std::vector<Part> parts;

private:
    void take(std::string_view line)
    {
        const std::string_view plain = trimmed(line);
        if (inCode_) {
            inCode_ = plain != fence_;
            prose().add(withoutEnd(line), line_);
        } else if (inBlock_) {
            if (plain == "```")
                inBlock_ = false;
            else
                (parts.back().block += line) += '\n';
        } else if (plain.starts_with("```") && plain != "```json") {
            beginCode(line, plain);
        } else if (plain.starts_with("```")) {
            begin();
        } else if (plain.starts_with("# ") || plain.starts_with("## ")) {
            head(plain);
        } else if (plain.starts_with("### ")) {
            section(trimmed(plain.substr(4)));
        } else if (parts.empty()) {
            if (!plain.empty())
                throw failureAt(file_, line_, message("a lesson begins with its title; write \"# Title\"."));
        } else {
            prose().add(withoutEnd(line), line_);
        }
    }
    /// Returns the text that the present line belongs to.
    [[nodiscard]] Prose& prose()
    {
        Part& part = parts.back();
        return part.sections.empty() ? part.prose : part.sections.back().prose;
    }
    /// Begins a block of code, which belongs to the text.
    void beginCode(std::string_view line, std::string_view plain)
    {
        if (parts.empty()) throw failureAt(file_, line_, message("a lesson begins with its title; write \"# Title\"."));
        fence_ = plain.substr(0, std::min(plain.find_first_not_of('`'), plain.size()));
        prose().add(withoutEnd(line), line_);
        inCode_ = true;
        blockLine_ = line_;
    }
    void section(std::string_view name)
    {
        const auto isName = [name](const auto& each) { return each == name; };
        if (std::none_of(sectionNames.begin(), sectionNames.end(), isName))
            throw failureAt(file_, line_,
                            "within a step there are the headings \"### Try\", \"### Question\" and \"### Answer\"; "
                            "write one of them, or \"## \" for a step.");
        if (parts.size() < 2)
            throw failureAt(file_, line_,
                            "\"### " + std::string(name) +
                                "\" belongs to a step; write \"## Title\" of the step above it.");
        std::vector<Section>& sections = parts.back().sections;
        for (const Section& each : sections)
            if (isName(each.name))
                throw failureAt(file_, line_,
                                "this step has \"### " + each.name +
                                    "\" already; put both into one, or make two steps.");
        sections.push_back({std::string(name), {}, line_});
    }
    void begin()
    {
        if (parts.empty()) throw failureAt(file_, line_, message("a lesson begins with its title; write \"# Title\"."));
        if (parts.back().hasBlock)
            throw failureAt(file_, line_, message("there is a block under this heading already; put both into one."));
        parts.back().hasBlock = inBlock_ = true;
        parts.back().block.assign(static_cast<std::size_t>(line_), '\n');
        blockLine_ = line_;
    }
    void head(std::string_view line)
    {
        const bool title = line.starts_with("# ");
        if (title != parts.empty())
            throw failureAt(file_, line_,
                            title ? message("a lesson has one title; write \"## \" for a step.")
                                  : message("a lesson begins with its title; write \"# Title\"."));
        parts.push_back({std::string(trimmed(line.substr(title ? 2 : 3))), {}, {}, {}, line_, false});
    }

    const std::string& file_;
    int line_ = 0, blockLine_ = 0;
    std::string fence_;  ///< Signs that end the present block of code.
    bool inBlock_ = false, inCode_ = false;
};

const ParameterValues* tableOf(const NamedValues& tables, std::string_view name)
{
    const auto found = std::find_if(tables.begin(), tables.end(), [&](const auto& each) { return each.first == name; });
    return found == tables.end() ? nullptr : &found->second;
}

/// Returns the parameter named "kind" or "hall.exposure"; null if there is none.
const ParameterInfo* parameterNamed(std::string_view name, std::string_view exhibit, const NamedValues& tables)
{
    if (name.starts_with("hall.")) {
        name.remove_prefix(5);
        exhibit = "hall";
    }
    const ParameterValues* values = tableOf(tables, exhibit);
    if (!values) return nullptr;
    const auto row = values->table().find(name);
    return row ? &values->rows()[*row] : nullptr;
}

Message noSuchParameter(std::string_view name, std::string_view exhibit)
{
    const bool ofHall = name.starts_with("hall.");
    const std::string subject(ofHall ? "hall" : exhibit);
    return message("there is no parameter \"{1}\"; `vitrine list --manual {2}` names those of {3}.",
                   ofHall ? name.substr(5) : name, subject, subject);
}

/// Parser for the parts of a lesson file.
class Reader {
public:
    Reader(const std::string& file, const NamedValues& tables, Lesson& lesson)
        : file_(file), tables_(tables), lesson_(lesson)
    {
    }

    void head(const Part& part)
    {
        if (!part.hasBlock)
            throw failureAt(
                file_, part.line,
                message("the block that names the exhibit of the lesson is missing; write ```json, {\"format\": "
                        "\"vitrine-lesson\", \"version\": 1, \"exhibit\": ...} and ``` below the title."));
        const JsonDocument document = object(part, {"format", "version", "exhibit"});
        const Json& root = document.root();
        if (root.value("format", Json()) != "vitrine-lesson")
            throw document.failure("format", message("this is not a lesson; write \"vitrine-lesson\"."));
        const Json version = root.value("version", Json());
        if (!version.is_number_integer() || version < 1)
            throw document.failure("version", message("this must be {1}; correct it there.", lessonVersion));
        if (version > lessonVersion)
            throw document.failure("version", message("this lesson is of a newer Vitrine; update the program."));
        const Json exhibit = root.value("exhibit", Json());
        if (!exhibit.is_string() || exhibit == "hall" || !tableOf(tables_, exhibit.get<std::string>()))
            throw document.failure("exhibit", message("there is no exhibit of that name; `vitrine list` names them."));
        lesson_.exhibit = exhibit.get<std::string>();
        lesson_.title = part.title;
        lesson_.intro = textOf(part.prose, part.line, mostLessonLetters);
    }

    void step(const Part& part)
    {
        if (!part.hasBlock)
            throw failureAt(
                file_, part.line,
                message("this step has no preset; write ```json, {\"values\": {}} and ``` below its text."));
        const JsonDocument document = object(part, {"values", "hall", "camera", "read"});
        LessonStep step{.title = part.title,
                        .text = textOf(part.prose, part.line, mostLessonLetters),
                        .task = {},
                        .question = {},
                        .answer = {},
                        .values = *tableOf(tables_, lesson_.exhibit),
                        .hall = {},
                        .camera = {},
                        .bestView = false,
                        .read = {},
                        .line = part.line};
        if (step.text.empty())
            throw failureAt(file_, part.line, "this step has no text; write a sentence below its heading.");
        takeSections(step, part);
        setParameters(step.values, document);
        for (const auto& [name, value] : section(document, "hall")) {
            const ParameterInfo& row = rowAt("hall." + name, document, "hall." + name);
            step.hall.emplace_back(
                *tableOf(tables_, "hall")->table().find(name),
                valueFromJson(row, value, place(document, "hall." + name), "hall." + name, lesson_.notes));
        }
        camera(step, document);
        if (document.root().contains("read")) step.read = number(document);
        lesson_.steps.push_back(std::move(step));
    }

private:
    static JsonPlace place(const JsonDocument& document, const std::string& path) { return {document, path}; }

    [[nodiscard]] JsonDocument object(const Part& part, const std::vector<std::string_view>& known) const
    {
        JsonDocument document = render::parseJson(part.block, file_, blockLimits);
        if (!document.root().is_object())
            throw failureAt(file_, part.line, message("its block must be an object: {...}."));
        for (const auto& [key, value] : document.root().items()) {
            if (std::find(known.begin(), known.end(), key) != known.end()) continue;
            throw document.failure(
                key, message("this key is not known here; remove it, or write one of {1}.", joined(known)));
        }
        return document;
    }

    void takeSections(LessonStep& step, const Part& part) const
    {
        const Section *question = nullptr, *answer = nullptr;
        for (const Section& section : part.sections) {
            const bool isAnswer = section.name == "Answer", isQuestion = section.name == "Question";
            std::string text = textOf(section.prose, section.line, isAnswer ? mostLessonLetters : mostTaskLetters);
            if (text.empty())
                throw failureAt(file_, section.line,
                                "there is no text below this heading; write a sentence, or remove the heading.");
            if (isAnswer) answer = &section;
            if (isQuestion) question = &section;
            (isAnswer ? step.answer : isQuestion ? step.question : step.task) = std::move(text);
        }
        if (question && !answer)
            throw failureAt(file_, question->line, "this question has no answer; write \"### Answer\" below it.");
        if (answer && !question)
            throw failureAt(file_, answer->line, "this answer has no question; write \"### Question\" above it.");
    }

    /// Returns the text below the heading in this line, without space at its ends.
    [[nodiscard]] std::string textOf(const Prose& prose, int line, std::size_t most) const
    {
        const std::string text(trimmed(prose.text));
        if (text.size() > most)
            throw failureAt(file_, line,
                            "the text below this heading has " + std::to_string(text.size()) +
                                " bytes and the strip has room for " + std::to_string(most) +
                                "; shorten it, or make two steps of it.");
        for (std::size_t at = text.find(parameterMark); at != std::string::npos;
             at = text.find(parameterMark, at + 1)) {
            const std::size_t name = at + parameterMark.size(), end = text.find(']', name);
            const std::string row = text.substr(name, end == std::string::npos ? end : end - name);
            if (end == std::string::npos || !parameterNamed(row, lesson_.exhibit, tables_))
                throw failureAt(file_, line,
                                message("in the text below this heading {1}", noSuchParameter(row, lesson_.exhibit)));
        }
        checkMarkup(text, prose);
        return withShaders(text, prose);
    }

    /// Notes the pictures of a text. Throws Failure with line and column of the first bad link, picture or formula.
    void checkMarkup(const std::string& text, const Prose& prose) const
    {
        std::vector<LessonMarkupProblem> problems;
        (void)lessonHtml(text,
                         {.parameter = [](std::string_view) { return std::string(); },
                          .picture =
                              [this](const std::string& file, const std::string&) {
                                  lesson_.pictures.insert(file);
                                  return std::string();
                              },
                          .folder = lesson_.folder},
                         &problems);
        if (problems.empty()) return;
        const std::size_t first = std::min(prose.text.find(text) + problems.front().at, prose.text.size());
        const std::size_t end = first == 0 ? std::string::npos : prose.text.rfind('\n', first - 1);
        const std::size_t column = first - (end == std::string::npos ? 0 : end + 1) + 1;
        throw failureAt(file_, lineAt(prose, first), column, problems.front().what);
    }

    /// Returns the line in the file of a place in a text.
    static int lineAt(const Prose& prose, std::size_t at)
    {
        const auto before = std::count(prose.text.begin(), prose.text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        return prose.lines[std::min(static_cast<std::size_t>(before), prose.lines.size() - 1)];
    }

    /// Fills empty blocks of code that name a part of a shader: "```glsl fur/shells.frag 10-20".
    [[nodiscard]] std::string withShaders(std::string text, const Prose& prose) const
    {
        constexpr std::string_view fence = "```glsl ";
        const std::size_t shift = prose.text.find(text);
        std::vector<std::string> exhibits;
        for (const auto& [name, values] : tables_) exhibits.push_back(name);
        std::size_t added = 0;
        for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at + 1)) {
            if (at > 0 && text[at - 1] != '\n') continue;
            const std::size_t end = text.find('\n', at);
            if (end == std::string::npos || text.compare(end + 1, 3, "```") != 0) continue;  // It has code of its own.
            const ShaderPart part =
                shaderPart(std::string_view(text).substr(at + fence.size(), end - at - fence.size()), exhibits);
            if (!part.problem.empty()) throw failureAt(file_, lineAt(prose, shift + at - added), 9, part.problem);
            text.insert(end + 1, part.text);
            added += part.text.size();
        }
        return text;
    }

    static std::vector<std::pair<std::string, Json>> section(const JsonDocument& document, const char* key)
    {
        std::vector<std::pair<std::string, Json>> entries;
        if (!document.root().contains(key)) return entries;
        const Json& values = document.root()[key];
        if (!values.is_object()) throw document.failure(key, message("this must be an object; correct it there."));
        for (const auto& [name, value] : values.items()) entries.emplace_back(name, value);
        return entries;
    }

    [[nodiscard]] const ParameterInfo& rowAt(const std::string& name, const JsonDocument& document,
                                             const std::string& path) const
    {
        const ParameterInfo* row = parameterNamed(name, lesson_.exhibit, tables_);
        if (!row) throw document.failure(path, noSuchParameter(name, lesson_.exhibit));
        return *row;
    }

    /// Sets the parameters of a step. An unknown parameter may be one that a scene file adds to the table, if the step
    /// names such a file; it is then kept as pending.
    void setParameters(ParameterValues& values, const JsonDocument& document)
    {
        ParameterValues::PendingParameters pending;
        for (const auto& [name, json] : section(document, "values")) {
            const std::string path = "values." + name;
            if (const auto row = values.table().find(name))
                values.setParameter(
                    *row, valueFromJson(values.rows()[*row], json, place(document, path), name, lesson_.notes));
            else
                pending[name] = render::writeJson(json);
        }
        const std::vector<std::string> files = values.tableFiles();
        const bool given = std::any_of(files.begin(), files.end(), [](const auto& file) { return !file.empty(); });
        for (const auto& [name, json] : pending)
            if (!given || !isParameterName(name)) (void)rowAt(name, document, "values." + name);
        values.setPending(std::move(pending));
    }

    void camera(LessonStep& step, const JsonDocument& document)
    {
        if (!document.root().contains("camera")) return;
        const Json& camera = document.root()["camera"];
        step.bestView = camera == "best";
        if (camera.is_string() && !step.bestView)
            throw document.failure("camera", message("this must be \"best\", or an object with eye, target and fov."));
        if (!step.bestView) step.camera = cameraFromJson(camera, place(document, "camera"), lesson_.notes);
    }

    [[nodiscard]] LessonNumber number(const JsonDocument& document) const
    {
        const Json& json = document.root()["read"];
        const std::string read = json.is_string() ? json.get<std::string>() : std::string();
        if (read == "milliseconds") return {};
        if (read.starts_with("counter:") && isParameterName(read.substr(8)))
            return {LessonNumber::Of::counter, read.substr(8)};
        if (!read.starts_with("row:"))
            throw document.failure("read", message("write \"milliseconds\", \"row:NAME\" or \"counter:NAME\" here."));
        (void)rowAt(read.substr(4), document, "read");
        return {LessonNumber::Of::row, read.substr(4)};
    }

    const std::string& file_;
    const NamedValues& tables_;
    Lesson& lesson_;
};

}  // namespace

Lesson parseLesson(const std::string& text, const std::string& fileName, const NamedValues& tables)
{
    if (const auto zero = render::zeroByteIn(text))
        throw failureAt(fileName, zero->line, message("{1}.", render::zeroByteProblem()));
    const Cutter cut(text, fileName);
    Lesson lesson;
    lesson.folder = std::filesystem::path(fileName).parent_path();
    Reader reader(fileName, tables, lesson);
    reader.head(cut.parts.front());
    for (std::size_t i = 1; i < cut.parts.size(); ++i) reader.step(cut.parts[i]);
    if (lesson.steps.empty())
        throw failureAt(fileName, cut.parts.front().line,
                        message("there is no step in it; write \"## Title\" for each."));
    if (lesson.steps.size() > mostLessonSteps)
        throw failureAt(fileName, lesson.steps[mostLessonSteps].line,
                        message("a lesson has at most {1} steps; make two of it.", mostLessonSteps));
    return lesson;
}

Lesson readLesson(const std::filesystem::path& path, const NamedValues& tables)
{
    std::string text = render::readFile(path, lessonBytes);
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";  // Some editors on Windows write it.
    if (text.starts_with(byteOrderMark)) text.erase(0, byteOrderMark.size());
    return parseLesson(text, path.string(), tables);
}

std::string withLabels(std::string_view text, std::string_view exhibit, const NamedValues& tables,
                       std::string_view before, std::string_view after)
{
    std::string result;
    for (std::size_t at = text.find(parameterMark); at != std::string_view::npos; at = text.find(parameterMark)) {
        const std::size_t end = text.find(']', at);
        if (end == std::string_view::npos) break;
        const std::string_view name = text.substr(at + parameterMark.size(), end - at - parameterMark.size());
        const ParameterInfo* row = parameterNamed(name, exhibit, tables);
        ((result += text.substr(0, at)) += before) += row ? translated(label(*row)) : std::string(name);
        result += after;
        text.remove_prefix(end + 1);
    }
    return result += text;
}

std::string lessonText(const Lesson& lesson, const NamedValues& tables)
{
    const auto shown = [&](const std::string& text) { return withLabels(text, lesson.exhibit, tables, "**", "**"); };
    std::string result = "# " + lesson.title + '\n';
    if (!lesson.intro.empty()) result += '\n' + shown(lesson.intro) + '\n';
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const LessonStep& step = lesson.steps[i];
        result += "\n## " + std::to_string(i + 1) + ". " + step.title + "\n\n" + shown(step.text) + '\n';
        for (const auto& [name, text] :
             {std::pair("Try", &step.task), std::pair("Question", &step.question), std::pair("Answer", &step.answer)})
            if (!text->empty()) result += "\n**" + translated(name) + ":** " + shown(*text) + '\n';
    }
    return result;
}

std::filesystem::path shippedLesson(std::string_view exhibit)
{
    const std::string file = std::string(exhibit) + ".md";
    std::error_code ignored;
    std::filesystem::path own = render::asset("lessons/" + language() + '/' + file);
    return std::filesystem::exists(own, ignored) ? own : render::asset("lessons/" + file);
}

}  // namespace vitrine
