#pragma once

namespace vitrine::test {

/// True in builds with clang's address sanitizer, where reading a damaged file takes up to a hundred times as long. In
/// those builds the fuzzers read many more files than a test.
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
