#pragma once

#include "exhibits/sdf_scenes/findings.h"

#include <string_view>
#include <vector>

namespace vitrine::scenes {

/// Reader of the numbers of nodes and records into a scene.
class FieldReader {
public:
    /// Scene and findings must outlive the reader.
    FieldReader(Scene& scene, Findings& findings) : scene_(scene), findings_(findings) {}

    /// Reads all fields of an object; missing ones get initial values. Returns the index of their first number. Keys
    /// that are neither fields nor in `others` are reported; `what` names the object in the message: "a sphere".
    std::uint32_t readObject(std::uint32_t file, std::uint32_t object, const std::vector<Field>& fields,
                             const std::vector<std::string_view>& others, const std::string& what);
    /// Reads one field; returns the index of its first number.
    std::uint32_t readField(std::uint32_t file, std::uint32_t value, const Field&);
    /// Appends initial values; returns the index of the first number.
    std::uint32_t initialFields(const std::vector<Field>&);

    /// Reads a JSON string. Any other value is reported, and gives an empty string.
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

/// Returns for example "0.0001 m to 10000 m", in the displayed unit.
[[nodiscard]] std::string rangeText(const Field&);

}  // namespace vitrine::scenes
