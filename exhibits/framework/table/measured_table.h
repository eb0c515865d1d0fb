#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/plan/render_backend.h"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Measurement of a table in progress.
class TableMeasurement {
public:
    virtual ~TableMeasurement() = default;
    /// Measures one part and returns whether there is another. Call it always with the same backend, which must time
    /// its steps.
    virtual bool step(render::RenderBackend&) = 0;
    /// Finished share of the time, 0 to 1, as far as it can be foreseen.
    [[nodiscard]] virtual double progress() const = 0;
    /// Returns the texts of the results so far, line by line. The first line has the names of the columns.
    [[nodiscard]] virtual const std::vector<std::vector<std::string>>& lines() const = 0;
    /// Returns how many lines there will be, without that of the names.
    [[nodiscard]] virtual std::size_t expectedLines() const = 0;
};

/// Capability: a special table of measurements, besides studies of its parameters.
class MeasuresTable {
public:
    virtual ~MeasuresTable() = default;
    [[nodiscard]] virtual std::string_view tableTitle() const = 0;
    /// Starts with these values. Throws Failure if a file that they name cannot be read. Thread-safe.
    [[nodiscard]] virtual std::unique_ptr<TableMeasurement> measureTable(const ParameterValues&) const = 0;
};

}  // namespace vitrine
