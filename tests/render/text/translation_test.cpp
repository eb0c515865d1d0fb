// Translation of displayed texts: whole texts, sentences with placeholders, and their values.

#include "render/text/translation.h"

#include <gtest/gtest.h>

#include <thread>

namespace vitrine {
namespace {

const Catalog& german()
{
    static const Catalog catalog({{"Roughness", "Rauheit"},
                                  {"it is empty", "es ist leer"},
                                  {"Cannot read {1}: {2}", "{=1} kann nicht gelesen werden: {2}"},
                                  {"Cannot read {1}: {2}; choose another picture.",
                                   "{=1} kann nicht gelesen werden: {2}; wählen Sie ein anderes Bild."},
                                  {"{1} of {2}", "{2}: {1}"},
                                  {"{1}, line {2}: {3}; correct it there.", "{=1}, Zeile {2}: {3}; korrigieren."},
                                  {"{1}, line {2}, column {3}: {4}.", "{=1}, Zeile {2}, Spalte {3}: {4}."},
                                  {"this is no JSON ({1}); correct it there", "das ist kein JSON ({=1}); korrigieren"},
                                  {"It is left out until it can be read.", "Sie bleibt weg, bis sie lesbar ist."},
                                  {"{1}", "nothing"},
                                  {"not yet", ""}});
    return catalog;
}

TEST(Translation, GivesWholeTextsAndLeavesWhatItDoesNotKnow)
{
    EXPECT_EQ(german().translated("Roughness"), "Rauheit");
    EXPECT_EQ(german().translated("/home/x/Roughness.json"), "/home/x/Roughness.json");
    EXPECT_EQ(german().translated(""), "");
    EXPECT_EQ(german().translated("not yet"), "not yet") << "an empty translation is none";
    EXPECT_EQ(german().translated("Roughnes"), "Roughnes");
}

TEST(Translation, FillsThePlacesOfASentenceAndTranslatesWhatStandsThere)
{
    EXPECT_EQ(german().translated("Cannot read a.png: it is empty; choose another picture."),
              "a.png kann nicht gelesen werden: es ist leer; wählen Sie ein anderes Bild.");
    EXPECT_EQ(german().translated("3 of Roughness"), "Rauheit: 3") << "places may change their order";
}

TEST(Translation, LeavesNamesAsTheyAreWhereTheTranslationSaysSo)
{
    EXPECT_EQ(german().translated("Cannot read Roughness: it is empty"),
              "Roughness kann nicht gelesen werden: es ist leer");
}

TEST(Translation, PrefersTheSentenceThatSaysMore)
{
    EXPECT_EQ(german().translated("Cannot read a: b; choose another picture."),
              "a kann nicht gelesen werden: b; wählen Sie ein anderes Bild.");
    EXPECT_EQ(german().translated("Cannot read a: b; choose another."), "Cannot read a: b; choose another.");
}

TEST(Translation, PrefersTheSentenceThatLeavesLeastInEnglish)
{
    EXPECT_EQ(german().translated("a.json, line 1, column 2: this is no JSON (end of input); correct it there."),
              "a.json, Zeile 1, Spalte 2: das ist kein JSON (end of input); korrigieren.")
        << "not the one that says more by itself, with all the rest in its place";
    EXPECT_EQ(german().translated("a.json, line 1: it is empty; correct it there."),
              "a.json, Zeile 1: es ist leer; korrigieren.");
}

TEST(Translation, TakesSentencesAndLinesOneByOne)
{
    EXPECT_EQ(german().translated("a.json, line 1, column 2: it is empty. It is left out until it can be read."),
              "a.json, Zeile 1, Spalte 2: es ist leer. Sie bleibt weg, bis sie lesbar ist.");
    EXPECT_EQ(german().translated("Roughness\nx\nRoughness"), "Rauheit\nx\nRauheit");
}

TEST(Translation, IsOfTheWholeTextOrNone)
{
    for (const char* text : {
             "moving: 50% of full resolution",                      // "{1} of {2}" does not match this sentence.
             "Cannot read a.png: the light went out",               // Unknown cause.
             "a.json, line 1: it was eaten; correct it there.",     //
             "It is left out until it can be read. Nobody knows.",  // Unknown second sentence,
             "Roughness\nis a word\nRoughness",                     // or line.
         })
        EXPECT_EQ(german().translated(text), text);
    // Names, numbers and quoted texts are not translated.
    EXPECT_EQ(german().translated("Cannot read a.png: \"no such thing\""),
              "a.png kann nicht gelesen werden: \"no such thing\"");
    EXPECT_EQ(german().translated("Cannot read a.png: 0.5, 1, 2 mm"), "a.png kann nicht gelesen werden: 0.5, 1, 2 mm");
    EXPECT_EQ(german().translated("50% of Roughness"), "Rauheit: 50%");
}

TEST(Translation, OfAHostileTextEndsSoon)
{
    std::string deep = "x";
    for (int i = 0; i < 200; ++i) deep = "1 of " + deep;
    EXPECT_FALSE(german().translated(deep).empty());
    EXPECT_EQ(german().translated(std::string(1 << 20, ':')), std::string(1 << 20, ':'));
}

TEST(Translation, IsEnglishUntilALanguageIsSetAndFromAnyThread)
{
    EXPECT_EQ(language(), "en");
    EXPECT_EQ(translated("Roughness"), "Roughness");
    setLanguage("de", std::make_shared<const Catalog>(Catalog::Entries{{"Roughness", "Rauheit"}}));
    std::string elsewhere;
    std::thread([&] { elsewhere = language() + ' ' + translated("Roughness"); }).join();
    EXPECT_EQ(elsewhere, "de Rauheit");
    setLanguage("en", nullptr);
    EXPECT_EQ(translated("Roughness"), "Roughness");
}

}  // namespace
}  // namespace vitrine
