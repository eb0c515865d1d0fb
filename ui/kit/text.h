#pragma once

#include <QString>

#include <string_view>

namespace vitrine::ui {

/// UTF-8, as the program's texts are, for widgets.
[[nodiscard]] inline QString text(std::string_view s)
{
    return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size()));
}

}  // namespace vitrine::ui
