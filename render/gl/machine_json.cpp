#include "render/gl/machine_json.h"

#include <unistd.h>

namespace vitrine::render::gl {

Json machineJson(const ContextInfo& gl)
{
    return Json{{"renderer", gl.renderer},
                {"vendor", gl.vendor},
                {"version", gl.version},
                {"software", gl.software},
                {"processors", sysconf(_SC_NPROCESSORS_ONLN)}};
}

}  // namespace vitrine::render::gl
