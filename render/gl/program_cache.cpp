#include "render/gl/program_cache.h"

#include "render/failure.h"

#include <algorithm>

namespace vitrine::render::gl {
namespace {

std::string identify(const ShaderKey& key)
{
    return key.vertex + '|' + describe(key) + '|' + key.prelude +
           (key.sources ? '|' + std::to_string(key.sources->hash()) : std::string());
}

Message placeOf(const ShaderKey& key, const ShaderMessage& problem)
{
    if (key.sources && key.sources->textByPath().contains(problem.file))
        return message("The generated shader {1}, line {2}: {3}", problem.file, problem.line, problem.text);
    return message("shaders/{1}, line {2}: {3}", problem.file, problem.line, problem.text);
}

}  // namespace

void ProgramCache::buildWith(std::shared_ptr<SharedContext> context)
{
    std::erase_if(programs_, [](const auto& entry) { return entry.second.building && !entry.second.pending; });
    builder_ = context ? std::make_unique<ProgramBuilder>(source_, std::move(context)) : nullptr;
}

std::optional<ProgramInUse> ProgramCache::useSpecialized(const ShaderKey& key)
{
    const std::string id = key.specialized ? identify(*key.specialized) : std::string();
    const std::string family = key.programFamily + " (specialized)";
    if (!key.programFamily.empty()) giveUpOthers(family, id);
    const auto base = key.specialized ? programs_.find(identify(key)) : programs_.end();
    if (base == programs_.end() || !base->second.build.program) return std::nullopt;
    auto found = programs_.find(id);
    if (found == programs_.end()) {
        if (!builder_ && !buildsInParallel()) return std::nullopt;
        found = programs_.emplace(id, Entry{*key.specialized, {}, {}}).first;
        found->second.key.programFamily = family;
        beginInBackground(id, found->second);
    }
    Entry& entry = found->second;
    entry.lastUse = frame_;
    takeWhatIsFinished(id, entry);
    if (!entry.build.program) return std::nullopt;
    base->second.lastUse = frame_;  // Kept, so that it can be used again at once when the key changes.
    return ProgramInUse{.program = entry.build.program.name(), .specialized = key.specialized->about};
}

void ProgramCache::begin(const std::vector<Pass>& passes, Building building)
{
    if (!buildsInParallel()) return;
    for (const Pass& pass : passes) {
        if (pass.work == Work::simulation) continue;
        const bool waits = building == Building::isWaitedFor || !canWait(pass.shader);
        if (!waits && !pass.shader.meanwhile) continue;
        const ShaderKey& key = waits ? pass.shader : *pass.shader.meanwhile;
        const auto [entry, isNew] = programs_.try_emplace(identify(key), Entry{key, {}, {}});
        if (!isNew) continue;
        entry->second.lastUse = frame_;
        entry->second.building = entry->second.awaited = true;
        entry->second.pending.emplace(source_, key);
    }
}

ProgramInUse ProgramCache::use(const ShaderKey& key, Building building)
{
    if (building == Building::goesOn)
        if (std::optional<ProgramInUse> specialized = useSpecialized(key)) return *specialized;
    const std::string id = identify(key);
    auto found = programs_.find(id);
    if (found == programs_.end()) {
        found = programs_.emplace(id, Entry{key, {}, {}}).first;
        if (building == Building::goesOn && canWait(key))
            beginInBackground(id, found->second);
        else
            rebuild(found->second);
    }
    Entry& entry = found->second;
    entry.lastUse = frame_;
    takeWhatIsFinished(id, entry);
    if (entry.building && (entry.awaited || building == Building::isWaitedFor)) buildNow(id, entry);
    if (entry.build.program) {
        if (!key.programFamily.empty()) {
            lastGood_[key.programFamily] = id;
            giveUpOthers(key.programFamily, id);
        }
        return {entry.build.program.name()};
    }
    if (std::optional<ProgramInUse> other = fallback(entry)) return *other;
    const ShaderMessage problem = entry.build.problem;
    programs_.erase(found);
    throw Failure(ErrorKind::shader,
                  message("{1} (while building {2}); correct the shader or reinstall the program.",
                          placeOf(key, problem), describe(key)),
                  {problem.file, problem.line});
}

bool ProgramCache::canWait(const ShaderKey& key) const
{
    if (key.programFamily.empty() || (!builder_ && !buildsInParallel())) return false;
    return key.meanwhile ||
           (lastGood_.contains(key.programFamily) && programs_.contains(lastGood_.at(key.programFamily)));
}

void ProgramCache::beginInBackground(const std::string& id, Entry& entry)
{
    giveUpOthers(entry.key.programFamily, id);
    entry.building = true;
    if (builder_)
        builder_->begin(id, entry.key);
    else
        entry.pending.emplace(source_, entry.key);
}

/// Cancels all other builds of the family: only the newest request is still useful.
void ProgramCache::giveUpOthers(const std::string& family, const std::string& id)
{
    std::erase_if(programs_, [&](const auto& entry) {
        if (entry.first == id || !entry.second.building || entry.second.awaited ||
            entry.second.key.programFamily != family)
            return false;
        if (builder_) builder_->cancel(entry.first);
        return true;
    });
}

void ProgramCache::takeWhatIsFinished(const std::string& id, Entry& entry)
{
    if (!entry.building) return;
    std::optional<BuiltProgram> finished;
    if (entry.pending) {
        if (entry.pending->done()) finished = entry.pending->take();
    } else {
        finished = builder_->take(id);
    }
    if (!finished) return;
    entry.building = entry.awaited = false;
    entry.pending.reset();
    take(entry, std::move(*finished));
}

/// Waits for the driver. What the thread should build is built here instead, since it may have others in its queue.
void ProgramCache::buildNow(const std::string& id, Entry& entry)
{
    entry.building = entry.awaited = false;
    if (entry.pending) {
        take(entry, entry.pending->take());
        entry.pending.reset();
        return;
    }
    builder_->cancel(id);
    rebuild(entry);
}

std::optional<ProgramInUse> ProgramCache::fallback(const Entry& entry)
{
    const ShaderKey& key = entry.key;
    if (key.programFamily.empty()) return std::nullopt;
    const Message why = entry.building
                            ? message("while the new program is being built")
                            : message("because the new program does not build: {1}", placeOf(key, entry.build.problem));
    const bool building = entry.building;
    if (key.meanwhile)
        return ProgramInUse{use(*key.meanwhile).program,
                            message("drawn with {1} {2}", describe(*key.meanwhile), why).english(), building};
    const auto last = lastGood_.find(key.programFamily);
    const auto good = last == lastGood_.end() ? programs_.end() : programs_.find(last->second);
    if (good == programs_.end() || !good->second.build.program) return std::nullopt;
    good->second.lastUse = frame_;
    ProgramInUse used{good->second.build.program.name(), message("drawn with the last good program {1}", why).english(),
                      building};
    const auto hashOf = [](const ShaderKey& of) { return of.sources ? of.sources->hash() : 0; };
    if (hashOf(good->second.key) != hashOf(key)) used.ofSources = hashOf(good->second.key);
    return used;
}

void ProgramCache::dropIdle()
{
    std::vector<std::pair<std::uint64_t, std::string>> idle;
    for (const auto& [id, entry] : programs_)
        if (entry.lastUse != frame_ && (!entry.building || entry.awaited)) idle.emplace_back(entry.lastUse, id);
    if (idle.size() <= mostIdle) return;
    std::sort(idle.begin(), idle.end());
    for (std::size_t i = 0; i < idle.size() - mostIdle; ++i) programs_.erase(idle[i].second);
    std::erase_if(lastGood_, [&](const auto& entry) { return !programs_.contains(entry.second); });
}

void ProgramCache::rebuild(Entry& entry)
{
    take(entry, buildProgram(source_, entry.key));
}

void ProgramCache::take(Entry& entry, BuiltProgram fresh)
{
    entry.newest = newestFile(fresh.files.empty() ? entry.build.files : fresh.files);
    if (!fresh.fromCache) builds_.push_back({describe(entry.key), fresh.seconds});
    const std::string& family = entry.key.programFamily;
    if (!family.empty())
        std::erase_if(problems_, [&](const ShaderProblem& problem) { return problem.programFamily == family; });
    const bool kept = !fresh.program && (entry.build.program || !family.empty());
    if (kept) problems_.push_back({fresh.problem.file, fresh.problem.line, fresh.problem.text, family});
    if (fresh.program || !entry.build.program)
        entry.build = std::move(fresh);
    else
        entry.build.problem = fresh.problem;
}

bool ProgramCache::reloadChanged()
{
    if (!source_.onDisk()) return false;
    bool tried = false;
    for (auto& [id, entry] : programs_) tried = tried || newestFile(entry.build.files) > entry.newest;
    if (!tried) return false;
    problems_.clear();
    for (auto& [id, entry] : programs_)
        if (!entry.building && (newestFile(entry.build.files) > entry.newest || !entry.build.problem.text.empty()))
            rebuild(entry);
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
    builder_.reset();
    for (auto& [id, entry] : programs_) {
        entry.build.program.abandon();
        if (entry.pending) entry.pending->abandon();
    }
}

}  // namespace vitrine::render::gl
