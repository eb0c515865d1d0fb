#pragma once

#include "exhibits/jobs/kit/job.h"
#include "exhibits/your_shader/export/exported_shader.h"

namespace vitrine::jobs {

/// Returns the shader that a scene shows: the visitor's own, or one that draws the exhibit alone. Reads the files that
/// the settings name, and takes as long as preparing a frame. Thread-safe. Throws Failure with a sentence on why the
/// exhibit cannot be exported.
[[nodiscard]] guest::ExportedShader sceneShader(const JobScene&);

}  // namespace vitrine::jobs
