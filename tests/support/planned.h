#pragma once

#include "exhibits/museum/museum.h"

namespace vitrine::test {

// One picture at once: prepared, then planned or asked about.

inline render::FramePlan planned(const Museum& museum, const Look& look, const FrameRequest& request,
                                 const render::KeptKeys& kept = {})
{
    return museum.plan(museum.prepare(look, request), request, kept);
}

inline double nextChange(const Museum& museum, const Look& look, const FrameRequest& request)
{
    return museum.nextChange(museum.prepare(look, request), request);
}

}  // namespace vitrine::test
