#include "exhibits/your_shader/crash_guard.h"

#include "exhibits/framework/files/state_folder.h"
#include "render/failure.h"
#include "render/files/asset_store.h"
#include "render/files/assets.h"
#include "render/files/strict_json.h"
#include "render/hash.h"

#include <algorithm>

namespace vitrine::guest {
namespace {

namespace fs = std::filesystem;

/// Largest number of works in a file.
constexpr std::size_t mostEntries = 8;

/// Returns whether a file comes with the program.
bool isOurs(const fs::path& file)
{
    const fs::path inAssets = file.lexically_normal().lexically_relative(render::asset("shaders").lexically_normal());
    return !inAssets.empty() && *inAssets.begin() != "..";
}

std::string textOfJson(const render::Json& json, const char* key)
{
    return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
}

}  // namespace

CrashGuard::CrashGuard(const fs::path& folder) : journal_(folder)
{
    for (const AbandonedSession& session : journal_.abandoned()) read(session);
}

CrashGuard& CrashGuard::ofProcess()
{
    static CrashGuard guard(stateFolder() / "shaders");
    return guard;
}

CrashGuard::Entry CrashGuard::entryOf(const Work& work)
{
    render::Hash hash;
    render::addTo(hash, render::fileState(work.path));
    return {fs::absolute(work.path).string(), work.id, std::to_string(hash.value())};
}

/// Takes the entries of a process that died. A file whose shaders were all saved again is removed.
void CrashGuard::read(const AbandonedSession& session)
{
    std::vector<Entry> entries;
    try {
        const render::Json json = render::parseJson(session.text, "", {1U << 16U, 8, 1000, 1U << 16U}).root();
        if (json.is_object() && json.contains("shaders") && json["shaders"].is_array())
            for (const render::Json& each : json["shaders"])
                entries.push_back({textOfJson(each, "file"),
                                   std::strtoull(textOfJson(each, "programs").c_str(), nullptr, 10),
                                   textOfJson(each, "saved")});
    } catch (const render::JsonFailure&) {
        entries.clear();  // The process died while it wrote the file.
    }
    std::erase_if(entries, [](const Entry& entry) {
        render::Hash now;
        render::addTo(now, render::fileState(entry.file));
        return entry.saved != std::to_string(now.value());
    });
    if (entries.empty()) journal_.discard(session);
    left_.insert(left_.end(), entries.begin(), entries.end());
}

bool CrashGuard::leavesOff(const Work& work) const
{
    const std::lock_guard lock(mutex_);
    return !left_.empty() && std::find(left_.begin(), left_.end(), entryOf(work)) != left_.end();
}

void CrashGuard::begin(const Work& work)
{
    const std::lock_guard lock(mutex_);
    if (wereDrawn_.contains(work.id) || isOurs(work.path)) return;
    const Entry entry = entryOf(work);
    if (std::find(beginning_.begin(), beginning_.end(), entry) != beginning_.end()) return;
    beginning_.push_back(entry);
    if (beginning_.size() > mostEntries) beginning_.erase(beginning_.begin());
    write();
}

void CrashGuard::drawn()
{
    const std::lock_guard lock(mutex_);
    if (beginning_.empty()) return;
    for (const Entry& entry : beginning_) wereDrawn_.insert(entry.programs);
    beginning_.clear();
    record_.reset();
    journal_.cleanExit();
}

void CrashGuard::write()
{
    render::Json shaders = render::Json::array();
    for (const Entry& entry : beginning_)
        shaders.push_back(
            render::Json{{"file", entry.file}, {"programs", std::to_string(entry.programs)}, {"saved", entry.saved}});
    try {
        journal_.write(render::writeJson(render::Json{{"shaders", shaders}}));
        if (!record_) record_.emplace(journal_.path());
    } catch (const Failure&) {
        return;  // A folder that cannot be written guards nothing; the journal of the session says so.
    }
}

}  // namespace vitrine::guest
