#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace vitrine::app {

/// File that is written to standard output when it is finished. It is made in a folder of its own among the temporary
/// files, which disappears with this object.
class StandardOutput {
public:
    /// Returns an object if the name stands for standard output: "-", or "-.exr" for another kind of file than the one
    /// of `usual` ("png"). Null for any other name. Throws Failure (ErrorKind::usage) if standard output is a terminal,
    /// and (ErrorKind::file) if the folder cannot be made.
    [[nodiscard]] static std::unique_ptr<StandardOutput> named(const std::string& name, const std::string& usual);
    ~StandardOutput();
    StandardOutput(const StandardOutput&) = delete;
    StandardOutput& operator=(const StandardOutput&) = delete;

    [[nodiscard]] std::filesystem::path file() const { return folder_ / name_; }
    /// Writes the file to standard output. Throws Failure (ErrorKind::file).
    void send() const;

private:
    explicit StandardOutput(std::string name);

    std::filesystem::path folder_;
    std::string name_;
};

}  // namespace vitrine::app
