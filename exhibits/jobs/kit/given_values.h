#pragma once

#include "exhibits/framework/table/preset_values.h"
#include "exhibits/jobs/kit/job_options.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::jobs {

/// Values of a job's parameters as they are given, in words or as JSON, on top of initial values or those of a settings
/// document. What was given implies values of other parameters, so the outcome is settled at the end.
class GivenValues {
public:
    /// On top of initial values: parameters that must be given are missing. The table must outlive it.
    explicit GivenValues(const Parameters&);
    /// On top of the values of a settings document, which count as given.
    explicit GivenValues(ParameterValues document);

    [[nodiscard]] const std::vector<JobOption>& options() const { return options_; }

    /// Gives what was typed for an option: one word, or several where the option takes them. Throws Failure
    /// (Blame::usage) that begins with the option and says what it takes.
    void type(const JobOption&, const std::vector<std::string>& words);
    /// Turns a flag on or off.
    void turn(const JobOption&, bool on);
    /// Gives every parameter that the object names; `place` is where the object stands. What is out of range is brought
    /// to the nearest legal value, with a note. Throws Failure naming file, line and key for a wrong type, an unknown
    /// choice and an unknown key.
    void read(const render::Json& object, const JsonPlace& place, std::vector<std::string>& notes);

    /// The values with all that follows from what was given. Throws Failure (Blame::usage) where `command` ("vitrine
    /// proof") lacks a parameter, where two exclude each other because they imply different values of a third, and
    /// where one that was typed has no effect.
    [[nodiscard]] ParameterValues settled(const std::string& command) const;

private:
    void give(std::size_t parameter, const Value&, const std::string& as);
    [[nodiscard]] ParameterValues withImplied() const;
    void refuseMissing(const std::string& command) const;
    void refuseUseless(const ParameterValues&) const;

    ParameterValues values_;
    std::vector<JobOption> options_;
    std::map<std::size_t, std::string> given_;  ///< Parameters of this layer, each with the option that gave it.
    bool onDocument_ = false;
    bool typed_ = false;
};

/// All values by key, numbers in SI: the "values" of a settings document.
[[nodiscard]] render::Json jsonOf(const ParameterValues&);

/// Words of a command line that give these values; parameters that have no effect are left out.
[[nodiscard]] std::vector<std::string> wordsOf(const ParameterValues&);

}  // namespace vitrine::jobs
