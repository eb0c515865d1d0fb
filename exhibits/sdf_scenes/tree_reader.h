#pragma once

#include "exhibits/sdf_scenes/field_reader.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::scenes {

/// Names defined in one file.
struct FileNames {
    std::map<std::string, std::uint32_t> materials{};    ///< Indices in `Scene::materials`.
    std::map<std::string, std::uint32_t> definitions{};  ///< Indices of values in the file's JSON.
    std::uint32_t root = noIndex;                        ///< Index of the root's value.
};

/// Reads the nodes of a scene into its tree, and expands instances and includes.
class TreeReader {
public:
    /// Returns the index of the file that `value` of `file` includes under a path, or nothing if an error was reported.
    using Include =
        std::function<std::optional<std::uint32_t>(std::uint32_t file, std::uint32_t value, const std::string& path)>;

    /// All arguments must outlive the reader. `names` are by file.
    TreeReader(Scene& scene, Findings& findings, const std::vector<FileNames>& names, Include include,
               const SceneLimits& limits)
        : scene_(scene), findings_(findings), fields_(scene, findings), names_(names), include_(std::move(include)),
          limits_(limits)
    {
    }

    /// Reads from the root of the first file.
    void read();

private:
    /// A node that remains to be read.
    struct Work {
        std::uint32_t file, value, parent, material, chain;
    };
    /// An instance or include on the path to a node.
    struct Expansion {
        std::uint32_t file, value, outer, depth;
    };

    void readNode(const Work&);
    void readPlace(const Work&, Node&);
    void readChildren(const Work&, std::uint32_t node, std::uint32_t material);
    void expand(const Work&, std::uint32_t node, std::uint32_t material, bool instance);
    void checkNumbers(const Work&, const Node&, std::size_t findingsBefore);
    [[nodiscard]] std::uint32_t materialOf(const Work&);
    [[nodiscard]] const NodeKind* kindOf(const Work&, std::string& word);
    std::uint32_t addNode(const Work&, Node);

    Scene& scene_;
    Findings& findings_;
    FieldReader fields_;
    const std::vector<FileNames>& names_;
    Include include_;
    const SceneLimits& limits_;
    std::vector<Work> work_;
    std::vector<Expansion> chains_;
    std::vector<std::uint32_t> lastChild_;
};

}  // namespace vitrine::scenes
