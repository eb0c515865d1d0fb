#pragma once

#include "exhibits/sdf_scenes/scene.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::scenes {

/// Origin of a part of converted text: the value at `path`, and everything inside it, was made from `original`.
struct MadeFrom {
    std::string path;
    std::uint32_t original = 0;
    bool shape = false;  ///< The value is a shape; the rest can be drawn without it.
};

/// Errors found while a scene is read, in order, up to a limit.
class Findings {
public:
    explicit Findings(std::size_t most) : most_(most) {}

    /// Adds an error about a value of a text; `sentence` is without its full stop.
    void add(const render::JsonText&, std::uint32_t value, const std::string& sentence);
    void add(const render::JsonFailure&);
    /// Adds an error about a shape of a converted text; the rest can be drawn without it.
    void addOfShape(const render::JsonText&, std::uint32_t value, const std::string& sentence);
    /// From here on, errors about values of `made` are reported at the values of `original` that they were made from.
    void translate(const render::JsonText& made, const render::JsonText& original, std::vector<MadeFrom> parts);

    [[nodiscard]] bool empty() const { return list_.empty(); }
    [[nodiscard]] bool full() const { return list_.size() >= most_; }
    [[nodiscard]] std::size_t count() const { return list_.size(); }
    [[nodiscard]] std::vector<Finding> take() { return std::move(list_); }
    /// Returns the shapes that all errors are about, as values of the converted text. Returns nothing if any error is
    /// about something else.
    [[nodiscard]] std::vector<std::uint32_t> shapes() const;

private:
    std::size_t most_;
    std::vector<Finding> list_;
    std::vector<std::uint32_t> shapes_;  ///< Shapes of the errors about shapes.
    const render::JsonText* made_ = nullptr;
    const render::JsonText* original_ = nullptr;
    std::vector<MadeFrom> parts_;
};

/// Returns for example "unknown key of a sphere: \"raduis\"; did you mean \"radius\"? Known are radius and material.".
[[nodiscard]] std::string unknownWord(std::string_view word, const std::string& of,
                                      const std::vector<std::string>& known);

/// Formats a number for a sentence: exactly if that is short, else with three digits.
[[nodiscard]] std::string sentenceNumber(double);

/// Joins words by commas, with "and" before the last one; of many, the first twelve.
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

}  // namespace vitrine::scenes
