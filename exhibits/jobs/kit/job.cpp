#include "exhibits/jobs/kit/job.h"

#include "exhibits/jobs/kit/part_folder.h"
#include "render/files/atomic_write.h"
#include "render/files/extension.h"
#include "render/files/number_text.h"
#include "render/image/picture_formats.h"
#include "render/text/joined.h"

#include <algorithm>
#include <cmath>

namespace vitrine::jobs {

std::string valueText(const Fact& fact)
{
    std::string text;
    if (const auto* number = std::get_if<double>(&fact.value))
        text = *number == std::round(*number) ? render::shortestNumber(*number) : render::shortNumber(*number);
    else
        text = std::get<std::string>(fact.value);
    return fact.unit.empty() ? text : text + ' ' + fact.unit;
}

std::string refusedExtension(const Job& job, const std::filesystem::path& out)
{
    const std::vector<std::string_view> extensions = job.needs().extensions;
    if (extensions.empty()) return {};
    const std::string given = render::lowerExtension(out);
    const render::PictureFileFormat* format = render::formatNamed(out);
    const auto is = [&](std::string_view extension) {
        const std::string usual = '.' + std::string(extension);
        return given == usual || (format && format == render::formatNamed("a" + usual));
    };
    if (std::any_of(extensions.begin(), extensions.end(), is)) return {};
    return out.string() + ": give a name that ends in " +
           alternatives(extensions, [](std::string_view extension) { return '.' + std::string(extension); }) + '.';
}

void requireWritable(const Job& job, const JobOrder& order)
{
    if (order.out.empty() || !order.inputs) return;
    const JobPlan plan = job.plan(order.values, order.scene, *order.inputs, order.out);
    const bool isFolder = job.needs().extensions.empty();
    if (isFolder || plan.makesFolders) makeFolders(order.out.parent_path(), order.out);
    for (const PlannedFile& file : plan.files)
        if (!isFolder || file.path != order.out) const render::PartFile writable(file.path);
    if (!order.reportFile.empty()) const render::PartFile writable(order.reportFile);
}

}  // namespace vitrine::jobs
