#pragma once

namespace vitrine::test {

/// True in builds with sanitizers, where reading a damaged file takes up to a hundred times as long. In those builds
/// the fuzzers read many more files than a test.
#if defined(VITRINE_SANITIZED)
inline constexpr bool isSanitized = true;
#else
inline constexpr bool isSanitized = false;
#endif

}  // namespace vitrine::test
