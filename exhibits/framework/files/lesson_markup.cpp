#include "exhibits/framework/files/lesson_markup.h"

#include "exhibits/framework/files/tex_formula.h"
#include "render/glsl/shader_source.h"
#include "render/image/picture_formats.h"
#include "render/text/escaped.h"
#include "render/text/nearest_word.h"
#include "render/text/trimmed.h"

#include <md4c.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

namespace vitrine {
namespace {

std::string attributeText(const MD_ATTRIBUTE& attribute)
{
    return {attribute.text, attribute.size};
}

/// Returns why a picture of this name cannot be shown; empty: it can.
Message pictureProblem(const std::string& name, const std::filesystem::path& folder)
{
    const std::filesystem::path file = name;
    const render::PictureFileFormat* format = render::formatNamed(file);
    if (name.empty() || file.has_parent_path() || name.find_first_of("/\\:") != std::string::npos)
        return message("the picture \"{1}\" is not in the folder of the lesson; put it there, and write its name alone",
                       name);
    if (!format || (format->format != render::ImageFormat::png && format->format != render::ImageFormat::jpeg))
        return message("the picture \"{1}\" is neither a PNG nor a JPEG; convert it", name);
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(folder / file, ignored))
        return message("there is no picture \"{1}\" in the folder of the lesson; put it there, or correct its name",
                       name);
    return {};
}

/// Writes what md4c finds in a text as HTML.
class MarkupWriter {
public:
    MarkupWriter(std::string_view text, const LessonMarkup& markup, std::vector<LessonMarkupProblem>* problems)
        : text_(text), markup_(markup), problems_(problems)
    {
    }

    std::string write()
    {
        MD_PARSER parser{};
        parser.flags = MD_FLAG_NOHTML | MD_FLAG_NOINDENTEDCODEBLOCKS | MD_FLAG_LATEXMATHSPANS;
        parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* self) { return of(self).enter(type, detail); };
        parser.leave_block = [](MD_BLOCKTYPE type, void*, void* self) { return of(self).leave(type); };
        parser.enter_span = [](MD_SPANTYPE type, void* detail, void* self) { return of(self).enter(type, detail); };
        parser.leave_span = [](MD_SPANTYPE type, void* detail, void* self) { return of(self).leave(type, detail); };
        parser.text = [](MD_TEXTTYPE type, const MD_CHAR* text, MD_SIZE size, void* self) {
            return of(self).take(type, {text, size});
        };
        md_parse(text_.data(), static_cast<MD_SIZE>(text_.size()), &parser, this);
        return std::move(html_);
    }

private:
    static MarkupWriter& of(void* self) { return *static_cast<MarkupWriter*>(self); }

    int enter(MD_BLOCKTYPE type, void* detail)
    {
        switch (type) {
        case MD_BLOCK_P: html_ += "<p>"; break;
        case MD_BLOCK_UL: html_ += "<ul>\n"; break;
        case MD_BLOCK_OL: {
            const unsigned start = static_cast<MD_BLOCK_OL_DETAIL*>(detail)->start;
            html_ += start == 1 ? "<ol>\n" : "<ol start=\"" + std::to_string(start) + "\">\n";
            break;
        }
        case MD_BLOCK_LI: html_ += "<li>"; break;
        case MD_BLOCK_QUOTE: html_ += "<blockquote>\n"; break;
        case MD_BLOCK_CODE: html_ += "<pre>"; break;
        case MD_BLOCK_HR: html_ += "<hr>\n"; break;
        case MD_BLOCK_H: html_ += "<p><strong>"; break;
        default: break;
        }
        return 0;
    }
    int leave(MD_BLOCKTYPE type)
    {
        switch (type) {
        case MD_BLOCK_P: html_ += "</p>\n"; break;
        case MD_BLOCK_UL: html_ += "</ul>\n"; break;
        case MD_BLOCK_OL: html_ += "</ol>\n"; break;
        case MD_BLOCK_LI: html_ += "</li>\n"; break;
        case MD_BLOCK_QUOTE: html_ += "</blockquote>\n"; break;
        case MD_BLOCK_CODE: html_ += "</pre>\n"; break;
        case MD_BLOCK_H: html_ += "</strong></p>\n"; break;
        default: break;
        }
        return 0;
    }
    int enter(MD_SPANTYPE type, void* detail)
    {
        switch (type) {
        case MD_SPAN_EM: write("<em>"); break;
        case MD_SPAN_STRONG: write("<strong>"); break;
        case MD_SPAN_CODE: write("<code>"); break;
        case MD_SPAN_A: {
            const MD_ATTRIBUTE& target = static_cast<MD_SPAN_A_DETAIL*>(detail)->href;
            const std::string url = attributeText(target);
            if (!isOutsideLink(url)) {
                const Message what =
                    message("the link \"{1}\" is not to a page of the web; begin it with https://", url);
                note(placeOf(target.text), what);
            }
            write(isOutsideLink(url) ? "<a href=\"" + escaped(url) + "\">" : "<a>");
            break;
        }
        case MD_SPAN_IMG: ++inPicture_; break;
        case MD_SPAN_LATEXMATH:
        case MD_SPAN_LATEXMATH_DISPLAY:
            inFormula_ = true;
            formula_.clear();
            break;
        default: break;
        }
        return 0;
    }
    int leave(MD_SPANTYPE type, void* detail)
    {
        switch (type) {
        case MD_SPAN_EM: write("</em>"); break;
        case MD_SPAN_STRONG: write("</strong>"); break;
        case MD_SPAN_CODE: write("</code>"); break;
        case MD_SPAN_A: write("</a>"); break;
        case MD_SPAN_IMG: picture(static_cast<MD_SPAN_IMG_DETAIL*>(detail)->src); break;
        case MD_SPAN_LATEXMATH: formula(false); break;
        case MD_SPAN_LATEXMATH_DISPLAY: formula(true); break;
        default: break;
        }
        return 0;
    }
    int take(MD_TEXTTYPE type, std::string_view text)
    {
        if (inFormula_) {
            if (formula_.empty()) formulaAt_ = placeOf(text.data());
            formula_ += type == MD_TEXT_SOFTBR || type == MD_TEXT_BR ? std::string_view(" ") : text;
            return 0;
        }
        if (inPicture_ > 0) {
            alternative_ += type == MD_TEXT_SOFTBR ? std::string_view(" ") : text;
            return 0;
        }
        switch (type) {
        case MD_TEXT_BR: html_ += "<br>\n"; break;
        case MD_TEXT_SOFTBR: html_ += '\n'; break;
        case MD_TEXT_ENTITY: html_ += text; break;
        case MD_TEXT_NULLCHAR: html_ += "\xEF\xBF\xBD"; break;
        case MD_TEXT_CODE: html_ += escaped(text); break;
        default: words(text);
        }
        return 0;
    }

    /// Writes a tag. The alternative text of a picture has none.
    void write(std::string_view tag)
    {
        if (inPicture_ == 0) html_ += tag;
    }

    /// Writes text, in which `[row:NAME]` stands for a parameter.
    void words(std::string_view text)
    {
        constexpr std::string_view mark = "[row:";
        for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark)) {
            const std::size_t end = text.find(']', at);
            if (end == std::string_view::npos) break;
            html_ += escaped(text.substr(0, at));
            html_ += markup_.parameter(text.substr(at + mark.size(), end - at - mark.size()));
            text.remove_prefix(end + 1);
        }
        html_ += escaped(text);
    }

    void picture(const MD_ATTRIBUTE& source)
    {
        if (--inPicture_ > 0) return;
        const std::string name = attributeText(source);
        const Message problem = pictureProblem(name, markup_.folder);
        if (problem.empty())
            html_ += markup_.picture(name, alternative_);
        else
            note(placeOf(source.text), problem);
        alternative_.clear();
    }

    void formula(bool isDisplayed)
    {
        inFormula_ = false;
        const TexFormula made = mathMlOfTex(formula_, isDisplayed);
        if (made.problem.empty())
            html_ += made.mathMl;
        else {
            note(formulaAt_ + made.at, made.problem);
            html_ += "<code>" + escaped(formula_) + "</code>";
        }
    }

    [[nodiscard]] static bool isOutsideLink(std::string_view url)
    {
        return url.starts_with("https://") || url.starts_with("http://");
    }

    /// Returns the place of a part of the text; of a text that md4c made, the last known one.
    [[nodiscard]] std::size_t placeOf(const char* part)
    {
        const std::less<> before;
        const char* end = text_.data() + text_.size();
        if (part && !before(part, text_.data()) && before(part, end))
            last_ = static_cast<std::size_t>(part - text_.data());
        return last_;
    }

    void note(std::size_t at, const Message& what)
    {
        if (problems_) problems_->push_back({at, what});
    }

    std::string_view text_;
    const LessonMarkup& markup_;
    std::vector<LessonMarkupProblem>* problems_;
    std::string html_, formula_, alternative_;
    std::size_t last_ = 0, formulaAt_ = 0;
    int inPicture_ = 0;
    bool inFormula_ = false;
};

std::vector<std::string_view> shaderTextLines(std::string_view text)
{
    std::vector<std::string_view> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

/// Range of lines, from 0; `end` is behind the last one. Empty: there is none.
struct LineRange {
    std::size_t begin = 0, end = 0;
};

/// Parses "10-20".
LineRange numberedLines(std::string_view words)
{
    std::size_t first = 0, last = 0;
    const char* end = words.data() + words.size();
    const auto one = std::from_chars(words.data(), end, first);
    if (one.ec != std::errc() || one.ptr == end || *one.ptr != '-') return {};
    const auto two = std::from_chars(one.ptr + 1, end, last);
    return two.ec == std::errc() && two.ptr == end && first >= 1 && last >= first ? LineRange{first - 1, last}
                                                                                  : LineRange();
}

/// Finds the definition of a function: from the line that begins with its type to the brace that closes it.
LineRange functionLines(const std::vector<std::string_view>& lines, std::string_view name)
{
    const std::string called = ' ' + std::string(name) + '(';
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].empty() || !std::isalpha(static_cast<unsigned char>(lines[i].front()))) continue;
        if (lines[i].find(called) == std::string_view::npos) continue;
        for (std::size_t end = i; end < lines.size(); ++end) {
            if (lines[end] == "}") return {i, end + 1};
            if (lines[end].ends_with(';') && !lines[end].starts_with(' ')) break;  // A declaration.
        }
    }
    return {};
}

}  // namespace

std::string lessonHtml(std::string_view text, const LessonMarkup& markup, std::vector<LessonMarkupProblem>* problems)
{
    return MarkupWriter(text, markup, problems).write();
}

ShaderPart shaderPart(std::string_view words, const std::vector<std::string>& exhibits)
{
    words = render::trimmed(words, " \t");
    const std::size_t space = std::min(words.find(' '), words.size());
    const std::string file(words.substr(0, space));
    const std::string_view part = render::trimmed(words.substr(space), " \t");
    const std::string folder = file.substr(0, std::min(file.find('/'), file.size()));
    if (folder != "lib" && std::find(exhibits.begin(), exhibits.end(), folder) == exhibits.end())
        return {{}, message("there is no exhibit \"{1}\"; `vitrine list` names them", folder)};
    const render::ShaderSource shaders;
    const std::optional<std::string> shader = shaders.read(file);
    if (!shader)
        return {{},
                message("there is no shader \"{1}\"{2} write the name of a file of the exhibit", file,
                        didYouMean(file, shaders.list()))};
    const std::vector<std::string_view> lines = shaderTextLines(*shader);
    LineRange range = numberedLines(part);
    if (range.end == 0) range = functionLines(lines, part);
    if (range.end == 0 || range.end > lines.size())
        return {
            {},
            message("\"{1}\" are no lines and no function of {2}, which has {3} lines; write 10-20, or the name of a "
                    "function",
                    part, file, lines.size())};
    if (range.end - range.begin > mostShaderLines)
        return {{},
                message("these are {1} lines of a shader, and a lesson shows at most {2}; choose fewer",
                        range.end - range.begin, mostShaderLines)};
    ShaderPart found;
    for (std::size_t i = range.begin; i < range.end; ++i) (found.text += lines[i]) += '\n';
    return found;
}

}  // namespace vitrine
