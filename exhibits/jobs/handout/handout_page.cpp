#include "exhibits/jobs/handout/handout_page.h"

#include "exhibits/framework/files/lesson_markup.h"
#include "exhibits/jobs/kit/html_text.h"
#include "render/text/escaped.h"
#include "render/text/translation.h"

#include <array>
#include <cstdio>
#include <string_view>

namespace vitrine::jobs {
namespace handouts {
namespace {

constexpr const char* printStyle = R"style(@page { margin: 18mm; }
body { margin: 0 auto; max-width: 46em; padding: 1em; color: #222; font: 11pt/1.5 "DejaVu Serif", Georgia, serif; }
h1 { font-size: 22pt; line-height: 1.2; }
h2 { font-size: 14pt; margin: 1.2em 0 .4em; }
section { break-inside: avoid; }
img { display: block; width: 100%; margin: .6em 0; }
.box { border-left: 3px solid #9a5f14; padding-left: .8em; margin: .6em 0; }
.answers { break-before: page; }
p img { width: auto; max-width: 100%; }
pre { padding: .5em .8em; background: #f3efe8; font-size: 9pt; line-height: 1.35; white-space: pre-wrap; }
)style";

constexpr const char* slideStyle =
    R"style(html, body { margin: 0; height: 100%; background: #111; color: #eee; font: 2.6vh/1.5 "DejaVu Sans", system-ui, sans-serif; }
section { display: none; height: 100vh; box-sizing: border-box; padding: 4vh 4vw; grid-template-columns: 3fr 2fr; gap: 3vw; align-items: center; }
section.on { display: grid; }
section.title { grid-template-columns: 1fr; }
h1 { font-size: 6vh; line-height: 1.2; }
h2 { font-size: 4vh; line-height: 1.2; margin: 0 0 .5em; }
img { width: 100%; max-height: 92vh; object-fit: contain; }
.box { border-left: .4vh solid #e0a050; padding-left: 1em; }
.answer { visibility: hidden; }
p img { width: auto; max-width: 100%; max-height: 40vh; }
pre { padding: .5em .8em; background: #222; font-size: 1.9vh; line-height: 1.3; white-space: pre-wrap; }
a { color: #8ab8ff; }
section.open .answer { visibility: visible; }
@media print { section { display: grid; break-after: page; } .answer { visibility: visible; } }
)style";

constexpr const char* slideScript = R"script(<script>
const slides = [...document.querySelectorAll("section")];
let at = Math.min(Math.max(parseInt(location.hash.slice(1)) || 1, 1), slides.length) - 1;
function show() {
    slides.forEach((slide, i) => slide.classList.toggle("on", i === at));
    location.replace("#" + (at + 1));
}
function go(by) {
    const slide = slides[at];
    if (by > 0 && slide.querySelector(".answer") && !slide.classList.contains("open")) {
        slide.classList.add("open");
        return;
    }
    at = Math.min(Math.max(at + by, 0), slides.length - 1);
    show();
}
addEventListener("keydown", event => {
    if (["ArrowRight", "ArrowDown", "PageDown", " ", "Enter"].includes(event.key)) go(1);
    else if (["ArrowLeft", "ArrowUp", "PageUp", "Backspace"].includes(event.key)) go(-1);
    else if (event.key === "Home") { at = 0; show(); }
    else if (event.key === "End") { at = slides.length - 1; show(); }
    else return;
    event.preventDefault();
});
addEventListener("click", event => { if (!event.target.closest("a")) go(1); });
show();
</script>
)script";

/// Writes the texts of a lesson as HTML.
class Texts {
public:
    Texts(const Lesson& lesson, const NamedValues& tables) : lesson_(lesson), tables_(tables) {}

    /// Returns a text as HTML. Names of parameters are strong, and pictures are copied beside the page.
    [[nodiscard]] std::string paragraphs(const std::string& text) const
    {
        const auto parameter = [this](std::string_view name) {
            const std::string mark = "[row:" + std::string(name) + ']';
            return "<strong>" + escaped(withLabels(mark, lesson_.exhibit, tables_, "", "")) + "</strong>";
        };
        const auto picture = [](const std::string& file, const std::string& alternative) {
            return "<img src=\"" + escaped(lessonPicture(file)) + "\" alt=\"" + escaped(alternative) + "\">";
        };
        return lessonHtml(text, {parameter, picture, lesson_.folder});
    }
    /// Returns a box with a heading: a task, a question or an answer. Empty without a text.
    [[nodiscard]] std::string box(const char* heading, const std::string& text, const char* kind) const
    {
        if (text.empty()) return {};
        return "<div class=\"box " + std::string(kind) + "\"><strong>" + escaped(translated(heading)) + "</strong>\n" +
               paragraphs(text) + "</div>\n";
    }
    [[nodiscard]] std::string heading(std::size_t step) const
    {
        return std::to_string(step + 1) + ". " + escaped(lesson_.steps[step].title);
    }
    [[nodiscard]] std::string picture(std::size_t step) const
    {
        return "<img src=\"" + stepPicture(step) + "\" alt=\"" + escaped(lesson_.steps[step].title) + "\">\n";
    }

private:
    const Lesson& lesson_;
    const NamedValues& tables_;
};

std::string pageStart(const std::string& title, const char* style)
{
    return "<!DOCTYPE html>\n<html lang=\"" + language() +
           "\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, "
           "initial-scale=1\">\n<title>" +
           escaped(title) + "</title>\n<style>\n" + style + "</style>\n</head>\n<body>\n";
}

constexpr const char* pageEnd = "</body>\n</html>\n";

}  // namespace
}  // namespace handouts

std::string stepPicture(std::size_t step)
{
    std::array<char, 40> name{};
    std::snprintf(name.data(), name.size(), "pictures/step-%02zu.png", step + 1);
    return name.data();
}

std::string lessonPicture(const std::string& file)
{
    return "pictures/lesson-" + file;
}

std::string handoutPage(const Lesson& lesson, const NamedValues& tables, AnswerPlace answers)
{
    const handouts::Texts texts(lesson, tables);
    std::string page = handouts::pageStart(lesson.title, handouts::printStyle) + "<h1>" + escaped(lesson.title) +
                       "</h1>\n" + (lesson.intro.empty() ? std::string() : texts.paragraphs(lesson.intro));
    std::string atEnd;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const LessonStep& step = lesson.steps[i];
        page += "<section>\n<h2>" + texts.heading(i) + "</h2>\n" + texts.picture(i) + texts.paragraphs(step.text) +
                texts.box("Try", step.task, "task") + texts.box("Question", step.question, "question");
        if (answers == AnswerPlace::below) page += texts.box("Answer", step.answer, "answer");
        page += "</section>\n";
        if (!step.answer.empty())
            atEnd += "<section>\n<h2>" + texts.heading(i) + "</h2>\n" + texts.paragraphs(step.question) +
                     texts.box("Answer", step.answer, "answer") + "</section>\n";
    }
    if (answers == AnswerPlace::atEnd && !atEnd.empty())
        page += "<div class=\"answers\">\n<h1>" + escaped(translated("Answers")) + "</h1>\n" + atEnd + "</div>\n";
    return page + handouts::pageEnd;
}

std::string slidesPage(const Lesson& lesson, const NamedValues& tables)
{
    const handouts::Texts texts(lesson, tables);
    std::string page = handouts::pageStart(lesson.title, handouts::slideStyle) +
                       "<section class=\"title\"><div>\n<h1>" + escaped(lesson.title) + "</h1>\n" +
                       (lesson.intro.empty() ? std::string() : texts.paragraphs(lesson.intro)) + "</div></section>\n";
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const LessonStep& step = lesson.steps[i];
        page += "<section>\n" + texts.picture(i) + "<div>\n<h2>" + texts.heading(i) + "</h2>\n" +
                texts.paragraphs(step.text) + texts.box("Try", step.task, "task") + "</div>\n</section>\n";
        if (!step.question.empty())
            page += "<section>\n" + texts.picture(i) + "<div>\n<h2>" + texts.heading(i) + "</h2>\n" +
                    texts.box("Question", step.question, "question") + texts.box("Answer", step.answer, "answer") +
                    "</div>\n</section>\n";
    }
    return page + handouts::slideScript + handouts::pageEnd;
}

}  // namespace vitrine::jobs
