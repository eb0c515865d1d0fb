// The methods of the service that draw: plan, render, study.

#include "app/ledger_json.h"
#include "app/picture_options.h"
#include "app/report.h"
#include "app/serve/base64.h"
#include "app/serve/json_rpc.h"
#include "app/serve/params.h"
#include "app/serve/service.h"
#include "app/study/study_options.h"
#include "exhibits/museum/picture_settings.h"
#include "exhibits/study/study.h"
#include "exhibits/study/study_text.h"
#include "render/failure.h"
#include "render/image/image_io.h"
#include "render/plan/diagnostics.h"

#include <CLI/CLI.hpp>

#include <filesystem>

namespace vitrine::app {

using render::Json;

namespace {

/// Of a picture that goes into the answer.
constexpr std::size_t mostAnswerBytes = 48U << 20U;

Json sizeJson(const RequestedPicture& job)
{
    return Json::array({job.request.frame.raster.size.x, job.request.frame.raster.size.y});
}

/// What was brought to the nearest legal value, and what pictures complain of.
Json notesJson(const std::vector<std::string>& notes, const std::vector<render::CulledPass>& skipped)
{
    Json json = Json::array();
    for (const std::string& note : notes) json.push_back(withoutDashes(note));
    for (const render::CulledPass& complaint : render::Diagnostics().begun(skipped)) json.push_back(lineOf(complaint));
    return json;
}

Json ledgerJson(const render::FrameReport& frame)
{
    Json counters = Json::object();
    for (const auto& [name, count] : frame.counters) counters[name] = count;
    return Json{{"ran", ranJson(frame.ran)}, {"skipped", skippedJson(frame.skipped)}, {"counters", counters}};
}

std::string pictureInBase64(const RequestedPicture& job, const PictureMaker& maker, render::PictureFormat format,
                            const render::PictureMetadata& metadata)
{
    const std::string bytes = render::encodedPicture("The picture", maker.picture(), format, metadata);
    if (bytes.size() > mostAnswerBytes)
        throw Failure(Blame::usage, "render: a picture of " + sizeJson(job).dump() + " pixels has " +
                                        std::to_string(bytes.size()) + " bytes, and an answer takes " +
                                        std::to_string(mostAnswerBytes) + "; let out name a file.");
    return base64(bytes);
}

}  // namespace

Json Service::planPicture(const Json& params, const Watch&)
{
    PictureOptions picture;
    CLI::App options;
    options.add_option("exhibit", picture.subject)->required();
    addPictureOptions(options, picture);
    readParams(options, "plan", params);
    const RequestedPicture job = requestedPicture(museum_, picture, sceneState_, cameraOf(picture.subject));
    PictureMaker maker(museum_, renderer_, job.sceneState, job.request);
    const render::FramePlan plan = maker.firstPlan();
    return Json{{"exhibit", picture.subject},
                {"size", sizeJson(job)},
                {"runs", plannedJson(plan.passes())},
                {"skipped", skippedJson(plan.skipped())},
                {"notes", notesJson(job.notes, plan.skipped())}};
}

Json Service::renderPicture(const Json& params, const Watch& watch)
{
    PictureOptions picture;
    bool sixteenBit = false, ledger = false;
    CLI::App options;
    options.add_option("exhibit", picture.subject)->required();
    options.add_option("--out", picture.out);
    options.add_flag("--sixteen-bit", sixteenBit);
    options.add_flag("--ledger", ledger);
    addPictureOptions(options, picture);
    readParams(options, "render", params);
    const bool inAnswer = picture.out.empty();
    if (inAnswer) picture.out = "answer.png";  // That kind: nothing is written.
    const render::PictureFormat format = pictureFormat("--out", picture.out, sixteenBit);
    const RequestedPicture job = requestedPicture(museum_, picture, sceneState_, cameraOf(picture.subject));
    PictureMaker maker(museum_, renderer_, job.sceneState, job.request);
    do watch(maker.progress(), "drawing");
    while (maker.step());
    const render::PictureMetadata metadata{
        .preset = pictureSettings(museum_, job.subject, job.sceneState, job.request, "Picture")};
    Json answer{{"exhibit", picture.subject}, {"size", sizeJson(job)}};
    if (inAnswer) {
        answer["png"] = pictureInBase64(job, maker, format, metadata);
    } else {
        render::writePicture(picture.out, maker.picture(), format, metadata);
        answer["out"] = std::filesystem::absolute(picture.out).string();
    }
    if (ledger) answer["ledger"] = ledgerJson(maker.report());
    answer["notes"] = notesJson(job.notes, maker.report().skipped);
    return answer;
}

Json Service::runStudy(const Json& params, const Watch& watch)
{
    StudyOptions asked;
    CLI::App options;
    addStudyOptions(options, asked);
    options.remove_option(options.get_option("--out"));  // The table is the answer.
    readParams(options, "study", params);
    std::vector<std::string> notes;
    StudyRequest request = studyRequest(museum_, asked, sceneState_, notes);
    Study study(museum_, renderer_, std::move(request));
    do watch(study.progress(), study.doing());
    while (study.step());
    Json answer = studyJson(museum_.subjects(), study.request(), study.result(), machineJson(gl_));
    answer["notes"] = notesJson(notes, {});
    return answer;
}

}  // namespace vitrine::app
