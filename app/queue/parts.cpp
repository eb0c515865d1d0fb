#include "app/queue/parts.h"

#include "app/kit/progress.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/read_file.h"
#include "render/files/strict_json.h"
#include "render/hash.h"
#include "render/version.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <random>

namespace vitrine::app {
namespace {

namespace fs = std::filesystem;
using render::Json;

constexpr std::size_t largestReport = std::size_t{64} << 20U;
constexpr std::size_t largestFile = std::size_t{1} << 32U;
constexpr const char* jobFile = "job.json";
constexpr const char* jobFormat = "vitrine-parts";
constexpr const char* keptFormat = "vitrine-picture";
constexpr int partsVersion = 1;

std::string hashText(const std::string& bytes)
{
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx",
                  static_cast<unsigned long long>(render::Hash().add(bytes).value()));
    return text.data();
}

Json jobOf(const std::vector<std::string>& command, int of)
{
    return {{"format", jobFormat},
            {"version", partsVersion},
            {"app", render::programVersion()},
            {"parts", of},
            {"command", command}};
}

/// Reads a small JSON file; nullopt if that is impossible.
std::optional<Json> readReport(const fs::path& path)
{
    try {
        return render::readJson(path, {.bytes = largestReport}).root();
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

fs::path folderOf(const fs::path& out)
{
    return out.string() + ".parts";
}

struct Job {
    std::vector<std::string> command;
    int parts = 1;
};

/// Reads the job of the folder. Throws Failure (ErrorKind::check) if there is none of this version of the program.
Job jobIn(const fs::path& folder)
{
    const std::optional<Json> job = readReport(folder / jobFile);
    if (!job || job->value("format", "") != jobFormat || !job->contains("command") || !(*job)["command"].is_array() ||
        (*job)["command"].empty())
        throw Failure(ErrorKind::check,
                      folder.string() + ": here are no parts; make them with --shard 1/N to N/N and the same --out.");
    if (job->value("version", 0) != partsVersion || job->value("app", "") != render::programVersion())
        throw Failure(ErrorKind::check, folder.string() + ": the parts are of another version of the program (" +
                                            job->value("app", "unknown") + "); merge them with that one.");
    Job found;
    for (const Json& word : (*job)["command"]) found.command.push_back(word.is_string() ? word.get<std::string>() : "");
    found.parts = std::clamp(job->value("parts", 1), 1, mostParts);
    return found;
}

[[noreturn]] void another(const fs::path& folder, const std::string& why)
{
    throw Failure(ErrorKind::usage, folder.string() + ": " + why + "; remove the folder, or give another --out.");
}

/// Makes the folder with the job in one step. If several parts start at once, on any machines, each finds the whole
/// folder or none. An existing folder that is not empty is left alone.
void makeFolder(const fs::path& folder, const std::string& job)
{
    fs::path made = folder;
    made += '.' + std::to_string(std::random_device()());
    std::error_code error, ignored;
    try {
        render::atomicWriteMakingFolder(made / jobFile, job);
    } catch (...) {
        fs::remove_all(made, ignored);
        throw;
    }
    fs::rename(made, folder, error);
    if (!error) return;
    fs::remove_all(made, ignored);
    if (!fs::exists(folder, ignored))
        throw Failure(ErrorKind::file, "Cannot make the folder " + folder.string() + ": " + error.message() +
                                           "; check your permissions, or give another --out.");
}

}  // namespace

Parts::Parts(const fs::path& out, const Shard& shard)
    : folder_(folderOf(out)), shard_(shard), command_(commandOfAllParts())
{
    std::error_code error;
    const fs::path job = file(jobFile);
    const Json wanted = jobOf(command_, shard.of);
    if (!fs::exists(job, error)) makeFolder(folder_, wanted.dump(1) + "\n");
    if (!fs::exists(job, error)) another(folder_, "something else is here");
    const std::optional<Json> there = readReport(job);
    if (!there || *there != wanted)
        another(folder_, "the parts of another job, or of another version of the program, are here");
    fs::remove(reportOf(shard.part), error);
}

std::vector<std::string> Parts::commandFor(const fs::path& out)
{
    return jobIn(folderOf(out)).command;
}

Parts::Parts(const fs::path& out) : folder_(folderOf(out))
{
    Job job = jobIn(folder_);
    command_ = std::move(job.command);
    shard_.of = job.parts;

    std::string problems;
    std::map<std::string, int> renderers;
    for (int part = 1; part <= shard_.of; ++part)
        if (const std::string why = problemOf(part, renderers); !why.empty())
            problems += "\n  part " + std::to_string(part) + " " + why + "; make it by: " + commandOf(part);
    if (!problems.empty())
        throw Failure(ErrorKind::check, folder_.string() + ": nothing was merged. Of " + std::to_string(shard_.of) +
                                            " parts," + problems);
    if (renderers.size() > 1)
        throw Failure(ErrorKind::check, folder_.string() + ": nothing was merged, because part " +
                                            std::to_string(renderers.begin()->second) + " was drawn by " +
                                            renderers.begin()->first + " and part " +
                                            std::to_string(renderers.rbegin()->second) + " by " +
                                            renderers.rbegin()->first + "; make all on machines of one kind.");
}

fs::path Parts::reportOf(int part) const
{
    return file("part_" + std::to_string(part) + ".json");
}

std::string Parts::commandOf(int part) const
{
    std::vector<std::string> words{"vitrine"};
    words.insert(words.end(), command_.begin(), command_.end());
    words.insert(words.end(), {"--shard", std::to_string(part) + "/" + std::to_string(shard_.of)});
    return shellText(words);
}

std::string Parts::problemOf(int part, std::map<std::string, int>& renderers) const
{
    std::error_code error;
    if (!fs::exists(reportOf(part), error)) return "is missing";
    const std::optional<Json> report = readReport(reportOf(part));
    if (!report || !report->is_object()) return "is damaged (" + reportOf(part).filename().string() + ")";
    if (const auto why = report->find("failed"); why != report->end())
        return "failed (" + (why->is_string() ? why->get<std::string>() : "for a reason unknown") + ")";
    const auto files = report->find("files");
    if (files == report->end() || !files->is_object()) return "is damaged (" + reportOf(part).filename().string() + ")";
    for (const auto& [name, hash] : files->items()) {
        try {
            if (fs::path(name).filename() != fs::path(name) ||
                hash != hashText(render::readFile(file(name), largestFile)))
                return "is damaged (" + name + ")";
        } catch (const Failure&) {
            return "is damaged (" + name + ")";
        }
    }
    renderers.try_emplace(report->value("renderer", ""), part);
    return {};
}

void Parts::wrote(const std::string& name)
{
    files_[name] = hashText(render::readFile(file(name), largestFile));
}

void Parts::keep(const std::string& name, const render::Image& image, const Json& about)
{
    const Json head{{"format", keptFormat},       {"width", image.width},        {"height", image.height},
                    {"channels", image.channels}, {"names", image.channelNames}, {"about", about}};
    std::string bytes = head.dump() + "\n";
    const std::size_t text = bytes.size();
    bytes.resize(text + image.pixels.size() * sizeof(float));
    if (!image.pixels.empty())
        std::memcpy(bytes.data() + text, image.pixels.data(), image.pixels.size() * sizeof(float));
    render::atomicWrite(file(name), bytes);
    files_[name] = hashText(bytes);
}

std::optional<render::Image> Parts::kept(const std::string& name, Json* about) const
{
    std::error_code error;
    if (!fs::exists(file(name), error)) return std::nullopt;
    const std::string bytes = render::readFile(file(name), largestFile);
    const std::size_t text = bytes.find('\n');
    try {
        const Json head = render::parseJson(bytes.substr(0, text), file(name).string()).root();
        render::Image image;
        image.width = head.at("width").get<int>();
        image.height = head.at("height").get<int>();
        image.channels = head.at("channels").get<int>();
        image.channelNames = head.at("names").get<std::vector<std::string>>();
        if (about) *about = head.at("about");
        const std::size_t count = (bytes.size() - text - 1) / sizeof(float);
        const auto wanted = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                            static_cast<std::size_t>(image.channels);
        if (head.at("format") != keptFormat || image.width < 0 || image.height < 0 || image.channels < 0 ||
            text == std::string::npos || count != wanted)
            throw std::runtime_error("other sizes");
        image.pixels.resize(count);
        if (count > 0) std::memcpy(image.pixels.data(), bytes.data() + text + 1, count * sizeof(float));
        return image;
    } catch (const std::exception&) {
        throw Failure(ErrorKind::check, file(name).string() + ": this is damaged; make its part again.");
    }
}

void Parts::finish(const std::string& renderer)
{
    render::atomicWrite(reportOf(shard_.part), Json{{"renderer", renderer}, {"files", files_}}.dump(1) + "\n");
}

void Parts::fail(const std::string& why)
{
    render::atomicWrite(reportOf(shard_.part), Json{{"failed", why}}.dump(1) + "\n");
}

int runPart(const fs::path& out, const Shard& shard, const std::function<std::optional<std::string>(Parts&)>& make)
{
    Parts parts(out, shard);
    std::optional<std::string> renderer;
    try {
        renderer = make(parts);
    } catch (const Failure& failure) {
        parts.fail(failure.what());
        throw;
    }
    if (!renderer) return StopSignal::exitCode;
    parts.finish(*renderer);
    std::printf("%s: part %d of %d is made; when all are: %s\n", parts.folder().c_str(), parts.shard().part,
                parts.shard().of, shellText({"vitrine", "merge", out.string()}).c_str());
    return 0;
}

}  // namespace vitrine::app
