#include "render/scene/gltf_animation.h"

#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/scene/gltf_accessor.h"
#include "render/scene/gltf_convert.h"
#include "render/scene/gltf_pose.h"
#include "render/scene/gltf_schema.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace vitrine::render {
namespace keys {

enum class Between : std::uint8_t { step, linear, cubic };
enum class Path : std::uint8_t { translation, rotation, scale, weights };

/// Key frames of one property of one node.
struct Channel {
    std::size_t node = 0;
    Path path = Path::translation;
    Between between = Between::linear;
    std::size_t width = 0;  ///< Number of floats per value.
    std::vector<float> times, values;

    [[nodiscard]] const float* value(std::size_t key, int part) const
    {
        const bool cubic = between == Between::cubic;
        return values.data() + (cubic ? 3 * key + static_cast<std::size_t>(part) : key) * width;
    }
    [[nodiscard]] std::vector<double> at(double seconds) const;
};

std::vector<double> slerped(const float* a, const float* b, double t)
{
    const glm::dquat from(a[3], a[0], a[1], a[2]), to(b[3], b[0], b[1], b[2]);
    const glm::dquat q = glm::slerp(from, to, t);
    return {q.x, q.y, q.z, q.w};
}

std::vector<double> Channel::at(double seconds) const
{
    const std::size_t last = times.size() - 1;
    const auto whole = [&](std::size_t key) {
        const float* v = value(key, 1);
        if (between != Between::cubic) v = value(key, 0);
        return std::vector<double>(v, v + width);
    };
    if (!(seconds > times.front())) return whole(0);
    if (seconds >= times[last]) return whole(last);
    const auto next = static_cast<std::size_t>(
        std::upper_bound(times.begin(), times.end(), static_cast<float>(seconds)) - times.begin());
    const std::size_t k = next - 1;
    const double span = static_cast<double>(times[next]) - static_cast<double>(times[k]);
    const double t = span > 0 ? std::clamp((seconds - static_cast<double>(times[k])) / span, 0.0, 1.0) : 0;
    if (between == Between::step) return whole(k);
    if (between == Between::linear && path == Path::rotation) return slerped(value(k, 0), value(next, 0), t);
    std::vector<double> out(width);
    for (std::size_t i = 0; i < width; ++i) {
        if (between == Between::linear) {
            out[i] = static_cast<double>(value(k, 0)[i]) * (1 - t) + static_cast<double>(value(next, 0)[i]) * t;
            continue;
        }
        const double p0 = static_cast<double>(value(k, 1)[i]), p1 = static_cast<double>(value(next, 1)[i]);
        const double m0 = span * static_cast<double>(value(k, 2)[i]),
                     m1 = span * static_cast<double>(value(next, 0)[i]);
        const double t2 = t * t, t3 = t2 * t;
        out[i] = (2 * t3 - 3 * t2 + 1) * p0 + (t3 - 2 * t2 + t) * m0 + (3 * t2 - 2 * t3) * p1 + (t3 - t2) * m1;
    }
    return out;
}

struct Skin {
    std::vector<std::size_t> joints;
    std::vector<glm::dmat4> meshFromJointRest;  ///< Inverse bind matrices.
};

}  // namespace keys

namespace {

using namespace keys;

/// Reads references to nodes and accessors from parts of the JSON that were not validated before.
class Reader {
public:
    Reader(const JsonDocument& document, const tinygltf::Model& gltf) : document_(document), gltf_(gltf) {}

    [[nodiscard]] std::size_t index(const Json& object, const char* key, std::size_t size,
                                    const std::string& path) const
    {
        const std::optional<std::size_t> found = optionalIndex(object, key, size, path);
        if (!found) throw document_.failure(path, message("\"{1}\" is missing; export the file again.", key));
        return *found;
    }
    [[nodiscard]] std::optional<std::size_t> optionalIndex(const Json& object, const char* key, std::size_t size,
                                                           const std::string& path) const
    {
        if (!object.is_object())
            throw document_.failure(path, message("this must be an object; export the file again."));
        const auto at = object.find(key);
        if (at == object.end()) return std::nullopt;
        if (!at->is_number_unsigned() || at->get<std::uint64_t>() >= size)
            throw document_.failure(path + "." + key, message("this names nothing; export the file again."));
        return static_cast<std::size_t>(at->get<std::uint64_t>());
    }
    [[nodiscard]] const Json& array(const Json& object, const char* key, const std::string& path) const
    {
        const auto at = object.is_object() ? object.find(key) : object.end();
        if (!object.is_object() || at == object.end() || !at->is_array())
            throw document_.failure(path, message("\"{1}\" must be an array; export the file again.", key));
        return *at;
    }
    /// Returns a top-level array; empty if it is missing.
    [[nodiscard]] const Json& rootArray(const char* key) const
    {
        const Json& found = arrayAt(document_, key);
        if (!found.is_array()) throw document_.failure(key, message("this must be an array; export the file again."));
        return found;
    }
    [[nodiscard]] std::vector<float> floats(std::size_t accessor, const std::string& path) const
    {
        std::vector<float> values = readFloats(gltf_, static_cast<int>(accessor));
        if (!std::all_of(values.begin(), values.end(), [](float x) { return std::isfinite(x); }))
            throw document_.failure(path, message("one of its values is not a finite number; export the file again."));
        return values;
    }
    [[nodiscard]] const JsonDocument& document() const { return document_; }
    [[nodiscard]] const tinygltf::Model& gltf() const { return gltf_; }

private:
    const JsonDocument& document_;
    const tinygltf::Model& gltf_;
};

std::optional<Path> pathOf(const Json& target)
{
    const auto at = target.find("path");
    if (at == target.end() || !at->is_string()) return std::nullopt;
    const std::string name = at->get<std::string>();
    if (name == "translation") return Path::translation;
    if (name == "rotation") return Path::rotation;
    if (name == "scale") return Path::scale;
    if (name == "weights") return Path::weights;
    return std::nullopt;
}

std::optional<Channel> readChannel(const Reader& reader, const Json& animation, const Json& json,
                                   const std::string& path)
{
    const Json& samplers = reader.array(animation, "samplers", path);
    const Json& sampler = samplers[reader.index(json, "sampler", samplers.size(), path)];
    const auto target = json.find("target");
    if (target == json.end() || !target->is_object()) return std::nullopt;
    const auto node = reader.optionalIndex(*target, "node", reader.gltf().nodes.size(), path + ".target");
    const auto what = pathOf(*target);
    if (!node || !what) return std::nullopt;
    Channel channel;
    channel.node = *node;
    channel.path = *what;
    const std::size_t accessors = reader.gltf().accessors.size();
    channel.times = reader.floats(reader.index(sampler, "input", accessors, path), path);
    channel.values = reader.floats(reader.index(sampler, "output", accessors, path), path);
    const auto between = sampler.find("interpolation");
    if (between != sampler.end() && *between == "STEP") channel.between = Between::step;
    if (between != sampler.end() && *between == "CUBICSPLINE") channel.between = Between::cubic;
    const std::size_t keys = channel.times.size() * (channel.between == Between::cubic ? 3 : 1);
    const std::size_t wanted = *what == Path::rotation ? 4 : *what == Path::weights ? 0 : 3;
    if (keys == 0 || channel.values.size() % keys != 0 || (wanted > 0 && channel.values.size() != keys * wanted))
        throw reader.document().failure(path, message("its keys and values do not agree; export the file again."));
    if (!std::is_sorted(channel.times.begin(), channel.times.end()))
        throw reader.document().failure(path, message("its times do not rise; export the file again."));
    channel.width = channel.values.size() / keys;
    return channel;
}

Skin readSkin(const Reader& reader, const Json& json, const std::string& path)
{
    Skin skin;
    for (const Json& joint : reader.array(json, "joints", path)) {
        if (!joint.is_number_unsigned() || joint.get<std::uint64_t>() >= reader.gltf().nodes.size())
            throw reader.document().failure(path + ".joints",
                                            message("one of them names no node; export the file again."));
        skin.joints.push_back(static_cast<std::size_t>(joint.get<std::uint64_t>()));
    }
    skin.meshFromJointRest.assign(skin.joints.size(), glm::dmat4(1));
    if (const auto at = reader.optionalIndex(json, "inverseBindMatrices", reader.gltf().accessors.size(), path)) {
        const std::vector<float> values = reader.floats(*at, path);
        if (values.size() < 16 * skin.joints.size())
            throw reader.document().failure(path + ".inverseBindMatrices",
                                            message("there are too few; export the file again."));
        for (std::size_t i = 0; i < skin.joints.size(); ++i)
            skin.meshFromJointRest[i] = glm::dmat4(glm::make_mat4(values.data() + 16 * i));
    }
    return skin;
}

std::vector<double> numbersOf(const Json& json)
{
    std::vector<double> numbers;
    if (!json.is_array()) return numbers;
    for (const Json& x : json)
        if (x.is_number()) numbers.push_back(x.get<double>());
    return numbers;
}

void setPath(tinygltf::Node& node, Path path, const std::vector<double>& value)
{
    node.matrix.clear();
    if (path == Path::translation) node.translation = value;
    if (path == Path::rotation) node.rotation = value;
    if (path == Path::scale) node.scale = value;
}

}  // namespace

struct AnimatedModel::Parts {
    explicit Parts(GltfFile read) : file(std::move(read)) {}

    GltfFile file;
    GltfLimits limits;
    std::vector<Animation> animations;
    std::vector<std::vector<Channel>> channels;  ///< Channels of each animation.
    std::vector<Skin> skins;
    std::vector<int> skinOfNode;
    std::vector<std::vector<double>> weightsOfNode;

    void read();
    [[nodiscard]] std::vector<glm::dmat4> places(const tinygltf::Model&) const;
};

void AnimatedModel::Parts::read()
{
    const Reader reader(file.document, file.gltf);
    const Json& skinsJson = reader.rootArray("skins");
    for (std::size_t i = 0; i < skinsJson.size(); ++i)
        skins.push_back(readSkin(reader, skinsJson[i], "skins[" + std::to_string(i) + "]"));
    const Json& nodes = arrayAt(file.document, "nodes");
    const Json& meshes = arrayAt(file.document, "meshes");
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto skin = reader.optionalIndex(nodes[i], "skin", skins.size(), elementPath("nodes", i, ""));
        skinOfNode.push_back(skin ? static_cast<int>(*skin) : -1);
        const int mesh = file.gltf.nodes[i].mesh;
        weightsOfNode.emplace_back();
        if (const auto own = nodes[i].find("weights"); own != nodes[i].end())
            weightsOfNode.back() = numbersOf(*own);
        else if (mesh >= 0 && meshes[static_cast<std::size_t>(mesh)].contains("weights"))
            weightsOfNode.back() = numbersOf(meshes[static_cast<std::size_t>(mesh)]["weights"]);
    }
    const Json& animationsJson = reader.rootArray("animations");
    for (std::size_t i = 0; i < animationsJson.size(); ++i) {
        const std::string path = "animations[" + std::to_string(i) + "]";
        const Json& json = animationsJson[i];
        Animation animation{message("animation {1}", i).english(), 0};
        channels.emplace_back();
        for (const Json& channel : reader.array(json, "channels", path))
            if (auto made = readChannel(reader, json, channel, path)) {
                animation.duration = std::max(animation.duration, static_cast<double>(made->times.back()));
                channels.back().push_back(std::move(*made));
            }
        if (const auto name = json.find("name");
            name != json.end() && name->is_string() && !name->get<std::string>().empty())
            animation.name = name->get<std::string>();
        animations.push_back(std::move(animation));
    }
}

/// Returns the transform of each node to model space.
std::vector<glm::dmat4> AnimatedModel::Parts::places(const tinygltf::Model& gltf) const
{
    std::vector<glm::dmat4> made(gltf.nodes.size(), glm::dmat4(1));
    std::vector<std::pair<std::size_t, glm::dmat4>> open;
    std::vector<bool> isChild(gltf.nodes.size(), false);
    for (const tinygltf::Node& node : gltf.nodes)
        for (const int child : node.children) isChild[static_cast<std::size_t>(child)] = true;
    for (std::size_t i = 0; i < gltf.nodes.size(); ++i)
        if (!isChild[i]) open.emplace_back(i, glm::dmat4(1));
    while (!open.empty()) {
        const auto [node, parent] = open.back();
        open.pop_back();
        made[node] = parent * nodeTransform(gltf.nodes[node]);
        for (const int child : gltf.nodes[node].children)
            open.emplace_back(static_cast<std::size_t>(child), made[node]);
    }
    return made;
}

AnimatedModel AnimatedModel::parse(const std::string& bytes, const std::filesystem::path& path,
                                   const GltfLimits& limits)
{
    auto parts = std::make_shared<Parts>(readGltfFile(bytes, path, limits));
    parts->limits = limits;
    parts->read();
    return AnimatedModel(std::move(parts));
}

AnimatedModel AnimatedModel::load(const std::filesystem::path& path, const GltfLimits& limits)
{
    return parse(readFile(path, limits.fileBytes), path, limits);
}

const std::vector<AnimatedModel::Animation>& AnimatedModel::animations() const
{
    return parts_->animations;
}

Model AnimatedModel::posed(int i, double seconds) const
{
    const Parts& parts = *parts_;
    tinygltf::Model gltf = parts.file.gltf;
    GltfPose pose;
    pose.weightsOfNode = parts.weightsOfNode;
    if (i >= 0 && static_cast<std::size_t>(i) < parts.channels.size())
        for (const Channel& channel : parts.channels[static_cast<std::size_t>(i)]) {
            const std::vector<double> value = channel.at(seconds);
            if (channel.path == Path::weights)
                pose.weightsOfNode[channel.node] = value;
            else
                setPath(gltf.nodes[channel.node], channel.path, value);
        }
    const std::vector<glm::dmat4> places = parts.places(gltf);
    pose.jointsOfNode.resize(gltf.nodes.size());
    for (std::size_t n = 0; n < gltf.nodes.size(); ++n) {
        if (parts.skinOfNode[n] < 0) continue;
        const Skin& skin = parts.skins[static_cast<std::size_t>(parts.skinOfNode[n])];
        for (std::size_t j = 0; j < skin.joints.size(); ++j)
            pose.jointsOfNode[n].push_back(places[skin.joints[j]] * skin.meshFromJointRest[j]);
    }
    Model model = convertGltf(gltf, parts.file.document, parts.limits, {}, &pose);
    model.warnings.insert(model.warnings.end(), parts.file.warnings.begin(), parts.file.warnings.end());
    return model;
}

}  // namespace vitrine::render
