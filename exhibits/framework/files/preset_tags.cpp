#include "exhibits/framework/files/preset_tags.h"

#include "exhibits/framework/files/preset.h"

#include <algorithm>

namespace vitrine {
namespace {

using render::Json;
using render::JsonDocument;

std::string lowered(std::string text)
{
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

bool stands(const PresetTags& tags, const std::string& tag)
{
    return std::any_of(tags.begin(), tags.end(), [&](const std::string& t) { return lowered(t) == lowered(tag); });
}

/// Returns why a text is no valid tag; empty if it is valid.
Message whyNoTag(const std::string& tag)
{
    if (tag.empty()) return message("a tag has at least one character");
    if (tag.size() > mostPresetTagBytes) return message("a tag has at most {1} bytes", mostPresetTagBytes);
    if (tag.front() == ' ' || tag.back() == ' ') return message("a tag neither begins nor ends with a blank");
    for (const char c : tag)
        if (c == ',' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            return message("a tag has neither commas nor control characters");
    return {};
}

}  // namespace

PresetTags tagsIn(const JsonDocument& document, const Json& root)
{
    PresetTags tags;
    if (!root.contains("tags")) return tags;
    const Json& written = root["tags"];
    if (!written.is_array())
        throw document.failure("tags", message("this must be an array of texts; correct it there."));
    if (written.size() > mostPresetTags)
        throw document.failure("tags", message("these are more than {1} tags; take some away.", mostPresetTags));
    for (std::size_t i = 0; i < written.size(); ++i) {
        const std::string path = "tags[" + std::to_string(i) + ']';
        if (!written[i].is_string()) throw document.failure(path, message("this must be text; correct it there."));
        std::string tag = written[i].get<std::string>();
        if (const Message why = whyNoTag(tag); !why.empty())
            throw document.failure(path, message("{1}; correct it there.", why));
        if (stands(tags, tag)) throw document.failure(path, message("\"{1}\" appears twice; remove one of them.", tag));
        tags.push_back(std::move(tag));
    }
    return tags;
}

PresetTags tagsFromText(std::string_view text)
{
    PresetTags tags;
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        std::string_view part = text.substr(0, comma);
        text.remove_prefix(std::min(comma + 1, text.size()));
        while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
        while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
        std::string tag(part);
        if (tag.empty() || stands(tags, tag)) continue;
        if (const Message why = whyNoTag(tag); !why.empty())
            throw Failure(ErrorKind::usage, message("\"{1}\" was not taken: {2}.", tag, why));
        tags.push_back(std::move(tag));
    }
    if (tags.size() > mostPresetTags)
        throw Failure(ErrorKind::usage,
                      message("A preset has at most {1} tags; these are {2}.", mostPresetTags, tags.size()));
    return tags;
}

std::string taggedPreset(const JsonDocument& document, const PresetTags& tags)
{
    (void)presetHeader(document);
    Json written = Json::array();
    for (const std::string& tag : tags) written.push_back(tag);
    // The tags are inserted after the name, as in other presets.
    Json root = Json::object();
    for (const auto& [key, value] : document.root().items()) {
        if (key == "tags") continue;
        root[key] = value;
        if (key == "name" && !tags.empty()) root["tags"] = written;
    }
    if (!tags.empty() && !root.contains("tags")) root["tags"] = written;
    return render::writeJson(root);
}

}  // namespace vitrine
