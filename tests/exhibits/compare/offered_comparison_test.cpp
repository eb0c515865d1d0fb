// Comparisons that exhibits offer.

#include "exhibits/compare/offered_comparison.h"

#include "exhibits/compare/differing_parameters.h"
#include "exhibits/crepuscular_rays/crepuscular_rays_table.h"
#include "exhibits/exhibits.h"
#include "render/failure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace vitrine::compare {
namespace {

/// Returns the error for a comparison that is not offered; empty if it is offered.
std::string refusalOf(const SceneObject& subject, std::string_view name)
{
    try {
        (void)offeredComparison(subject, name);
        return {};
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.kind(), ErrorKind::usage);
        return failure.what();
    }
}

TEST(OfferedComparison, NamesRowsThatThereAreAndValuesThatTheyMayHave)
{
    int offers = 0;
    for (const auto& exhibit : allExhibits()) {
        std::set<std::string> names, titles;
        const Parameters& table = exhibit->parameters();
        for (const OfferedComparison& offered : offeredComparisons(*exhibit)) {
            SCOPED_TRACE(std::string(exhibit->name()) + ": " + offered.name);
            ++offers;
            EXPECT_TRUE(names.insert(offered.name).second);
            EXPECT_TRUE(titles.insert(offered.title).second);
            EXPECT_FALSE(offered.help.empty());
            ASSERT_FALSE(offered.rows.empty());
            for (const auto& [name, value] : offered.rows) {
                const auto row = table.find(name);
                ASSERT_TRUE(row) << name;
                EXPECT_EQ(nearestLegal(table.rows()[*row], value), value) << name;
            }
        }
    }
    EXPECT_GE(offers, 9);
}

TEST(OfferedComparison, HasTheValuesOfAButForItsParametersWhichDoNotMove)
{
    const auto exhibits = allExhibits();
    const auto rays =
        std::find_if(exhibits.begin(), exhibits.end(), [](const auto& e) { return e->name() == "crepuscular_rays"; });
    const crepuscular_rays::CrepuscularRaysTable table;
    SceneState a{{table.initial(), table.initial()}, {}};
    a.values[1].set(table.weight, 0.25);
    a.values[1].setMotion(table.technique.row, Motion{.from = 0.0, .to = 3.0});
    const SceneState b = otherSide(a, 1, offeredComparison(**rays, "screen"));
    EXPECT_EQ(b.values[0], a.values[0]);
    EXPECT_EQ(b.values[1][table.technique], crepuscular_rays::RayTechnique::screen);
    EXPECT_EQ(b.values[1][table.weight], 0.25);
    EXPECT_TRUE(b.values[1].motions().empty());
    ASSERT_EQ(differingParameters(a, b).size(), 1U);
    EXPECT_NE(refusalOf(**rays, "nothing").find("without, screen, air"), std::string::npos);
    EXPECT_NE(refusalOf(**rays, "scren").find("did you mean screen?"), std::string::npos);
    EXPECT_EQ(refusalOf(**rays, "air"), "");
}

TEST(OfferedComparison, IsNoneWhereAnExhibitOffersNone)
{
    for (const auto& exhibit : allExhibits())
        if (offeredComparisons(*exhibit).empty()) {
            EXPECT_NE(refusalOf(*exhibit, "mesh").find("offers no comparisons"), std::string::npos);
        }
}

}  // namespace
}  // namespace vitrine::compare
