#pragma once

#include <OpenImageIO/imageio.h>

namespace vitrine::render {

/// Lifts OpenImageIO's limit on a picture's size while it exists, to read a file row by row. A decode that runs at the
/// same time is still limited by `whyTooLarge`, before it allocates memory.
class Unlimited {
public:
    Unlimited() { OIIO::attribute("limits:imagesize_MB", 0); }
    ~Unlimited() { OIIO::attribute("limits:imagesize_MB", 2048); }
    Unlimited(const Unlimited&) = delete;
    Unlimited& operator=(const Unlimited&) = delete;
};

}  // namespace vitrine::render
