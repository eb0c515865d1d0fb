// Closes what render/glsl/begin_cpu.h opens.

#undef float

#undef VITRINE_GLSL_FIELD
#undef VITRINE_GLSL_ARRAY
#pragma pop_macro("BLOCK_STRUCT")

}  // namespace
}  // namespace vitrine::glsl

#pragma GCC diagnostic pop
