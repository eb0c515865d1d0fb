#pragma once

#include "render/gl/program.h"
#include "render/gl/shared_context.h"

#include <condition_variable>
#include <deque>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace vitrine::render::gl {

/// Builds programs on a thread with its own context, in the order of the requests.
class ProgramBuilder {
public:
    ProgramBuilder(const ShaderSource&, std::shared_ptr<SharedContext>);
    ~ProgramBuilder();  ///< Waits for the program that is being built.
    ProgramBuilder(const ProgramBuilder&) = delete;
    ProgramBuilder& operator=(const ProgramBuilder&) = delete;

    void begin(const std::string& id, const ShaderKey&);
    /// Removes a program from the queue. If it is already being built, its result is discarded.
    void cancel(const std::string& id);
    /// Returns the finished program, once; nothing until it is finished. Rethrows an exception of the build.
    [[nodiscard]] std::optional<BuiltProgram> take(const std::string& id);

private:
    struct Job {
        std::string id;
        ShaderKey key;
    };
    void run();

    const ShaderSource& source_;
    std::shared_ptr<SharedContext> context_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Job> waiting_;
    std::string building_;  ///< Id; empty if idle or if the program was canceled.
    struct Finished {
        BuiltProgram built;
        std::exception_ptr thrown;  ///< Set instead of `built` if the build threw, for example std::bad_alloc.
    };
    std::map<std::string, Finished> finished_;
    bool stop_ = false;
    std::thread thread_;  ///< Last member: the thread uses the others.
};

}  // namespace vitrine::render::gl
