#include "exhibits/framework/files/recovery.h"

#include "exhibits/framework/files/state_folder.h"
#include "render/failure.h"
#include "tests/support/environment_variable.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace vitrine;
using test::TemporaryFolder;

TEST(Recovery, OffersWhatACrashLeftBehind)
{
    const TemporaryFolder folder;
    // A process that writes its journal and ends abnormally.
    const pid_t child = ::fork();
    if (child == 0) {
        const RecoveryJournal journal(folder.path());
        journal.write("first");
        journal.write("the state");
        ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
    const RecoveryJournal journal(folder.path());
    const std::vector<AbandonedSession> sessions = journal.abandoned();
    ASSERT_EQ(sessions.size(), 1U);
    EXPECT_EQ(sessions[0].pid, child);
    EXPECT_EQ(sessions[0].text, "the state");
    EXPECT_GT(sessions[0].modified, 1'600'000'000);
    journal.discard(sessions[0]);
    EXPECT_TRUE(journal.abandoned().empty());
}

TEST(Recovery, CountsOtherProcessesThatAreRunning)
{
    const TemporaryFolder folder;
    const RecoveryJournal own(folder.path());
    own.write("own");
    EXPECT_EQ(own.othersRunning(), 0);
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        RecoveryJournal(folder.path()).write("other");
        (void)::write(ready[1], "x", 1);
        ::pause();
        ::_exit(0);
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    EXPECT_EQ(own.othersRunning(), 1);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_EQ(own.othersRunning(), 0);
    ::close(ready[0]);
    ::close(ready[1]);
}

TEST(Recovery, SaysHowToSetAnotherFolderIfItsOwnCannotBeWritten)
{
    const TemporaryFolder folder;
    const auto saidFor = [&](const std::filesystem::path& file) {
        try {
            writeOwnFile(file, "text");
        } catch (const Failure& failure) {
            return std::string(failure.what());
        }
        return std::string();
    };
    // A file in place of the folder makes writing fail even for root.
    std::ofstream(folder.path() / "vitrine") << "no folder";
    std::string ofState;
    {
        const test::EnvironmentVariable state("XDG_STATE_HOME", folder.path().string());
        ofState = saidFor(stateFolder() / "recovery" / "1-2.json");
    }
    EXPECT_NE(ofState.find("XDG_STATE_HOME set to a folder that can be written"), std::string::npos) << ofState;
    EXPECT_EQ(ofState.find("choose"), std::string::npos) << ofState;
    const std::string other = saidFor(folder.path() / "vitrine" / "a.json");
    EXPECT_NE(other.find("allow writing in that folder."), std::string::npos) << other;
    EXPECT_EQ(saidFor(folder.path() / "new" / "a.json"), "");
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "new" / "a.json"));
}

TEST(Recovery, OffersWhatAProcessLeftThatWasKilledAndThatItsParentHasNotAskedFor)
{
    const TemporaryFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        RecoveryJournal(folder.path()).write("the state");
        ::kill(::getpid(), SIGKILL);
    }
    siginfo_t info{};
    // It has ended, but is still listed.
    ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT), 0);
    ASSERT_TRUE(std::filesystem::exists("/proc/" + std::to_string(child) + "/stat"));
    EXPECT_EQ(RecoveryJournal(folder.path()).abandoned().size(), 1U);
    ::waitpid(child, nullptr, 0);
    EXPECT_EQ(RecoveryJournal(folder.path()).abandoned().size(), 1U);
}

TEST(Recovery, KeepsWhatIsPutAsideWithoutOfferingItAgain)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "999999999-1.json", "what crashes");
    const RecoveryJournal journal(folder.path());
    ASSERT_EQ(journal.abandoned().size(), 1U);
    const std::filesystem::path aside = journal.putAside(journal.abandoned().front());
    EXPECT_TRUE(journal.abandoned().empty());
    EXPECT_EQ(test::bytesOf(aside), "what crashes");
}

TEST(Recovery, DoesNotOfferWhatIsStillRunning)
{
    const TemporaryFolder folder;
    const RecoveryJournal journal(folder.path());
    journal.write("mine");
    EXPECT_TRUE(journal.abandoned().empty());
    journal.cleanExit();
    EXPECT_TRUE(folder.files().empty());
    journal.cleanExit();
}

TEST(Recovery, TellsANewProcessWithAnOldNumberApart)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / (std::to_string(::getpid()) + "-1.json"), "of an earlier process");
    ASSERT_EQ(RecoveryJournal(folder.path()).abandoned().size(), 1U);
}

TEST(Recovery, IgnoresFilesThatAreNotItsOwn)
{
    const TemporaryFolder folder;
    for (const char* name : {"notes.txt", "x-1.json", "-5-1.json", "99999999999999-1.json", "1.json"})
        test::writeBytes(folder / name, "x");
    EXPECT_TRUE(RecoveryJournal(folder.path()).abandoned().empty());
    EXPECT_TRUE(RecoveryJournal(folder / "none").abandoned().empty());
}

}  // namespace
