#pragma once

#include "exhibits/shader_export/glsl_items.h"

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

// Uniform blocks of an exhibit's shader as constants.
namespace vitrine::guest {

/// Member of a struct or a block.
struct BlockField {
    std::string type, name;
    int count = 0;  ///< Length of an array; 0: no array.
    std::string comment = {};
};
using BlockStructs = std::map<std::string, std::vector<BlockField>>;

/// Reads the fields of a `#define X_FIELDS(FIELD, ARRAY) ...` of a block file.
[[nodiscard]] std::vector<BlockField> fieldsOfMacro(const std::string& text, const GlslMacros&);
/// Reads the members between the braces of a block or struct.
[[nodiscard]] std::vector<BlockField> fieldsInBraces(const std::string& text, const GlslMacros&);

/// Returns the GLSL text of a struct with those fields whose names are in `used`.
[[nodiscard]] std::string structText(const std::string& name, const std::vector<BlockField>&,
                                     const std::set<std::string>& used);

/// Writes assignments of the numbers in a block's bytes (std140).
class BlockConstants {
public:
    /// Only fields whose names are in `used` are written. Both must outlive this object.
    BlockConstants(const BlockStructs& structs, const std::set<std::string>& used) : structs_(structs), used_(used) {}

    /// Returns lines such as "    portal.workPerMeter = 2.0;". `prefix`: "portal." or empty. Members in `without` are
    /// left out, by their whole names.
    [[nodiscard]] std::string lines(const std::vector<BlockField>&, std::span<const std::byte> bytes,
                                    const std::string& prefix, const std::set<std::string>& without) const;

private:
    struct Shape {
        std::size_t alignment = 4, size = 4;
    };
    [[nodiscard]] Shape shapeOf(const std::string& type) const;
    void write(const std::string& type, std::size_t offset, std::span<const std::byte>, const std::string& name,
               const std::set<std::string>& without, std::string& lines) const;
    std::size_t writeAll(const std::vector<BlockField>&, std::size_t offset, std::span<const std::byte>,
                         const std::string& prefix, const std::set<std::string>& without, std::string& lines) const;

    const BlockStructs& structs_;
    const std::set<std::string>& used_;
};

}  // namespace vitrine::guest
