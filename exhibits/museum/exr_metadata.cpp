#include "exhibits/museum/exr_metadata.h"

#include "render/files/number_text.h"
#include "render/files/strict_json.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

namespace vitrine {
namespace {

/// MurmurHash3_x86_32 of Austin Appleby, with seed 0.
std::uint32_t murmurHash3(std::string_view bytes)
{
    const auto mixed = [](std::uint32_t block) { return std::rotl(block * 0xcc9e2d51U, 15) * 0x1b873593U; };
    std::uint32_t hash = 0;
    std::size_t at = 0;
    for (; at + 4 <= bytes.size(); at += 4) {
        std::uint32_t block = 0;
        std::memcpy(&block, bytes.data() + at, 4);
        hash = std::rotl(hash ^ mixed(block), 13) * 5 + 0xe6546b64U;
    }
    std::uint32_t tail = 0;
    for (std::size_t i = bytes.size(); i > at; --i) tail = tail << 8U | static_cast<unsigned char>(bytes[i - 1]);
    hash ^= mixed(tail) ^ static_cast<std::uint32_t>(bytes.size());
    hash = (hash ^ hash >> 16U) * 0x85ebca6bU;
    hash = (hash ^ hash >> 13U) * 0xc2b2ae35U;
    return hash ^ hash >> 16U;
}

std::string hexadecimal(std::uint32_t number)
{
    std::array<char, 9> text{};
    std::snprintf(text.data(), text.size(), "%08x", number);
    return text.data();
}

std::array<float, 16> rowVectorMatrix(const glm::dmat4& m)
{
    // The columns of a matrix for column vectors are the rows of that for row vectors.
    std::array<float, 16> rows{};
    std::transform(glm::value_ptr(m), glm::value_ptr(m) + 16, rows.begin(), [](double x) { return float(x); });
    return rows;
}

render::ExrCamera exrCamera(const FrameRequest& frame)
{
    const render::View view = render::makeView(frame.camera, {frame.raster.size});
    glm::dmat4 leftHanded(1), fromClip(0.5);
    leftHanded[2][2] = -1;
    fromClip[1][1] = -0.5;
    fromClip[3] = {0.5, 0.5, 0, 1};
    fromClip[2] = {0, 0, 1, 0};
    return {rowVectorMatrix(leftHanded * view.viewFromWorld), rowVectorMatrix(fromClip * view.clipFromWorld)};
}

void addCryptomatte(const Museum& museum, render::PictureMetadata& metadata)
{
    render::Json manifest = render::Json::object();
    const auto add = [&](std::size_t i) {
        const std::string name(museum.subject(i).name());
        manifest[name] = hexadecimal(std::bit_cast<std::uint32_t>(cryptomatteId(name)));
    };
    for (std::size_t i = 0; i < museum.subjects().size(); ++i) add(i);
    const std::string key = "cryptomatte/" + hexadecimal(murmurHash3(cryptomatteLayer)).substr(0, 7) + '/';
    metadata.texts.emplace_back(key + "name", cryptomatteLayer);
    metadata.texts.emplace_back(key + "hash", "MurmurHash3_32");
    metadata.texts.emplace_back(key + "conversion", "uint32_to_float32");
    metadata.texts.emplace_back(key + "manifest", manifest.dump());
}

}  // namespace

float cryptomatteId(std::string_view name)
{
    const std::uint32_t hash = murmurHash3(name);
    const std::uint32_t exponent = std::clamp(hash >> 23U & 255U, 1U, 254U);
    return std::bit_cast<float>((hash & 0x807fffffU) | exponent << 23U);
}

render::PictureMetadata exrMetadata(const Museum& museum, const PictureRequest& request)
{
    render::PictureMetadata metadata;
    metadata.camera = exrCamera(request.frame);
    const auto say = [&](bool isThere, const char* channel, const char* meaning) {
        if (isThere) metadata.texts.emplace_back(std::string("vitrine:") + channel, meaning);
    };
    const Channels& channels = request.frame.channels;
    say(true, "world",
        request.frame.alone ? "right-handed, y up, meters, origin of the exhibit"
                            : "right-handed, y up, meters, origin of the hall");
    say(request.depth, "depth.Z",
        "meters along the view axis from the eye to the surface at the pixel's center; infinity where there is none");
    say(channels.normal, "normal", "unit vector in world space at the pixel's center");
    say(channels.evaluations, "evaluations", "number of evaluations of the distance field for the pixel's center");
    say(channels.albedo, "albedo",
        "base color of the surface at the pixel's center before any light, linear with the primaries of Rec. 709; 0 "
        "for volumes, pictures on screens, views into worlds of light, and where there is no surface");
    say(request.position, "position", "meters in world space at the pixel's center; 0 where there is no surface");
    if (request.before)
        metadata.texts.emplace_back(
            "vitrine:backward",
            "pixels, u to the right and v up, from the pixel's center to where its surface was in the frame " +
                render::shortestNumber(request.before->seconds) +
                " s before; the motion since then is its negative. Of the camera alone: surfaces are taken to stand "
                "still, so it does not hold for what moves by itself; 0 where the surface was behind the camera");
    if (request.objects) addCryptomatte(museum, metadata);
    return metadata;
}

}  // namespace vitrine
