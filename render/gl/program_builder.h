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

/// Builds programs on a thread with a context of its own, in the order in which they were asked for.
class ProgramBuilder {
public:
    ProgramBuilder(const ShaderSource&, std::shared_ptr<SharedContext>);
    ~ProgramBuilder();  ///< Waits for the program that is being built.
    ProgramBuilder(const ProgramBuilder&) = delete;
    ProgramBuilder& operator=(const ProgramBuilder&) = delete;

    void begin(const std::string& id, const ShaderKey&);
    /// Not begun yet: never will be. Begun: what comes of it is thrown away.
    void cancel(const std::string& id);
    /// The program, once: nothing while it is not finished. Throws what building it threw.
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
    std::string building_;  ///< Id; empty when idle or when nobody wants it any more.
    struct Finished {
        BuiltProgram built;
        std::exception_ptr thrown;  ///< In its place: memory may end while it is built.
    };
    std::map<std::string, Finished> finished_;
    bool stop_ = false;
    std::thread thread_;  ///< Last: it uses the others.
};

}  // namespace vitrine::render::gl
