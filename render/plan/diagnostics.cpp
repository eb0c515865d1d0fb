#include "render/plan/diagnostics.h"

#include <algorithm>
#include <utility>

namespace vitrine::render {

std::string lineOf(const CulledPass& complaint)
{
    return complaint.unreadable.empty() ? complaint.name + ": " + complaint.reason : complaint.reason;
}

std::vector<CulledPass> Diagnostics::begun(const std::vector<CulledPass>& skipped)
{
    std::vector<std::string> now;
    std::vector<CulledPass> fresh;
    for (const CulledPass& s : skipped) {
        if (!s.complaint) continue;
        std::string line = lineOf(s);
        if (std::find(now.begin(), now.end(), line) != now.end()) continue;
        if (std::find(last_.begin(), last_.end(), line) == last_.end()) fresh.push_back(s);
        now.push_back(std::move(line));
    }
    last_ = std::move(now);
    return fresh;
}

}  // namespace vitrine::render
