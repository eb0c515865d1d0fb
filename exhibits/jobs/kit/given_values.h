#pragma once

#include "exhibits/framework/table/preset_values.h"
#include "exhibits/jobs/kit/job_options.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::jobs {

/// Values of a job's parameters while arguments are read, as words or as JSON. A given value may imply values of other
/// parameters; `settled` resolves this once everything is given.
class GivenValues {
public:
    /// Starts from the initial values. Parameters that are required (`mustBeGiven`) count as missing. The table must
    /// outlive this object.
    explicit GivenValues(const Parameters&);
    /// Starts from the values of a settings document, all of which count as given.
    explicit GivenValues(ParameterValues document);

    [[nodiscard]] const std::vector<JobOption>& options() const { return options_; }

    /// Sets the value of an option from the typed words: one, or several if the option accepts several. Throws Failure
    /// (ErrorKind::usage) that begins with the option and says which values are valid.
    void type(const JobOption&, const std::vector<std::string>& words);
    /// Turns a flag on or off.
    void turn(const JobOption&, bool on);
    /// Sets every parameter in the JSON object; `place` is the location of the object. A value out of range becomes the
    /// nearest legal one, with a note. Throws Failure naming file, line and key for a wrong type, an unknown choice or
    /// an unknown key.
    void read(const render::Json& object, const JsonPlace& place, std::vector<std::string>& notes);

    /// Returns whether the parameter was typed, or is in the document that was read last.
    [[nodiscard]] bool has(std::size_t parameter) const { return given_.count(parameter) > 0; }
    /// Returns the values, with everything that the given ones imply. Throws Failure (ErrorKind::usage) in three cases:
    /// a parameter that `command` ("vitrine proof") requires is missing, two values imply different values of a third
    /// parameter, or a typed parameter has no effect.
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

/// Returns all values by key, with numbers in SI units: the "values" of a settings document.
[[nodiscard]] render::Json jsonOf(const ParameterValues&);

/// Returns the words of a command line for these values. Parameters without effect are left out.
[[nodiscard]] std::vector<std::string> wordsOf(const ParameterValues&);

}  // namespace vitrine::jobs
