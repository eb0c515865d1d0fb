#include "app/kit/apply_preset.h"

#include "exhibits/framework/files/preset_store.h"
#include "render/failure.h"
#include "render/files/assets.h"
#include "render/files/read_file.h"
#include "render/files/strict_json.h"
#include "render/image/image_io.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"
#include "render/video/carried_settings.h"

#include <filesystem>

namespace vitrine::app {
namespace {

/// Returns the file of a shipped preset with this name, or else the path as given.
std::string presetFile(const std::string& given, const std::string& subject)
{
    namespace fs = std::filesystem;
    const fs::path path = given;
    std::error_code ignored;
    if (path.has_parent_path() || path.has_extension() || fs::exists(path, ignored)) return given;
    std::vector<std::string> all;
    for (const PresetEntry& preset : PresetStore::standard(render::asset("presets")).list(subject)) {
        if (!preset.shipped) continue;
        const std::string name = preset.path.stem().string();
        if (name == given) return preset.path.string();
        all.push_back(name);
    }
    if (all.empty())
        throw Failure(ErrorKind::file, "There is neither a file nor a preset of " + subject + " named " + given +
                                           "; give a preset file.");
    throw Failure(ErrorKind::file, "There is neither a file nor a preset of " + subject + " named " + given +
                                       didYouMean(given, all) + " its presets are " + joined(all) + '.');
}

void append(std::vector<std::string>& notes, const std::string& file, const std::vector<std::string>& more)
{
    for (const std::string& note : more) notes.push_back(file + ": " + note);
}

}  // namespace

std::string presetTextOf(const std::string& file)
{
    if (!render::mayCarrySettings(file)) {
        std::string text = render::readFile(file, presetLimits.bytes);
        return render::settingsInDescription(text).value_or(std::move(text));
    }
    std::optional<std::string> text = render::carriedSettings(file);
    if (!text)
        throw Failure(ErrorKind::file,
                      file + ": this picture carries no preset; give a preset file, or a picture that Vitrine made.");
    return *text;
}

std::string applyPreset(const Museum& museum, const std::string& given, RequestedPicture& job)
{
    const std::string file = presetFile(given, std::string(museum.subject(job.subject).name()));
    const std::string text = presetTextOf(file);
    const PresetHeader header = presetHeader(render::parseJson(text, file, presetLimits));
    if (header.isExhibition) {
        Exhibition exhibition =
            parseExhibition(text, file, namedValues(museum.subjects(), museum.initialSceneState().values));
        for (auto& [name, values] : exhibition.values)
            if (const auto i = museum.find(name)) job.sceneState.values[*i] = values;
        job.sceneState.camera = exhibition.camera;
        const bool isHall = job.subject == hallIndex;
        const bool ofSubject = exhibition.chosen == museum.subject(job.subject).name();
        job.cameraFromPreset = isHall || ofSubject;
        append(job.notes, file, exhibition.notes);
        if (!exhibition.picture) return {};
        if (!ofSubject && !(isHall && exhibition.picture->isOfTheHall()))
            return file + ": this is a picture of " + exhibition.chosen +
                   "; its settings were taken, and not its size, samples, time or turns.";
        job.taken = exhibition.picture;
        return {};
    }
    // The hall shows presets of any exhibit. Another subject takes only its own.
    const std::string expected =
        job.subject == hallIndex ? header.exhibit : std::string(museum.subject(job.subject).name());
    const auto owner = museum.find(expected);
    if (!owner)
        throw Failure(ErrorKind::file,
                      file + ": it is a preset of \"" + header.exhibit + "\", which is not in this museum.");
    Preset preset = parsePreset(text, file, expected, museum.subject(*owner).parameters());
    job.sceneState.values[*owner] = preset.values;
    if (preset.camera) {
        job.sceneState.camera = *preset.camera;
        job.cameraFromPreset = true;
    }
    append(job.notes, file, preset.notes);
    return {};
}

}  // namespace vitrine::app
