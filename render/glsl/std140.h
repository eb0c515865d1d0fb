#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

// Fields of a uniform block are listed once, for GLSL and C++, in files `*_block.glsl` that both compile:
//
//     #define LAMP_FIELDS(FIELD, ARRAY) FIELD(vec3, position) FIELD(bool, isOn) ARRAY(vec4, planes, 4)
//     BLOCK_STRUCT(LampBlock, LAMP_FIELDS)
//
// The list has the fields in order, with types and names as in GLSL; a type may be a BLOCK_STRUCT defined above. A
// shader includes the file and declares `uniform Lamp { LampBlock lamp; };`. A header includes the file within its
// namespace and gets `struct LampBlock { glm::vec3 position{}; bool isOn{}; std::array<glm::vec4, 4> planes{}; };`.
// render::std140Bytes converts such a struct to the bytes that the shader reads.
#define BLOCK_STRUCT(Block, FIELDS)                                                                                    \
    struct Block {                                                                                                     \
        using vec2 = glm::vec2;                                                                                        \
        using vec3 = glm::vec3;                                                                                        \
        using vec4 = glm::vec4;                                                                                        \
        using ivec2 = glm::ivec2;                                                                                      \
        using ivec3 = glm::ivec3;                                                                                      \
        using ivec4 = glm::ivec4;                                                                                      \
        using mat4 = glm::mat4;                                                                                        \
        using uint = std::uint32_t;                                                                                    \
        FIELDS(VITRINE_BLOCK_FIELD, VITRINE_BLOCK_ARRAY)                                                               \
        template <typename Self, typename Visit> static void visitFields(Self& self, Visit visit)                      \
        {                                                                                                              \
            FIELDS(VITRINE_BLOCK_VISIT, VITRINE_BLOCK_VISIT_ARRAY)                                                     \
        }                                                                                                              \
    };
#define VITRINE_BLOCK_FIELD(type, name) type name{};
#define VITRINE_BLOCK_ARRAY(type, name, count) std::array<type, count> name{};
#define VITRINE_BLOCK_VISIT(type, name) visit(#name, self.name);
#define VITRINE_BLOCK_VISIT_ARRAY(type, name, count) visit(#name, self.name);

namespace vitrine::render {

/// Satisfied by the structs that BLOCK_STRUCT defines.
template <typename T>
concept BlockStruct = requires(const T& block)
{
    T::visitFields(block, [](const char*, const auto&) {});
};

/// Writes values one after another in std140 layout (OpenGL 4.5 core, 7.6.2.2). Padding is 0.
class Std140Writer {
public:
    /// Appends a value; returns its offset in bytes.
    std::size_t put(float value) { return append(&value, sizeof value, sizeof value); }
    std::size_t put(std::int32_t value) { return append(&value, sizeof value, sizeof value); }
    std::size_t put(std::uint32_t value) { return append(&value, sizeof value, sizeof value); }
    std::size_t put(bool value) { return put(std::int32_t{value}); }
    template <glm::length_t N, typename T, glm::qualifier Q> std::size_t put(const glm::vec<N, T, Q>& value)
    {
        static_assert(sizeof(T) == 4);
        return append(&value[0], sizeof(T) * N, N == 2 ? 8 : 16);
    }
    template <glm::length_t C, glm::length_t R, glm::qualifier Q> std::size_t put(const glm::mat<C, R, float, Q>& value)
    {
        const std::size_t begin = align(16);
        for (glm::length_t column = 0; column < C; ++column) {
            put(value[column]);
            align(16);
        }
        return begin;
    }
    template <typename T, std::size_t N> std::size_t put(const std::array<T, N>& values)
    {
        const std::size_t begin = align(16);
        for (const T& value : values) {
            put(value);
            align(16);
        }
        return begin;
    }
    template <BlockStruct T> std::size_t put(const T& block)
    {
        const std::size_t begin = align(16);
        T::visitFields(block, [this](const char*, const auto& field) { this->put(field); });
        align(16);
        return begin;
    }

    void reserve(std::size_t bytes) { bytes_.reserve(bytes); }
    /// Pads to the next multiple of `alignment`; returns the new size.
    std::size_t align(std::size_t alignment)
    {
        bytes_.resize((bytes_.size() + alignment - 1) / alignment * alignment);
        return bytes_.size();
    }

    /// Returns the bytes of the whole block, padded to a multiple of 16.
    [[nodiscard]] std::vector<std::byte> take()
    {
        align(16);
        return std::move(bytes_);
    }

private:
    std::size_t append(const void* value, std::size_t size, std::size_t alignment)
    {
        const std::size_t begin = align(alignment);
        bytes_.resize(begin + size);
        std::memcpy(bytes_.data() + begin, value, size);
        return begin;
    }

    std::vector<std::byte> bytes_;
};

/// Returns the offset of a field of the struct, in bytes; 0 if there is no field of that name.
template <BlockStruct T> [[nodiscard]] std::size_t std140Offset(std::string_view field)
{
    Std140Writer writer;
    std::size_t offset = 0;
    const T block{};
    T::visitFields(block, [&](std::string_view name, const auto& value) {
        const std::size_t begin = writer.put(value);
        if (name == field) offset = begin;
    });
    return offset;
}

/// Returns the bytes of a uniform block whose only member is `block`.
template <BlockStruct T> [[nodiscard]] std::vector<std::byte> std140Bytes(const T& block)
{
    Std140Writer writer;
    writer.reserve(2 * sizeof(T));  // Upper bound: no padding is larger than the value before it.
    writer.put(block);
    return writer.take();
}

}  // namespace vitrine::render
