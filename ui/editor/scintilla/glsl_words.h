#pragma once

namespace vitrine::ui {

/// Keywords of GLSL 4.50, separated by blanks.
inline constexpr const char* glslKeywords =
    "attribute break buffer case centroid coherent const continue default discard do else false flat for highp if "
    "in inout invariant layout lowp mediump noperspective out precise precision readonly restrict return sample "
    "shared smooth struct subroutine switch true uniform varying volatile while writeonly";

inline constexpr const char* glslTypes =
    "bool bvec2 bvec3 bvec4 dmat2 dmat3 dmat4 double dvec2 dvec3 dvec4 float image2D image3D imageCube int "
    "isampler2D isampler3D ivec2 ivec3 ivec4 mat2 mat2x2 mat2x3 mat2x4 mat3 mat3x2 mat3x3 mat3x4 mat4 mat4x2 mat4x3 "
    "mat4x4 sampler1D sampler2D sampler2DArray sampler2DShadow sampler3D samplerBuffer samplerCube uint usampler2D "
    "usampler3D uvec2 uvec3 uvec4 vec2 vec3 vec4 void";

/// Functions and variables of GLSL 4.50, and those of ISF and Shadertoy.
inline constexpr const char* glslFunctions =
    "abs acos acosh all any asin asinh atan atanh bitCount bitfieldExtract bitfieldInsert bitfieldReverse ceil clamp "
    "cos "
    "cosh cross dFdx dFdy degrees determinant distance dot equal exp exp2 faceforward findLSB findMSB floatBitsToInt "
    "floatBitsToUint floor fma fract frexp fwidth greaterThan greaterThanEqual imageLoad imageSize imageStore "
    "intBitsToFloat inverse inversesqrt isinf isnan ldexp length lessThan lessThanEqual log log2 matrixCompMult max "
    "min "
    "mix mod modf normalize not notEqual outerProduct packHalf2x16 pow radians reflect refract round roundEven sign "
    "sin "
    "sinh smoothstep sqrt step tan tanh texelFetch texture texture2D textureCube textureGrad textureLod textureSize "
    "transpose trunc uintBitsToFloat unpackHalf2x16 gl_FragColor gl_FragCoord gl_FragDepth gl_FrontFacing "
    "gl_InstanceID gl_Position gl_VertexID gl_GlobalInvocationID gl_LocalInvocationID gl_WorkGroupID DATE FRAMEINDEX "
    "IMG_NORM_PIXEL IMG_NORM_THIS_PIXEL IMG_PIXEL IMG_SIZE IMG_THIS_PIXEL PASSINDEX RENDERSIZE TIME TIMEDELTA "
    "isf_FragNormCoord vv_FragNormCoord iChannel0 iChannel1 iChannel2 iChannel3 iChannelResolution iDate iFrame iMouse "
    "iResolution iTime iTimeDelta u_date u_delta u_frame u_mouse u_resolution u_time";

}  // namespace vitrine::ui
