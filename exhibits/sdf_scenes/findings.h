#pragma once

#include "exhibits/sdf_scenes/scene.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::scenes {

/// Where parts of a text that was made from another one come from: the value at `path` and all in it from `original`.
struct MadeFrom {
    std::string path;
    std::uint32_t original = 0;
    bool shape = false;  ///< A shape, without which the rest can be drawn.
};

/// What is found wrong while a scene is read, in its order, up to a limit.
class Findings {
public:
    explicit Findings(std::size_t most) : most_(most) {}

    /// About a value of a text; `sentence` without its full stop.
    void add(const render::JsonText&, std::uint32_t value, const std::string& sentence);
    void add(const render::JsonFailure&, const std::string& file);
    /// About a shape of a text that is converted, without which the rest can be drawn.
    void addOfShape(const render::JsonText&, std::uint32_t value, const std::string& sentence);
    /// From here on, values of `made` are shown at those of `original` that they were made from.
    void translate(const render::JsonText& made, const render::JsonText& original, std::vector<MadeFrom> parts);

    [[nodiscard]] bool empty() const { return list_.empty(); }
    [[nodiscard]] bool full() const { return list_.size() >= most_; }
    [[nodiscard]] std::size_t count() const { return list_.size(); }
    [[nodiscard]] std::vector<Finding> take() { return std::move(list_); }
    /// The shapes that they are about, values of the text that was converted; nothing where any is about something
    /// else.
    [[nodiscard]] std::vector<std::uint32_t> shapes() const;

private:
    std::size_t most_;
    std::vector<Finding> list_;
    std::vector<std::uint32_t> shapes_;  ///< Of the findings that are about one.
    const render::JsonText* made_ = nullptr;
    const render::JsonText* original_ = nullptr;
    std::vector<MadeFrom> parts_;
};

/// "\"raduis\" is no key of a sphere; did you mean \"radius\"? There are radius, material, ...".
[[nodiscard]] std::string unknownWord(std::string_view word, const std::string& of,
                                      const std::vector<std::string>& known);

/// A number for a sentence: as it is where that is short, else three digits of it.
[[nodiscard]] std::string sentenceNumber(double);

/// Words with commas between them, the last one behind "and"; of many the first twelve.
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

}  // namespace vitrine::scenes
