#include "exhibits/framework/files/preset_store.h"

#include "exhibits/framework/files/slug.h"
#include "exhibits/framework/files/state_folder.h"
#include "render/image/image_io.h"
#include "tests/exhibits/framework/table/every_kind.h"
#include "tests/support/environment_variable.h"
#include "tests/support/failures.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <optional>

namespace {

using namespace vitrine;
using test::everyKind;
namespace fs = std::filesystem;

class Store : public ::testing::Test {
protected:
    static Preset preset(const std::string& name)
    {
        Preset p{"everything", name, everyKind.initial(), std::nullopt, render::Json::object(), {}};
        p.values.set(everyKind.morph, 0.75);
        return p;
    }
    StoredPreset load(const fs::path& path) const { return store.load(path, "everything", everyKind); }
    std::vector<std::string> names() const
    {
        std::vector<std::string> all;
        for (const PresetEntry& entry : store.list("everything")) all.push_back(entry.name);
        return all;
    }

    const test::TemporaryFolder folder;
    const PresetStore store{{folder / "user", folder / "shipped", folder / "trash"}};
};

TEST_F(Store, SavesListsAndLoads)
{
    EXPECT_TRUE(store.list("everything").empty());
    const StoredPreset saved = store.saveAs(preset("Half a Mug!"));
    EXPECT_EQ(saved.path, folder / "user/everything/half-a-mug.json");
    const std::vector<PresetEntry> entries = store.list("everything");
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(entries[0].name, "Half a Mug!");
    EXPECT_FALSE(entries[0].shipped);
    EXPECT_FALSE(entries[0].thumbnail);
    EXPECT_EQ(load(entries[0].path).preset.values, saved.preset.values);
}

TEST_F(Store, GivesEveryNameAFileOfItsOwn)
{
    EXPECT_EQ(store.saveAs(preset("Café")).path.filename(), "cafe.json");
    EXPECT_EQ(store.saveAs(preset("CAFE")).path.filename(), "cafe-2.json");
    EXPECT_EQ(store.saveAs(preset("杯")).path.filename(), "preset.json");
    EXPECT_EQ(store.saveAs(preset("../../etc/passwd")).path.filename(), "etc-passwd.json");
    EXPECT_EQ(slugFor(std::string(500, 'a')).size(), 64U);
    EXPECT_EQ(slugFor("  -- "), "preset");
    EXPECT_EQ(slugFor("Straße №5 ﬁn"), "stra-e-no5-fin");
}

TEST_F(Store, NoticesThatTheFileChangedOnDisk)
{
    StoredPreset first = store.saveAs(preset("A"));
    StoredPreset second = load(first.path);
    second.preset.values.set(everyKind.morph, 0.1);
    EXPECT_EQ(store.save(second), SaveOutcome::saved);
    EXPECT_EQ(store.save(second), SaveOutcome::saved) << "one's own change is no surprise";
    first.preset.values.set(everyKind.morph, 0.9);
    EXPECT_EQ(store.save(first), SaveOutcome::changedOnDisk);
    EXPECT_EQ(load(first.path).preset.values[everyKind.morph], 0.1);
    EXPECT_EQ(store.save(first, IfChanged::overwrite), SaveOutcome::saved);
    EXPECT_EQ(load(first.path).preset.values[everyKind.morph], 0.9);
}

TEST_F(Store, NeverRewritesWhatItCouldNotRead)
{
    const fs::path broken = folder / "user/everything/broken.json";
    test::writeBytes(broken, "{\"format\": ");
    const std::vector<PresetEntry> entries = store.list("everything");
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(entries[0].name, "broken");
    EXPECT_NE(entries[0].problem.find("not valid JSON"), std::string::npos);
    EXPECT_FAILURE(load(broken), "broken.json");
    EXPECT_FAILURE(store.rename(broken, "Other"), "broken.json");
    EXPECT_FAILURE(store.duplicate(broken, "Other"), "broken.json");
    EXPECT_FAILURE(store.exportFile(broken, folder / "out.json"), "broken.json");
    EXPECT_FAILURE(store.importFile(broken, "everything", everyKind), "broken.json");
    EXPECT_EQ(store.saveAs(preset("Broken")).path.filename(), "broken-2.json");
    EXPECT_EQ(test::bytesOf(broken), "{\"format\": ");
}

TEST_F(Store, LeavesShippedPresetsAlone)
{
    test::writeBytes(folder / "shipped/everything/first.json", presetText(preset("First")));
    (void)store.saveAs(preset("A second"));
    EXPECT_EQ(names(), (std::vector<std::string>{"First", "A second"})) << "shipped ones come first";
    StoredPreset shipped = load(folder / "shipped/everything/first.json");
    EXPECT_TRUE(shipped.shipped);
    EXPECT_FAILURE(store.save(shipped), "part of Vitrine");
    EXPECT_FAILURE(store.rename(shipped.path, "X"), "part of Vitrine");
    EXPECT_FAILURE(store.remove(shipped.path), "part of Vitrine");
    const fs::path copy = store.duplicate(shipped.path, "First (mine)");
    EXPECT_EQ(copy, folder / "user/everything/first-mine.json");
    EXPECT_EQ(load(copy).preset.name, "First (mine)");
}

TEST_F(Store, RenamesWithPictureAndUnknownKeys)
{
    const fs::path path = folder / "user/everything/a.json";
    test::writeBytes(
        path,
        R"({"format": "vitrine-preset", "version": 1, "exhibit": "everything", "name": "A", "values": {"future": [1]}})");
    test::writeBytes(PresetStore::thumbnailPath(path), "picture");
    const fs::path renamed = store.rename(path, "B & C");
    EXPECT_EQ(renamed.filename(), "b-c.json");
    EXPECT_EQ(test::bytesOf(PresetStore::thumbnailPath(renamed)), "picture");
    EXPECT_FALSE(fs::exists(path));
    EXPECT_EQ(load(renamed).preset.name, "B & C");
    EXPECT_NE(test::bytesOf(renamed).find("future"), std::string::npos);
    EXPECT_EQ(store.rename(renamed, "b c"), renamed) << "the same file name will do";
    EXPECT_EQ(names(), std::vector<std::string>{"b c"});
}

TEST_F(Store, TagsAreListedAndChangedWithoutTouchingTheRest)
{
    const StoredPreset saved = store.saveAs(preset("A"));
    const std::string before = test::bytesOf(saved.path);
    store.setTags(saved.path, {"night"});
    EXPECT_EQ(store.list("everything")[0].tags, PresetTags{"night"});
    EXPECT_EQ(load(saved.path).preset.tags, PresetTags{"night"});
    const fs::path copy = store.duplicate(saved.path, "B");
    EXPECT_EQ(load(copy).preset.tags, PresetTags{"night"}) << "a copy is found by the same words";
    StoredPreset again = load(saved.path);
    EXPECT_EQ(store.save(again), SaveOutcome::saved);
    EXPECT_EQ(load(saved.path).preset.tags, PresetTags{"night"});
    store.setTags(saved.path, {});
    EXPECT_EQ(test::bytesOf(saved.path), before);
    const fs::path shipped = folder / "shipped/everything/first.json";
    test::writeBytes(shipped, before);
    EXPECT_FAILURE(store.setTags(shipped, {"night"}), "part of Vitrine");
    EXPECT_EQ(test::bytesOf(shipped), before);
}

TEST_F(Store, RemovesIntoATrashAndRestores)
{
    const StoredPreset saved = store.saveAs(preset("A"));
    test::writeBytes(PresetStore::thumbnailPath(saved.path), "picture");
    const std::string content = test::bytesOf(saved.path);
    const RemovedDocument removed = store.remove(saved.path);
    EXPECT_TRUE(names().empty());
    EXPECT_FALSE(fs::exists(PresetStore::thumbnailPath(saved.path)));
    EXPECT_EQ(store.restore(removed), saved.path);
    EXPECT_EQ(test::bytesOf(saved.path), content);
    EXPECT_EQ(test::bytesOf(PresetStore::thumbnailPath(saved.path)), "picture");

    const RemovedDocument again = store.remove(saved.path);
    (void)store.saveAs(preset("A"));
    EXPECT_EQ(store.restore(again).filename(), "a-2.json") << "its place was taken";
    EXPECT_FAILURE(store.restore(again), "Cannot move");
}

TEST_F(Store, ImportsFilesAndPicturesAndExports)
{
    test::writeBytes(folder / "in/some.json", presetText(preset("From a file")));
    const fs::path imported = store.importFile(folder / "in/some.json", "everything", everyKind);
    EXPECT_EQ(imported.filename(), "from-a-file.json");
    store.exportFile(imported, folder / "out/x.json");
    EXPECT_EQ(test::bytesOf(folder / "out/x.json"), test::bytesOf(folder / "in/some.json"));

    const render::Image image(4, 4, 3, 0.5F);
    render::writePicture(folder / "in/a.png", image, render::PictureFormat::png8,
                         {.preset = presetText(preset("In a picture 😀"))});
    EXPECT_EQ(load(store.importFile(folder / "in/a.png", "everything", everyKind)).preset.name, "In a picture 😀");
    render::writePicture(folder / "in/b.png", image, render::PictureFormat::png8);
    EXPECT_FAILURE(store.importFile(folder / "in/b.png", "everything", everyKind), "no preset in this picture");
    EXPECT_FAILURE(store.importFile(folder / "in/none.json", "everything", everyKind), "no such file");
    test::writeBytes(folder / "in/other.json",
                     R"({"format": "vitrine-preset", "version": 1, "exhibit": "fur", "name": "x"})");
    EXPECT_FAILURE(store.importFile(folder / "in/other.json", "everything", everyKind), "this preset is for fur");
}

TEST_F(Store, FollowsTheFoldersOfTheDesktop)
{
    const auto stateWith = [](const std::optional<std::string>& value) {
        const test::EnvironmentVariable state("XDG_STATE_HOME", value);
        return stateFolder();
    };
    EXPECT_EQ(stateWith("/some/state"), "/some/state/vitrine");
    EXPECT_TRUE(stateWith("relative").string().ends_with("/.local/state/vitrine"));
    EXPECT_TRUE(stateWith(std::nullopt).is_absolute());
    const test::EnvironmentVariable data("XDG_DATA_HOME", "/some/data");
    EXPECT_EQ(userPresetFolder(), "/some/data/vitrine/presets");
}

}  // namespace
