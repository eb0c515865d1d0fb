#pragma once

#include "exhibits/framework/parameters.h"
#include "exhibits/museum/picture.h"
#include "render/image/image.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// Where the views of a print come from.
enum class ViewOrigin : std::uint8_t {
    shown,  ///< Rendered from what is on show.
    files,  ///< A folder, or pictures in viewing order from the left.
    quilt,  ///< One picture with a grid of views, the first at the bottom left, rows upwards.
};

/// Views that were read or rendered, from left to right. What is inside is the desk's own.
class PrintViews {
public:
    virtual ~PrintViews() = default;
    [[nodiscard]] virtual int count() const = 0;
    /// Adds a picture of linear light, row 0 at the top, as the new rightmost view. Throws Failure when it is empty.
    virtual void add(const render::Image&) = 0;
    /// The JSON text of the look that was rendered, for the print to carry.
    virtual void setLook(std::string) = 0;
};

/// One view of what is shown, to be rendered; the picture goes to PrintViews::add.
struct PrintShot {
    Look look;
    PictureRequest request;
};

/// How far the scene reaches from the camera, and from where to where the print holds it, in metres; the far
/// ends may be infinite.
struct SceneDepth {
    double nearest = 0, farthest = 0;
    double nearestHeld = 0, farthestHeld = 0;
    double scaleThatHolds = 1;  ///< Baseline scale at which the print holds all of it, at most 1.
    std::vector<std::string> warnings{};
};

/// What a printer and a visitor want to know about a print, or why it cannot be. Lengths in metres.
struct PrintSummary {
    std::string refusal;                ///< A full sentence with the limit; empty when the print can be made.
    std::vector<std::string> warnings;  ///< Full sentences on what will disappoint.
    std::int64_t width = 0, height = 0; ///< Pixels, bleed included.
    double bytes = 0;                   ///< Of the file, uncompressed.
    double pixelsPerLens = 0;
    double storedLpi = 0;               ///< Of the strips, with the dpi that the file stores.
    double effectiveViews = 0;          ///< How many can be told apart.
    double zone = 0;                    ///< Angle in which the views are seen once, in radians.
    double depthBudget = 0;             ///< Before and behind the print together, without doubled contours.
    std::vector<double> ownShare;       ///< Per view, at its own angle: the rest is cross-talk.
};

/// RGB as files store it, sRGB-encoded, 8 bit, row 0 at the top, no padding.
struct CodedPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb{};
};

/// Where the lenses lie on a raster: at (x, y), in pixels from its top left corner, `at0 + perX x + perY y`
/// lenses; cusps are where that is a whole number.
struct LensGrid {
    double at0 = 0, perX = 0, perY = 0;
};

/// An eye that looks at the middle of the print. Angles in radians.
struct PrintEye {
    double angle = 0;       ///< To the right of the print's normal.
    double angleAlong = 0;  ///< Above it.
    double distance = std::numeric_limits<double>::infinity();  ///< Of the eye's plane from the print, in metres.
};

/// A print to look at before it is made. Every function may be called from any thread.
class PrintPreview {
public:
    virtual ~PrintPreview() = default;
    [[nodiscard]] virtual std::int64_t width() const = 0;
    [[nodiscard]] virtual std::int64_t height() const = 0;
    [[nodiscard]] virtual LensGrid lenses() const = 0;
    /// The raster itself, ends excluded, exactly as a file of 8 bits will have it. Must lie on the raster.
    [[nodiscard]] virtual CodedPicture raster(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) const = 0;
    /// What an eye sees of that raster through the lenses; about `side` pixels along the longer side. Empty for
    /// charts, which are looked at with their sheet in the hand.
    [[nodiscard]] virtual CodedPicture seen(const PrintEye&, int side) const = 0;
};

/// A sheet in the list of sheets.
struct SheetEntry {
    std::string name;
    bool own = false;  ///< The user's: can be changed and removed.
};

/// Told the part that is done, 0 to 1; false stops the work, which then throws PrintStopped.
using PrintProgress = std::function<bool(double)>;

/// The visitor asked for it: nothing was written, nothing needs saying.
struct PrintStopped {};

/// Makes lenticular prints for a dialog or a test: everything that can be set is one table, and values of it
/// are all that the other functions need. No function needs OpenGL, and all but those that change the list of
/// sheets may be called from any thread.
class PrintDesk {
public:
    virtual ~PrintDesk() = default;

    [[nodiscard]] virtual const Parameters& parameters() const = 0;
    [[nodiscard]] virtual ViewOrigin origin(const ParameterValues&) const = 0;
    /// The same values with another origin.
    [[nodiscard]] virtual ParameterValues withOrigin(const ParameterValues&, ViewOrigin) const = 0;
    /// Whether a row means something for these values, as a print of views or as a chart.
    [[nodiscard]] virtual bool matters(const ParameterInfo&, const ParameterValues&, bool chart) const = 0;
    /// Whether views that were got for one serve the other.
    [[nodiscard]] virtual bool sameViews(const ParameterValues&, const ParameterValues&) const = 0;
    /// Distance from which the print is to be looked at, in metres; infinity is one.
    [[nodiscard]] virtual double viewingDistance(const ParameterValues&) const = 0;

    // Sheets.
    /// Shipped ones first. `problem` says why the user's own could not be read.
    [[nodiscard]] virtual std::vector<SheetEntry> sheets(std::string& problem) const = 0;
    /// The values with that sheet's numbers. Throws Failure when there is none of that name.
    [[nodiscard]] virtual ParameterValues withSheet(const ParameterValues&, const std::string& name) const = 0;
    /// The name of the sheet that these values have, or empty when they match none of the list. Of several alike, the
    /// one that is named `preferred`, else the first.
    [[nodiscard]] virtual std::string sheetName(const ParameterValues&, const std::string& preferred = {}) const = 0;
    /// Adds the sheet of these values to the user's own under that name, or replaces it. Throws Failure when
    /// the sheet cannot be, when a shipped sheet has that name, or when the file cannot be written.
    virtual void saveSheet(const ParameterValues&, const std::string& name) = 0;
    virtual void removeSheet(const std::string& name) = 0;

    // Views.
    /// No views yet.
    [[nodiscard]] virtual std::shared_ptr<PrintViews> newViews() const = 0;
    /// Reads what is asked for, or throws Failure naming the file; PrintStopped when told to.
    [[nodiscard]] virtual std::shared_ptr<const PrintViews> readViews(const ParameterValues&, const std::vector<std::string>& files,
                                                                      const PrintProgress&) const = 0;
    /// What to render, from left to right, with the look's camera in the middle. `draft`: small and quick, to look
    /// at while setting up. `frame` gives all but camera, size and seed. Throws Failure as `summary` refuses.
    [[nodiscard]] virtual std::vector<PrintShot> shots(const ParameterValues&, const Look&, const FrameRequest& frame, bool draft) const = 0;
    /// The values with another baseline scale.
    [[nodiscard]] virtual ParameterValues withBaselineScale(const ParameterValues&, double) const = 0;
    /// From a picture of the look with the channel "depth.Z". Throws Failure as `summary` refuses.
    [[nodiscard]] virtual SceneDepth sceneDepth(const ParameterValues&, const Look&, const render::Image&) const = 0;

    // The print.
    /// What will be; the name of the file decides the format. Never throws for settings that cannot be: they are
    /// its refusal. Without views, of as many as the values ask for.
    [[nodiscard]] virtual PrintSummary summary(const ParameterValues&, const PrintViews*, bool chart, const std::filesystem::path&) const = 0;
    /// Throws Failure as `summary` refuses. Without views, a preview of the chart.
    [[nodiscard]] virtual std::shared_ptr<const PrintPreview> preview(const ParameterValues&, std::shared_ptr<const PrintViews>) const = 0;
    /// Writes the print, or without views the chart, and its JSON beside it. Returns the picture files. Throws
    /// Failure naming file and cause, or PrintStopped; then nothing is left behind and old files stand.
    virtual std::vector<std::filesystem::path> write(const ParameterValues&, std::shared_ptr<const PrintViews>, const std::vector<std::string>& sources,
                                                     const std::filesystem::path&, const PrintProgress&) const = 0;

    // Settings as text.
    /// Everything that is set, as a print's own JSON has it.
    [[nodiscard]] virtual std::string settingsText(const ParameterValues&, const std::vector<std::string>& sources) const = 0;
    struct Settings {
        ParameterValues values;
        std::vector<std::string> sources;
        std::vector<std::string> notes;  ///< What had to be changed, for people.
    };
    /// Reads a JSON that a print or `settingsText` wrote. Throws Failure naming file, line and key.
    [[nodiscard]] virtual Settings settingsFrom(const std::string& text, const std::string& fileName) const = 0;
    /// The JSON beside or inside a print, or of a file of settings. Throws Failure when there is none.
    [[nodiscard]] virtual std::string settingsIn(const std::filesystem::path&) const = 0;
};

}  // namespace vitrine
