#include "render/gl/program_cache.h"

#include "render/failure.h"

#include <algorithm>

namespace vitrine::render::gl {
namespace {

std::string identify(const ShaderKey& key)
{
    return key.vertex + '|' + describe(key) + '|' + key.prelude;
}

}  // namespace

GLuint ProgramCache::use(const ShaderKey& key)
{
    const std::string id = identify(key);
    auto found = programs_.find(id);
    if (found == programs_.end()) {
        found = programs_.emplace(id, Entry{key, {}, {}}).first;
        rebuild(found->second);
    }
    const BuiltProgram& build = found->second.build;
    if (!build.program) {
        const ShaderMessage problem = build.problem;
        programs_.erase(found);
        throw Failure(Blame::shader, "shaders/" + problem.file + ", line " + std::to_string(problem.line) + ": " + problem.text +
                                         " (while building " + describe(key) + "); correct the shader or reinstall the program.");
    }
    found->second.lastUse = frame_;
    return build.program.name();
}

void ProgramCache::dropIdle()
{
    std::vector<std::pair<std::uint64_t, std::string>> idle;
    for (const auto& [id, entry] : programs_)
        if (entry.lastUse != frame_) idle.emplace_back(entry.lastUse, id);
    if (idle.size() <= mostIdle) return;
    std::sort(idle.begin(), idle.end());
    for (std::size_t i = 0; i < idle.size() - mostIdle; ++i) programs_.erase(idle[i].second);
}

void ProgramCache::rebuild(Entry& entry)
{
    BuiltProgram fresh = buildProgram(source_, entry.key);
    entry.newest = newestFile(fresh.files.empty() ? entry.build.files : fresh.files);
    built_ += fresh.fromCache ? 0 : 1;
    if (fresh.program || !entry.build.program) {
        entry.build = std::move(fresh);
    } else {
        entry.build.problem = fresh.problem;
        problems_.push_back({fresh.problem.file, fresh.problem.line, fresh.problem.text});
    }
}

bool ProgramCache::reloadChanged()
{
    if (!source_.onDisk()) return false;
    bool tried = false;
    for (auto& [id, entry] : programs_) tried = tried || newestFile(entry.build.files) > entry.newest;
    if (!tried) return false;
    problems_.clear();
    for (auto& [id, entry] : programs_)
        if (newestFile(entry.build.files) > entry.newest || !entry.build.problem.text.empty()) rebuild(entry);
    return true;
}

std::filesystem::file_time_type ProgramCache::newestFile(const std::vector<std::string>& files) const
{
    std::filesystem::file_time_type newest = std::filesystem::file_time_type::min();
    if (!source_.folder()) return newest;
    for (const std::string& file : files) {
        std::error_code error;
        const auto time = std::filesystem::last_write_time(*source_.folder() / file, error);
        if (!error) newest = std::max(newest, time);
    }
    return newest;
}

void ProgramCache::abandon()
{
    for (auto& [id, entry] : programs_) entry.build.program.abandon();
}

}  // namespace vitrine::render::gl
