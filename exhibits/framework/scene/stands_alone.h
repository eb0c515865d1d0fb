#pragma once

#include "exhibits/framework/scene/prepare.h"
#include "exhibits/framework/table/parameters.h"
#include "exhibits/framework/table/value_text.h"
#include "render/failure.h"
#include "render/glsl/shader_key.h"
#include "render/text/message.h"

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Numbers of an exhibit's uniform blocks as GLSL, for a shader that is drawn elsewhere.
struct StandAloneNumbers {
    /// Named number that others are computed from; becomes a slider. SI.
    struct Input {
        std::string name, label;
        Unit unit = Unit::none;
        double initial = 0, low = 0, high = 1;
        std::optional<double> exact = {};  ///< Most exact value of an accuracy parameter.
    };
    std::vector<Input> inputs = {};
    std::shared_ptr<const render::ShaderSources> sources = {};  ///< Replace those of the pass; null: they stay.
    std::string functions = {};                                 ///< Functions that `assignments` call.
    /// Statements, a line each. "@name@" stands for an input in SI, and TIME for the seconds since the beginning.
    std::string assignments = {};
    std::set<std::string> assigned = {};  ///< Members of blocks that these statements set.
    std::vector<Message> notes = {};      ///< Sentences on what does not follow the inputs.
    std::optional<double> pivotDistance =
        {};  ///< Distance from the eye to the point that an orbit is around, meters of the hall.
};

/// Capability: can be drawn by a shader that computes the exhibit's numbers itself.
class StandsAlone {
public:
    virtual ~StandsAlone() = default;
    /// Returns the values with which the exhibit is drawn by one shader without buffers, such as the evaluation of all
    /// shapes. Throws Failure if that would change the picture (`refuseToStandAlone`) by more than an accuracy
    /// parameter allows.
    [[nodiscard]] virtual ParameterValues standAloneValues(const ParameterValues&) const = 0;
    [[nodiscard]] virtual StandAloneNumbers standAloneNumbers(const ParameterValues&) const = 0;
};

/// Throws the Failure of an exhibit that cannot stand alone with the present value of a choice or toggle, but with
/// another one.
[[noreturn]] inline void refuseToStandAlone(std::string_view title, const ParameterInfo& parameter, double present,
                                            double other)
{
    throw Failure(ErrorKind::check,
                  message("{1} cannot stand alone while “{2}” is “{3}”; choose “{4}”.", Message::ofTable(title),
                          Message::ofTable(label(parameter)), Message::ofTable(formatValue(parameter, present)),
                          Message::ofTable(formatValue(parameter, other))));
}

}  // namespace vitrine
