#pragma once

#include <string>
#include <vector>

namespace vitrine::test {

/// One line that says `#include`.
struct Include {
    std::string file;  ///< That includes, relative to the project.
    int line = 0;
    std::string target;  ///< Between the quotes or angles.
};

/// All files below a folder of the project whose extension is one of `extensions`, relative to the
/// project, sorted. Fails the test when there is none.
[[nodiscard]] std::vector<std::string> sourceFiles(const std::string& folder,
                                                   const std::vector<std::string>& extensions);
[[nodiscard]] std::string sourceText(const std::string& file);
/// Without comments: their text is replaced by spaces, so that lines keep their numbers.
[[nodiscard]] std::string withoutComments(std::string);
[[nodiscard]] std::vector<Include> includesOf(const std::string& file);
[[nodiscard]] std::vector<std::string> lines(const std::string&);

inline const std::vector<std::string> cppExtensions{".h", ".cpp"};
inline const std::vector<std::string> glslExtensions{".glsl", ".vert", ".frag", ".comp"};

}  // namespace vitrine::test
