// Jobs that are split into parts and merged: `--shard` and `vitrine merge`.

#include "render/files/strict_json.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace vitrine {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using Typed = std::vector<std::string>;

Typed film(const std::string& out)
{
    return {"record", "sdf_morph", "--alone",   "--samples", "1",     "--size", "32x18",
            "--fps",  "5",         "--seconds", "1",         "--out", out};
}

Typed printOf(const std::string& out)
{
    return {"print",       "--exhibit", "sdf_morph", "--alone",    "--samples", "1",   "--count",    "4",
            "--view-size", "32x24",     "--lpi",     "40",         "--dpi",     "300", "--width-mm", "20",
            "--height-mm", "15",        "--sweep",   "morph=0..1", "--out",     out};
}

Typed studyOf(const std::string& out)
{
    return {"study",   "sdf_morph", "stepLimit", "--values", "8,32,128", "--size", "32x18",
            "--views", "2",         "--runs",    "2",        "--alone",  "--out",  out};
}

Typed with(Typed words, const Typed& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

void makeParts(const Typed& command, int of)
{
    for (int part = 1; part <= of; ++part) {
        const test::Ended ended =
            test::vitrine(with(command, {"--shard", std::to_string(part) + "/" + std::to_string(of)}));
        ASSERT_EQ(ended.code, 0) << ended.err;
    }
}

}  // namespace

TEST(LongMergeCommand, AFilmOfThreePartsIsTheFilmOfOne)
{
    const TemporaryFolder folder;
    for (const char* name : {"film.apng", "film.mp4"}) {
        const std::string out = folder / name;
        ASSERT_EQ(test::vitrine(film(out)).code, 0);
        const std::string whole = test::bytesOf(out);
        fs::remove(out);
        makeParts(film(out), 3);
        EXPECT_FALSE(fs::exists(out));
        const test::Ended merged = test::vitrine({"merge", out});
        ASSERT_EQ(merged.code, 0) << merged.err;
        EXPECT_TRUE(test::bytesOf(out) == whole) << name;
    }
}

TEST(LongMergeCommand, APrintOfTwoPartsIsThePrintOfOne)
{
    const TemporaryFolder folder;
    const std::string out = folder / "print.tif";
    ASSERT_EQ(test::vitrine(printOf(out)).code, 0);
    const std::string whole = test::bytesOf(out);
    const std::string described = test::bytesOf(out + ".json");
    fs::remove(out);
    makeParts(printOf(out), 2);
    const test::Ended merged = test::vitrine({"merge", out});
    ASSERT_EQ(merged.code, 0) << merged.err;
    EXPECT_TRUE(test::bytesOf(out) == whole);
    EXPECT_EQ(test::bytesOf(out + ".json"), described);
}

TEST(LongMergeCommand, AStudyOfThreePartsFindsTheErrorsAndCountsOfOne)
{
    const TemporaryFolder folder;
    const std::string out = folder / "study";
    ASSERT_EQ(test::vitrine(studyOf(out)).code, 0);
    const render::Json whole = render::Json::parse(test::bytesOf(out + "/study.json"));
    fs::remove_all(out);
    makeParts(studyOf(out), 3);
    const test::Ended merged = test::vitrine({"merge", out});
    ASSERT_EQ(merged.code, 0) << merged.err;
    const render::Json parts = render::Json::parse(test::bytesOf(out + "/study.json"));
    ASSERT_EQ(parts["points"].size(), whole["points"].size());
    ASSERT_EQ(parts["points"].size(), 3U);
    for (std::size_t i = 0; i < parts["points"].size(); ++i) {
        for (const char* key : {"setting", "error", "errors", "modelError", "counters", "values"}) {
            ASSERT_EQ(parts["points"][i].contains(key), whole["points"][i].contains(key)) << key;
            if (whole["points"][i].contains(key)) {
                EXPECT_EQ(parts["points"][i][key], whole["points"][i][key]) << key;
            }
        }
    }
    EXPECT_TRUE(parts["points"][0].contains("error"));
}

TEST(LongMergeCommand, PartsThatAreMissingFailedOrDamagedAreNamedAndNothingChanges)
{
    const TemporaryFolder folder;
    const std::string out = folder / "film.apng";
    EXPECT_EQ(test::vitrine({"merge", out}).code, 1) << "there is nothing";
    test::writeBytes(out, "the old film");
    makeParts(film(out), 2);
    const fs::path parts = out + ".parts";
    const std::string frame = test::bytesOf(parts / "000002.png");

    fs::remove(parts / "part_1.json");
    test::writeBytes(parts / "000002.png", frame.substr(0, frame.size() / 2));
    test::Ended ended = test::vitrine({"merge", out});
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.err.find("part 1 is missing; make it by: vitrine record sdf_morph"), std::string::npos)
        << ended.err;
    EXPECT_NE(ended.err.find("part 2 is damaged (000002.png)"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("--shard 2/2"), std::string::npos) << ended.err;
    EXPECT_EQ(test::bytesOf(out), "the old film");

    test::writeBytes(parts / "part_1.json", "{\"failed\": \"The disk is full.\"}");
    test::writeBytes(parts / "part_2.json", "{{{");
    ended = test::vitrine({"merge", out});
    EXPECT_NE(ended.err.find("part 1 failed (The disk is full.)"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("part 2 is damaged (part_2.json)"), std::string::npos) << ended.err;
    EXPECT_EQ(test::bytesOf(out), "the old film");

    makeParts(film(out), 2);
    ASSERT_EQ(test::vitrine({"merge", out}).code, 0);
    EXPECT_NE(test::bytesOf(out), "the old film");

    // Parts drawn by different renderers must not be merged.
    render::Json report = render::Json::parse(test::bytesOf(parts / "part_2.json"));
    report["renderer"] = "another card";
    test::writeBytes(parts / "part_2.json", report.dump());
    ended = test::vitrine({"merge", out});
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.err.find("another card"), std::string::npos) << ended.err;
}

TEST(MergeCommand, WhatCannotBeSplitIsRefusedInOneSentence)
{
    const TemporaryFolder folder;
    const std::string out = folder / "film.apng";
    for (const char* shard : {"0/3", "4/3", "1", "a/b", "1/0", "1/99999", "-1/2", "1/2/3", "999999999999/9"}) {
        const test::Ended ended = test::vitrine(with(film(out), {"--shard", shard}));
        EXPECT_EQ(ended.code, 2) << shard;
        EXPECT_NE(ended.err.find(std::string("--shard ") + shard), std::string::npos) << ended.err;
    }
    EXPECT_FALSE(fs::exists(out + ".parts"));
    makeParts(film(out), 1);
    test::Ended ended = test::vitrine(with(film(out), {"--turn", "90", "--shard", "1/1"}));
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("the parts of another job"), std::string::npos) << ended.err;
    ended = test::vitrine({"study", "fur", "--alone", "--size", "16x9", "--out", folder / "s", "--shard", "1/2"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("cannot be split"), std::string::npos) << ended.err;
    ended = test::vitrine({"print", "--chart", "pitch", "--lpi", "40", "--width-mm", "10", "--height-mm", "10", "--out",
                           folder / "c.tif", "--shard", "1/2"});
    EXPECT_EQ(ended.code, 2);
}

TEST(MergeCommand, FramesAreSharedWithoutMerging)
{
    const TemporaryFolder folder;
    const std::string out = folder / "frames/%02d.png";
    ASSERT_EQ(test::vitrine(with(film(out), {"--shard", "2/2"})).code, 0);
    EXPECT_FALSE(fs::exists(folder / "frames/01.png"));
    EXPECT_TRUE(fs::exists(folder / "frames/02.png"));
    EXPECT_TRUE(fs::exists(folder / "frames/04.png"));
    ASSERT_EQ(test::vitrine(with(film(out), {"--shard", "1/2"})).code, 0);
    EXPECT_TRUE(fs::exists(folder / "frames/05.png"));
}

TEST(LongMergeCommand, TheScriptForGnuParallelMakesTheSameFilm)
{
    if (std::system("command -v parallel >/dev/null 2>&1") != 0) GTEST_SKIP() << "GNU parallel is not installed";
    const TemporaryFolder folder;
    const std::string out = folder / "a film.apng";
    ASSERT_EQ(test::vitrine(film(out)).code, 0);
    const std::string whole = test::bytesOf(out);
    fs::remove(out);
    std::string script = "VITRINE=" VITRINE_PROGRAM " sh " VITRINE_SOURCE_DIR "/app/queue/parallel.sh 3";
    for (const std::string& word : film(out)) script += " '" + word + "'";
    ASSERT_EQ(std::system((script + " >/dev/null").c_str()), 0);
    EXPECT_TRUE(test::bytesOf(out) == whole);
}

TEST(MergeCommand, TheScriptsOfQueuesKnowBothFormsOfOut)
{
    const TemporaryFolder folder;
    for (const char* words : {"3 render fur --out 'a b.png' --size 8x8", "3 render fur '--out=a b.png' --size 8x8"}) {
        const std::string line = "sh -c '. " VITRINE_SOURCE_DIR "/app/queue/arguments.sh; printf %s \"$out\"' queue " +
                                 std::string(words) + " >'" + std::string(folder / "out") + "'";
        EXPECT_EQ(std::system(line.c_str()), 0) << words;
        EXPECT_EQ(test::bytesOf(folder / "out"), "a b.png") << words;
    }
}

TEST(LongMergeCommand, PartsThatBeginAtOnceShareOneFolder)
{
    const TemporaryFolder folder;
    for (int turn = 0; turn < 2; ++turn) {
        const std::string out = folder / (std::to_string(turn) + ".apng");
        std::string line;
        for (int part = 1; part <= 5; ++part) {
            line += VITRINE_PROGRAM;
            for (const std::string& word : film(out)) line += " '" + word + "'";
            line += " --shard " + std::to_string(part) + "/5 >/dev/null & ";
        }
        ASSERT_EQ(std::system((line + "wait").c_str()), 0);
        const auto merged = test::vitrine({"merge", out});
        EXPECT_EQ(merged.code, 0) << merged.err;
    }
    // No other file is left beside the recordings and their parts.
    for (const auto& file : fs::directory_iterator(folder / ""))
        EXPECT_TRUE(file.path().extension() == ".apng" || file.path().extension() == ".parts" ||
                    file.path().filename().string().ends_with(".apng.vitrine-job.json"))
            << file.path();
}

TEST(LongMergeCommand, TheScriptForSlurmMakesTheSameFilmAndNamesAPartThatFailed)
{
    const TemporaryFolder folder;
    // Does at once what Slurm does later: all tasks of the array, then the job that depends on it.
    test::writeBytes(folder / "sbatch",
                     "#!/bin/sh\n"
                     "last=\nfor word in \"$@\"; do case $word in\n"
                     "--array=1-*) last=${word#--array=1-} ;;\n"
                     "--dependency=*) [ \"$word\" = --dependency=afterany:7 ] || exit 1 ;;\n"
                     "--wrap=*) wrap=${word#--wrap=} ;;\nesac; done\n"
                     "if [ -n \"$last\" ]; then\n"
                     "for task in $(seq $last); do SLURM_ARRAY_TASK_ID=$task sh -c \"$wrap\" >/dev/null; done\n"
                     "echo 7\nelse sh -c \"$wrap\" >&2 || true\necho 8\nfi\n");
    test::writeBytes(folder / "failing", "#!/bin/sh\n"
                                         "[ \"$SLURM_ARRAY_TASK_ID\" != 2 ] || exit 4\n"
                                         "exec " VITRINE_PROGRAM " \"$@\"\n");
    for (const char* script : {"sbatch", "failing"})
        fs::permissions(fs::path(folder / script), fs::perms::owner_exec, fs::perm_options::add);
    const std::string whole = folder / "whole.apng";
    ASSERT_EQ(test::vitrine(film(whole)).code, 0);
    const auto queued = [&](const std::string& program, const std::string& out) {
        std::string line = "PATH='" + std::string(folder / "") + "':$PATH VITRINE='" + program + "' sh " +
                           VITRINE_SOURCE_DIR "/app/queue/slurm_array.sh 3";
        for (const std::string& word : film(out)) line += " \"" + word + "\"";
        EXPECT_EQ(std::system((line + " >/dev/null 2>'" + std::string(folder / "errors") + "'").c_str()), 0);
        return test::bytesOf(folder / "errors");
    };
    const std::string out = folder / "visitor's film.apng";
    queued(VITRINE_PROGRAM, out);
    EXPECT_TRUE(test::bytesOf(out) == test::bytesOf(whole));
    const std::string second = folder / "second.apng";
    const std::string errors = queued(folder / "failing", second);
    EXPECT_NE(errors.find("part 2 is missing"), std::string::npos) << errors;
    EXPECT_EQ(errors.find("part 1 is missing"), std::string::npos) << errors;
    EXPECT_FALSE(fs::exists(second));
}

}  // namespace vitrine
