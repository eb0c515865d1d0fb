#include "render/measure/clock_trial.h"

#include "render/files/number_text.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vitrine::render {
namespace {

constexpr double tolerance = 0.2;

using Times = std::map<double, ClockSample>;  // The fastest run of each load.

Times quickest(std::span<const ClockSample> samples)
{
    Times times;
    for (const ClockSample& s : samples) {
        const auto [known, isNew] = times.try_emplace(s.load, s);
        if (isNew) continue;
        known->second.query = std::min(known->second.query, s.query);
        known->second.wall = std::min(known->second.wall, s.wall);
        known->second.cpu = std::min(known->second.cpu, s.cpu);
    }
    return times;
}

/// Returns the ratio of times of the largest to the smallest load, divided by the ratio of the loads.
double growth(const Times& times, double ClockSample::*clock)
{
    const ClockSample& first = times.begin()->second;
    const ClockSample& last = times.rbegin()->second;
    return last.*clock / (first.*clock) / (last.load / first.load);
}

bool nearOne(double ratio)
{
    return ratio >= 1 - tolerance && ratio <= 1 + tolerance;
}

/// Returns whether the times of all loads are proportional to the loads.
bool scales(const Times& times, double ClockSample::*clock)
{
    if (times.size() < 2) return false;
    const ClockSample& first = times.begin()->second;
    return std::all_of(times.begin(), times.end(), [&](const auto& entry) {
        return nearOne(entry.second.*clock / (first.*clock) / (entry.first / first.load));
    });
}

/// Returns the ratio of query to wall time that differs most from 1.
double worstAgreement(const Times& times)
{
    double worst = 1;
    for (const auto& [load, s] : times) {
        const double ratio = s.query / s.wall;
        if (!std::isfinite(ratio) || std::abs(ratio - 1) > std::abs(worst - 1)) worst = ratio;
    }
    return worst;
}

std::string rounded(double x)
{
    return std::isfinite(x) ? shortestNumber(std::round(x * 1000) / 1000) : "nothing measurable";
}

}  // namespace

ClockChoice chooseClock(std::span<const ClockSample> samples, bool softwareRenderer, double overheadSeconds)
{
    ClockChoice choice;
    choice.overheadSeconds = overheadSeconds;
    const Times times = quickest(samples);
    if (times.size() < 2) {
        choice.method = softwareRenderer ? ClockMethod::cpu : ClockMethod::wall;
        choice.why = "no loads of different size were timed";
    } else {
        const double agreement = worstAgreement(times);
        const bool queryTrue = nearOne(agreement) && scales(times, &ClockSample::query);
        choice.method = softwareRenderer ? ClockMethod::cpu : queryTrue ? ClockMethod::query : ClockMethod::wall;
        const auto clock = choice.method == ClockMethod::cpu     ? &ClockSample::cpu
                           : choice.method == ClockMethod::query ? &ClockSample::query
                                                                 : &ClockSample::wall;
        choice.trusted = scales(times, clock);
        const double load = times.rbegin()->first / times.begin()->first;
        choice.why = rounded(load) + " times the work takes " + rounded(load * growth(times, clock)) +
                     " times as long by this clock";
        choice.why += "; a timer query shows " + rounded(agreement) + " of the wall clock's time" +
                      (queryTrue ? "" : ", so it is not used");
    }
    choice.name = choice.method == ClockMethod::query ? "GPU timer query"
                  : choice.method == ClockMethod::cpu ? "process CPU time around glFinish"
                                                      : "wall time around glFinish";
    return choice;
}

}  // namespace vitrine::render
