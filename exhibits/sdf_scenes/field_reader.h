#pragma once

#include "exhibits/sdf_scenes/findings.h"

#include <string_view>
#include <vector>

namespace vitrine::scenes {

/// Reads the numbers of nodes and records into a scene.
class FieldReader {
public:
    /// Both must outlive it.
    FieldReader(Scene& scene, Findings& findings) : scene_(scene), findings_(findings) {}

    /// All fields of an object, initial where it has none; the first of their numbers. Keys that are neither fields nor
    /// in `others` are found wrong; `what` names the object there: "a sphere".
    std::uint32_t readObject(std::uint32_t file, std::uint32_t object, const std::vector<Field>& fields,
                             const std::vector<std::string_view>& others, const std::string& what);
    /// One field; the first of its numbers.
    std::uint32_t readField(std::uint32_t file, std::uint32_t value, const Field&);
    /// Initial numbers.
    std::uint32_t initialFields(const std::vector<Field>&);

    /// A string of JSON. Anything else is found wrong, and empty.
    std::string readString(std::uint32_t file, std::uint32_t value);

private:
    void readInto(std::uint32_t file, std::uint32_t value, const Field&, std::uint32_t at);
    Number readNumber(std::uint32_t file, std::uint32_t value, const Field&);
    Number readExpression(std::uint32_t file, std::uint32_t value, const Field&);
    bool isWithin(std::uint32_t file, std::uint32_t value, const Field&, double x);
    [[nodiscard]] const render::JsonText& text(std::uint32_t file) const { return *scene_.files[file].text; }

    Scene& scene_;
    Findings& findings_;
};

/// "0.0001 m to 10000 m", in the unit that is shown.
[[nodiscard]] std::string rangeText(const Field&);

}  // namespace vitrine::scenes
