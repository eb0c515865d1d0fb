#include "render/gl/program_builder.h"

#include <utility>

namespace vitrine::render::gl {

ProgramBuilder::ProgramBuilder(const ShaderSource& source, std::shared_ptr<SharedContext> context)
    : source_(source), context_(std::move(context)), thread_([this] { run(); })
{
}

ProgramBuilder::~ProgramBuilder()
{
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
        waiting_.clear();
    }
    wake_.notify_one();
    thread_.join();
}

void ProgramBuilder::begin(const std::string& id, const ShaderKey& key)
{
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back({id, key});
    }
    wake_.notify_one();
}

void ProgramBuilder::cancel(const std::string& id)
{
    const std::lock_guard lock(mutex_);
    std::erase_if(waiting_, [&](const Job& job) { return job.id == id; });
    finished_.erase(id);
    if (building_ == id) building_.clear();
}

std::optional<BuiltProgram> ProgramBuilder::take(const std::string& id)
{
    const std::lock_guard lock(mutex_);
    auto node = finished_.extract(id);
    if (node.empty()) return std::nullopt;
    if (node.mapped().thrown) std::rethrow_exception(node.mapped().thrown);
    return std::move(node.mapped().built);
}

void ProgramBuilder::run()
{
    context_->makeCurrent();
    std::unique_lock lock(mutex_);
    for (;;) {
        wake_.wait(lock, [&] { return stop_ || !waiting_.empty(); });
        if (stop_) break;
        const Job job = std::move(waiting_.front());
        waiting_.pop_front();
        building_ = job.id;
        lock.unlock();
        Finished finished;
        try {
            finished.built = buildProgram(source_, job.key);
            glFinish();  // The other context then sees the complete program.
        } catch (...) {
            finished.thrown = std::current_exception();
        }
        lock.lock();
        if (building_ == job.id) finished_.insert_or_assign(job.id, std::move(finished));
        building_.clear();
    }
    lock.unlock();
    context_->release();
}

}  // namespace vitrine::render::gl
