#pragma once

#include <glm/glm.hpp>

#include <string>
#include <utility>
#include <vector>

namespace vitrine::bench {

/// Settings of a run, from the command line.
struct Options {
    int runs = 0;               ///< Repetitions of each measurement; 0: the case's own number.
    glm::ivec2 size{640, 360};  ///< Size of drawn pictures, in pixels.
    double scale = 1;           ///< Scale of the large print; 0.1 is a tenth of its width and height.
    std::vector<std::pair<std::string, std::string>> programs;  ///< Name and path of further programs to measure.

    [[nodiscard]] int runsOr(int usual) const { return runs > 0 ? runs : usual; }
};

/// One question that a measurement answers. Prints Markdown to standard output; returns false where it cannot be
/// measured, after the reason was printed to standard error.
struct Case {
    std::string name, question;
    bool draws;  ///< It needs OpenGL, so its result is named by the renderer.
    bool (*run)(const Options&);
};

bool hallCosts(const Options&);
bool interlacing(const Options&);
bool largePrint(const Options&);
bool sdfEvaluations(const Options&);
bool windowLatency(const Options&);
bool windowStart(const Options&);

/// Median of the values, the upper one of an even number; 0 of none.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace vitrine::bench
