#pragma once

#include <QString>

#include <string_view>

namespace vitrine::ui {

/// Converts UTF-8 text of the lower layers for widgets.
[[nodiscard]] inline QString text(std::string_view s)
{
    return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size()));
}

}  // namespace vitrine::ui
