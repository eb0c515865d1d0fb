#include "ui/presets/look_text.h"

#include "exhibits/framework/preset.h"

#include <algorithm>

namespace vitrine::ui {
namespace {

std::size_t chosenIn(const Gallery& gallery, const Look& look, const std::string& name)
{
    for (std::size_t i = 0; i < gallery.subjects().size(); ++i)
        if (gallery.subjects()[i]->name() == name) return i;
    try {
        FrameRequest request;
        request.camera = look.camera;
        const std::optional<Pointed> middle = gallery.pick(look, request, {0, 0});
        return middle ? middle->exhibit : hallIndex;
    } catch (const std::exception&) {
        return hallIndex;  // A file that cannot be read is told of where it is drawn.
    }
}

}  // namespace

std::string textOf(const Gallery& gallery, const Look& look, std::size_t chosen, const std::string& name)
{
    Exhibition everything;
    everything.name = name;
    everything.chosen = std::string(gallery.subjects()[chosen]->name());
    everything.camera = look.camera;
    everything.values = namedValues(gallery.subjects(), look.values);
    return exhibitionText(everything);
}

Look lookFrom(const Gallery& gallery, std::string text, std::string fileName, std::vector<std::string>& notes,
              std::size_t* chosen)
{
    Look look = gallery.initialLook();
    const NamedValues initial = namedValues(gallery.subjects(), look.values);
    Exhibition read = parseExhibition(std::move(text), std::move(fileName), initial);
    for (auto& [name, values] : read.values) {
        const auto at =
            std::find_if(initial.begin(), initial.end(), [&](const auto& entry) { return entry.first == name; });
        if (at != initial.end()) look.values[static_cast<std::size_t>(at - initial.begin())] = std::move(values);
    }
    look.camera = read.camera;
    notes.insert(notes.end(), read.notes.begin(), read.notes.end());
    if (chosen) *chosen = chosenIn(gallery, look, read.chosen);
    return look;
}

}  // namespace vitrine::ui
