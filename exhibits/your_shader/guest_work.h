#pragma once

#include "exhibits/framework/scene/shows_pictures.h"
#include "exhibits/your_shader/guest_shader.h"
#include "exhibits/your_shader/shader_check.h"
#include "render/files/asset_store.h"
#include "render/glsl/shader_key.h"
#include "render/text/message.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::guest {

struct YourShaderTable;

/// Image that passes of a work draw into.
struct Target {
    std::string name;  ///< As the shader calls it; "picture" if it has no name.
    bool isFloat = false;
    bool isPersistent = false;  ///< The shader says that its content stays until the next step.
    bool isKept = false;        ///< A step reads what the step before drew into it.
    bool isRead = false;        ///< A pass of the shader reads it.
    bool repeats = false, isNearest = false, hasLevels = false;
    bool isCube = false;
    std::string width, height;  ///< Size expressions (`passSize`).
};

/// Picture that a pass reads.
struct PassPicture {
    enum class From : std::uint8_t {
        thisStep,     ///< Target drawn in the same step.
        stepBefore,   ///< Target of the step before.
        input,        ///< The visitor's choice.
        file,         ///< `Work::files`.
        keyboard,     ///< Keys that the parameter `keys` names.
        environment,  ///< Built-in cube map (`environmentImage`).
        grayNoise,    ///< Built-in volume (`noiseImage`).
        colorNoise,
        waveform,  ///< Sound of an input.
        spectrum,  ///< Frequencies of the sound of an input.
        nothing    ///< Black.
    };
    int unit = 0;
    From from = From::nothing;
    std::size_t index = 0;  ///< Index of the target, input or file.

    /// Returns whether it is a target of the work.
    [[nodiscard]] bool isTarget() const { return from == From::thisStep || from == From::stepBefore; }
};

/// Names of the generated shaders in `WorkPass::sources`.
inline constexpr const char* generatedVertex = "your_shader/vertex shader";
inline constexpr const char* generatedFragment = "your_shader/fragment shader";

/// One drawing of a work.
struct WorkPass {
    std::shared_ptr<const render::ShaderSources> sources;
    std::size_t target = 0;
    std::vector<PassPicture> pictures;  ///< Only those that the program reads.
};

/// A visitor's shader that can be drawn.
struct Work {
    std::shared_ptr<const Shader> shader;
    std::filesystem::path path;
    std::vector<WorkPass> passes;
    std::vector<Target> targets;
    std::vector<std::filesystem::path> files;  ///< Pictures that the shader names: imports and channels.
    std::vector<std::string> beside;           ///< Further files that it was read from.
    bool readsTime = false;                    ///< Time, frame number or date, an event, or the keyboard.
    bool readsMouse = false;                   ///< Position or button of the mouse.
    bool readsKeys = false;
    bool isKept = false;   ///< A step depends on the step before.
    std::uint64_t id = 0;  ///< Hash of its programs.

    /// Returns whether a pass reads the picture of this input.
    [[nodiscard]] bool readsPicture(std::size_t input) const;
};

/// Makes the work of a shader that was checked without errors. Returns null and adds to `errors` if it reads something
/// that is not drawn yet.
[[nodiscard]] std::shared_ptr<const Work> makeWork(const CheckedShader&, const std::filesystem::path&,
                                                   std::vector<Finding>& errors);

/// Result of reading a file: a table with the work, or the reason why there is none.
struct WorkReading {
    std::shared_ptr<const YourShaderTable> table;
    Message why;                    ///< "own.fs:3:12: ..."; empty on success.
    std::vector<Finding> findings;  ///< Errors, or remarks about a shader that is shown.
    /// Files that were read, with their states then.
    std::vector<std::pair<std::filesystem::path, render::FileState>> files;
};

/// Reads and translates the file at `path`, or `text` in its place if that is not empty. Returns the same object until
/// one of its files changes. `sources`: pictures that its inputs may show. Thread-safe.
[[nodiscard]] std::shared_ptr<const WorkReading> readWork(const std::filesystem::path& path, render::AssetStore&,
                                                          const std::string& text = {},
                                                          const std::vector<PictureSource>& sources = {});

}  // namespace vitrine::guest
