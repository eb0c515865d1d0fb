#pragma once

#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>

namespace vitrine {

/// Returns the texts of all elements with `between` from one to the next: "a, b, c". `textOf` is a function or a member
/// that gives an element's text.
template <typename Elements, typename TextOf = std::identity>
[[nodiscard]] std::string joined(const Elements& elements, std::string_view between = ", ", const TextOf& textOf = {})
{
    std::string text;
    bool isFirst = true;
    for (const auto& element : elements) {
        if (!isFirst) text += between;
        isFirst = false;
        text += std::invoke(textOf, element);
    }
    return text;
}

/// Returns the texts of all elements as a choice: "a, b or c".
template <typename Elements, typename TextOf = std::identity>
[[nodiscard]] std::string alternatives(const Elements& elements, const TextOf& textOf = {})
{
    std::string text;
    std::size_t left = std::size(elements);
    for (const auto& element : elements) {
        text += std::invoke(textOf, element);
        --left;
        if (left > 0) text += left == 1 ? " or " : ", ";
    }
    return text;
}

}  // namespace vitrine
