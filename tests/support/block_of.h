#pragma once

#include "render/glsl/std140.h"

#include <gtest/gtest.h>

#include <cstring>

namespace vitrine::test {

/// Reads the fields of a uniform block from its bytes, in their order.
class BlockReader {
public:
    explicit BlockReader(const std::vector<std::byte>& bytes) : bytes_(bytes) {}

    template <typename T> void get(T& value)
    {
        if constexpr (render::BlockStruct<T>) {
            at_.align(16);
            T::visitFields(value, [this](const char*, auto& field) { this->get(field); });
            at_.align(16);
        } else if constexpr (requires { value.fill(value[0]); }) {
            at_.align(16);
            for (auto& element : value) {
                get(element);
                at_.align(16);
            }
        } else if constexpr (std::is_same_v<T, bool>) {
            std::int32_t number = 0;
            get(number);
            value = number != 0;
        } else {
            const std::size_t begin = at_.put(value);
            if (begin + sizeof value > bytes_.size())
                ADD_FAILURE() << "the block ends before byte " << begin + sizeof value;
            else
                std::memcpy(&value, bytes_.data() + begin, sizeof value);
        }
    }

private:
    const std::vector<std::byte>& bytes_;
    render::Std140Writer at_;  ///< Computes the position of each field.
};

/// Returns the struct from which `render::std140Bytes` made the bytes.
template <render::BlockStruct T> T blockOf(const std::vector<std::byte>& bytes)
{
    T block;
    BlockReader(bytes).get(block);
    return block;
}

}  // namespace vitrine::test
