#include "ui/look_text.h"

#include "exhibits/framework/preset.h"

#include <algorithm>

namespace vitrine::ui {

std::string textOf(const Gallery& gallery, const Look& look, const std::string& name)
{
    Exhibition everything;
    everything.name = name;
    everything.camera = look.camera;
    everything.values = namedValues(gallery.exhibits(), look.values);
    return exhibitionText(everything);
}

Look lookFrom(const Gallery& gallery, std::string text, std::string fileName, std::vector<std::string>& notes)
{
    Look look = gallery.initialLook();
    const NamedValues initial = namedValues(gallery.exhibits(), look.values);
    Exhibition read = parseExhibition(std::move(text), std::move(fileName), initial);
    for (auto& [name, values] : read.values) {
        const auto at = std::find_if(initial.begin(), initial.end(), [&](const auto& entry) { return entry.first == name; });
        if (at != initial.end()) look.values[static_cast<std::size_t>(at - initial.begin())] = std::move(values);
    }
    look.camera = read.camera;
    notes.insert(notes.end(), read.notes.begin(), read.notes.end());
    return look;
}

}  // namespace vitrine::ui
