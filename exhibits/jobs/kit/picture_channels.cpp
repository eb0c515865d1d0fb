#include "exhibits/jobs/kit/picture_channels.h"

#include "render/failure.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <vector>

namespace vitrine::jobs {

PictureRecord channelsNamed(const std::string& text)
{
    PictureRecord named;
    std::istringstream parts(text);
    for (std::string name; std::getline(parts, name, ',');) {
        std::erase(name, ' ');
        if (name == "color") continue;
        bool* channel = channelOf(named, name);
        if (!channel) {
            const std::vector<std::string_view> names = channelNames();
            std::vector<std::string> near = {"color"};
            near.insert(near.end(), names.begin(), names.end());
            throw Failure(ErrorKind::usage, "--channels: \"" + name + "\" is not a channel" + didYouMean(name, near) +
                                                " give color, " + alternatives(names) + ", separated by commas.");
        }
        *channel = true;
    }
    return named;
}

void addChannels(const PictureRecord& named, const std::optional<FrameBefore>& before, PictureRequest& request)
{
    if (named.motion && !before)
        throw Failure(ErrorKind::usage,
                      "--channels: motion is that of a camera between two frames, and this picture has "
                      "no frame before; record frames with the channel motion.");
    request.frame.channels = named.channels;
    request.depth = named.depth;
    request.position = named.position;
    request.objects = named.objects;
    if (named.motion) request.before = before;
}

}  // namespace vitrine::jobs
