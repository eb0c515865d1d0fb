#include "exhibits/study/study_store.h"

#include "exhibits/framework/files/slug.h"
#include "exhibits/framework/files/state_folder.h"
#include "render/files/atomic_write.h"
#include "render/files/read_file.h"
#include "render/image/image_io.h"

#include <algorithm>

namespace vitrine::study {
namespace {

namespace fs = std::filesystem;
using render::Json;

fs::path picturesOf(fs::path study)
{
    return study.replace_extension(StudyStore::picturesExtension);
}

std::uintmax_t sizeOf(const fs::path& path)
{
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    return error ? 0 : size;
}

bool isNewer(const StudyEntry& a, const StudyEntry& b)
{
    if (a.problem.empty() != b.problem.empty()) return a.problem.empty();
    return std::tie(a.study.measured, a.path) > std::tie(b.study.measured, b.path);
}

}  // namespace

std::string nameOfStudyFile(const fs::path& file)
{
    if (file.stem() != "study") return file.stem().string();
    std::error_code error;
    const std::string folder = fs::absolute(file, error).parent_path().filename().string();
    return folder.empty() ? file.stem().string() : folder;
}

StudyStore StudyStore::standard()
{
    return {stateFolder() / "studies", stateFolder() / "trash"};
}

std::vector<StudyEntry> StudyStore::list() const
{
    std::vector<StudyEntry> entries;
    for (const fs::path& path : documentsIn(folder_)) {
        StudyEntry entry{path, {}, {}};
        try {
            entry.study = readStudy(path);
        } catch (const Failure& failure) {
            entry.problem = failure.what();
        }
        entries.push_back(std::move(entry));
    }
    std::sort(entries.begin(), entries.end(), isNewer);
    return entries;
}

void StudyStore::makeRoomFor(std::uintmax_t bytes) const
{
    const std::vector<fs::path> files = documentsIn(folder_);
    std::uintmax_t taken = bytes;
    std::size_t count = files.size() + 1;
    for (const fs::path& path : files) taken += sizeOf(path);
    const auto fits = [&] { return count <= limits_.studies && taken <= limits_.bytes; };
    if (fits()) return;
    const std::vector<StudyEntry> entries = list();
    std::vector<fs::path> leaving;
    for (auto entry = entries.rbegin(); entry != entries.rend() && !fits(); ++entry) {
        if (!entry->problem.empty() || !entry->study.name.empty()) continue;
        leaving.push_back(entry->path);
        taken -= std::min(taken, sizeOf(entry->path));
        --count;
    }
    if (!fits())
        throw Failure(ErrorKind::file,
                      "This study was not kept: those with names in " + folder_.string() +
                          " take all the room that there is; delete one of them, or save this one elsewhere.");
    std::error_code ignored;
    for (const fs::path& path : leaving) {
        fs::remove(path, ignored);
        fs::remove(picturesOf(path), ignored);
    }
}

void StudyStore::makeRoomForPictures(const fs::path& added) const
{
    std::uintmax_t taken = 0;
    for (const fs::path& path : documentsIn(folder_)) taken += sizeOf(picturesOf(path));
    if (taken <= limits_.pictureBytes) return;
    const std::vector<StudyEntry> entries = list();
    std::vector<fs::path> leaving;
    for (auto entry = entries.rbegin(); entry != entries.rend() && taken > limits_.pictureBytes; ++entry) {
        const std::uintmax_t bytes = sizeOf(picturesOf(entry->path));
        if (bytes == 0 || entry->path == added || !entry->problem.empty() || !entry->study.name.empty()) continue;
        leaving.push_back(picturesOf(entry->path));
        taken -= std::min(taken, bytes);
    }
    std::error_code ignored;
    if (taken > limits_.pictureBytes) {
        fs::remove(picturesOf(added), ignored);
        throw Failure(ErrorKind::file,
                      "The pictures of this study were not kept, its numbers were: pictures of studies "
                      "with names in " +
                          folder_.string() + " take all the room that there is; delete one of those.");
    }
    for (const fs::path& path : leaving) fs::remove(path, ignored);
}

void StudyStore::keepPictures(const fs::path& study, const ContactSheet& sheet) const
{
    if (sheet.empty()) return;
    render::writePicture(picturesOf(study), sheet.image, render::PictureFormat::exr);
    makeRoomForPictures(study);
}

ContactSheet StudyStore::pictures(const fs::path& path, const KeptStudy& study) const
{
    const fs::path file = picturesOf(path);
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return {};
    ContactSheet sheet{render::readImage(file), study.size, study.views.size(), study.points.size()};
    if (glm::ivec2(sheet.image.width, sheet.image.height) != sheet.extent() || sheet.image.channels != 3)
        throw Failure(ErrorKind::file,
                      file.string() + " does not hold the pictures of " + path.filename().string() + "; delete it.");
    return sheet;
}

fs::path StudyStore::write(const Json& study) const
{
    const std::string text = render::writeJson(study);
    const KeptStudy read = parseStudy(render::parseJson(text, "the study", studyLimits));  // Must be readable again.
    makeRoomFor(text.size());
    fs::path path = freePath(folder_, slugFor(read.measured + ' ' + read.exhibit + ' ' + read.parameterNames()));
    writeOwnFile(path, text);
    return path;
}

fs::path StudyStore::keep(Json study, const std::string& measured, bool complete) const
{
    study["measured"] = measured;
    study["complete"] = complete;
    return write(study);
}

std::vector<fs::path> StudyStore::add(const fs::path& from) const
{
    std::vector<fs::path> added;
    for (const auto& [study, json] : parseStudies(render::readJson(from, studyLimits))) {
        const Json kept = study.name.empty() ? named(json, nameOfStudyFile(from)) : json;
        const std::string text = render::writeJson(kept);
        const std::vector<fs::path> there = documentsIn(folder_);
        const auto same = std::find_if(there.begin(), there.end(), [&](const fs::path& path) {
            return sizeOf(path) == text.size() && render::readFile(path, studyLimits.bytes) == text;
        });
        added.push_back(same != there.end() ? *same : write(kept));
    }
    return added;
}

void StudyStore::rename(const fs::path& path, const std::string& name) const
{
    const render::JsonDocument document = render::readJson(path, studyLimits);
    (void)parseStudy(document);
    render::atomicWrite(path, render::writeJson(named(document.root(), name)));
}

}  // namespace vitrine::study
