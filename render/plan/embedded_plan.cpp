#include "render/plan/embedded_plan.h"

#include <utility>

namespace vitrine::render {
namespace {

/// Gives images, buffers and states of the inner plan their names in the outer one.
class InnerNames {
public:
    explicit InnerNames(const std::string& prefix) : prefix_(prefix) {}

    void rename(std::string& name) const { name.insert(0, prefix_); }
    void rename(std::vector<std::string>& names) const
    {
        for (std::string& name : names) rename(name);
    }
    void rename(std::vector<SampledTexture>& inputs) const
    {
        for (SampledTexture& input : inputs)
            if (auto* image = std::get_if<std::string>(&input.source)) rename(*image);
    }
    void rename(std::vector<BufferUse>& buffers) const
    {
        for (BufferUse& use : buffers)
            if (auto* buffer = std::get_if<std::string>(&use.source)) rename(*buffer);
    }
    void rename(std::vector<Attachment>& attachments) const
    {
        for (Attachment& attachment : attachments) rename(attachment.image);
    }
    void rename(Pass& pass) const
    {
        rename(pass.colors);
        if (pass.depth) rename(pass.depth->image);
        rename(pass.storage);
        rename(pass.inputs);
        rename(pass.buffers);
        rename(pass.reads);
        rename(pass.writes);
        rename(pass.mipmaps);
        if (pass.depthOnly) rename(pass.depthOnly->inputs);
        for (Draw& draw : pass.draws) {
            rename(draw.inputs);
            rename(draw.buffers);
        }
    }

private:
    const std::string& prefix_;
};

/// Returns the view that the pass has in its own plan.
View viewOf(const Pass& pass, const FramePlan& plan)
{
    if (pass.view) return *pass.view;
    for (const std::string& image : outputsOf(pass))
        if (const auto info = plan.images().find(image); info != plan.images().end() && info->second.hasOwnPixels())
            return viewOfOwnPixels(plan.view, info->second);
    return plan.view;
}

void declare(FramePlan& plan, const FramePlan& inner, const EmbeddedPlan& place)
{
    const InnerNames names(place.imagePrefix);
    for (const auto& [name, declared] : inner.images()) {
        if (place.onlyKept && !declared.persistent) continue;
        ImageInfo info = declared;
        info.ownPixels = info.hasOwnPixels();
        info.size = sizeOf(declared, inner.view.raster);
        info.divisor = 0;
        names.rename(info.name);
        plan.image(std::move(info));
    }
    for (const auto& [name, declared] : inner.buffers()) {
        if (place.onlyKept && !declared.persistent) continue;
        BufferInfo info = declared;
        names.rename(info.name);
        plan.buffer(std::move(info));
    }
}

}  // namespace

void embed(FramePlan& plan, const FramePlan& inner, const EmbeddedPlan& place)
{
    declare(plan, inner, place);
    for (const CulledPass& left : inner.skipped()) {
        if (!left.complaint) continue;
        if (left.unreadable.empty())
            plan.warn(place.passPrefix + left.name, left.reason, left.work);
        else
            plan.warnOfFile(place.passPrefix + left.name, left.unreadable,
                            left.reason.substr(left.unreadable.size() + 1));
    }
    if (place.onlyKept) return;
    const InnerNames names(place.imagePrefix);
    for (Pass pass : inner.passes()) {
        pass.view = viewOf(pass, inner);
        pass.name.insert(0, place.passPrefix);
        pass.reason = place.reason;
        pass.phase = place.phase;
        names.rename(pass);
        // The last good program of a family draws with its own images, which are those of one plan.
        if (!pass.shader.programFamily.empty()) names.rename(pass.shader.programFamily);
        pass.shader.meanwhile = nullptr;
        pass.shader.specialized = nullptr;
        plan.add(std::move(pass));
    }
}

}  // namespace vitrine::render
