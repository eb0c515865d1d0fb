#pragma once

#include <string>
#include <string_view>

namespace vitrine::render {

/// A text without the byte order mark of UTF-8. Editors on Windows write one; it says nothing that is not known.
/// RFC 8259, 8.1, lets readers leave it out.
[[nodiscard]] inline std::string withoutByteOrderMark(std::string text)
{
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) text.erase(0, mark.size());
    return text;
}

}  // namespace vitrine::render
