// Settings files that are no regular files: pipes, folders, devices, very large ones. Nothing blocks, and nothing is
// written to them.

#include "ui/kit/ini_file.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <QSettings>

#include <sys/stat.h>

namespace vitrine::ui {
namespace {

TEST(IniFile, IsReadAndWrittenWhereItIsAFileOrMissing)
{
    const test::TemporaryFolder folder;
    const QString path = QString::fromStdString((folder / "window.ini").string());
    ASSERT_EQ(iniPath(path), path) << "missing";
    QSettings(iniPath(path), QSettings::IniFormat).setValue(QStringLiteral("theme"), QStringLiteral("dark"));
    EXPECT_EQ(iniPath(path), path);
    EXPECT_EQ(QSettings(iniPath(path), QSettings::IniFormat).value(QStringLiteral("theme")).toString(),
              QStringLiteral("dark"));
}

TEST(IniFile, ThatIsNoneGivesNoSettingsWithoutWaiting)
{
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    std::filesystem::create_directory(folder / "folder");
    std::filesystem::create_symlink("pipe", folder / "link");
    test::writeBytes(folder / "large", std::string((4U << 20U) + 1, 'x'));
    const std::vector<std::string> before = folder.files();
    for (const char* name : {"pipe", "folder", "link", "large", "/dev/zero"}) {
        SCOPED_TRACE(name);
        const QString path = iniPath(QString::fromStdString((folder / name).string()));
        QSettings settings(path, QSettings::IniFormat);
        EXPECT_TRUE(settings.allKeys().isEmpty());
        settings.setValue(QStringLiteral("theme"), QStringLiteral("dark"));
        settings.sync();
        EXPECT_EQ(settings.status(), QSettings::AccessError);
    }
    EXPECT_EQ(folder.files(), before);
    EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/zero"));
}

}  // namespace
}  // namespace vitrine::ui
