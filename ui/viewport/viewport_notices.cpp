#include "ui/viewport/viewport_notices.h"

#include "ui/viewport/overlay.h"
#include "ui/viewport/reading_notice.h"

#include <utility>

namespace vitrine::ui {

ViewportNotices::ViewportNotices(QWidget* viewport, std::function<std::vector<render::PendingAsset>()> pending)
    : hint_(new Overlay(Overlay::Place::bottom, viewport)), destination_(new Overlay(Overlay::Place::top, viewport)),
      button_(new Overlay(Overlay::Place::center, viewport)), problems_(new Overlay(Overlay::Place::topLeft, viewport)),
      reading_(std::make_unique<ReadingNotice>(viewport, std::move(pending)))
{
}

ViewportNotices::~ViewportNotices() = default;

void ViewportNotices::sayHint(const QString& text)
{
    hint_->say(text);
}

void ViewportNotices::sayDestination(const QString& text)
{
    destination_->say(text);
}

void ViewportNotices::sayButton(const QString& text)
{
    button_->say(text);
}

void ViewportNotices::sayShaderProblems(const QString& text)
{
    problems_->say(text);
}

void ViewportNotices::startReading()
{
    reading_->start();
}

void ViewportNotices::place()
{
    for (Overlay* overlay : {hint_, destination_, button_, problems_}) overlay->place();
    reading_->place();
}

}  // namespace vitrine::ui
