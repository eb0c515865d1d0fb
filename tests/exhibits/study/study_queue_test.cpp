#include "exhibits/study/study_queue.h"

#include <gtest/gtest.h>

#include <utility>

namespace vitrine::study {
namespace {

/// Parts in memory: a part makes every second measure; `measures` holds what parts have kept.
struct Halves final : StudyParts {
    bool part = false;
    std::map<std::string, StudyMeasure> measures;

    [[nodiscard]] bool isPart() const override { return part; }
    [[nodiscard]] bool makes(std::size_t number) const override { return !part || number % 2 == 0; }
    void keep(const std::string& key, const StudyMeasure& measure) override { measures[key] = measure; }
    [[nodiscard]] std::optional<StudyMeasure> find(const std::string& key) const override
    {
        const auto found = measures.find(key);
        return found == measures.end() ? std::nullopt : std::optional(found->second);
    }
};

/// Queue of jobs "0", "1", ... that note what is measured and taken. A measure takes two steps.
struct Noted {
    explicit Noted(StudyParts* parts, int jobs = 4) : queue(parts)
    {
        for (int i = 0; i < jobs; ++i) add(i);
    }
    void add(int i)
    {
        queue.add(
            std::to_string(i), "job " + std::to_string(i),
            [this, i, begun = false]() mutable -> std::optional<StudyMeasure> {
                if (!std::exchange(begun, true)) return std::nullopt;
                measured.push_back(i);
                return StudyMeasure{.milliseconds = {1.0 * i}};
            },
            [this](const StudyMeasure& measure) { taken.push_back(static_cast<int>(measure.milliseconds.front())); });
    }
    void run()
    {
        while (!queue.empty()) queue.step();
    }

    StudyQueue queue;
    std::vector<int> measured, taken;
};

using Numbers = std::vector<int>;

TEST(StudyQueue, MeasuresAndTakesEveryJobInOrder)
{
    Noted noted(nullptr);
    EXPECT_FALSE(noted.queue.isPart());
    EXPECT_EQ(noted.queue.waiting(), 4U);
    noted.queue.step();
    EXPECT_EQ(noted.queue.doing(), "job 0");
    EXPECT_EQ(noted.queue.done(), 0U);
    EXPECT_TRUE(noted.measured.empty()) << "a measure takes two steps";
    noted.queue.step();
    EXPECT_EQ(noted.queue.done(), 1U);
    EXPECT_EQ(noted.taken, (Numbers{0}));
    noted.run();
    EXPECT_EQ(noted.taken, (Numbers{0, 1, 2, 3}));
    EXPECT_EQ(noted.queue.done(), 4U);
}

TEST(StudyQueue, APartMeasuresItsShareKeepsItAndTakesNothing)
{
    Halves halves;
    halves.part = true;
    Noted noted(&halves);
    EXPECT_TRUE(noted.queue.isPart());
    noted.run();
    EXPECT_EQ(noted.measured, (Numbers{0, 2}));
    EXPECT_TRUE(noted.taken.empty());
    EXPECT_EQ(halves.measures.size(), 2U);
}

TEST(StudyQueue, WhatPartsMeasuredIsTakenAndTheRestIsMeasured)
{
    Halves halves;
    halves.part = true;
    Noted part(&halves);
    part.run();
    halves.part = false;
    Noted whole(&halves);
    whole.run();
    EXPECT_EQ(whole.measured, (Numbers{1, 3}));
    EXPECT_EQ(whole.taken, (Numbers{0, 1, 2, 3}));
}

TEST(StudyQueue, AJobMayAddOthersWhenItsMeasureIsTaken)
{
    Noted noted(nullptr, 1);
    noted.queue.add(
        "more", "more", [] { return std::optional(StudyMeasure{}); },
        [&noted](const StudyMeasure&) {
            for (int i = 10; i < 30; ++i) noted.add(i);
        });
    noted.run();
    EXPECT_EQ(noted.taken.size(), 21U);
    EXPECT_EQ(noted.queue.done(), 22U);
}

}  // namespace
}  // namespace vitrine::study
