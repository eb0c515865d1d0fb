#include "ui/jobs/job_setup.h"

#include "exhibits/framework/files/state_folder.h"
#include "exhibits/jobs/kit/job_document.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"

#include <filesystem>

namespace vitrine::ui {
namespace {

std::filesystem::path rememberedDocument(const jobs::Job& job)
{
    return stateFolder() / "jobs" / (std::string(job.name()) + ".vitrine-job.json");
}

}  // namespace

JobSetup::JobSetup(const jobs::Job& job, QObject* parent)
    : QObject(parent), job_(job), history_(SceneState{{job.parameters().initial()}, {}})
{
    connect(&history_, &History::changed, this, &JobSetup::changed);
    connect(&history_, &History::replaced, this, &JobSetup::changed);
}

void JobSetup::change(const QString& text, const ParameterValues& values)
{
    history_.change(text, {{values}, {}});
}

void JobSetup::recall()
{
    const std::filesystem::path file = rememberedDocument(job_);
    std::error_code unreadable;
    if (!std::filesystem::exists(file, unreadable)) {
        emit changed();
        return;
    }
    try {
        history_.restart({{jobs::readDocument(file, job_, nullptr).values}, {}});
    } catch (const Failure& failure) {
        qWarning("%s", failure.what());  // The dialog begins with initial values.
    }
    emit changed();
}

void JobSetup::remember() const
{
    try {
        render::atomicWriteMakingFolder(rememberedDocument(job_), documentText(job_, jobs::JobOrder{values()}, {}));
    } catch (const Failure& failure) {
        qWarning("%s", failure.what());  // Next time the dialog begins with older values.
    }
}

}  // namespace vitrine::ui

#include "moc_job_setup.cpp"
