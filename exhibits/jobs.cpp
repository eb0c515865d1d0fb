#include "exhibits/jobs.h"

#include "exhibits/jobs/comparison/comparison_job.h"
#include "exhibits/jobs/handout/handout_job.h"
#include "exhibits/jobs/mesh/mesh_job.h"
#include "exhibits/jobs/picture/picture_job.h"
#include "exhibits/jobs/print/print_job.h"
#include "exhibits/jobs/proof/proof_job.h"
#include "exhibits/jobs/quilt/quilt_job.h"
#include "exhibits/jobs/record/record_job.h"
#include "exhibits/jobs/shader/shader_job.h"
#include "exhibits/jobs/sprite/sprite_job.h"
#include "exhibits/jobs/study/study_job.h"
#include "exhibits/jobs/table/table_job.h"

#include <algorithm>

namespace vitrine::jobs {

const std::vector<std::unique_ptr<const Job>>& allJobs()
{
    static const auto jobs = [] {
        std::vector<std::unique_ptr<const Job>> all;
        all.push_back(std::make_unique<PictureJob>());
        all.push_back(std::make_unique<StudyJob>());
        all.push_back(std::make_unique<ComparisonJob>());
        all.push_back(std::make_unique<RecordJob>());
        all.push_back(std::make_unique<PrintJob>());
        all.push_back(std::make_unique<ProofJob>());
        all.push_back(std::make_unique<QuiltJob>());
        all.push_back(std::make_unique<SpriteJob>());
        all.push_back(std::make_unique<MeshJob>());
        all.push_back(std::make_unique<ShaderJob>());
        all.push_back(std::make_unique<TableJob>());
        all.push_back(std::make_unique<HandoutJob>());
        return all;
    }();
    return jobs;
}

const Job* findJob(std::string_view name)
{
    const auto& jobs = allJobs();
    const auto found = std::find_if(jobs.begin(), jobs.end(), [&](const auto& job) { return job->name() == name; });
    return found == jobs.end() ? nullptr : found->get();
}

}  // namespace vitrine::jobs
