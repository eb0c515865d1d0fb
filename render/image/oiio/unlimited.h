#pragma once

#include <OpenImageIO/imageio.h>

namespace vitrine::render {

/// Lifts OpenImageIO's limit on a picture's size, to look into a file row by row. A decode that runs meanwhile is
/// still held by `whyTooLarge`, before it takes memory.
class Unlimited {
public:
    Unlimited() { OIIO::attribute("limits:imagesize_MB", 0); }
    ~Unlimited() { OIIO::attribute("limits:imagesize_MB", 2048); }
    Unlimited(const Unlimited&) = delete;
    Unlimited& operator=(const Unlimited&) = delete;
};

}  // namespace vitrine::render
