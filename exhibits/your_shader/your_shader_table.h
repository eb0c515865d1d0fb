#pragma once

#include "exhibits/framework/scene/shows_pictures.h"
#include "exhibits/framework/table/parameters.h"
#include "exhibits/framework/table/studied_parameters.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::guest {

struct Input;
struct Shader;
struct Work;

enum class ShaderChange : int { goesOn, recomputes };

/// Parameters of the exhibit with a visitor's shader. The inputs of the shader are appended. Six parameters are
/// essential: the file, then inputs in their order, then others that a shader without so many inputs may read.
struct YourShaderTable final : Parameters {
    /// Makes the parameters without a shader's inputs.
    YourShaderTable() : YourShaderTable(0) {}
    /// Makes the parameters for a work, which must not be null. `sources`: pictures that its inputs may show.
    explicit YourShaderTable(std::shared_ptr<const Work>, std::vector<PictureSource> sources = {});
    /// Makes the parameters for a shader that is not translated yet.
    explicit YourShaderTable(const Shader&);

    /// Returns the name of the source whose picture an input shows; empty: it shows a file, or is no picture.
    [[nodiscard]] std::string sourceOf(std::size_t input, const ParameterValues&) const;

private:
    static constexpr std::size_t mostEssential = 6;
    const std::size_t ofAllInputs_;  ///< Number of the parameters of all inputs; the members below need it.

    /// Says whether a parameter of every shader is essential; `number`: its rank among them, from 1.
    [[nodiscard]] Essential essentialAt(std::size_t number) const
    {
        return essential(number == 1 || number + ofAllInputs_ <= mostEssential);
    }

public:
    /// File of the assets that is shown first.
    static constexpr std::string_view firstShader = "gyroid.frag";

    Group show = group("Display");
    File file = this->Parameters::file(
        "file",
        "Path of a shader: ISF (.fs), Shadertoy code or its JSON, or a plain fragment shader. "
        "Its inputs become sliders.",
        extensions("fs frag glsl json txt"), addsParameters(), inAssetFolder("shaders", firstShader), essentialAt(1));
    File document = this->Parameters::document(
        "document", file,
        "The edited shader with all changes that are not in its file yet. Resetting it discards them.");
    File draft = this->Parameters::document(
        "draft", file,
        "The text in the editor while it has errors: the last good shader is shown. Resetting it discards "
        "the text.");
    Toggle animate =
        toggle("animate", false, "Whether time runs; it shows only in shaders that read the time.", essentialAt(2));
    Real moment = real("moment", 0, second, Range{-1e6, 1e6}.soft(0, 60),
                       "Time that is shown, or at which the animation starts.", essentialAt(3));
    Real mouseX =
        real("mouseX", 0.5, none, {0, 1},
             "Position of the mouse for shaders that read it: 0 is the left edge of the picture, 1 the right.",
             essentialAt(4));
    Real mouseY =
        real("mouseY", 0.5, none, {0, 1},
             "Position of the mouse for shaders that read it: 0 is the lower edge of the picture, 1 the upper.",
             essentialAt(5));
    Toggle mouseDown = toggle("mouseDown", false, "Whether the button of the mouse is held, for Shadertoy's iMouse.");

    Real pressX = real("pressX", -1, none, {-1, 1},
                       "Position at which the button of the mouse was pressed last, for Shadertoy's iMouse: 0 is the "
                       "left edge of the picture, 1 the right.",
                       reads(-1, "never"));
    Real pressY = real("pressY", -1, none, {-1, 1},
                       "Position at which the button of the mouse was pressed last, for Shadertoy's iMouse: 0 is the "
                       "lower edge of the picture, 1 the upper.",
                       reads(-1, "never"));
    Text keys =
        text("keys", "Keys that are pressed, for shaders that read the keyboard: code@from-to in seconds, separated by "
                     "blanks. 65@1-2.5 holds the key A for 1.5 s; codes are those of browsers.");

    Group steps = group("Steps");
    Real rate = real("rate", 60, hertz, {1, 240},
                     "Number of steps per second of shaders that continue from their last picture; frame counters "
                     "advance at this rate, too.");
    Choice<ShaderChange> afterChange =
        choice("afterChange", ShaderChange::goesOn, {"continue", "recompute"},
               "Behavior of persistent buffers when an input changes: the shader continues from their content, or "
               "begins again. Pictures for files always begin again.");

    Count restarts = count("restarts", 0, {0, 1000},
                           "Counter of restarts: any change empties all buffers, and the steps begin again.");
    Toggle markInvalid =
        toggle("markInvalid", false,
               "Marks pixels in magenta at which the picture or a kept float buffer contains infinity or "
               "NaN.");

    Group accuracy = group("Accuracy");
    Count loopRounds = count("loopRounds", 65536, {16, 262144, logarithmic},
                             "Largest number of loop iterations per pixel, in all loops together: low cuts long loops "
                             "off, high lets them end.",
                             quality(262144), essentialAt(6));
    Count screenWidth =
        count("screenWidth", 960, {64, 4096, logarithmic}, "Width of the picture in its frame in the hall, in pixels.");
    Count pictureSide = count("pictureSide", 512, {16, 2048, logarithmic},
                              "Largest width and height of a picture of the hall or of another exhibit that an input "
                              "shows, in pixels: low is fast and coarse. It is drawn with one sample per pixel.",
                              labeled("Shown picture, side"));
    StudiedParameters studied{*this, {{.name = "loopRounds", .settles = "The loops of the shader end earlier."}}};

    const std::shared_ptr<const Work> work;  ///< Null before the shader is translated.
    /// Parameters of each input, in the order of its components; empty for inputs without any. Those of a picture are
    /// its file and, if there are other sources, the choice between file and sources.
    std::vector<std::vector<std::size_t>> ofInputs;

private:
    explicit YourShaderTable(std::size_t ofAllInputs) : ofAllInputs_(ofAllInputs) {}
    /// Returns how many parameters the inputs of a shader get.
    [[nodiscard]] static std::size_t countOf(const Shader&, const std::vector<PictureSource>&);
    /// Says whether the next parameter of an input is essential.
    [[nodiscard]] Essential nextOfInputs() { return essential(++shownOfInputs_ < mostEssential); }
    void addInputs(const Shader&);
    std::vector<std::size_t> addInput(const Input&);
    std::vector<std::size_t> addPicture(const std::string& name, const std::string& label);
    std::vector<std::size_t> addNumbers(const Input&, const std::string& name, std::string_view label);

    std::vector<PictureSource> sources_;
    std::size_t shownOfInputs_ = 0;
};

}  // namespace vitrine::guest
