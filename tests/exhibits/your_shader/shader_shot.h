#pragma once

#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "tests/support/gallery.h"
#include "tests/support/made_image.h"
#include "tests/support/temporary_folder.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <string>

namespace vitrine::test {

/// The exhibit alone with a shader of the test.
class ShaderShot {
public:
    ShaderShot()
    {
        shot.request.frame.averageIn = AverageIn::display;
        shot.request.frame.transparent = false;
        shot.size(24, 16);
    }

    /// Writes the file, names it, and returns the problems of reading it.
    std::string show(const std::string& text, const std::string& name = "own.fs")
    {
        writeBytes(folder / name, text);
        set("file", (folder / name).string());
        return read();
    }
    std::string read()
    {
        TabledSceneState tabled = gallery().museum.readTables(shot.sceneState);
        shot.sceneState = std::move(tabled.sceneState);
        std::string why;
        for (const Message& message : tabled.unreadable) why += message.english();
        return why;
    }
    void set(const char* name, const Value& value)
    {
        const auto row = shot.values().table().find(name);
        ASSERT_TRUE(row) << name;
        shot.values().setParameter(*row, value);
    }
    /// Copies the shaders of the folder "shadertoy" with a picture, shows one of them, and returns the problems.
    std::string showOurs(const char* file)
    {
        const std::filesystem::path ours = folder / "shadertoy";
        std::filesystem::copy(VITRINE_SOURCE_DIR "/tests/exhibits/your_shader/shadertoy", ours,
                              std::filesystem::copy_options::skip_existing | std::filesystem::copy_options::recursive);
        const auto redRightGreenBelow = [](int x, int y, int c) {
            return c == 0 ? static_cast<float>(x) : c == 1 ? static_cast<float>(y) : 0;
        };
        render::writePicture(ours / "four.png", made(2, 2, redRightGreenBelow), render::PictureFormat::png8);
        set("file", (ours / file).string());
        return read();
    }
    /// Returns the display value of a pixel, 0 to 255; rows count from the bottom.
    static std::array<int, 3> code(const Picture& picture, int x, int y)
    {
        std::array<int, 3> codes{};
        for (int c = 0; c < 3; ++c)
            codes[static_cast<std::size_t>(c)] = static_cast<int>(
                std::lround(255 * render::srgbFromLinear(picture.image.at(x, picture.height() - 1 - y, c))));
        return codes;
    }
    [[nodiscard]] std::array<int, 3> codeAt(int x, int y) const { return code(shot.take(), x, y); }

    TemporaryFolder folder;
    Shot shot{"your_shader"};
};

}  // namespace vitrine::test
