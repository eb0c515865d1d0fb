#include "render/image/color_channels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string_view>

namespace vitrine::render {
namespace {

std::string lowered(std::string_view text)
{
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return out;
}

/// A layer with the indices of its channels, by their names in lower case.
struct Layer {
    std::string name;
    std::map<std::string, int> channels;

    [[nodiscard]] int at(const char* first, const char* second) const
    {
        for (const char* channel : {first, second})
            if (const auto found = channels.find(channel); found != channels.end()) return found->second;
        return -1;
    }
    [[nodiscard]] bool isLuminanceChroma() const { return channels.contains("ry") && channels.contains("by"); }
    /// Returns whether its red, green and blue are a color, and not the numbers of Cryptomatte.
    [[nodiscard]] bool hasColors() const
    {
        if (lowered(name.substr(name.rfind('.') + 1)).starts_with("crypto")) return false;
        return at("r", "red") >= 0 && at("g", "green") >= 0 && at("b", "blue") >= 0;
    }
    [[nodiscard]] bool hasGray() const
    {
        return channels.contains("y") && !channels.contains("x") && !channels.contains("z") && !isLuminanceChroma();
    }
    /// Returns the priority: 0 for the main layer, 1 for a finished picture, 2 for others.
    [[nodiscard]] int rank() const
    {
        if (name.empty()) return 0;
        const std::string last = lowered(name.substr(name.rfind('.') + 1));
        constexpr std::array<std::string_view, 6> finished = {"combined", "rgba",      "rgb",
                                                              "beauty",   "composite", "color"};
        return std::find(finished.begin(), finished.end(), last) != finished.end() ? 1 : 2;
    }
};

std::vector<Layer> layersOf(const std::vector<std::string>& names)
{
    std::vector<Layer> layers;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t dot = names[i].rfind('.');
        const std::string layer = dot == std::string::npos ? std::string() : names[i].substr(0, dot);
        const std::string channel = dot == std::string::npos ? names[i] : names[i].substr(dot + 1);
        auto known = std::find_if(layers.begin(), layers.end(), [&](const Layer& l) { return l.name == layer; });
        if (known == layers.end()) known = layers.insert(layers.end(), {layer, {}});
        known->channels.emplace(lowered(channel), static_cast<int>(i));
    }
    return layers;
}

std::string whyNoColor(bool isLuminanceChroma, const std::vector<std::string>& names)
{
    if (isLuminanceChroma)
        return "its colors are stored as luminance and chroma (Y, RY, BY), which is not read; save it with the "
               "channels R, G and B";
    constexpr std::size_t mostNamed = 8;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), mostNamed); ++i) list += (i == 0 ? "" : ", ") + names[i];
    if (names.size() > mostNamed) list += ", and " + std::to_string(names.size() - mostNamed) + " more";
    return "it has no color: there are neither channels R, G and B nor Y, only " + list;
}

}  // namespace

std::vector<int> ColorChannels::numbers() const
{
    std::vector<int> all;
    for (const int number : {gray, red, green, blue, alpha})
        if (number >= 0) all.push_back(number);
    return all;
}

ColorChannels colorChannels(const std::vector<std::string>& names)
{
    const std::vector<Layer> layers = layersOf(names);
    ColorChannels chosen;
    const Layer* best = nullptr;
    const auto isBetter = [](const Layer& a, const Layer& b) {
        if (a.rank() != b.rank()) return a.rank() < b.rank();
        return a.hasColors() && !b.hasColors();
    };
    for (const Layer& layer : layers)
        if ((layer.hasColors() || layer.hasGray()) && (!best || isBetter(layer, *best))) best = &layer;
    if (!best) {
        chosen.isLuminanceChroma =
            std::any_of(layers.begin(), layers.end(), [](const Layer& layer) { return layer.isLuminanceChroma(); });
        chosen.problem = whyNoColor(chosen.isLuminanceChroma, names);
        return chosen;
    }
    for (const Layer& layer : layers)
        if (&layer != best && (layer.hasColors() || layer.hasGray())) chosen.otherLayers.push_back(layer.name);
    chosen.layer = best->name;
    if (best->hasColors()) {
        chosen.red = best->at("r", "red");
        chosen.green = best->at("g", "green");
        chosen.blue = best->at("b", "blue");
    } else {
        chosen.gray = best->at("y", "y");
    }
    chosen.alpha = best->at("a", "alpha");
    return chosen;
}

}  // namespace vitrine::render
