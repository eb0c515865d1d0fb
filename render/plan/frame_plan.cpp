#include "render/plan/frame_plan.h"

#include <algorithm>
#include <cassert>
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

void collectInputs(const std::vector<Input>& inputs, std::vector<std::string>& names)
{
    for (const Input& input : inputs)
        if (const auto* image = std::get_if<std::string>(&input.source)) names.push_back(*image);
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
    return names;
}

std::vector<std::string> inputsOf(const Pass& pass)
{
    std::vector<std::string> names = pass.reads;
    collectInputs(pass.inputs, names);
    for (const Draw& draw : pass.draws) collectInputs(draw.inputs, names);
    forEachAttachment(pass, [&](const Attachment& a) {
        if (a.load == Load::keep) names.push_back(a.image);
    });
    return names;
}

void FramePlan::image(ImageInfo info)
{
    const std::string name = info.name;
    images_.insert_or_assign(name, std::move(info));
}

void FramePlan::add(Pass pass)
{
    assert(!find(pass.name) && "two passes share a name");
    if (pass.bound.isZero() && !runEverything) {
        skipped_.push_back({.name = std::move(pass.name), .reason = std::move(pass.bound.whyNone), .work = pass.work, .boundIsZero = true});
        return;
    }
    passes_.push_back(std::move(pass));
}

bool FramePlan::needs(const Bound& bound, std::initializer_list<const char*> passes)
{
    if (!bound.isZero() || runEverything) return true;
    for (const char* pass : passes) skipped_.push_back({.name = pass, .reason = bound.whyNone, .work = Work::raster, .boundIsZero = true});
    return false;
}

bool FramePlan::needs(Pass& pass, Effect effect)
{
    if (effect.bound.isZero() && !runEverything) {
        if (!findSkipped(effect.name)) skipped_.push_back({.name = std::move(effect.name), .reason = std::move(effect.bound.whyNone), .work = pass.work, .boundIsZero = true});
        return false;
    }
    pass.effects.push_back(std::move(effect));
    return true;
}

void FramePlan::skip(std::string name, std::string reason, Work work)
{
    skipped_.push_back({std::move(name), std::move(reason), work});
}

void FramePlan::complain(std::string name, std::string reason, Work work)
{
    skipped_.push_back({.name = std::move(name), .reason = std::move(reason), .work = work, .complaint = true});
}

void FramePlan::complainOfFile(std::string name, std::string unreadable, const std::string& instead)
{
    std::string reason = unreadable + ' ' + instead;
    skipped_.push_back({.name = std::move(name), .reason = std::move(reason), .complaint = true, .unreadable = std::move(unreadable)});
}

void FramePlan::prune(const std::vector<std::string>& outputs, const KeptKeys& kept)
{
    std::stable_sort(passes_.begin(), passes_.end(), [](const Pass& a, const Pass& b) { return a.stage < b.stage; });
    if (runEverything) return;

    const auto unchanged = [&](const Pass& pass) {
        if (!pass.key) return false;
        const auto last = kept.find(pass.name);
        if (last == kept.end() || last->second != *pass.key) return false;
        const std::vector<std::string> written = outputsOf(pass);
        return std::all_of(written.begin(), written.end(), [&](const std::string& name) {
            const auto info = images_.find(name);
            return info == images_.end() || info->second.kept;
        });
    };

    // Walk backwards: a pass is kept if something kept reads what it writes. A pass that clears an
    // image ends the interest in earlier writers of its whole content.
    std::set<std::string> wanted(outputs.begin(), outputs.end());
    std::vector<Pass> surviving;
    for (auto pass = passes_.rbegin(); pass != passes_.rend(); ++pass) {
        const std::vector<std::string> written = outputsOf(*pass);
        const bool called = std::any_of(written.begin(), written.end(), [&](const std::string& n) { return wanted.contains(n); });
        // What fed only an unchanged pass is read by nothing, but that it is unchanged says more.
        if (unchanged(*pass)) {
            skip(pass->name, "unchanged since it last ran", pass->work);
            continue;
        }
        if (!called) {
            skip(pass->name, "nothing reads what it writes", pass->work);
            continue;
        }
        forEachAttachment(*pass, [&](const Attachment& a) {
            if (a.load == Load::clear && a.layer < 0 && a.level == 0) wanted.erase(a.image);
        });
        for (const std::string& name : inputsOf(*pass)) wanted.insert(name);
        surviving.push_back(std::move(*pass));
    }
    std::reverse(surviving.begin(), surviving.end());
    passes_ = std::move(surviving);
}

const Pass* FramePlan::find(std::string_view name) const
{
    const auto pass = std::find_if(passes_.begin(), passes_.end(), [&](const Pass& p) { return p.name == name; });
    return pass == passes_.end() ? nullptr : &*pass;
}

const Skipped* FramePlan::findSkipped(std::string_view name) const
{
    const auto pass = std::find_if(skipped_.begin(), skipped_.end(), [&](const Skipped& p) { return p.name == name; });
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
