#pragma once

#include "render/gl/framebuffers.h"
#include "render/gl/stored.h"
#include "render/gl/texture.h"
#include "render/plan/frame_plan.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::render::gl {

/// Images and buffers that plans name, and framebuffers of the images. A resource is freed when a frame does not
/// declare or use it. A history image has two textures, which are swapped after it was written. An image of a sliced
/// pass also has two: one is drawn into, while the other, the last complete result, is read.
class Resources {
public:
    /// Creates the resources that the plan's passes use and frees all others. Returns the names of persistent images
    /// and buffers that are new, and so have no content yet, or were freed. Their content must be drawn again.
    std::vector<std::string> prepare(const FramePlan&);

    /// Texture that passes read under this name. Throws std::out_of_range if it is unknown.
    [[nodiscard]] const Texture& image(const std::string& name) const;
    /// Texture that passes write under this name.
    [[nodiscard]] const Texture& target(const std::string& name) const;
    [[nodiscard]] GLuint buffer(const std::string& name) const { return buffers_.at(name).buffer.name(); }
    [[nodiscard]] std::int64_t bufferBytes(const std::string& name) const { return buffers_.at(name).info.bytes; }
    /// Framebuffer with the attachments of a raster pass.
    [[nodiscard]] GLuint framebuffer(const Pass&);

    /// Call it when a pass has completed this image; in a sliced pass after the last slice.
    void finished(const std::string& name);

    [[nodiscard]] bool has(const std::string& name) const { return images_.contains(name); }
    [[nodiscard]] std::size_t imageCount() const { return images_.size(); }
    [[nodiscard]] std::int64_t framebuffersMade() const { return framebuffers_.made(); }
    [[nodiscard]] std::vector<Stored> stored() const;
    void abandon();

private:
    enum class Pair : std::uint8_t { none, history, slices };
    struct StoredImage {
        ImageInfo info;
        Pair pair = Pair::none;
        Texture texture;
        std::optional<Texture> other;  ///< History: the last frame's texture. Sliced pass: the texture being drawn.
        bool written = false;          ///< History: written since the last swap.
    };
    struct StoredBuffer {
        BufferInfo info;
        BufferName buffer;
    };
    void prepareImages(const FramePlan&, const std::set<std::string>& used, std::vector<std::string>& lost);
    void prepareBuffers(const FramePlan&, const std::set<std::string>& used, std::vector<std::string>& lost);
    void forget(const StoredImage&);

    std::map<std::string, StoredImage> images_;
    std::map<std::string, std::string> historyOf_;  ///< Name of the last frame's content (`previous`) -> image.
    std::map<std::string, StoredBuffer> buffers_;
    Framebuffers framebuffers_;
};

}  // namespace vitrine::render::gl
