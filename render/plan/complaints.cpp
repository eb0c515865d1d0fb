#include "render/plan/complaints.h"

#include <algorithm>
#include <utility>

namespace vitrine::render {

std::vector<std::string> Complaints::begun(const std::vector<Skipped>& skipped)
{
    std::vector<std::string> now, fresh;
    for (const Skipped& s : skipped) {
        if (!s.complaint) continue;
        std::string line = s.name + ": " + s.reason;
        if (std::find(now.begin(), now.end(), line) != now.end()) continue;
        if (std::find(last_.begin(), last_.end(), line) == last_.end()) fresh.push_back(line);
        now.push_back(std::move(line));
    }
    last_ = std::move(now);
    return fresh;
}

}  // namespace vitrine::render
