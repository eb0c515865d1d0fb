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

/// The images and buffers that plans name, and the framebuffers made of the images. What the last frame did not declare
/// or use is freed. Of a history image there are two textures, which change places when it was written; of an image
/// that is made by parts, too: one is drawn into while the other, the last whole result, is read.
class Resources {
public:
    /// Makes what the plan's passes use and frees the rest. Returns the names of persistent images and buffers that are
    /// new, and hence hold nothing yet, or gone: what was kept in them must be made again.
    std::vector<std::string> prepare(const FramePlan&);

    /// What passes read under this name; std::out_of_range when unknown.
    [[nodiscard]] const Texture& image(const std::string& name) const;
    /// What passes write under this name.
    [[nodiscard]] const Texture& target(const std::string& name) const;
    [[nodiscard]] GLuint buffer(const std::string& name) const { return buffers_.at(name).buffer.name(); }
    [[nodiscard]] std::int64_t bufferBytes(const std::string& name) const { return buffers_.at(name).info.bytes; }
    /// The framebuffer of what a raster pass draws into.
    [[nodiscard]] GLuint framebuffer(const Pass&);

    /// A pass has written all that it writes into this image: of one made by parts, the last part.
    void finished(const std::string& name);

    [[nodiscard]] bool has(const std::string& name) const { return images_.contains(name); }
    [[nodiscard]] std::size_t imageCount() const { return images_.size(); }
    [[nodiscard]] std::int64_t framebuffersMade() const { return framebuffers_.made(); }
    [[nodiscard]] std::vector<Stored> stored() const;
    void abandon();

private:
    enum class Pair : std::uint8_t { none, history, parts };
    struct StoredImage {
        ImageInfo info;
        Pair pair = Pair::none;
        Texture texture;
        std::optional<Texture> other;  ///< Of a history: the frame before. By parts: what is being drawn.
        bool written = false;          ///< Of a history: since they last changed places.
    };
    struct StoredBuffer {
        BufferInfo info;
        BufferName buffer;
    };
    void prepareImages(const FramePlan&, const std::set<std::string>& used, std::vector<std::string>& lost);
    void prepareBuffers(const FramePlan&, const std::set<std::string>& used, std::vector<std::string>& lost);
    void forget(const StoredImage&);

    std::map<std::string, StoredImage> images_;
    std::map<std::string, std::string> historyOf_;  ///< Name of the last frame's content -> image.
    std::map<std::string, StoredBuffer> buffers_;
    Framebuffers framebuffers_;
};

}  // namespace vitrine::render::gl
