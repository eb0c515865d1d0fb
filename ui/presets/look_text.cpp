#include "ui/presets/look_text.h"

#include "exhibits/framework/preset.h"

#include <algorithm>

namespace vitrine::ui {
namespace {

std::size_t chosenIn(const Museum& museum, const Look& look, const std::string& name)
{
    if (const auto found = museum.find(name)) return *found;
    FrameRequest request;
    request.camera = look.camera;
    const std::optional<Pointed> middle = museum.pick(museum.prepare(look, request), request, {0, 0});
    return middle ? middle->exhibit : hallIndex;
}

}  // namespace

std::string textOf(const Museum& museum, const Look& look, std::size_t chosen, const std::string& name)
{
    Exhibition everything;
    everything.name = name;
    everything.chosen = std::string(museum.subject(chosen).name());
    everything.camera = look.camera;
    everything.values = namedValues(museum.subjects(), look.values);
    return exhibitionText(everything);
}

Look lookFrom(const Museum& museum, std::string text, std::string fileName, std::vector<std::string>& notes,
              std::size_t* chosen)
{
    Look look = museum.initialLook();
    const NamedValues initial = namedValues(museum.subjects(), look.values);
    Exhibition read = parseExhibition(std::move(text), std::move(fileName), initial);
    for (auto& [name, values] : read.values) {
        const auto at =
            std::find_if(initial.begin(), initial.end(), [&](const auto& entry) { return entry.first == name; });
        if (at != initial.end()) look.values[static_cast<std::size_t>(at - initial.begin())] = std::move(values);
    }
    look.camera = read.camera;
    notes.insert(notes.end(), read.notes.begin(), read.notes.end());
    if (chosen) *chosen = chosenIn(museum, look, read.chosen);
    return look;
}

}  // namespace vitrine::ui
