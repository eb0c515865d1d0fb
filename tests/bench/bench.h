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
    double minutes = 8;         ///< Longest time of the report of a machine.
    double scale = 1;           ///< Scale of the large print; 0.1 is a tenth of its width and height.
    std::vector<std::pair<std::string, std::string>> programs;  ///< Name and path of further programs to measure.

    [[nodiscard]] int runsOr(int usual) const { return runs > 0 ? runs : usual; }
};

/// Measurement that answers one question. `run` prints Markdown to standard output. If measuring is impossible, it
/// prints the reason to standard error and returns false.
struct Case {
    std::string name, question;
    bool draws;  ///< Draws with OpenGL, so its result is named by the renderer.
    bool (*run)(const Options&);
};

bool hallCosts(const Options&);
bool interlacing(const Options&);
bool largePrint(const Options&);
bool portableReport(const Options&);
bool sdfEvaluations(const Options&);
bool windowLatency(const Options&);
/// `longest`: seconds for each start; the case ends without a table when one takes longer.
bool windowStart(const Options&, double longest);

/// Returns the median, for an even number of values the upper one; 0 if there are none.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace vitrine::bench
