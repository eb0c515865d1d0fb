#pragma once

#include "exhibits/framework/parameters.h"
#include "render/plan/render_backend.h"

#include <memory>
#include <string>
#include <string_view>

namespace vitrine {

/// A table in the making.
class TableMeasurement {
public:
    virtual ~TableMeasurement() = default;
    /// Measures a part of it and returns whether there is another. Always on the same backend, which times its steps.
    virtual bool step(render::RenderBackend&) = 0;
    /// The part that is done, 0 to 1.
    [[nodiscard]] virtual double progress() const = 0;
    /// What is measured so far as comma-separated values: a line of names, then one for each row.
    [[nodiscard]] virtual std::string csv() const = 0;
};

/// Has a table of its own to measure, besides studies of its rows.
class MeasuresTable {
public:
    virtual ~MeasuresTable() = default;
    [[nodiscard]] virtual std::string_view tableTitle() const = 0;
    /// Begins with these values. Throws Failure where a file that they name cannot be read. Any thread may call it.
    [[nodiscard]] virtual std::unique_ptr<TableMeasurement> measureTable(const ParameterValues&) const = 0;
};

}  // namespace vitrine
