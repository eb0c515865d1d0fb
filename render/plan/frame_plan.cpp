#include "render/plan/frame_plan.h"

#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <set>
#include <utility>

namespace vitrine::render {
namespace {

template <typename Visit> void forEachAttachment(const Pass& pass, Visit visit)
{
    for (const Attachment& a : pass.colors) visit(a);
    if (pass.depth) visit(*pass.depth);
    for (const Attachment& a : pass.storage) visit(a);
}

void collectInputs(const std::vector<SampledTexture>& inputs, std::vector<std::string>& names)
{
    for (const SampledTexture& input : inputs)
        if (const auto* image = std::get_if<std::string>(&input.source)) names.push_back(*image);
}

void collectBuffers(const std::vector<BufferUse>& buffers, Access other, std::vector<std::string>& names)
{
    for (const BufferUse& use : buffers)
        if (const auto* buffer = std::get_if<std::string>(&use.source);
            buffer && (use.access == other || use.access == Access::readWrite))
            names.push_back(*buffer);
}

/// Returns the names of sampled images and attachments, without simulation states.
std::vector<std::string> imagesOf(const Pass& pass)
{
    std::vector<std::string> names = pass.mipmaps;
    collectInputs(pass.inputs, names);
    for (const Draw& draw : pass.draws) collectInputs(draw.inputs, names);
    forEachAttachment(pass, [&](const Attachment& a) { names.push_back(a.image); });
    return names;
}

std::vector<std::string> buffersOf(const Pass& pass)
{
    std::vector<std::string> names;
    const auto collect = [&](const std::vector<BufferUse>& uses) {
        for (const BufferUse& use : uses)
            if (const auto* buffer = std::get_if<std::string>(&use.source)) names.push_back(*buffer);
    };
    collect(pass.buffers);
    for (const Draw& draw : pass.draws) collect(draw.buffers);
    return names;
}

/// ", part 3 of 8"; ", parts 3 to 8 of 8".
std::string partsText(const Pass& pass)
{
    const std::string first = std::to_string(pass.temporal.firstSlice + 1);
    const std::string of = " of " + std::to_string(pass.sliceCount);
    if (pass.temporal.endSlice == pass.temporal.firstSlice + 1) return ", part " + first + of;
    return ", parts " + first + " to " + std::to_string(pass.temporal.endSlice) + of;
}

}  // namespace

const char* toString(Work work)
{
    switch (work) {
    case Work::simulation: return "simulation";
    case Work::raster: return "raster";
    case Work::compute: return "compute";
    }
    return "";
}

std::vector<std::string> outputsOf(const Pass& pass)
{
    std::vector<std::string> names = pass.writes;
    forEachAttachment(pass, [&](const Attachment& a) { names.push_back(a.image); });
    collectBuffers(pass.buffers, Access::write, names);
    return names;
}

std::vector<std::string> inputsOf(const Pass& pass)
{
    std::vector<std::string> names = pass.reads;
    collectInputs(pass.inputs, names);
    collectBuffers(pass.buffers, Access::read, names);
    for (const Draw& draw : pass.draws) {
        collectInputs(draw.inputs, names);
        collectBuffers(draw.buffers, Access::read, names);
    }
    forEachAttachment(pass, [&](const Attachment& a) {
        if (a.load == Load::keep) names.push_back(a.image);
    });
    return names;
}

ResourceId FramePlan::image(ImageInfo info)
{
    const std::string name = info.name;
    images_.insert_or_assign(name, std::move(info));
    return ResourceId(name);
}

FramePlan FramePlan::withPassesFirst(std::vector<Pass> first) const
{
    FramePlan plan = *this;
    plan.passes_.insert(plan.passes_.begin(), std::make_move_iterator(first.begin()),
                        std::make_move_iterator(first.end()));
    return plan;
}

ResourceId FramePlan::buffer(BufferInfo info)
{
    const std::string name = info.name;
    buffers_.insert_or_assign(name, std::move(info));
    return ResourceId(name);
}

ResourceId FramePlan::history(History history)
{
    history.image.persistent = true;
    const std::string name = history.image.name;
    images_.insert_or_assign(name, history.image);
    histories_.insert_or_assign(name, HistoryState{std::move(history), false, {}, view});
    return ResourceId(name);
}

void FramePlan::add(Pass pass)
{
    assert(!find(pass.name) && "two passes share a name");
    if (pass.bound.isZero() && !runEverything) {
        skipped_.push_back({.name = std::move(pass.name),
                            .reason = std::move(pass.bound.whyNone),
                            .work = pass.work,
                            .boundIsZero = true});
        return;
    }
    if (pass.sliceCount > 1) {
        assert(pass.contentHash && "work for several frames needs a key");
        for (std::string& name : outputsOf(pass)) slicedImages_.insert(std::move(name));
    }
    if (pass.localLights) {
        const LocalLightsBlock lights = runEverything
                                            ? inOneCell(*pass.localLights)
                                            : reachingLights(*pass.localLights, pass.shaded, pass.view.value_or(view));
        pass.blocks[BLOCK_LOCAL_LIGHTS] = std140Bytes(lights);
        if (lights.count > 0) pass.counts["localLights"] = lights.count;
    }
    passes_.push_back(std::move(pass));
}

bool FramePlan::includeIfEffective(const ContributionBound& bound, std::initializer_list<const char*> passes)
{
    if (!bound.isZero() || runEverything) return true;
    for (const char* pass : passes)
        skipped_.push_back({.name = pass, .reason = bound.whyNone, .work = Work::raster, .boundIsZero = true});
    return false;
}

bool FramePlan::includeIfEffective(Pass& pass, Effect effect)
{
    if (effect.bound.isZero() && !runEverything) {
        if (!findSkipped(effect.name))
            skipped_.push_back({.name = std::move(effect.name),
                                .reason = std::move(effect.bound.whyNone),
                                .work = pass.work,
                                .boundIsZero = true});
        return false;
    }
    pass.effects.push_back(std::move(effect));
    return true;
}

void FramePlan::skip(std::string name, std::string reason, Work work)
{
    assert(!reason.empty());
    skipped_.push_back({std::move(name), std::move(reason), work});
}

void FramePlan::warn(std::string name, std::string reason, Work work)
{
    skipped_.push_back({.name = std::move(name), .reason = std::move(reason), .work = work, .complaint = true});
}

void FramePlan::warnOfFile(std::string name, std::string unreadable, const std::string& instead)
{
    std::string reason = unreadable + ' ' + instead;
    skipped_.push_back(
        {.name = std::move(name), .reason = std::move(reason), .complaint = true, .unreadable = std::move(unreadable)});
}

void FramePlan::prune(const std::vector<std::string>& outputs, const PersistentState& kept)
{
    std::stable_sort(passes_.begin(), passes_.end(), [](const Pass& a, const Pass& b) { return a.phase < b.phase; });
    for (auto& [name, info] : images_) info.persistent = info.persistent || slicedImages_.contains(name);
    for (auto& [name, info] : buffers_) info.persistent = info.persistent || slicedImages_.contains(name);
    if (!runEverything) drop(outputs, kept);
    for (Pass& pass : passes_) takeSlice(pass, kept);
    readTemporalState(kept);
}

bool FramePlan::isUnchanged(const Pass& pass, const PersistentState& kept) const
{
    if (!pass.contentHash) return false;
    const auto last = kept.passes.find(pass.name);
    if (last == kept.passes.end() || last->second != *pass.contentHash) return false;
    const std::vector<std::string> written = outputsOf(pass);
    return std::all_of(written.begin(), written.end(), [&](const std::string& name) {
        if (const auto buffer = buffers_.find(name); buffer != buffers_.end()) return buffer->second.persistent;
        const auto info = images_.find(name);
        return info == images_.end() || info->second.persistent;
    });
}

std::vector<bool> FramePlan::calledFor(const std::vector<std::string>& outputs,
                                       const std::vector<bool>& unchanged) const
{
    // Walk backwards: a pass is kept if a kept pass reads what it writes. A pass that clears a whole image makes
    // earlier writers of it unnecessary. A pass that reads a history will read this frame's content in the next frame.
    // The writers of that history are therefore kept, too, and the walk is repeated.
    std::set<std::string> always(outputs.begin(), outputs.end());
    for (;;) {
        std::set<std::string> wanted = always;
        std::vector<bool> called(passes_.size(), false);
        for (std::size_t i = passes_.size(); i-- > 0;) {
            const Pass& pass = passes_[i];
            const std::vector<std::string> written = outputsOf(pass);
            if (unchanged[i] ||
                std::none_of(written.begin(), written.end(), [&](const std::string& n) { return wanted.contains(n); }))
                continue;
            called[i] = true;
            forEachAttachment(pass, [&](const Attachment& a) {
                if (a.load == Load::clear && a.layer < 0 && a.level == 0) wanted.erase(a.image);
            });
            for (const BufferUse& use : pass.buffers)
                if (const auto* buffer = std::get_if<std::string>(&use.source); buffer && use.access == Access::write)
                    wanted.erase(*buffer);
            for (const std::string& name : inputsOf(pass)) wanted.insert(name);
        }
        const std::size_t before = always.size();
        for (const auto& [name, state] : histories_)
            if (wanted.contains(previous(name))) always.insert(name);
        if (always.size() == before) return called;
    }
}

void FramePlan::drop(const std::vector<std::string>& outputs, const PersistentState& kept)
{
    std::vector<bool> unchanged;
    for (const Pass& pass : passes_) unchanged.push_back(isUnchanged(pass, kept));
    const std::vector<bool> called = calledFor(outputs, unchanged);
    std::vector<Pass> surviving;
    for (std::size_t i = passes_.size(); i-- > 0;) {
        Pass& pass = passes_[i];
        // A pass that fed only an unchanged pass is read by nothing. "Unchanged" is the more useful reason, so it is
        // tested first.
        if (unchanged[i])
            skip(pass.name, "unchanged since it last ran", pass.work);
        else if (!called[i])
            skip(pass.name, "its output is not used", pass.work);
        else
            surviving.push_back(std::move(pass));
    }
    std::reverse(surviving.begin(), surviving.end());
    passes_ = std::move(surviving);
}

void FramePlan::takeSlice(Pass& pass, const PersistentState& kept) const
{
    pass.temporal = {.lastView = view};
    if (pass.sliceCount <= 1) return;
    const auto progress = kept.slices.find(pass.name);
    const bool begun = progress != kept.slices.end() && progress->second.hash == pass.contentHash.value_or(0) &&
                       progress->second.done < pass.sliceCount;
    pass.temporal.used = true;
    pass.temporal.firstSlice = begun ? progress->second.done : 0;
    pass.temporal.endSlice = allSlices || runEverything ? pass.sliceCount : pass.temporal.firstSlice + 1;
    pass.reason += partsText(pass);
    if (pass.temporal.firstSlice == 0) return;
    for (Attachment& a : pass.colors) a.load = Load::keep;
    if (pass.depth) pass.depth->load = Load::keep;
}

void FramePlan::readTemporalState(const PersistentState& kept)
{
    std::map<std::string, const HistoryState*> byPrevious;
    for (auto& [name, state] : histories_) {
        const auto last = kept.histories.find(name);
        state = historyState(state.history, state.history.view.value_or(view), time, resetHistory,
                             last == kept.histories.end() ? nullptr : &last->second);
        byPrevious[previous(name)] = &state;
    }
    std::set<std::string> unfinishedImages;
    std::set<std::string> emptyImages;  // Outputs of sliced passes that never produced a complete result.
    for (Pass& pass : passes_) {
        const std::vector<std::string> written = outputsOf(pass);
        const auto writes = [&](const std::string& name) {
            return std::find(written.begin(), written.end(), name) != written.end();
        };
        for (const std::string& name : inputsOf(pass)) {
            if (const auto state = byPrevious.find(name); state != byPrevious.end()) {
                pass.temporal.used = true;
                pass.temporal.lastView = state->second->lastView;
                if (pass.temporal.valid && !state->second->valid)
                    pass.reason += ", its history starts again: " + state->second->reset;
                pass.temporal.valid = pass.temporal.valid && state->second->valid;
            }
            if (!slicedImages_.contains(name) || (pass.sliceCount > 1 && writes(name))) continue;
            pass.temporal.used = true;
            pass.temporal.provisional = pass.temporal.provisional || unfinishedImages.contains(name);
            pass.temporal.valid = pass.temporal.valid && !emptyImages.contains(name);
        }
        if (pass.temporal.provisional || pass.temporal.endSlice < pass.sliceCount)
            unfinishedImages.insert(written.begin(), written.end());
        if (pass.temporal.endSlice >= pass.sliceCount) continue;
        const auto progress = kept.slices.find(pass.name);
        if (progress == kept.slices.end() || !progress->second.completedOnce)
            emptyImages.insert(written.begin(), written.end());
    }
}

bool FramePlan::unfinished() const
{
    return std::any_of(passes_.begin(), passes_.end(),
                       [](const Pass& pass) { return pass.temporal.endSlice < pass.sliceCount; });
}

std::vector<std::string> FramePlan::errors() const
{
    std::vector<std::string> found;
    const auto isImage = [&](const std::string& name) {
        return images_.contains(name) || std::any_of(histories_.begin(), histories_.end(), [&](const auto& history) {
                   return previous(history.first) == name;
               });
    };
    for (const Pass& pass : passes_) {
        for (const std::string& name : imagesOf(pass))
            if (!isImage(name))
                found.push_back(pass.name + " uses the image \"" + name + "\", which the plan does not declare");
        for (const std::string& name : buffersOf(pass))
            if (!buffers_.contains(name))
                found.push_back(pass.name + " uses the buffer \"" + name + "\", which the plan does not declare");
    }
    for (const auto& [name, info] : buffers_)
        if (images_.contains(name)) found.push_back("\"" + name + "\" is the name of an image and of a buffer");
    return found;
}

const Pass* FramePlan::find(std::string_view name) const
{
    const auto pass = std::find_if(passes_.begin(), passes_.end(), [&](const Pass& p) { return p.name == name; });
    return pass == passes_.end() ? nullptr : &*pass;
}

const CulledPass* FramePlan::findSkipped(std::string_view name) const
{
    const auto pass =
        std::find_if(skipped_.begin(), skipped_.end(), [&](const CulledPass& p) { return p.name == name; });
    return pass == skipped_.end() ? nullptr : &*pass;
}

std::string toString(const FramePlan& plan)
{
    std::string text;
    for (const Pass& pass : plan.passes()) {
        if (!text.empty()) text += " > ";
        text += pass.name;
    }
    return text;
}

}  // namespace vitrine::render
