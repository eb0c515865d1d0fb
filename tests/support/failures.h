#pragma once

#include "render/failure.h"

#include <gtest/gtest.h>

#include <string>

namespace vitrine::test {

/// Returns the message of the Failure that `work` throws. Fails the test if it throws none, or one of another kind.
template <typename Work> std::string failureOf(const Work& work, ErrorKind kind = ErrorKind::file)
{
    try {
        (void)work();
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.kind(), kind);
        return failure.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return {};
}

/// The same for a Failure with ErrorKind::usage.
template <typename Work> std::string refusalOf(const Work& work)
{
    return failureOf(work, ErrorKind::usage);
}

}  // namespace vitrine::test

/// Expects a Failure whose message contains `part`.
#define EXPECT_FAILURE(statement, part)                                                                                \
    EXPECT_PRED_FORMAT2(::testing::IsSubstring, part, ::vitrine::test::failureOf([&] { (void)(statement); }))
