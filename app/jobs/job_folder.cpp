#include "app/jobs/job_folder.h"

#include "app/study/study_folder.h"

namespace vitrine::app {

const JobFolder* folderOf(const jobs::Job& job)
{
    static const JobFolder study{requireStudyFolder, writeStudyFolder, tellStudy};
    return job.name() == "study" ? &study : nullptr;
}

}  // namespace vitrine::app
