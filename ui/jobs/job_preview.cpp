#include "ui/jobs/job_preview.h"

#include "ui/jobs/picture_preview.h"
#include "ui/jobs/sprite_preview.h"

namespace vitrine::ui {

JobPreview* makePreview(std::string_view job, QWidget* parent)
{
    if (job == "render") return new PicturePreview(parent);
    if (job == "sprite") return new SpritePreview(parent);
    return nullptr;
}

}  // namespace vitrine::ui

#include "moc_job_preview.cpp"
