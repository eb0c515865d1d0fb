#include "render/gl/resources.h"

#include "render/failure.h"

#include <algorithm>

namespace vitrine::render::gl {
namespace {

std::set<std::string> namesUsed(const FramePlan& plan)
{
    std::set<std::string> used;
    for (const Pass& pass : plan.passes()) {
        for (std::string& name : inputsOf(pass)) used.insert(std::move(name));
        for (std::string& name : outputsOf(pass)) used.insert(std::move(name));
    }
    for (const auto& [name, info] : plan.images())
        if (info.persistent) used.insert(name);
    for (const auto& [name, info] : plan.buffers())
        if (info.persistent) used.insert(name);
    for (const auto& [name, state] : plan.histories())
        if (used.contains(previous(name))) used.insert(name);
    return used;
}

BufferName makeBuffer(const BufferInfo& info)
{
    GLuint name = 0;
    glCreateBuffers(1, &name);
    BufferName buffer(name);
    while (glGetError() != GL_NO_ERROR) {
    }
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(std::max<std::int64_t>(info.bytes, 16)), nullptr,
                         GL_DYNAMIC_STORAGE_BIT);
    if (glGetError() != GL_NO_ERROR) {
        throw Failure(
            ErrorKind::openGl,
            message("The graphics driver cannot store the buffer \"{1}\" of {2} bytes; choose fewer or smaller things.",
                    info.name, info.bytes));
    }
    glClearNamedBufferData(name, GL_R8, GL_RED, GL_UNSIGNED_BYTE, nullptr);
    glObjectLabel(GL_BUFFER, name, -1, info.name.c_str());
    return buffer;
}

}  // namespace

std::vector<std::string> Resources::prepare(const FramePlan& plan)
{
    const std::set<std::string> used = namesUsed(plan);
    std::vector<std::string> lost;
    prepareImages(plan, used, lost);
    prepareBuffers(plan, used, lost);
    historyOf_.clear();
    for (const auto& [name, state] : plan.histories()) historyOf_[previous(name)] = name;
    return lost;
}

void Resources::prepareImages(const FramePlan& plan, const std::set<std::string>& used, std::vector<std::string>& lost)
{
    std::erase_if(images_, [&](const auto& entry) {
        if (used.contains(entry.first)) return false;
        if (entry.second.info.persistent) lost.push_back(entry.first);
        forget(entry.second);
        return true;
    });
    for (const auto& [name, info] : plan.images()) {
        if (!used.contains(name)) continue;
        const glm::ivec2 size = sizeOf(info, plan.view.raster);
        const Pair pair = plan.histories().contains(name)      ? Pair::history
                          : plan.slicedImages().contains(name) ? Pair::slices
                                                               : Pair::none;
        const auto stored = images_.find(name);
        if (stored != images_.end() && sameStorage(stored->second.info, info) &&
            stored->second.texture.size() == size && stored->second.pair == pair) {
            if (stored->second.pair == Pair::history && stored->second.written)
                std::swap(stored->second.texture, *stored->second.other);
            stored->second.written = false;
            continue;
        }
        if (stored != images_.end()) {
            forget(stored->second);
            images_.erase(stored);
        }
        StoredImage made{info, pair, Texture(info, size), std::nullopt, false};
        if (pair != Pair::none) {
            made.other.emplace(info, size);
            made.texture.clear();
            made.other->clear();
        }
        images_.emplace(name, std::move(made));
        if (info.persistent) lost.push_back(name);
    }
}

void Resources::prepareBuffers(const FramePlan& plan, const std::set<std::string>& used, std::vector<std::string>& lost)
{
    std::erase_if(buffers_, [&](const auto& entry) {
        const auto declared = plan.buffers().find(entry.first);
        if (used.contains(entry.first) && declared != plan.buffers().end() && declared->second == entry.second.info)
            return false;
        if (entry.second.info.persistent) lost.push_back(entry.first);
        return true;
    });
    for (const auto& [name, info] : plan.buffers()) {
        if (!used.contains(name) || buffers_.contains(name)) continue;
        buffers_.emplace(name, StoredBuffer{info, makeBuffer(info)});
        if (info.persistent) lost.push_back(name);
    }
}

void Resources::forget(const StoredImage& stored)
{
    framebuffers_.forget(stored.texture);
    if (stored.other) framebuffers_.forget(*stored.other);
}

const Texture& Resources::image(const std::string& name) const
{
    const auto history = historyOf_.find(name);
    return history == historyOf_.end() ? images_.at(name).texture : *images_.at(history->second).other;
}

const Texture& Resources::target(const std::string& name) const
{
    const StoredImage& stored = images_.at(name);
    return stored.pair == Pair::slices ? *stored.other : stored.texture;
}

GLuint Resources::framebuffer(const Pass& pass)
{
    const auto targetOf = [&](const Attachment& attachment) {
        return TargetImage{&target(attachment.image), attachment.layer, attachment.level};
    };
    std::vector<TargetImage> colors;
    for (const Attachment& color : pass.colors) colors.push_back(targetOf(color));
    return framebuffers_.use(colors, pass.depth ? targetOf(*pass.depth) : TargetImage{});
}

void Resources::finished(const std::string& name)
{
    const auto stored = images_.find(name);
    if (stored == images_.end()) return;
    stored->second.written = true;
    if (stored->second.pair == Pair::slices) std::swap(stored->second.texture, *stored->second.other);
}

std::vector<Stored> Resources::stored() const
{
    Stored images{"images"};
    for (const auto& [name, image] : images_) {
        images.add(image.texture.bytes());
        if (image.other) images.add(image.other->bytes());
    }
    Stored buffers{"buffers"};
    for (const auto& [name, stored] : buffers_) buffers.add(stored.info.bytes);
    return {images, buffers};
}

void Resources::abandon()
{
    framebuffers_.abandon();
    for (auto& [name, stored] : images_) {
        stored.texture.abandon();
        if (stored.other) stored.other->abandon();
    }
    for (auto& [name, stored] : buffers_) stored.buffer.abandon();
}

}  // namespace vitrine::render::gl
