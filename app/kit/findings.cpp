#include "app/kit/findings.h"

#include "render/failure.h"
#include "render/version.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <optional>

namespace vitrine::app {
namespace {

using render::Json;

/// Takes `name` and the number behind it from the beginning of the text: ", line 3". Returns 0, and takes nothing, if
/// it does not begin so.
int takeNumber(std::string_view& text, std::string_view name)
{
    if (!text.starts_with(name)) return 0;
    const std::string_view digits = text.substr(name.size());
    int number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || number < 1) return 0;
    text = digits.substr(static_cast<std::size_t>(end - digits.data()));
    return number;
}

}  // namespace

CheckFinding findingOf(const Failure& failure, const std::string& file)
{
    CheckFinding finding{.sentence = failure.message()};
    const std::string whole = failure.what();
    if (!whole.starts_with(file)) return finding;
    std::string_view rest = std::string_view(whole).substr(file.size());
    finding.line = takeNumber(rest, ", line ");
    if (finding.line > 0) finding.column = takeNumber(rest, ", column ");
    if (const std::size_t end = rest.find(": "); finding.line > 0 && rest.starts_with(", ") && end != rest.npos)
        finding.key = rest.substr(2, end - 2);
    return finding;
}

Json newDocument(std::string_view format)
{
    return {{"format", std::string(format)}, {"version", 1}, {"app", render::programVersion()}};
}

FindingsReport::FindingsReport(std::string_view command) : json_(newDocument("vitrine-findings"))
{
    json_["command"] = std::string(command);
    json_["good"] = true;
    json_["files"] = Json::array();
}

Json& FindingsReport::add(const std::string& file, bool good, const std::vector<CheckFinding>& findings)
{
    if (!good) json_["good"] = false;
    Json all = Json::array();
    for (const CheckFinding& finding : findings) {
        Json entry{{"level", finding.isError ? "error" : "note"},
                   {"sentence", finding.sentence.english()},
                   {"file", finding.file.empty() ? file : finding.file}};
        if (finding.line > 0) entry["line"] = finding.line;
        if (finding.column > 0) entry["column"] = finding.column;
        if (!finding.key.empty()) entry["key"] = finding.key;
        all.push_back(std::move(entry));
    }
    json_["files"].push_back(Json{{"file", file}, {"good", good}, {"findings", std::move(all)}});
    return json_["files"].back();
}

int checkEach(const std::vector<std::string>& files, std::string_view command, bool asJson,
              const std::function<int(const std::string& file, FindingsReport*)>& check)
{
    FindingsReport report(command);
    int worst = 0;
    for (const std::string& file : files) worst = std::max(worst, check(file, asJson ? &report : nullptr));
    if (asJson) report.print();
    return worst;
}

void FindingsReport::print() const
{
    std::fputs(render::writeJson(json_).c_str(), stdout);
}

}  // namespace vitrine::app
