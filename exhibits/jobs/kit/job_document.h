#pragma once

#include "exhibits/framework/files/picture_record.h"
#include "exhibits/jobs/kit/job.h"
#include "render/files/strict_json.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::jobs {

/// Version of settings documents that is written; newer ones are refused.
inline constexpr int jobDocumentVersion = 1;

/// Settings of a job, from which it can be run again. As a file:
///
///     {
///       "format": "vitrine-job",
///       "version": 1,
///       "app": "0.1.0",
///       "job": "sprite",
///       "values": {"model": "hero.glb", "size": [64, 64], ...},
///       "scene": {"format": "vitrine-exhibition", ...},
///       "out": "hero.png",
///       "report": {"frames": "96", ...}
///     }
///
/// `values` has all parameters, in SI, so that a document outlives a change of an initial value.
struct JobDocument {
    ParameterValues values;
    SceneState scene = {};    ///< Without values for a job without a scene.
    std::string chosen = {};  ///< Exhibit that is shown, of a job that chooses one.
    /// How the scene is shown, for jobs that use a scene.
    std::optional<PictureRecord> taken = {};
    std::string name = {};                    ///< Name of the scene's settings, for people.
    std::optional<OtherSettings> other = {};  ///< Settings B, of a job that compares two.
    std::filesystem::path out = {};           ///< Beside the document.
    std::vector<std::string> notes = {};
};

/// Returns the path of the document beside an output: "hero.png.vitrine-job.json" for "hero.png".
[[nodiscard]] std::filesystem::path documentFile(const std::filesystem::path& out);

/// Returns the text of a document. Throws Failure if a value cannot be written.
[[nodiscard]] std::string documentText(const Job&, const JobOrder&, const std::vector<Fact>& facts);

/// Reads a document, or the one beside an output. A value out of range becomes the nearest legal one, with a note.
/// `museum` may be null for a job without a scene. Throws Failure naming file, line and key if there is no document, if
/// it belongs to another job or a newer version, or if a key is unknown or has a wrong type.
[[nodiscard]] JobDocument readDocument(const std::filesystem::path&, const Job&, const Museum*);
/// The same for a text; `name` is the name of its file, for messages.
[[nodiscard]] JobDocument parseDocument(std::string text, const std::string& name, const Job&, const Museum*);

/// Returns a JSON Schema (draft 2020-12) for the "values" of the job's documents.
[[nodiscard]] render::Json schemaOf(const Job&);

}  // namespace vitrine::jobs
