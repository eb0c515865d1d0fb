#pragma once

#include "exhibits/printing/print_table.h"
#include "exhibits/printing/print_views.h"
#include "tests/support/degree.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_print.h"

#include <gtest/gtest.h>

#include <memory>

namespace vitrine::printing::test {

using vitrine::test::degree;

/// Test with the settings of a small print of views from files, and a folder.
class SetUpPrint : public testing::Test {
protected:
    vitrine::test::TemporaryFolder folder_;
    const PrintTable& table_ = printTable();
    ParameterValues values_ = table_.initial();

    void SetUp() override
    {
        values_.set(table_.origin, ViewOrigin::files);
        values_.set(table_.width, 0.03);
        values_.set(table_.height, 0.02);
        values_.set(table_.views, 12);
        values_.set(table_.viewWidth, 960);
    }
    /// Returns views of uniform gray: view k has (k + 1) / (count + 1) of linear light.
    [[nodiscard]] static std::shared_ptr<const PrintViews> solid(int count)
    {
        const auto views = std::make_shared<PrintViews>();
        for (int k = 0; k < count; ++k)
            views->add(render::Image(24, 16, 3, static_cast<float>(k + 1) / static_cast<float>(count + 1)));
        return views;
    }
};

}  // namespace vitrine::printing::test
