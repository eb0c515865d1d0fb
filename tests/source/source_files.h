#pragma once

#include <string>
#include <vector>

namespace vitrine::test {

/// One `#include` line.
struct Include {
    std::string file;  ///< Including file, relative to the project.
    int line = 0;
    std::string target;  ///< Text between the quotes or angle brackets.
};

/// Returns all files below a folder of the project with one of these extensions, relative to the project, sorted. Fails
/// the test if there are none.
[[nodiscard]] std::vector<std::string> sourceFiles(const std::string& folder,
                                                   const std::vector<std::string>& extensions);
[[nodiscard]] std::string sourceText(const std::string& file);
/// Replaces comments by spaces, so that positions and line numbers stay the same.
[[nodiscard]] std::string withoutComments(std::string);
[[nodiscard]] std::vector<Include> includesOf(const std::string& file);
[[nodiscard]] std::vector<std::string> lines(const std::string&);

inline const std::vector<std::string> cppExtensions{".h", ".cpp"};
inline const std::vector<std::string> glslExtensions{".glsl", ".vert", ".frag", ".comp"};

}  // namespace vitrine::test
