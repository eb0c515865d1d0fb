#include "app/serve/json_rpc.h"
#include "exhibits/study/study_comparison.h"
#include "tests/fuzz/promises.h"
#include "tests/fuzz/readers.h"

#include <string>

namespace vitrine::fuzz {

bool readStudy(std::string_view bytes)
{
    return accepts([&] {
        std::vector<study::KeptStudy> studies;
        for (const study::StudyAndJson& each :
             study::parseStudies(render::parseJson(std::string(bytes), "fuzz.json", study::studyLimits)))
            studies.push_back(each.study);
        require(!studies.empty(), "a file of studies has one");
        for (const study::KeptStudy& study : studies) {
            for (std::size_t point = 0; point < study.points.size(); ++point) (void)study.pointText(point);
            for (const std::size_t point : study.front) require(point < study.points.size(), "a front names points");
        }
        require(!study::keptCsv(studies).empty(), "studies can be written as a table");
        studies.push_back(studies.front());
        for (const std::string& cost : study::sharedCosts(studies)) {
            const study::StudyComparison compared = study::compareStudies(studies, study::labelsOf(studies), cost);
            require(!study::comparisonCsv(compared).empty(), "a comparison can be written as a table");
            (void)render::writeJson(study::comparisonJson(studies, compared));
        }
    });
}

bool readRequest(std::string_view bytes)
{
    const auto requireOneLine = [](const std::string& line) {
        require(line.find('\n') == line.size() - 1, "an answer is one line");
        return render::parseJson(line, "answer").root();
    };
    try {
        const app::RpcRequest request = app::parseRequest(std::string(bytes));
        require(request.params.is_object(), "params go by name");
        const render::Json answer = requireOneLine(app::answerLine(request.id, request.params));
        require(answer["id"] == request.id && answer["result"] == request.params, "what was read is written again");
        return true;
    } catch (const app::RpcFailure& failure) {
        require(requireOneLine(app::errorLine(failure.id(), failure))["id"] == failure.id(), "a refusal has the id");
        return false;
    }
}

}  // namespace vitrine::fuzz
