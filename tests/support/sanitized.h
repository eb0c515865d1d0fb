#pragma once

namespace vitrine::test {

/// True in builds with clang's address sanitizer, where a damaged file takes up to a hundred times as long to read. The
/// fuzzers of the same readers try far more files there than a test can.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool isSanitized = true;
#else
inline constexpr bool isSanitized = false;
#endif
#else
inline constexpr bool isSanitized = false;
#endif

}  // namespace vitrine::test
