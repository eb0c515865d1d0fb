#pragma once

#include "exhibits/museum/museum.h"
#include "render/gl/renderer.h"

#include <glm/glm.hpp>

#include <functional>
#include <memory>
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
bool yourShader(const Options&);

/// Frame that is measured beside others.
struct Row {
    std::string name;
    std::function<render::FrameReport()> draw;
    std::vector<double> cpu{}, wall{};  ///< Milliseconds.
    render::FrameReport last{};
};
using SharedRenderer = std::shared_ptr<render::gl::Renderer>;
/// Returns a row that draws a request. `perFrame`: seconds by which its time advances.
[[nodiscard]] Row frame(std::string name, const Museum&, const SceneState&, FrameRequest, SharedRenderer,
                        double perFrame = 0);
/// Draws all rows in turn, after three frames each that are not measured.
void measure(std::vector<Row>&, int rounds);
/// Prints a table of the rows: counters, medians, ratios to the first row.
void print(const char* title, const std::vector<Row>&);

/// Returns the median, for an even number of values the upper one; 0 if there are none.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace vitrine::bench
