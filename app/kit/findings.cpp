#include "app/kit/findings.h"

#include "render/failure.h"
#include "render/version.h"

#include <algorithm>
#include <cstdio>

namespace vitrine::app {

using render::Json;

CheckFinding findingOf(const Failure& failure, const std::string& file)
{
    const FilePlace& at = failure.place();
    return {.sentence = failure.message(),
            .file = at.file == file ? std::string() : at.file,
            .line = at.line,
            .column = at.column,
            .key = at.key};
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
