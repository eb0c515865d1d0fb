#pragma once

#include <cmath>
#include <random>
#include <string>

namespace vitrine::test {

/// Returns the root of a scene file: shapes in one smooth union, whose total size does not depend on their number.
inline std::string manyShapes(int count)
{
    std::mt19937 engine(static_cast<unsigned>(count));
    const auto random = [&](double low, double high) { return low + (high - low) * double(engine()) / 4294967296.0; };
    const double size = 0.9 / std::cbrt(count);
    std::string text =
        R"({"kind": "union", "blend": "quadratic", "blendWidth": )" + std::to_string(0.4 * size) + ", \"children\": [";
    for (int i = 0; i < count; ++i) {
        const std::string s = std::to_string(size * random(0.5, 1)), half = std::to_string(0.5 * size);
        const char* kinds[] = {"sphere", "box", "torus", "capsule"};
        text += (i > 0 ? ", {\"kind\": \"" : "{\"kind\": \"") + std::string(kinds[i % 4]) + "\"";
        if (i % 4 == 0) text += ", \"radius\": " + half;
        if (i % 4 == 1) text += ", \"size\": " + s;
        if (i % 4 == 2) text += ", \"majorRadius\": " + half + ", \"minorRadius\": " + std::to_string(0.2 * size);
        if (i % 4 == 3)
            text += ", \"start\": [0, -" + half + ", 0], \"end\": [0, " + half +
                    ", 0], \"radius\": " + std::to_string(0.3 * size);
        // One statement for each: the order within an expression is the compiler's.
        const std::string turnY = std::to_string(random(-90, 90)), turnX = std::to_string(random(-90, 90));
        const std::string z = std::to_string(random(-1, 1)), y = std::to_string(random(-1, 1));
        const std::string x = std::to_string(random(-1, 1));
        text += ", \"translate\": [" + x + ", " + y + ", " + z + "], \"rotate\": [" + turnX + ", " + turnY + ", 0]}";
    }
    return text + "]}";
}

}  // namespace vitrine::test
