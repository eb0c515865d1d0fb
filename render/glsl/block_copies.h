#pragma once

#include <string>

namespace vitrine::render {

/// Returns whether a shader has the line `#define COPY_BLOCKS`. It gains from copies if a loop of it reads uniform
/// blocks.
[[nodiscard]] bool asksForCopies(const std::string& shader);

/// Returns the text of a shader, changed so that it reads each number of its uniform blocks once, at its beginning, and
/// uses copies from then on; lines keep their numbers. For llvmpipe (Mesa 22.3, emit_load_ubo): a fragment shader there
/// reads each number of a block pixel by pixel, some 27 instructions for eight pixels, and again at every turn of a
/// loop.
///
/// Changed are blocks `layout(std140, ...) uniform Name { Type instance; };` with a Type declared by BLOCK_STRUCT, and
/// the block of the parameters. Arrays are copied if their indices are all numerals; others are read from the block as
/// before. A block with such arrays that is used as a whole, as an argument of a function, is not copied. The shaders
/// of a program must all be changed: blocks of the same name have the same members.
[[nodiscard]] std::string copyingBlocks(const std::string& shader);

}  // namespace vitrine::render
