#include "ui/jobs/make_preview.h"

#include "ui/jobs/picture_preview.h"
#include "ui/jobs/sprite_preview.h"
#include "ui/jobs/text_preview.h"

namespace vitrine::ui {

JobPreview* makePreview(const jobs::Job& job, QWidget* parent)
{
    switch (job.needs().preview) {
    case jobs::PreviewForm::picture: return new PicturePreview(parent);
    case jobs::PreviewForm::text: return new TextPreview(parent);
    case jobs::PreviewForm::sprites: return new SpritePreview(parent);
    case jobs::PreviewForm::none: break;
    }
    return nullptr;
}

}  // namespace vitrine::ui
