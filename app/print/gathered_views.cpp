#include "app/print/gathered_views.h"

#include "app/kit/progress.h"
#include "app/print/rendered_views.h"
#include "exhibits/printing/fitting.h"
#include "exhibits/printing/view_colors.h"
#include "exhibits/printing/view_files.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/image/image_io.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace vitrine::app {
namespace {

namespace fs = std::filesystem;

printing::SequenceSettings sequenceOf(const ViewOptions& options)
{
    return {options.every, options.pingPong, options.count};
}

/// Adds `note` unless it is empty or was added before.
void addNote(std::vector<std::string>& notes, const std::string& note)
{
    if (!note.empty() && std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

/// Adds the notes of a reader, which do not name the file.
void addNotes(std::vector<std::string>& notes, const fs::path& file, const std::vector<std::string>& sentences)
{
    for (const std::string& sentence : sentences) notes.push_back(file.filename().string() + ": " + sentence);
}

/// Parses the values of `--place`. Throws Failure (ErrorKind::usage) if one is malformed or names a missing picture.
printing::ViewPlaces placesOf(const ViewOptions& options, std::size_t pictures)
{
    std::string all;
    for (const std::string& place : options.places) (all += place) += ';';
    printing::ViewPlaces places = printing::viewPlaces(all);
    printing::requirePictures(places, static_cast<int>(pictures));
    return places;
}

/// Describes a view's source: the file, and its place if it was placed by hand.
std::string sourceOf(const std::string& name, int picture, const printing::ViewPlaces& places)
{
    const printing::ViewPlace place = printing::placeOf(places, picture);
    return place == printing::ViewPlace{} ? name : name + ", placed by " + printing::textOf({{picture, place}});
}

GatheredViews viewsOfFiles(const ViewOptions& options)
{
    GatheredViews result;
    const std::vector<fs::path> files = printing::viewFiles(options.files, &result.notes);
    const printing::ViewPlaces places = placesOf(options, files.size());
    const std::vector<std::size_t> numbers = printing::chosenViews(files.size(), sequenceOf(options));
    std::vector<fs::path> chosen;
    for (const std::size_t i : numbers) chosen.push_back(files[i]);
    const double aspect = printing::aspectOf(layoutOf(options, static_cast<int>(chosen.size())).settings());
    const printing::ViewColors colors = printing::viewColors(chosen);
    result.profile = colors.profile;
    addNote(result.notes, colors.note);
    ProgressLine line("reading views");
    std::set<std::pair<int, int>> sizes;
    for (const fs::path& file : chosen) {
        if (!line.show(static_cast<double>(result.sources.names.size()) / static_cast<double>(chosen.size())))
            throw Failure(ErrorKind::usage, "Reading the views was stopped; nothing was written.");
        std::vector<std::string> warnings;
        render::Image image =
            render::readColor(file, {.keepColors = colors.keep, .canceled = StopSignal::stopped}, &warnings);
        addNotes(result.notes, file, warnings);
        sizes.emplace(image.width, image.height);
        addNote(result.notes, printing::fittingNote(image, aspect, options.values[printing::printTable().fitting]));
        const int picture = static_cast<int>(numbers[result.sources.names.size()]) + 1;
        result.views.add(printing::fitted(std::move(image), aspect, options.values[printing::printTable().fitting],
                                          printing::placeOf(places, picture)));
        result.sources.names.push_back(sourceOf(file.filename().string(), picture, places));
    }
    if (sizes.size() > 1) result.notes.emplace_back("The views differ in size; each is scaled to the print.");
    return result;
}

/// Parses the columns and rows of --quilt. Throws Failure (ErrorKind::usage).
glm::ivec2 gridOf(const std::string& text)
{
    if (const std::optional<glm::ivec2> grid = printing::quiltGrid(text)) return *grid;
    throw Failure(ErrorKind::usage, "--quilt \"" + text +
                                        "\": give columns x rows, each from 1 to 1000, and the picture, such as "
                                        "--quilt 8x6 quilt.png.");
}

GatheredViews viewsOfQuilt(const ViewOptions& options)
{
    const glm::ivec2 grid = gridOf(options.quilt[0]);
    const std::vector<std::size_t> chosen =
        printing::chosenViews(static_cast<std::size_t>(grid.x * grid.y), sequenceOf(options));
    const double aspect = printing::aspectOf(layoutOf(options, static_cast<int>(chosen.size())).settings());
    const fs::path file = options.quilt[1];
    const printing::ViewColors colors = printing::viewColors({file});
    GatheredViews result;
    result.profile = colors.profile;
    std::vector<std::string> warnings;
    const render::Image quilt =
        render::readColor(file, {.keepColors = colors.keep, .canceled = StopSignal::stopped}, &warnings);
    addNotes(result.notes, file, warnings);
    addNote(result.notes, printing::quiltNote(quilt, grid.x, grid.y));
    const auto order =
        options.quiltOrder == "top-left" ? printing::QuiltOrder::topLeft : printing::QuiltOrder::bottomLeft;
    const printing::ViewPlaces places = placesOf(options, static_cast<std::size_t>(grid.x * grid.y));
    for (const std::size_t k : chosen) {
        render::Image view = printing::viewOfQuilt(quilt, grid.x, grid.y, static_cast<int>(k), order);
        addNote(result.notes, printing::fittingNote(view, aspect, options.values[printing::printTable().fitting]));
        const int picture = static_cast<int>(k) + 1;
        result.views.add(printing::fitted(std::move(view), aspect, options.values[printing::printTable().fitting],
                                          printing::placeOf(places, picture)));
        result.sources.names.push_back(
            sourceOf(file.filename().string() + ", view " + std::to_string(k), picture, places));
    }
    return result;
}

}  // namespace

printing::PrintLayout layoutOf(const ViewOptions& options, int views)
{
    return printing::PrintLayout(printing::printSettings(options.values, views));
}

GatheredViews gatherViews(const ViewOptions& options)
{
    const int ways = static_cast<int>(!options.files.empty()) + static_cast<int>(!options.quilt.empty()) +
                     static_cast<int>(!options.scene.subject.empty());
    if (ways == 0)
        throw Failure(ErrorKind::usage, "There are no views; give pictures with --views or --quilt, or an --exhibit.");
    if (ways > 1)
        throw Failure(ErrorKind::usage,
                      "The views come from one place: give only one of --views, --quilt and --exhibit.");
    if (!options.scene.subject.empty()) return renderedViews(options);
    return options.quilt.empty() ? viewsOfFiles(options) : viewsOfQuilt(options);
}

}  // namespace vitrine::app
