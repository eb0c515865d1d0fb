#pragma once

#include <string>
#include <string_view>

namespace vitrine::render {

/// Removes the byte order mark of UTF-8, which editors on Windows write. RFC 8259, 8.1, lets readers ignore it.
[[nodiscard]] inline std::string withoutByteOrderMark(std::string text)
{
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) text.erase(0, mark.size());
    return text;
}

}  // namespace vitrine::render
