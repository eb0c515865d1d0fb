#pragma once

#include "render/image/image.h"

#include <functional>

namespace vitrine::test {

/// Makes an image of three channels from the values of a function.
inline render::Image made(int width, int height, const std::function<float(int x, int y, int c)>& value)
{
    render::Image image(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) image.at(x, y, c) = value(x, y, c);
    return image;
}

}  // namespace vitrine::test
